!> How much memory this process may have.
module base_memory
    use, intrinsic :: iso_c_binding, only: c_int, c_int64_t
    implicit none (type, external)
    private

    public :: has_little_memory

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
        integer(c_int), parameter :: address_space = 9_c_int
        integer(c_int64_t), parameter :: enough = 2_c_int64_t**30
        integer(c_int64_t) :: limits(2)
        has_little_memory = .false.
        if (c_getrlimit(address_space, limits) /= 0) return
        has_little_memory = limits(1) >= 0 .and. limits(1) < enough
    end function has_little_memory

end module base_memory
