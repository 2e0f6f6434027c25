!> How much memory and stack this process may have.
module base_memory
    use, intrinsic :: iso_c_binding, only: c_int, c_int64_t
    use base_kinds, only: i64
    implicit none (type, external)
    private

    public :: has_little_memory, stack_room

    !> What is limited: the stack, the address space.
    integer(c_int), parameter :: stack = 3_c_int, address_space = 9_c_int

    interface
        !> A limit of this process: the present and the largest; -1 where there is no such limit.
        integer(c_int) function c_getrlimit(resource, limits) bind(c, name='getrlimit')
            import :: c_int, c_int64_t
            integer(c_int), value :: resource               !! which
            integer(c_int64_t), intent(out) :: limits(2)    !! negative: unlimited
        end function c_getrlimit
    end interface

contains

    !> True where the address space is limited (`ulimit -v`) to less than threads may reserve: with
    !> glibc each has 64 MiB set aside for what it allocates.
    logical function has_little_memory()
        integer(c_int64_t), parameter :: enough = 2_c_int64_t**30
        integer(c_int64_t) :: limits(2)
        has_little_memory = .false.
        if (c_getrlimit(address_space, limits) /= 0) return
        has_little_memory = limits(1) >= 0 .and. limits(1) < enough
    end function has_little_memory

    !> Bytes that the stack may take (`ulimit -s`); `huge` where it is not limited.
    integer(i64) function stack_room() result(room)
        integer(c_int64_t) :: limits(2)
        room = huge(room)
        if (c_getrlimit(stack, limits) /= 0) return
        if (limits(1) >= 0) room = int(limits(1), i64)
    end function stack_room

end module base_memory
