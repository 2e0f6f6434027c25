!> The figures that SAE 700202 prints, as golden/book/ holds them, and how far a scan is from them.
module support_book
    use base_kinds, only: dp
    use base_text, only: columns
    implicit none (type, external)
    private

    public :: figure_type, read_figures, read_coefficients, text_file, characters_wrong

    !> A field of golden/book/*.csv is no longer than this.
    integer, parameter :: field_length = 24

    !> One figure of the book.
    type :: figure_type
        character(1) :: table = ''              !! 2 or 4
        character(field_length) :: line = ''    !! name of its line or section: `MHB side`
        character(1) :: axis = ''               !! X or Y, which was stepped; blank: a coefficient
        character(field_length) :: along = ''   !! stepped ordinate as printed; letter A to E
        character(field_length) :: column = ''  !! root1 or root2 of the 1970 page
        character(field_length) :: scanned = '' !! as it stands in the scan
        character(field_length) :: restored = '' !! as it was printed
    contains
        procedure :: place
    end type figure_type

contains

    !> The ordinates of tables 2 and 4, in the order of the file.
    function read_figures(path) result(figures)
        character(*), intent(in) :: path !! golden/book/tables.csv
        type(figure_type), allocatable :: figures(:)
        character(field_length) :: field(7)
        character(:), allocatable :: text
        integer :: at

        text = text_file(path)
        at = 1
        allocate (figures(0))
        call next_record(text, at, field)
        do while (at <= len(text))
            call next_record(text, at, field)
            figures = [figures, figure_type(field(1)(1:1), field(2), field(3)(1:1), field(4), &
                field(5), field(6), field(7))]
        end do
    end function read_figures

    !> The coefficients that table 2 prints of its first line.
    function read_coefficients(path) result(figures)
        character(*), intent(in) :: path !! golden/book/inputs.csv
        type(figure_type), allocatable :: figures(:)
        character(field_length) :: field(5)
        character(:), allocatable :: text
        integer :: at

        text = text_file(path)
        at = 1
        allocate (figures(0))
        do while (at <= len(text))
            call next_record(text, at, field)
            if (field(1) /= '2' .or. len_trim(field(3)) > 1) cycle
            figures = [figures, figure_type('2', field(2), '', field(3), '', field(4), field(5))]
        end do
    end function read_coefficients

    !> The stepped ordinate of a figure as a number, deck units.
    real(dp) function place(figure)
        class(figure_type), intent(in) :: figure !! an ordinate, no coefficient
        read (figure%along, *) place
    end function place

    !> A whole file as one text.
    function text_file(path) result(text)
        character(*), intent(in) :: path !! a file that is there
        character(:), allocatable :: text
        integer :: unit, length
        open (newunit=unit, file=path, access='stream', form='unformatted', action='read', &
            status='old')
        inquire (unit=unit, size=length)
        allocate (character(length) :: text)
        read (unit) text
        close (unit)
    end function text_file

    !> Takes the fields of the next line apart at their commas.
    subroutine next_record(text, at, field)
        character(*), intent(in) :: text            !! the file
        integer, intent(inout) :: at                !! where the line begins; then the next one
        character(*), intent(out) :: field(:)       !! its fields
        integer :: i, line_end, last

        line_end = index(text(at:)//new_line('a'), new_line('a')) + at - 2
        do i = 1, size(field)
            last = index(text(at:line_end)//',', ',') + at - 2
            field(i) = text(at:last)
            at = min(last + 2, line_end + 1)
        end do
        at = line_end + 2
    end subroutine next_record

    !> How many characters must be changed, put in or taken out to make one text the other.
    !>
    !> Source: V. I. Levenshtein, "Binary codes capable of correcting deletions, insertions and
    !> reversals", Soviet Physics Doklady 10 (1966), pp. 707-710.
    pure integer function characters_wrong(scanned, restored) result(wrong)
        character(*), intent(in) :: scanned  !! a figure; blanks at its end do not count
        character(*), intent(in) :: restored !! the same figure as it should be
        integer :: row(0:len(restored)), corner, above, i, j

        row = [(j, j=0, len(restored))]
        do i = 1, len_trim(scanned)
            corner = row(0)
            row(0) = i
            do j = 1, len_trim(restored)
                above = row(j)
                row(j) = min(above + 1, row(j - 1) + 1, &
                    corner + merge(0, 1, columns(scanned, i, i) == columns(restored, j, j)))
                corner = above
            end do
        end do
        wrong = row(len_trim(restored))
    end function characters_wrong

end module support_book
