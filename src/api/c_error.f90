!> Errors as handles of C, and the version; see `loft.h`.
module api_c_error
    use, intrinsic :: iso_c_binding, only: c_associated, c_f_pointer, c_int, c_loc, c_null_ptr, &
        c_ptr, c_size_t
    use api_c_text, only: copied
    use api_loft, only: cause, error_type, loft_version
    use base_error, only: fail
    implicit none (type, external)
    private

    public :: hand_over, refuse, loft_abi_version, c_version
    public :: loft_error_cause, loft_error_message, loft_error_free

    !> The interface that `loft.h` describes: LOFT_ABI_VERSION there, and the number of the shared
    !> library.
    integer(c_int), parameter :: abi_version = 1_c_int

contains

    !> Hands an error over to the caller, or says that there is none.
    subroutine hand_over(error, slot)
        type(error_type), allocatable, intent(in) :: error  !! of the call
        type(c_ptr), intent(in) :: slot                     !! the caller's handle, or null
        type(error_type), pointer :: held
        type(c_ptr), pointer :: handle

        if (.not. c_associated(slot)) return
        call c_f_pointer(slot, handle)
        handle = c_null_ptr
        if (.not. allocated(error)) return
        allocate (held)
        held = error
        handle = c_loc(held)
    end subroutine hand_over

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
        type(c_ptr), value :: room              !! where it goes, or null
        integer(c_size_t), value :: bytes       !! there
        c_version = copied(loft_version(), room, bytes)
    end function c_version

    !> What kind of failure an error is; 0 for NULL.
    integer(c_int) function loft_error_cause(error) bind(c, name='loft_error_cause') result(why)
        type(c_ptr), value :: error !! a handle, or null
        type(error_type), pointer :: held

        why = 0_c_int
        if (.not. c_associated(error)) return
        call c_f_pointer(error, held)
        why = int(held%cause, c_int)
    end function loft_error_cause

    !> What is wrong and what would be right.
    integer(c_size_t) function loft_error_message(error, room, bytes) &
        bind(c, name='loft_error_message') result(length)
        type(c_ptr), value :: error             !! a handle, or null
        type(c_ptr), value :: room              !! where it goes, or null
        integer(c_size_t), value :: bytes       !! there
        type(error_type), pointer :: held
        character(:), allocatable :: text

        text = ''
        if (c_associated(error)) then
            call c_f_pointer(error, held)
            text = held%message
        end if
        length = copied(text, room, bytes)
    end function loft_error_message

    !> Frees an error.
    subroutine loft_error_free(slot) bind(c, name='loft_error_free')
        type(c_ptr), value :: slot !! address of the handle, which becomes NULL
        type(error_type), pointer :: held
        type(c_ptr), pointer :: handle

        if (.not. c_associated(slot)) return
        call c_f_pointer(slot, handle)
        if (.not. c_associated(handle)) return
        call c_f_pointer(handle, held)
        deallocate (held)
        handle = c_null_ptr
    end subroutine loft_error_free

end module api_c_error
