!> The results LOFT writes, which appear under their name only when they are whole.
!>
!> A result is written beside its final name and renamed when complete, so that a reader never sees
!> half of it and a failed run leaves the old one. Devices, FIFOs and links are written through.
module app_files
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_int, c_int64_t, c_intptr_t, &
        c_ptr, c_size_t
    use app_signals, only: guard_file, release_file
    use base_error, only: cause, error_type, fail
    use base_output, only: output_type
    use base_posix, only: c_close, c_creat, c_fclose, c_fileno, c_fopen, c_getpid, c_mkdir, &
        c_readlink, c_rename, c_text, c_truncate, c_unlink, last_error, real_path, &
        standard_error, standard_output
    use base_text, only: to_text
    implicit none (type, external)
    private

    public :: result_file_type, hold_standard_files, make_folder, base_name

    !> Permissions asked for a new file or folder; the umask takes its part.
    integer(c_int), parameter :: file_mode = int(o'666', c_int), folder_mode = int(o'777', c_int)

    !> A result being written.
    type :: result_file_type
        private
        character(:), allocatable :: final     !! the name it will have; not set: standard output
        character(:), allocatable :: unfinished !! the name it has now, where that differs
        integer :: guard = 0                    !! of the unfinished file against signals
        integer(c_int) :: descriptor = standard_output
    contains
        procedure :: begin
        procedure :: finish
        procedure :: publish
        procedure :: complete
        procedure :: abandon
        procedure :: is_device
    end type result_file_type

contains

    !> Fills standard input, output and error where they came closed, so that no file opened later
    !> gets the place of one and takes what is meant for it. Writing to them fails as before.
    subroutine hold_standard_files()
        type(c_ptr) :: stream
        integer(c_int) :: ignored
        do
            stream = c_fopen(c_text('/dev/null'), c_text('r'))
            if (.not. c_associated(stream)) return
            if (c_fileno(stream) > standard_error) exit
        end do
        ignored = c_fclose(stream)
    end subroutine hold_standard_files

    !> Begins a result; without a name, or as `-`, it goes to standard output.
    !>
    !> Fails with `cause%file_trouble` and the system's words.
    subroutine begin(file, name, out, error)
        class(result_file_type), intent(inout) :: file      !! the file
        character(*), intent(in) :: name                    !! as the user gave it; may be empty
        type(output_type), intent(inout) :: out             !! what is put there goes to the file
        type(error_type), allocatable, intent(out) :: error !! see above
        character(:), allocatable :: path

        path = name
        if (name /= '' .and. name /= '-') then
            file%final = name
            if (can_be_replaced(name)) then
                path = name//'.part'//to_text(int(c_getpid()))
                file%unfinished = path
                call guard_file(path, file%guard)
            end if
            file%descriptor = c_creat(c_text(path), file_mode)
            if (file%descriptor < 0) then
                call fail(error, cause%file_trouble, name//': '//last_error())
                call release_file(file%guard)
                return
            end if
        end if
        call out%attach(file%descriptor)
    end subroutine begin

    !> Ends a result: all of it is handed over and it gets its final name.
    !>
    !> Fails with `cause%file_trouble` where any part could not be written; the unfinished file is
    !> then removed.
    subroutine complete(file, out, error)
        class(result_file_type), intent(inout) :: file      !! the file
        type(output_type), intent(inout) :: out             !! as `begin` had it
        type(error_type), allocatable, intent(out) :: error !! see above
        call file%finish(out, error)
        if (.not. allocated(error)) call file%publish(error)
    end subroutine complete

    !> Hands over all of a result; it has not yet its final name.
    !>
    !> Fails with `cause%file_trouble` where any part could not be written; the unfinished file is
    !> then removed.
    subroutine finish(file, out, error)
        class(result_file_type), intent(inout) :: file      !! the file
        type(output_type), intent(inout) :: out             !! as `begin` had it
        type(error_type), allocatable, intent(out) :: error !! see above
        character(:), allocatable :: name
        integer(c_int) :: status

        name = 'standard output'
        if (allocated(file%final)) name = file%final
        call out%flush(error)
        if (allocated(error)) then
            error%message = name//': '//error%message
        else if (allocated(file%final)) then
            status = c_close(file%descriptor)
            if (status < 0) call fail(error, cause%file_trouble, name//': '//last_error())
            file%descriptor = standard_output
        end if
        if (allocated(error)) call file%abandon()
    end subroutine finish

    !> Gives a finished result its final name.
    !>
    !> Fails with `cause%file_trouble`; the unfinished file is then removed.
    subroutine publish(file, error)
        class(result_file_type), intent(inout) :: file      !! after `finish`
        type(error_type), allocatable, intent(out) :: error !! see above

        if (.not. allocated(file%unfinished)) return
        if (c_rename(c_text(file%unfinished), c_text(file%final)) < 0) then
            call fail(error, cause%file_trouble, file%final//': '//last_error())
            call file%abandon()
            return
        end if
        call release_file(file%guard)
        deallocate (file%unfinished)
    end subroutine publish

    !> Gives a result up: what was written is removed, what had the name before stays.
    subroutine abandon(file)
        class(result_file_type), intent(inout) :: file !! the file
        integer(c_int) :: ignored
        if (file%descriptor /= standard_output) ignored = c_close(file%descriptor)
        file%descriptor = standard_output
        if (.not. allocated(file%unfinished)) return
        ignored = c_unlink(c_text(file%unfinished))
        call release_file(file%guard)
        deallocate (file%unfinished)
    end subroutine abandon

    !> True for a result that is no regular file, nor a link: a device or FIFO, or standard output,
    !> also as `/dev/stdout`. It has no folder in which anything could stand beside it.
    logical function is_device(file)
        class(result_file_type), intent(in) :: file !! begun
        is_device = .not. allocated(file%final)
        if (is_device .or. allocated(file%unfinished)) return
        is_device = index(file%final, '/dev/') == 1 .or. &
            .not. can_be_replaced(real_path(file%final))
    end function is_device

    !> True where a name is free or a regular file's, which a rename may replace. Only a regular
    !> file has a length that can be set (here to what it is), and only a link can be read as one.
    logical function can_be_replaced(name)
        character(*), intent(in) :: name !! a path
        character(kind=c_char) :: target(1)
        integer(c_int64_t) :: length
        logical :: exists

        can_be_replaced = c_readlink(c_text(name), target, 1_c_size_t) < 0_c_intptr_t
        if (.not. can_be_replaced) return
        inquire (file=name, exist=exists, size=length)
        if (exists) can_be_replaced = c_truncate(c_text(name), length) == 0
    end function can_be_replaced

    !> Makes a folder where there is none.
    !>
    !> Fails with `cause%file_trouble` and the system's words.
    subroutine make_folder(name, error)
        character(*), intent(in) :: name                    !! path of the folder
        type(error_type), allocatable, intent(out) :: error !! see above
        character(:), allocatable :: trouble
        logical :: exists

        if (c_mkdir(c_text(name), folder_mode) == 0) return
        trouble = last_error()
        inquire (file=name//'/.', exist=exists)
        if (.not. exists) call fail(error, cause%file_trouble, name//': '//trouble)
    end subroutine make_folder

    !> The last part of a path: `cards/nose.crd` is `nose.crd`.
    pure function base_name(path) result(name)
        character(*), intent(in) :: path !! any path
        character(:), allocatable :: name
        name = path(index(path, '/', back=.true.) + 1:)
    end function base_name

end module app_files
