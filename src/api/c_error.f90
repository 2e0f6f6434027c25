!> Errors as handles of C, and the version; see `loft.h`.
!>
!> An argument of C that may be NULL is optional here: NULL is absent.
module api_c_error
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_int, c_loc, &
        c_null_ptr, c_ptr, c_size_t
    use api_c_text, only: copied
    use api_loft, only: cause, error_type, loft_version
    use base_error, only: fail
    implicit none (type, external)
    private

    public :: hand_over, refuse, succeeded, loft_abi_version, c_version
    public :: loft_error_cause, loft_error_message, loft_error_free

    !> The interface that `loft.h` describes: LOFT_ABI_VERSION there, and the number of the shared
    !> library.
    integer(c_int), parameter :: abi_version = 1_c_int

contains

    !> Hands an error over to the caller, or says that there is none.
    subroutine hand_over(error, slot)
        type(error_type), allocatable, intent(in) :: error  !! of the call
        type(c_ptr), intent(out), optional :: slot          !! the caller's handle
        type(error_type), pointer :: held

        if (.not. present(slot)) return
        slot = c_null_ptr
        if (.not. allocated(error)) return
        allocate (held)
        held = error
        slot = c_loc(held)
    end subroutine hand_over

    !> The same, and 1 where there is no error, 0 where there is one.
    integer(c_int) function succeeded(error, slot)
        type(error_type), allocatable, intent(in) :: error  !! of the call
        type(c_ptr), intent(out), optional :: slot          !! the caller's handle
        succeeded = merge(0_c_int, 1_c_int, allocated(error))
        call hand_over(error, slot)
    end function succeeded

    !> Makes the error of a handle or an address that is NULL.
    pure subroutine refuse(what, error)
        character(*), intent(in) :: what                    !! `the deck`
        type(error_type), allocatable, intent(out) :: error !! `cause%usage`
        call fail(error, cause%usage, what//' is NULL')
    end subroutine refuse

    !> The interface of the library.
    pure integer(c_int) function loft_abi_version() bind(c, name='loft_abi_version')
        loft_abi_version = abi_version
    end function loft_abi_version

    !> The version of LOFT.
    integer(c_size_t) function c_version(room, bytes) bind(c, name='loft_version')
        character(kind=c_char), intent(inout), optional :: room(*)  !! where it goes
        integer(c_size_t), value :: bytes                           !! there
        c_version = copied(loft_version(), room, bytes)
    end function c_version

    !> The error behind a handle; not associated where the handle is null.
    function error_of(handle) result(error)
        type(c_ptr), intent(in) :: handle !! of C
        type(error_type), pointer :: error
        error => null()
        if (c_associated(handle)) call c_f_pointer(handle, error)
    end function error_of

    !> What kind of failure an error is; 0 for NULL.
    integer(c_int) function loft_error_cause(error) bind(c, name='loft_error_cause') result(why)
        type(c_ptr), value :: error !! a handle, or null
        type(error_type), pointer :: held
        why = 0_c_int
        held => error_of(error)
        if (associated(held)) why = int(held%cause, c_int)
    end function loft_error_cause

    !> What is wrong and what would be right.
    integer(c_size_t) function loft_error_message(error, room, bytes) &
        bind(c, name='loft_error_message') result(length)
        type(c_ptr), value :: error                                 !! a handle, or null
        character(kind=c_char), intent(inout), optional :: room(*)  !! where it goes
        integer(c_size_t), value :: bytes                           !! there
        type(error_type), pointer :: held

        held => error_of(error)
        if (associated(held)) then
            length = copied(held%message, room, bytes)
        else
            length = copied('', room, bytes)
        end if
    end function loft_error_message

    !> Frees an error.
    subroutine loft_error_free(handle) bind(c, name='loft_error_free')
        type(c_ptr), intent(inout), optional :: handle !! becomes NULL
        type(error_type), pointer :: held

        if (.not. present(handle)) return
        held => error_of(handle)
        if (associated(held)) deallocate (held)
        handle = c_null_ptr
    end subroutine loft_error_free

end module api_c_error
