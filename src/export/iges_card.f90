!> The card images of an IGES file: 80 columns, of which 73 has the letter of the section and 74 to
!> 80 the number of the card in it (IGES 5.3, 2.2.1).
!>
!>     +---------- 1 to 72: data ---------------------------------------------+-------+
!>     110,0.,0.,0.,1.,2.5,0.;                                               5P      3
!>     +---------- 1 to 64: data in section P ------------------------+ 66-72-P
!>
!> Free format goes on from card to card. A number and its comma stay on one card, and so do the
!> count of a text, its H and its first character; the rest of a text goes on in column 1.
module export_iges_card
    use base_output, only: output_type
    use base_text, only: right, to_text
    implicit none (type, external)
    private

    public :: section_type

    !> A section, as far as it is written.
    type :: section_type
        character :: letter = 'S'       !! S, G, D, P or T
        integer :: count = 0            !! cards so far
        type(output_type), private :: images
    contains
        procedure :: put_card
        procedure :: put_free
        procedure :: text
    end type section_type

    !> Columns for data, with and without a pointer behind them.
    integer, parameter :: data_columns = 72, pointed_columns = 64

contains

    !> Puts a card.
    subroutine put_card(section, data)
        class(section_type), intent(inout) :: section   !! the section
        character(*), intent(in) :: data                !! columns 1 to 72
        character(data_columns) :: padded

        padded = data
        section%count = section%count + 1
        call section%images%line(padded//section%letter//right(to_text(section%count), 7))
    end subroutine put_card

    !> Puts a record in free format on as many cards as it needs, in section P with the pointer to
    !> its entity behind each.
    subroutine put_free(section, record, pointer)
        class(section_type), intent(inout) :: section   !! the section
        character(*), intent(in) :: record              !! with its commas and semicolon
        integer, intent(in), optional :: pointer        !! to the entity, in section P
        character(data_columns) :: data
        integer :: width, first, last, open

        width = data_columns
        if (present(pointer)) width = pointed_columns
        first = 1
        open = 0
        do while (first <= len(record))
            call fill_card(record, first, width, open, last)
            data = record(first:last)
            if (present(pointer)) data(pointed_columns + 1:) = right(to_text(pointer), 8)
            call section%put_card(data)
            first = last + 1
        end do
    end subroutine put_free

    !> Finds the end of what goes on a card: as many values as there is room for.
    pure subroutine fill_card(record, first, width, open, last)
        character(*), intent(in) :: record  !! with its commas and semicolon
        integer, intent(in) :: first        !! where the card begins
        integer, intent(in) :: width        !! columns it has
        integer, intent(inout) :: open      !! end of the text that was begun on a card before
        integer, intent(out) :: last        !! where the card ends
        integer :: next, head, end

        next = max(first, open + 1)
        do while (next <= len(record) .and. next - first < width)
            call find_value(record, next, head, end)
            if (head - first >= width) exit
            open = end
            next = end + 1
        end do
        last = min(next - 1, first + width - 1)
    end subroutine fill_card

    !> The end of a value with its comma or semicolon, and of that part of it that must be on one
    !> card.
    pure subroutine find_value(record, from, head, end)
        character(*), intent(in) :: record  !! with its commas and semicolon
        integer, intent(in) :: from         !! where the value begins
        integer, intent(out) :: head        !! see above
        integer, intent(out) :: end         !! see above
        integer :: digits, count

        digits = verify(record(from:), '0123456789') - 1
        if (digits > 0 .and. record(from + digits:from + digits) == 'H') then
            read (record(from:from + digits - 1), *) count
            head = from + digits + 1
            end = head + count
        else
            end = from - 1 + scan(record(from:), ',;')
            head = end
        end if
    end subroutine find_value

    !> The cards, each with its line end.
    pure function text(section)
        class(section_type), intent(in) :: section  !! the section
        character(:), allocatable :: text
        text = section%images%text()
    end function text

end module export_iges_card
