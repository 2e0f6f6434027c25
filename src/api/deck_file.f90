!> A deck as a file: opened, read line by line through a `source_type`, closed.
module api_deck_file
    use, intrinsic :: iso_c_binding, only: c_associated, c_int, c_null_ptr, c_ptr
    use base_error, only: cause, error_type, fail
    use base_posix, only: c_fclose, c_fileno, c_fopen, c_text, last_error, standard_input
    use deck_source, only: source_type
    implicit none (type, external)
    private

    public :: deck_file_type

    !> A deck open for reading.
    type :: deck_file_type
        private
        type(c_ptr) :: stream = c_null_ptr
        logical :: is_standard = .false.
    contains
        procedure :: open => open_deck
        procedure :: close => close_deck
    end type deck_file_type

contains

    !> Opens a deck by name; `-` is standard input.
    !>
    !> Fails with `cause%file_trouble` and the system's words.
    subroutine open_deck(file, name, source, error)
        class(deck_file_type), intent(inout) :: file        !! the file
        character(*), intent(in) :: name                    !! as the user gave it
        type(source_type), intent(inout) :: source          !! will give its lines
        type(error_type), allocatable, intent(out) :: error !! see above

        file%is_standard = name == '-'
        if (file%is_standard) then
            call source%attach(standard_input)
            return
        end if
        file%stream = c_fopen(c_text(name), c_text('r'))
        if (c_associated(file%stream)) then
            call source%attach(c_fileno(file%stream))
        else
            call fail(error, cause%file_trouble, name//': '//trim(last_error()))
        end if
    end subroutine open_deck

    !> Closes a deck, if it is open. Standard input stays as it is.
    subroutine close_deck(file)
        class(deck_file_type), intent(inout) :: file !! the file
        integer(c_int) :: ignored
        if (c_associated(file%stream)) ignored = c_fclose(file%stream)
        file%stream = c_null_ptr
    end subroutine close_deck

end module api_deck_file
