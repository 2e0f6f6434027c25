!> Where finished text goes: a large buffer in front of a descriptor that `app` has opened, or,
!> where there is none, a text kept in memory (tests read it there). Writers put lines and never
!> ask which. The first failure is kept and later puts do nothing, so a writer need not look after
!> each line.
module base_output
    use, intrinsic :: iso_c_binding, only: c_int, c_intptr_t, c_size_t
    use base_error, only: cause, error_type, fail
    use base_kinds, only: i64
    use base_posix, only: c_write, can_try_again, last_error, standard_output, to_write
    implicit none (type, external)
    private

    public :: output_type

    !> Bytes gathered before the system is asked to write.
    integer, parameter :: buffer_size = 65536
    !> Bytes an output in memory has room for at first, and that it keeps when it is emptied.
    integer, parameter :: memory_size = 1024, kept_size = 65536
    !> The descriptor of an output that only gathers.
    integer(c_int), parameter :: memory = -1

    !> A place for text. As declared it gathers in memory; `attach` gives it a descriptor.
    type :: output_type
        private
        integer(c_int) :: descriptor = memory
        character(:), allocatable :: buffer
        integer(i64) :: used = 0
        character(:), allocatable :: trouble
    contains
        procedure :: attach
        procedure :: put
        procedure :: line
        procedure :: lines => put_lines
        procedure :: flush => flush_output
        procedure :: text => gathered_text
        procedure :: has_failed
        procedure :: length => gathered_length
        procedure :: pour
        procedure :: clear => clear_output
    end type output_type

contains

    !> Sends what is put from now on to an open descriptor.
    subroutine attach(out, descriptor)
        class(output_type), intent(inout) :: out   !! the output
        integer(c_int), intent(in) :: descriptor   !! open for writing
        out%descriptor = descriptor
    end subroutine attach

    !> Puts text as it is.
    subroutine put(out, text)
        class(output_type), intent(inout) :: out !! the output
        character(*), intent(in) :: text         !! any bytes

        if (.not. has_room(out, len(text, i64))) call make_room(out, len(text, i64))
        if (allocated(out%trouble)) return
        if (len(text, i64) > len(out%buffer, i64) - out%used) then
            call write_all(out, text)
        else
            out%buffer(out%used + 1:out%used + len(text, i64)) = text
            out%used = out%used + len(text, i64)
        end if
    end subroutine put

    !> Puts a line: the text and a line feed.
    subroutine line(out, text)
        class(output_type), intent(inout) :: out !! the output
        character(*), intent(in) :: text         !! the line
        integer(i64) :: length

        length = len(text, i64) + 1
        if (.not. has_room(out, length)) call make_room(out, length)
        if (allocated(out%trouble)) return
        if (length > len(out%buffer, i64) - out%used) then
            call out%put(text)
            call out%put(new_line('a'))
        else
            out%buffer(out%used + 1:out%used + length - 1) = text
            out%used = out%used + length
            out%buffer(out%used:out%used) = new_line('a')
        end if
    end subroutine line

    !> Puts lines without the blanks at their ends.
    subroutine put_lines(out, lines)
        class(output_type), intent(inout) :: out !! the output
        character(*), intent(in) :: lines(:)     !! the lines
        integer :: i
        do i = 1, size(lines)
            call out%line(trim(lines(i)))
        end do
    end subroutine put_lines

    !> Hands everything to the system.
    !>
    !> Fails with `cause%file_trouble` and the system's words where any byte since the start could
    !> not be written; standard output is named.
    subroutine flush_output(out, error)
        class(output_type), intent(inout) :: out            !! the output
        type(error_type), allocatable, intent(out) :: error !! see above

        if (out%descriptor /= memory) call empty(out)
        if (.not. allocated(out%trouble)) return
        call fail(error, cause%file_trouble, out%trouble)
        if (out%descriptor == standard_output) error%message = 'standard output: '//out%trouble
    end subroutine flush_output

    !> What an output in memory has gathered.
    pure function gathered_text(out) result(text)
        class(output_type), intent(in) :: out !! an output without descriptor
        character(out%used) :: text
        if (allocated(out%buffer)) text = out%buffer(:out%used)
    end function gathered_text

    !> How many bytes an output in memory has gathered.
    pure integer(i64) function gathered_length(out) result(length)
        class(output_type), intent(in) :: out !! an output without descriptor
        length = out%used
    end function gathered_length

    !> Puts a part of what an output in memory has gathered into another output.
    subroutine pour(out, into, first, last)
        class(output_type), intent(in) :: out       !! an output without descriptor
        type(output_type), intent(inout) :: into    !! gets the bytes
        integer(i64), intent(in) :: first           !! first byte, from 1
        integer(i64), intent(in) :: last            !! last byte; before the first: there is none
        if (last >= first) call into%put(out%buffer(first:last))
    end subroutine pour

    !> Empties an output in memory, which keeps its room unless that is large.
    subroutine clear_output(out)
        class(output_type), intent(inout) :: out !! an output without descriptor
        out%used = 0
        if (.not. allocated(out%buffer)) return
        if (len(out%buffer) > kept_size) deallocate (out%buffer)
    end subroutine clear_output

    !> True where something could not be written; there is no use in going on.
    pure logical function has_failed(out)
        class(output_type), intent(in) :: out !! the output
        has_failed = allocated(out%trouble)
    end function has_failed

    !> True where the buffer has room for some bytes.
    pure logical function has_room(out, length)
        class(output_type), intent(in) :: out    !! the output
        integer(i64), intent(in) :: length       !! bytes to come
        has_room = .false.
        if (allocated(out%buffer)) has_room = length <= len(out%buffer, i64) - out%used
    end function has_room

    !> Makes room for some bytes: empties the buffer, or in memory lets it grow.
    subroutine make_room(out, length)
        class(output_type), intent(inout) :: out !! the output
        integer(i64), intent(in) :: length       !! bytes to come
        character(:), allocatable :: grown

        if (.not. allocated(out%buffer)) allocate (character(merge(memory_size, buffer_size, &
            out%descriptor == memory)) :: out%buffer)
        if (has_room(out, length)) return
        if (out%descriptor /= memory) then
            call empty(out)
        else
            allocate (character(2*len(out%buffer, i64) + length) :: grown)
            grown(:out%used) = out%buffer(:out%used)
            call move_alloc(grown, out%buffer)
        end if
    end subroutine make_room

    !> Writes the buffer and leaves it empty.
    subroutine empty(out)
        class(output_type), intent(inout) :: out !! an output with a descriptor
        if (out%used == 0) return
        call write_all(out, out%buffer(:out%used))
        out%used = 0
    end subroutine empty

    !> Writes every byte, however often the system takes only a part.
    subroutine write_all(out, text)
        class(output_type), intent(inout) :: out !! an output with a descriptor
        character(*), intent(in) :: text         !! what to write
        integer(c_intptr_t) :: taken
        integer(i64) :: done

        done = 0
        do while (done < len(text, i64) .and. .not. allocated(out%trouble))
            taken = c_write(out%descriptor, text(done + 1:), int(len(text, i64) - done, c_size_t))
            if (taken > 0) then
                done = done + int(taken, i64)
            else if (taken == 0) then
                out%trouble = 'no byte is taken'
            else if (.not. can_try_again(out%descriptor, to_write)) then
                out%trouble = trim(last_error())
            end if
        end do
    end subroutine write_all

end module base_output
