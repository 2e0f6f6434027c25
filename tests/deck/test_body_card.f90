!> Cards of a body deck cut into fields: by columns, between commas, continued.
program test_body_card
    use base_fault, only: fault_list_type
    use base_kinds, only: i64
    use deck_body_card, only: blame, blame_inside, blame_span, card_type, continue_card, &
        field_count, field_text, is_continuation, new_card, warn
    use deck_source, only: line_type
    use support_job_deck, only: words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(card_type) :: card

    call columns_and_commas()
    call continuations()
    call faults()
    call tap%finish()

contains

    !> A line of a deck.
    function line(text, number)
        character(*), intent(in) :: text
        integer, intent(in) :: number
        type(line_type) :: line
        line = line_type(text, int(number, i64), len(text, i64), len_trim(text))
    end function line

    !> All fields of a card with `:` between them.
    function all_fields(card) result(text)
        type(card_type), intent(in) :: card
        character(:), allocatable :: text
        integer :: i
        text = ''
        do i = 1, field_count(card)
            text = text//field_text(card, i)//':'
        end do
    end function all_fields

    subroutine columns_and_commas()
        card = new_card(line('LINE    mhb     SIDE', 1))
        call tap%same(all_fields(card), 'LINE:MHB:SIDE:', 'fields of eight columns, in capitals')
        card = new_card(line('1234567812345678 5', 1))
        call tap%same(all_fields(card), '12345678:12345678:5:', 'fields that are full stay apart')
        card = new_card(line(repeat(' ', 79)//'9', 1))
        call tap%ok(field_count(card) == 10 .and. field_text(card, 10) == '9', &
            'column 80 is in field 10')
        card = new_card(line('  Line , mhb,SIDE  ', 1))
        call tap%same(all_fields(card), 'LINE:MHB:SIDE:', &
            'fields between commas lose blanks around')
        card = new_card(line('A,,B,', 1))
        call tap%same(all_fields(card), 'A::B:', &
            'an empty field counts, nothing behind a last comma')
        card = new_card(line(',1', 1))
        call tap%same(all_fields(card), ':1:', 'a comma in column 1 leaves field 1 empty')
        card = new_card(line(',', 1))
        call tap%ok(field_count(card) == 0 .and. field_text(card, 5) == '', &
            'a comma alone has no field')
    end subroutine columns_and_commas

    subroutine continuations()
        call tap%ok(is_continuation(line('+       5.', 1)), 'a + alone in field 1 continues')
        call tap%ok(is_continuation(line('+,5.', 1)), 'so it does before a comma')
        call tap%ok(.not. is_continuation(line('+5.     5.', 1)), 'a number with its sign does not')
        call tap%ok(.not. is_continuation(line('+5.,5.', 1)), 'nor before a comma')
        card = new_card(line('A       B', 1))
        call continue_card(card, line('+       11      12', 2))
        call tap%ok(field_text(card, 11) == '11' .and. field_text(card, 12) == '12', &
            'a continuation goes on with field 11')
        call continue_card(card, line('+,21', 3))
        call tap%ok(field_text(card, 19) == '' .and. field_text(card, 20) == '21', &
            'a second one goes on behind field 19')
        card = new_card(line('A,B,', 1))
        call continue_card(card, line('+,C', 2))
        call tap%same(all_fields(card), 'A:B:C:', 'behind commas it follows the last field')
    end subroutine continuations

    subroutine faults()
        type(fault_list_type) :: list
        card = new_card(line('A        B', 7))
        call continue_card(card, line('+       11', 9))
        call blame(card, 2, 'm', list)
        call blame_span(card, 2, 11, 'm', list)
        call warn(card, 11, 'm', list)
        call blame_inside(card, 2, 1, 1, 'm', list)
        call blame(card, 21, 'm', list)
        call tap%same(words_of(list), '7:9-16 error: m|7:9-80 error: m|9:9-16 warning: m|'// &
            '7:10-10 error: m|9:11-11 error: m|', 'faults stand on the columns of their fields')
        call tap%same(list%item(3)%card, '+       11', 'and on their line')
        call list%clear()
        card = new_card(line('A, BC ,,D', 7))
        call blame(card, 2, 'm', list)
        call blame(card, 3, 'm', list)
        call blame_inside(card, 2, 2, 2, 'm', list)
        call blame(card, 5, 'm', list)
        call tap%same(words_of(list), &
            '7:4-5 error: m|7:8-8 error: m|7:5-5 error: m|7:10-10 error: m|', &
            'faults between commas stand on the text, or where it would be')
    end subroutine faults

end program test_body_card
