!> A file read whole, as it is, byte for byte: the deck of a sweep, a journal that is gone on with.
module app_whole_file
    use, intrinsic :: iso_c_binding, only: c_associated, c_int, c_intptr_t, c_ptr, c_size_t
    use base_error, only: cause, error_type, fail
    use base_kinds, only: i64
    use base_posix, only: c_fclose, c_fileno, c_fopen, c_read, c_text, last_error, standard_input
    implicit none (type, external)
    private

    public :: read_whole

    !> Bytes asked of the system at a time, and at most in all.
    integer(i64), parameter :: block_size = 65536, most_bytes = 1024_i64**3

contains

    !> Reads a file to its end; `-` is standard input.
    !>
    !> Fails with `cause%file_trouble` and the system's words, and where it is longer than a
    !> gigabyte.
    subroutine read_whole(name, text, error)
        character(*), intent(in) :: name                    !! as the user gave it
        character(:), allocatable, intent(out) :: text      !! all its bytes
        type(error_type), allocatable, intent(out) :: error !! see above
        type(c_ptr) :: stream
        integer(c_int) :: ignored

        if (name == '-') then
            call read_descriptor(standard_input, text, error)
        else
            stream = c_fopen(c_text(name), c_text('r'))
            if (.not. c_associated(stream)) then
                call fail(error, cause%file_trouble, name//': '//trim(last_error()))
                return
            end if
            call read_descriptor(c_fileno(stream), text, error)
            ignored = c_fclose(stream)
        end if
        if (allocated(error)) error%message = name//': '//error%message
    end subroutine read_whole

    !> Reads what comes from a descriptor.
    subroutine read_descriptor(descriptor, text, error)
        integer(c_int), intent(in) :: descriptor            !! open for reading
        character(:), allocatable, intent(out) :: text      !! all that comes
        type(error_type), allocatable, intent(out) :: error !! see `read_whole`
        character(:), allocatable :: buffer, grown
        integer(i64) :: filled
        integer(c_intptr_t) :: got

        allocate (character(block_size) :: buffer)
        filled = 0
        do
            got = c_read(descriptor, buffer(filled + 1:), int(len(buffer, i64) - filled, c_size_t))
            if (got < 0) call fail(error, cause%file_trouble, trim(last_error()))
            if (got <= 0) exit
            filled = filled + int(got, i64)
            if (filled > most_bytes) then
                call fail(error, cause%file_trouble, 'longer than a gigabyte; it is not read')
                exit
            end if
            if (filled < len(buffer, i64)) cycle
            allocate (character(2*filled) :: grown)
            grown(:filled) = buffer
            call move_alloc(grown, buffer)
        end do
        allocate (character(filled) :: text)
        text = buffer(:filled)
    end subroutine read_descriptor

end module app_whole_file
