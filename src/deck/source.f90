!> Lines of a deck as they arrive: bytes from a descriptor that `app` has opened, cut at line feeds.
!> Only one line is held, and of that no more than any card can use, so memory stays the same
!> however long the deck or the line.
!>
!> A carriage return before the line feed and a byte order mark at the very start belong to the
!> file, not to a card, and are taken off. A last line without line feed counts.
module deck_source
    use, intrinsic :: iso_c_binding, only: c_int, c_intptr_t, c_size_t
    use base_error, only: cause, error_type, fail
    use base_kinds, only: i64
    use base_posix, only: c_read, can_try_again, last_error, to_read
    use base_sha256, only: sha256_type
    implicit none (type, external)
    private

    public :: source_type, line_type

    !> Bytes asked of the system at a time.
    integer, parameter :: block_size = 65536
    !> Bytes of a line that are kept; the rest is only counted.
    integer, parameter, public :: kept_length = 1024
    !> Descriptor of a source that is a text in memory.
    integer(c_int), parameter :: memory = -1

    !> One line of a file.
    type :: line_type
        character(:), allocatable :: text   !! the first `kept_length` bytes
        integer(i64) :: number = 0          !! line of the file, from 1
        integer(i64) :: length = 0          !! bytes in the whole line
        integer :: filled = 0               !! the last byte of it that is not a blank
        logical :: has_null = .false.       !! a null byte was met: this is no text file
        logical :: has_control = .false.    !! a control byte was met: a tab, say
    end type line_type

    !> Where the lines come from.
    type :: source_type
        private
        integer(c_int) :: descriptor = memory
        character(:), allocatable :: block
        integer(i64) :: next = 1
        integer(i64) :: filled = 0
        integer(i64) :: lines = 0
        logical :: at_end = .false.
        character(:), allocatable :: trouble
        type(line_type), allocatable :: waiting(:)
        type(sha256_type), allocatable :: sum
    contains
        procedure :: attach
        procedure :: from_text
        procedure :: begin_checksum
        procedure :: read_checksum
        procedure :: next_line
        procedure :: has_line
        procedure :: put_back
    end type source_type

contains

    !> Takes lines from an open descriptor.
    subroutine attach(source, descriptor)
        class(source_type), intent(inout) :: source !! the source
        integer(c_int), intent(in) :: descriptor    !! open for reading
        source%descriptor = descriptor
        allocate (character(block_size) :: source%block)
    end subroutine attach

    !> Takes lines from a text in memory.
    subroutine from_text(source, text)
        class(source_type), intent(inout) :: source !! the source
        character(*), intent(in) :: text            !! lines with line feeds between them
        source%block = text
        source%filled = len(text, i64)
    end subroutine from_text

    !> From now on all bytes that are read are summed up; nothing may have been read yet.
    pure subroutine begin_checksum(source)
        class(source_type), intent(inout) :: source !! has its descriptor or its text
        allocate (source%sum)
        call source%sum%take(source%block(:source%filled))
    end subroutine begin_checksum

    !> The SHA-256 of all bytes of a source, after `begin_checksum`: what has not been read yet is
    !> read to its end and passed over.
    !>
    !> Fails with `cause%file_trouble` and the system's words where the source can't be read.
    subroutine read_checksum(source, checksum, error)
        class(source_type), intent(inout) :: source         !! the source
        character(64), intent(out) :: checksum              !! as `sha256sum` prints it
        type(error_type), allocatable, intent(out) :: error !! see above

        do while (.not. source%at_end)
            call refill(source)
        end do
        checksum = source%sum%hex()
        if (allocated(source%trouble)) call fail(error, cause%file_trouble, source%trouble)
    end subroutine read_checksum

    !> Reads the next line.
    !>
    !> Fails with `cause%file_trouble` and the system's words where the source can't be read.
    subroutine next_line(source, line, found, error)
        class(source_type), intent(inout) :: source         !! the source
        type(line_type), intent(out) :: line                !! the line, where one was found
        logical, intent(out) :: found                       !! false after the last line
        type(error_type), allocatable, intent(out) :: error !! see above
        integer(i64) :: last

        line%text = ''
        found = .false.
        if (allocated(source%waiting)) then
            call take_waiting(source%waiting, line)
            found = .true.
            return
        end if
        do
            if (source%next > source%filled) call refill(source)
            if (source%at_end) exit
            found = .true.
            last = line_end(source)
            call gather(line, source%block(source%next:last - 1))
            source%next = last + 1
            if (last <= source%filled .or. line%has_null) exit
        end do
        if (allocated(source%trouble)) call fail(error, cause%file_trouble, source%trouble)
        if (.not. found) return
        source%lines = source%lines + 1
        line%number = source%lines
        call strip(line)
    end subroutine next_line

    !> True where a whole line is at hand: the next can be had without waiting for it.
    pure logical function has_line(source)
        class(source_type), intent(in) :: source !! the source
        has_line = allocated(source%waiting) .or. line_end(source) <= source%filled
    end function has_line

    !> Where the next line feed stands in the block; behind the block where there is none.
    pure integer(i64) function line_end(source) result(last)
        class(source_type), intent(in) :: source !! the source
        do last = source%next, source%filled
            if (source%block(last:last) == new_line('a')) return
        end do
    end function line_end

    !> Puts a line back: it is the next to be read again. Of several the last comes first.
    subroutine put_back(source, line)
        class(source_type), intent(inout) :: source !! the source
        type(line_type), intent(in) :: line         !! a line read from it
        type(line_type), allocatable :: waiting(:)
        integer :: count

        count = 0
        if (allocated(source%waiting)) count = size(source%waiting)
        allocate (waiting(count + 1))
        if (count > 0) waiting(:count) = source%waiting
        waiting(count + 1) = line
        call move_alloc(waiting, source%waiting)
    end subroutine put_back

    !> Takes the line that was put back last.
    subroutine take_waiting(waiting, line)
        type(line_type), allocatable, intent(inout) :: waiting(:) !! the lines; emptied: none
        type(line_type), intent(inout) :: line                      !! the line
        type(line_type), allocatable :: others(:)
        integer :: count

        count = size(waiting)
        line = waiting(count)
        if (count > 1) then
            allocate (others(count - 1))
            others = waiting(:count - 1)
        end if
        call move_alloc(others, waiting)
    end subroutine take_waiting

    !> Asks the system for more bytes.
    subroutine refill(source)
        class(source_type), intent(inout) :: source !! the source
        integer(c_intptr_t) :: got

        source%next = 1
        source%filled = 0
        if (source%descriptor /= memory .and. .not. source%at_end) then
            do
                got = c_read(source%descriptor, source%block, int(block_size, c_size_t))
                if (got >= 0) exit
                if (.not. can_try_again(source%descriptor, to_read)) exit
            end do
            if (got < 0) source%trouble = trim(last_error())
            source%filled = max(0_i64, int(got, i64))
            if (allocated(source%sum)) call source%sum%take(source%block(:source%filled))
        end if
        source%at_end = source%filled == 0
    end subroutine refill

    !> Adds a piece to a line: the text as far as it is kept, the length in full.
    pure subroutine gather(line, piece)
        type(line_type), intent(inout) :: line !! the line so far
        character(*), intent(in) :: piece      !! what follows
        integer(i64) :: room, i

        room = max(0_i64, kept_length - line%length)
        if (line%length == 0) then
            line%text = piece(:min(room, len(piece, i64)))
        else
            line%text = line%text//piece(:min(room, len(piece, i64)))
        end if
        do i = len(piece, i64), 1_i64, -1_i64
            if (piece(i:i) /= ' ') exit
        end do
        if (i > 0) line%filled = int(min(line%length + i, int(huge(line%filled), i64)))
        do i = 1, len(piece, i64)
            if (piece(i:i) >= ' ') cycle
            line%has_control = .true.
            if (piece(i:i) == achar(0)) line%has_null = .true.
        end do
        line%length = line%length + len(piece, i64)
    end subroutine gather

    !> Takes off what belongs to the file: a carriage return at the end, a byte order mark in front.
    pure subroutine strip(line)
        type(line_type), intent(inout) :: line !! a whole line
        character(3), parameter :: mark = char(239)//char(187)//char(191)
        character, parameter :: carriage_return = achar(13)

        if (line%length > 0 .and. line%length <= kept_length) then
            if (line%text(line%length:) == carriage_return) then
                line%length = line%length - 1
                line%text = line%text(:line%length)
                line%filled = len_trim(line%text)
            end if
        end if
        if (line%number == 1 .and. index(line%text, mark) == 1) then
            line%text = line%text(4:)
            line%length = line%length - 3
            line%filled = line%filled - 3
        end if
    end subroutine strip

end module deck_source
