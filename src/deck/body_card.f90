!> A card of a body deck and its fields. In columns a card has ten fields of eight:
!>
!>     1       9       17      25      33      41      49      57      65      73
!>     SECTION LOWER   LCL     LSH     MHB     0.      999.999
!>
!> A card with a comma in it is free-field: the same fields in the same order between commas, up to
!> 132 columns. A card with nothing but `+` in its first field continues the one before: its second
!> field follows the last field of that card.
module deck_body_card
    use base_fault, only: fault_list_type, fault_type, new_fault, severity
    use base_kinds, only: i64
    use base_text, only: columns, upper
    use deck_source, only: line_type
    implicit none (type, external)
    private

    public :: card_type, new_card, continue_card, is_continuation
    public :: field_count, field_text, blame, blame_span, blame_inside, warn

    !> Columns of a field, and fields of a card that goes by columns.
    integer, parameter, public :: field_width = 8, fields_across = 10
    !> Columns of a card with commas.
    integer, parameter, public :: free_columns = 132

    !> One line of a card: a card and each of its continuations is one.
    type, public :: sheet_type
        integer(i64) :: line = 0                !! line of the file, from 1
        character(free_columns) :: image = ''   !! its columns
    end type sheet_type

    !> Where a field stands.
    type, public :: field_type
        integer :: sheet = 1    !! on which line of the card, from 1
        integer :: first = 1    !! its first column
        integer :: last = 0     !! its last column; before the first where it is empty
    end type field_type

    !> A card with its continuations. Whoever finds it wrong, now or later, blames its fields.
    type :: card_type
        type(sheet_type), allocatable :: sheet(:)   !! its lines
        type(field_type), allocatable :: field(:)   !! its fields, in order
    end type card_type

contains

    !> Cuts a line into fields.
    pure function new_card(line) result(card)
        type(line_type), intent(in) :: line !! a line of the deck
        type(card_type) :: card
        allocate (card%sheet, source=[sheet_type(line%number, line%text)])
        allocate (card%field, source=fields_of_line(line, 1))
    end function new_card

    !> Puts the fields of a continuation behind those of its card.
    pure subroutine continue_card(card, line)
        type(card_type), intent(inout) :: card  !! the card so far
        type(line_type), intent(in) :: line     !! its continuation
        type(field_type), allocatable :: more(:)

        allocate (more, source=fields_of_line(line, size(card%sheet) + 1))
        card%sheet = [card%sheet, sheet_type(line%number, line%text)]
        card%field = [card%field, more(2:)]
    end subroutine continue_card

    !> True for a line whose first field is `+` and nothing else. (`+5.` is a number.)
    pure logical function is_continuation(line)
        type(line_type), intent(in) :: line !! a line of the deck
        type(field_type), allocatable :: field(:)
        allocate (field, source=fields_of_line(line, 1))
        is_continuation = columns(line%text, field(1)%first, field(1)%last) == '+'
    end function is_continuation

    !> The fields of one line. Behind the last comma of a free-field card there may be nothing.
    pure function fields_of_line(line, sheet) result(field)
        type(line_type), intent(in) :: line !! a line of the deck
        integer, intent(in) :: sheet        !! which line of its card it is
        type(field_type), allocatable :: field(:)
        integer :: i

        if (index(line%text, ',') > 0) then
            allocate (field, source=fields_between_commas(trim( &
                columns(line%text, 1, free_columns)), sheet))
        else
            allocate (field, source=[(field_type(sheet, field_width*(i - 1) + 1, field_width*i), &
                i = 1, fields_across)])
        end if
    end function fields_of_line

    !> The fields of a free-field card, without the blanks around them.
    pure function fields_between_commas(text, sheet) result(field)
        character(*), intent(in) :: text    !! the line
        integer, intent(in) :: sheet        !! which line of its card it is
        type(field_type), allocatable :: field(:)
        integer :: begin, finish

        allocate (field(0))
        begin = 1
        do while (begin <= len(text))
            finish = begin + index(text(begin:)//',', ',') - 2
            field = [field, trimmed_field(text, sheet, begin, finish)]
            begin = finish + 2
        end do
    end function fields_between_commas

    !> A field without the blanks around it.
    pure type(field_type) function trimmed_field(text, sheet, first, last) result(field)
        character(*), intent(in) :: text    !! the line
        integer, intent(in) :: sheet        !! which line of its card it is
        integer, intent(in) :: first        !! first column behind a comma
        integer, intent(in) :: last         !! last column before the next comma

        field = field_type(sheet, first, first - 1)
        if (text(first:last) == '') return
        field%first = first - 1 + verify(text(first:last), ' ')
        field%last = first - 1 + verify(text(first:last), ' ', back=.true.)
    end function trimmed_field

    !> Fields of a card, up to the last that is not blank.
    pure integer function field_count(card) result(count)
        type(card_type), intent(in) :: card !! the card
        do count = size(card%field), 1, -1
            if (field_text(card, count) /= '') return
        end do
    end function field_count

    !> The columns of a field without the blanks before its text, blanks behind it.
    pure function field_columns(card, number) result(text)
        type(card_type), intent(in) :: card !! the card
        integer, intent(in) :: number       !! which field, from 1
        character(free_columns) :: text

        text = ''
        if (number > size(card%field)) return
        associate (field => card%field(number))
            text = adjustl(columns(card%sheet(field%sheet)%image, field%first, field%last))
        end associate
    end function field_columns

    !> The text of a field in capitals, without blanks around it; nothing behind the card's end.
    pure function field_text(card, number) result(text)
        type(card_type), intent(in) :: card !! the card
        integer, intent(in) :: number       !! which field, from 1
        character(len_trim(field_columns(card, number), i64)) :: text
        text = upper(field_columns(card, number))
    end function field_text

    !> Where a field is or would be, for the row of carets: at least one column.
    pure type(field_type) function place_of(card, number) result(place)
        type(card_type), intent(in) :: card !! the card
        integer, intent(in) :: number       !! which field, from 1

        if (number <= size(card%field)) then
            place = card%field(number)
        else
            place%sheet = size(card%sheet)
            place%first = len_trim(card%sheet(place%sheet)%image) + 1
        end if
        place%last = max(place%first, place%last)
    end function place_of

    !> Adds an error that stands on one field.
    pure subroutine blame(card, number, message, faults)
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: number                   !! the field at fault
        character(*), intent(in) :: message             !! what is wrong and what would be right
        type(fault_list_type), intent(inout) :: faults  !! gets the fault
        call blame_span(card, number, number, message, faults)
    end subroutine blame

    !> Adds an error that stands on several fields, or on those of them that are on the first line.
    pure subroutine blame_span(card, first, last, message, faults)
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: first                    !! first field at fault
        integer, intent(in) :: last                     !! last field at fault
        character(*), intent(in) :: message             !! what is wrong and what would be right
        type(fault_list_type), intent(inout) :: faults  !! gets the fault
        type(field_type) :: begin, finish
        integer :: i

        begin = place_of(card, first)
        do i = first, last
            finish = place_of(card, i)
            if (finish%sheet == begin%sheet) begin%last = finish%last
        end do
        call add(card, begin, new_fault(severity%error, begin%first, begin%last, message), faults)
    end subroutine blame_span

    !> Adds an error that stands on some characters of a field's text.
    pure subroutine blame_inside(card, number, first, last, message, faults)
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: number                   !! the field at fault
        integer, intent(in) :: first                    !! first character of `field_text`
        integer, intent(in) :: last                     !! last character of it
        character(*), intent(in) :: message             !! what is wrong and what would be right
        type(fault_list_type), intent(inout) :: faults  !! gets the fault
        type(field_type) :: place
        integer :: before

        place = card%field(number)
        before = place%first - 2 + verify(columns(card%sheet(place%sheet)%image, place%first, &
            place%last), ' ')
        call add(card, place, new_fault(severity%error, before + first, before + last, message), &
            faults)
    end subroutine blame_inside

    !> Adds a warning that stands on one field.
    pure subroutine warn(card, number, message, faults)
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: number                   !! the field it speaks of
        character(*), intent(in) :: message             !! what the user will want to know
        type(fault_list_type), intent(inout) :: faults  !! gets the fault
        type(field_type) :: place
        place = place_of(card, number)
        call add(card, place, new_fault(severity%warning, place%first, place%last, message), faults)
    end subroutine warn

    !> Adds a fault with the line it stands on.
    pure subroutine add(card, place, fault, faults)
        type(card_type), intent(in) :: card             !! the card
        type(field_type), intent(in) :: place           !! the field at fault
        type(fault_type), intent(in) :: fault           !! what is wrong
        type(fault_list_type), intent(inout) :: faults  !! gets the fault
        integer :: before

        before = faults%count
        call faults%add(fault)
        associate (sheet => card%sheet(place%sheet))
            call faults%place(before, sheet%line, trim(sheet%image))
        end associate
    end subroutine add

end module deck_body_card
