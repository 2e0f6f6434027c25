!> The results LOFT writes, which appear under their name only when they are whole.
!>
!> A result is written beside its final name and renamed when complete, so that a reader never sees
!> half of it and a failed run leaves the old one. It keeps the permissions of the file it replaces.
!> A link stays, and the file it leads to is replaced; devices and FIFOs are written through.
module app_files
    use, intrinsic :: iso_c_binding, only: c_associated, c_int, c_null_ptr, c_ptr
    use app_signals, only: guard_file, release_file
    use base_error, only: cause, error_type, fail
    use base_file_facts, only: facts_of_file, file_facts_type
    use base_output, only: output_type
    use base_posix, only: c_access, c_close, c_creat, c_fchmod, c_fclose, c_fileno, c_fopen, &
        c_fsync, c_getpid, c_link, c_mkdir, c_rename, c_text, c_unlink, is_needless, last_error, &
        read_link, standard_error, standard_input, standard_output
    use base_text, only: to_text
    implicit none (type, external)
    private

    public :: result_file_type, hold_standard_files, make_folder, base_name, can_be_replaced

    !> Permissions asked for a new file or folder; the umask takes its part.
    integer(c_int), parameter :: file_mode = int(o'666', c_int), folder_mode = int(o'777', c_int)
    !> What a file must allow to be replaced: that it be written.
    integer(c_int), parameter :: writing = 2
    !> Links that are followed one after the other.
    integer, parameter :: most_links = 40

    !> A result being written.
    type :: result_file_type
        private
        character(:), allocatable :: name       !! as the user gave it; not set: standard output
        character(:), allocatable :: final      !! the name it will have: `name`, links followed
        character(:), allocatable :: unfinished !! the name it has now, where that differs
        character(:), allocatable :: former     !! what had the final name, kept under this one
        integer :: guard = 0                    !! of the unfinished file against signals
        type(c_ptr) :: stream = c_null_ptr      !! of the unfinished file while it is open
        integer(c_int) :: descriptor = standard_output
    contains
        procedure :: begin
        procedure :: finish
        procedure :: publish
        procedure :: complete
        procedure :: abandon
        procedure :: is_device
        procedure :: keep_former
        procedure :: drop_former
        procedure :: take_back
    end type result_file_type

contains

    !> Fills standard input, output and error where they came closed, so that no file opened later
    !> gets the place of one and takes what is meant for it. Reading and writing fail as before:
    !> what is opened can only be written, or only be read.
    subroutine hold_standard_files()
        type(c_ptr) :: stream
        integer(c_int) :: ignored

        stream = c_fopen(c_text('/dev/null'), c_text('w'))
        if (.not. c_associated(stream)) return
        if (c_fileno(stream) /= standard_input) ignored = c_fclose(stream)
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
        type(file_facts_type) :: facts

        if (name /= '' .and. name /= '-') then
            file%name = name
            file%final = followed(name)
            facts = facts_of_file(file%final)
            if (can_be_replaced(name)) then
                call begin_beside(file, facts)
            else
                file%descriptor = c_creat(c_text(file%final), file_mode)
            end if
            if (file%descriptor < 0) then
                call fail(error, cause%file_trouble, name//': '//trim(last_error()))
                file%descriptor = standard_output
                call release_file(file%guard)
                return
            end if
        end if
        call out%attach(file%descriptor)
    end subroutine begin

    !> True for a name that is free or a regular file's, links followed: such a result gets its name
    !> when it is whole.
    logical function can_be_replaced(name)
        character(*), intent(in) :: name !! as the user gave it
        type(file_facts_type) :: facts
        character(:), allocatable :: target

        facts = facts_of_file(followed(name))
        call read_link(followed(name), target)
        can_be_replaced = target == '' .and. (facts%is_regular .or. .not. facts%exists)
    end function can_be_replaced

    !> Begins a result beside its final name, with the permissions of what has that name. What was
    !> left there by a process of the same number that was killed goes; nothing is written through.
    subroutine begin_beside(file, facts)
        class(result_file_type), intent(inout) :: file  !! gets the descriptor, -1 where it fails
        type(file_facts_type), intent(in) :: facts      !! of what has the final name
        integer(c_int) :: ignored

        file%descriptor = -1
        if (facts%exists .and. c_access(c_text(file%final), writing) < 0) return
        file%unfinished = file%final//'.part'//to_text(int(c_getpid()))
        call guard_file(file%unfinished, file%guard)
        ignored = c_unlink(c_text(file%unfinished))
        file%stream = c_fopen(c_text(file%unfinished), c_text('wx'))
        if (.not. c_associated(file%stream)) return
        file%descriptor = c_fileno(file%stream)
        if (facts%exists) ignored = c_fchmod(file%descriptor, facts%permissions)
    end subroutine begin_beside

    !> A path whose last part is no link: what the links say, one after the other. Links of the
    !> system to what a process has open are not followed.
    function followed(name) result(path)
        character(*), intent(in) :: name !! as the user gave it
        character(:), allocatable :: path
        character(:), allocatable :: target
        integer :: i

        path = name
        do i = 1, most_links
            if (index(path, '/dev/') == 1 .or. index(path, '/proc/') == 1) return
            call read_link(path, target)
            if (target == '') return
            if (index(target, '/') /= 1) target = path(:index(path, '/', back=.true.))//target
            path = target
        end do
    end function followed

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
        integer(c_int) :: status

        call out%flush(error)
        if (allocated(file%name)) then
            if (allocated(error)) then
                error%message = file%name//': '//error%message
            else
                call close_whole(file, status)
                if (status < 0) call fail(error, cause%file_trouble, &
                    file%name//': '//trim(last_error()))
            end if
        end if
        if (allocated(error)) call file%abandon()
    end subroutine finish

    !> Closes the file of a result. An unfinished one is brought to the disk first, so that not even
    !> a loss of power leaves less than all of it under the final name.
    subroutine close_whole(file, status)
        class(result_file_type), intent(inout) :: file  !! all of it is written
        integer(c_int), intent(out) :: status           !! -1 where that fails

        status = 0
        if (c_associated(file%stream)) then
            if (c_fsync(file%descriptor) < 0) then
                if (.not. is_needless()) status = -1
            end if
            if (status < 0) return
            status = c_fclose(file%stream)
            file%stream = c_null_ptr
        else
            status = c_close(file%descriptor)
        end if
        file%descriptor = standard_output
    end subroutine close_whole

    !> Gives a finished result its final name.
    !>
    !> Fails with `cause%file_trouble`; the unfinished file is then removed.
    subroutine publish(file, error)
        class(result_file_type), intent(inout) :: file      !! after `finish`
        type(error_type), allocatable, intent(out) :: error !! see above

        if (.not. allocated(file%unfinished)) return
        if (c_rename(c_text(file%unfinished), c_text(file%final)) < 0) then
            call fail(error, cause%file_trouble, file%name//': '//trim(last_error()))
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
        if (c_associated(file%stream)) then
            ignored = c_fclose(file%stream)
        else if (file%descriptor /= standard_output) then
            ignored = c_close(file%descriptor)
        end if
        file%stream = c_null_ptr
        file%descriptor = standard_output
        if (.not. allocated(file%unfinished)) return
        ignored = c_unlink(c_text(file%unfinished))
        call release_file(file%guard)
        deallocate (file%unfinished)
    end subroutine abandon

    !> Keeps what has the final name under another one too, where the file system can do that.
    subroutine keep_former(file)
        class(result_file_type), intent(inout) :: file !! finished
        integer(c_int) :: ignored
        if (.not. allocated(file%unfinished)) return
        file%former = file%final//'.old'//to_text(int(c_getpid()))
        ignored = c_unlink(c_text(file%former))
        if (c_link(c_text(file%final), c_text(file%former)) < 0) deallocate (file%former)
    end subroutine keep_former

    !> What had the final name is no longer needed.
    subroutine drop_former(file)
        class(result_file_type), intent(inout) :: file !! after `keep_former`
        integer(c_int) :: ignored
        if (.not. allocated(file%former)) return
        ignored = c_unlink(c_text(file%former))
        deallocate (file%former)
    end subroutine drop_former

    !> Takes a published result back: what had the name before has it again.
    subroutine take_back(file)
        class(result_file_type), intent(inout) :: file !! after `keep_former` and `publish`
        integer(c_int) :: ignored
        if (.not. allocated(file%final) .or. allocated(file%unfinished)) return
        if (allocated(file%former)) then
            ignored = c_rename(c_text(file%former), c_text(file%final))
            deallocate (file%former)
        else
            ignored = c_unlink(c_text(file%final))
        end if
    end subroutine take_back

    !> True for a result that has no folder in which anything could stand beside it: a device or
    !> FIFO, or standard output, also as `/dev/stdout`.
    logical function is_device(file)
        class(result_file_type), intent(in) :: file !! begun
        is_device = .not. allocated(file%unfinished)
    end function is_device

    !> Makes a folder where there is none.
    !>
    !> Fails with `cause%file_trouble` and the system's words.
    subroutine make_folder(name, error)
        character(*), intent(in) :: name                    !! path of the folder
        type(error_type), allocatable, intent(out) :: error !! see above
        character(:), allocatable :: trouble
        type(file_facts_type) :: facts

        if (c_mkdir(c_text(name), folder_mode) == 0) return
        trouble = trim(last_error())
        facts = facts_of_file(name)
        if (.not. facts%is_folder) call fail(error, cause%file_trouble, name//': '//trouble)
    end subroutine make_folder

    !> The last part of a path: `cards/nose.crd` is `nose.crd`.
    pure function base_name(path) result(name)
        character(*), intent(in) :: path !! any path
        character(:), allocatable :: name
        name = path(index(path, '/', back=.true.) + 1:)
    end function base_name

end module app_files
