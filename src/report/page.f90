!> Pages of a listing: a heading on each, page numbers, a form feed between two, and no line that
!> is lost because a page was full.
module report_page
    use base_constants, only: version
    use base_figures, only: put_text, put_whole
    use base_kinds, only: i64
    use base_output, only: output_type
    use base_text, only: characters, first_bytes, printable
    implicit none (type, external)
    private

    public :: page_type

    !> Columns of a page, and of the widest page.
    integer, parameter, public :: page_columns = 80, widest_page = 132
    !> Lines of a page, heading and foot margin included, as on the 11-inch form at 6 lines an inch.
    integer, parameter :: page_lines = 60
    !> What stands for the rest of a text that is cut.
    character(*), parameter :: cut = '...'
    !> A column heading has at most so many lines.
    integer, parameter :: most_heads = 2

    !> A listing being printed.
    type :: page_type
        private
        character(:), allocatable :: title      !! first line of every page, left
        character(:), allocatable :: deck       !! second line, left
        character(:), allocatable :: units      !! second line, middle
        character(:), allocatable :: below      !! second line and the blank one, as they are put
        integer :: number = 0                   !! of the present page
        integer :: columns = page_columns       !! of a page
        integer :: lines = page_lines           !! of a page
        integer :: used = widest_page*page_lines !! lines of this one filled; none is begun
        integer :: heads = 0                    !! lines of column heading in force
        character(widest_page) :: head(most_heads) = '' !! these
        integer(i64) :: filled(most_heads) = 0  !! columns of each, without blanks at its end
    contains
        procedure :: set_heading
        procedure :: set_size
        procedure :: width
        procedure :: line
        procedure :: paragraph
        procedure :: blank
        procedure :: keep
        procedure :: kept_lines
        procedure :: equal_lines
        procedure :: set_columns
        procedure :: end_columns
    end type page_type

contains

    !> Says what stands at the head of every page.
    subroutine set_heading(page, title, deck, units)
        class(page_type), intent(inout) :: page !! the listing
        character(*), intent(in) :: title       !! of the deck, or nothing
        character(*), intent(in) :: deck        !! name of the deck
        character(*), intent(in) :: units       !! unit of its numbers
        page%title = title
        page%deck = deck
        page%units = units
        if (allocated(page%below)) deallocate (page%below)
    end subroutine set_heading

    !> Says how large a page is; 80 columns and 60 lines unless said.
    subroutine set_size(page, columns, lines)
        class(page_type), intent(inout) :: page !! the listing, nothing printed yet
        integer, intent(in) :: columns          !! at most `widest_page`
        integer, intent(in) :: lines            !! heading included
        page%columns = columns
        page%lines = lines
        if (allocated(page%below)) deallocate (page%below)
    end subroutine set_size

    !> Columns of a page.
    pure integer function width(page)
        class(page_type), intent(in) :: page !! the listing
        width = page%columns
    end function width

    !> Prints a line, on a new page where this one is full. A control byte shows as `?`.
    subroutine line(page, out, text)
        class(page_type), intent(inout) :: page !! the listing
        type(output_type), intent(inout) :: out !! where it goes
        character(*), intent(in) :: text        !! the line
        if (page%used >= page%lines) call turn(page, out)
        call out%line(trim(printable(text)))
        page%used = page%used + 1
    end subroutine line

    !> Prints a sentence of any length, broken between words.
    subroutine paragraph(page, out, text)
        class(page_type), intent(inout) :: page !! the listing
        type(output_type), intent(inout) :: out !! where it goes
        character(*), intent(in) :: text        !! one or more sentences
        character(:), allocatable :: rest
        integer :: last

        rest = trim(text)
        do while (len(rest) > page%columns)
            last = index(rest(:page%columns + 1), ' ', back=.true.) - 1
            if (last <= 2) last = page%columns
            call page%line(out, rest(:last))
            rest = '  '//adjustl(rest(last + 1:))
            rest = trim(rest)
        end do
        call page%line(out, rest)
    end subroutine paragraph

    !> Prints blank lines; at the foot of a page they are left out.
    subroutine blank(page, out)
        class(page_type), intent(inout) :: page !! the listing
        type(output_type), intent(inout) :: out !! where it goes
        if (page%used >= page%lines) return
        call out%line('')
        page%used = page%used + 1
    end subroutine blank

    !> Turns the page unless some lines still fit on it.
    subroutine keep(page, out, lines)
        class(page_type), intent(inout) :: page !! the listing
        type(output_type), intent(inout) :: out !! where it goes
        integer, intent(in) :: lines            !! lines that belong together
        if (page%used + lines > page%lines) call turn(page, out)
    end subroutine keep

    !> Prints lines for which `keep` has made room, from the beginning of a text.
    subroutine kept_lines(page, out, text, bytes, lines)
        class(page_type), intent(inout) :: page !! the listing
        type(output_type), intent(inout) :: out !! where they go
        type(output_type), intent(in) :: text   !! has them; nothing in them but what prints
        integer(i64), intent(in) :: bytes       !! of all of them, line feeds included
        integer, intent(in) :: lines            !! how many
        call text%pour(out, 1_i64, bytes)
        page%used = page%used + lines
    end subroutine kept_lines

    !> Prints lines of equal length, as many on a page as fit.
    subroutine equal_lines(page, out, text, before, length, lines)
        class(page_type), intent(inout) :: page !! the listing
        type(output_type), intent(inout) :: out !! where they go
        type(output_type), intent(in) :: text   !! has them; nothing in them but what prints
        integer(i64), intent(in) :: before      !! bytes of the text in front of them
        integer, intent(in) :: length           !! bytes of each, its line feed included
        integer, intent(in) :: lines            !! how many
        integer :: done, fitting

        done = 0
        do while (done < lines)
            if (page%used >= page%lines) call turn(page, out)
            fitting = min(lines - done, page%lines - page%used)
            call text%pour(out, before + int(done, i64)*int(length, i64) + 1_i64, &
                before + int(done + fitting, i64)*int(length, i64))
            page%used = page%used + fitting
            done = done + fitting
        end do
    end subroutine equal_lines

    !> Prints a column heading and repeats it on every page from now on.
    subroutine set_columns(page, out, head)
        class(page_type), intent(inout) :: page !! the listing
        type(output_type), intent(inout) :: out !! where it goes
        character(*), intent(in) :: head(:)     !! its lines, at most `most_heads`
        integer :: i
        page%heads = 0
        call page%keep(out, size(head) + 2)
        page%heads = size(head)
        do i = 1, page%heads
            if (page%head(i) == head(i)) cycle
            page%head(i) = printable(head(i))
            page%filled(i) = len_trim(page%head(i), i64)
        end do
        call put_heads(page, out)
    end subroutine set_columns

    !> Prints the column heading in force; there is room for it.
    subroutine put_heads(page, out)
        class(page_type), intent(inout) :: page !! the listing
        type(output_type), intent(inout) :: out !! where it goes
        integer :: i
        do i = 1, page%heads
            call out%line(page%head(i)(:page%filled(i)))
        end do
        page%used = page%used + page%heads
    end subroutine put_heads

    !> Ends the table whose column heading is in force.
    subroutine end_columns(page)
        class(page_type), intent(inout) :: page !! the listing
        page%heads = 0
    end subroutine end_columns

    !> Begins a page.
    subroutine turn(page, out)
        class(page_type), intent(inout) :: page !! the listing
        type(output_type), intent(inout) :: out !! where it goes
        type(output_type) :: below
        character(16) :: number
        integer :: next

        page%number = page%number + 1
        if (page%number > 1) call out%put(achar(12))
        next = 1
        call put_text('PAGE ', number, next)
        call put_whole(int(page%number, i64), number, next)
        call put_spread(page, out, page%title, '', number(:next - 1))
        if (.not. allocated(page%below)) then
            call put_spread(page, below, page%deck, page%units, 'LOFT '//version)
            call below%line('')
            page%below = below%text()
        end if
        call out%put(page%below)
        page%used = 3
        call put_heads(page, out)
    end subroutine turn

    !> Puts three texts on one line of a page: left, middle, right. The left text is cut where there
    !> is no room for it. Its characters are counted, not its bytes, since a title may be in UTF-8.
    subroutine put_spread(page, out, left, middle, right)
        type(page_type), intent(in) :: page     !! the listing
        type(output_type), intent(inout) :: out !! where it goes
        character(*), intent(in) :: left        !! begins the line
        character(*), intent(in) :: middle      !! about column 40, or nothing
        character(*), intent(in) :: right       !! ends the line
        character(*), parameter :: blanks = repeat(' ', widest_page)
        integer :: room, used

        room = page%columns - len(right) - 1
        if (middle /= '') room = room - len(middle) - 2
        used = characters(left)
        if (used <= room) then
            call out%put(left)
        else
            call out%put(left(:first_bytes(left, room - len(cut))))
            call out%put(cut)
            used = room
        end if
        if (middle /= '') then
            room = max(2, page%columns/2 - used)
            call out%put(blanks(:int(room, i64)))
            call out%put(middle)
            used = used + room + characters(middle)
        end if
        call out%put(blanks(:int(page%columns - used - len(right), i64)))
        call out%line(right)
    end subroutine put_spread

end module report_page
