!> Memory that can't be had: LOFT says so and ends with status 2, unfinished results removed. GNU
!> Fortran looks at what `malloc` answers in some places and not in others; so the program is linked
!> (`--wrap` of the linker, where it has that) to ask for memory through these. No module uses them.
module app_memory
    use, intrinsic :: iso_c_binding, only: c_associated, c_ptr, c_size_t
    use app_signals, only: stop_for
    implicit none (type, external)
    private

    public :: checked_malloc, checked_calloc, checked_realloc

    interface
        !> Memory; a null pointer where there is none left.
        type(c_ptr) function malloc(size) bind(c, name='__real_malloc')
            import :: c_ptr, c_size_t
            integer(c_size_t), value :: size !! bytes
        end function malloc

        !> Memory filled with zeros; a null pointer where there is none left.
        type(c_ptr) function calloc(count, size) bind(c, name='__real_calloc')
            import :: c_ptr, c_size_t
            integer(c_size_t), value :: count !! of elements
            integer(c_size_t), value :: size  !! bytes of each
        end function calloc

        !> The same memory in another size; a null pointer where there is none left.
        type(c_ptr) function realloc(former, size) bind(c, name='__real_realloc')
            import :: c_ptr, c_size_t
            type(c_ptr), value :: former     !! what was had
            integer(c_size_t), value :: size !! bytes
        end function realloc
    end interface

contains

    !> What the program calls as `malloc`.
    type(c_ptr) function checked_malloc(size) bind(c, name='__wrap_malloc') result(memory)
        integer(c_size_t), value :: size !! bytes
        memory = malloc(size)
        if (.not. c_associated(memory) .and. size /= 0_c_size_t) call stop_for('out of memory')
    end function checked_malloc

    !> What the program calls as `calloc`.
    type(c_ptr) function checked_calloc(count, size) bind(c, name='__wrap_calloc') result(memory)
        integer(c_size_t), value :: count !! of elements
        integer(c_size_t), value :: size  !! bytes of each
        memory = calloc(count, size)
        if (.not. c_associated(memory) .and. min(count, size) /= 0_c_size_t) &
            call stop_for('out of memory')
    end function checked_calloc

    !> What the program calls as `realloc`.
    type(c_ptr) function checked_realloc(former, size) bind(c, name='__wrap_realloc') result(memory)
        type(c_ptr), value :: former     !! what was had
        integer(c_size_t), value :: size !! bytes
        memory = realloc(former, size)
        if (.not. c_associated(memory) .and. size /= 0_c_size_t) call stop_for('out of memory')
    end function checked_realloc

end module app_memory
