!> Fields of a card of words that run together: more than the word in the first one, numbers behind
!> the last one. Most of them are decimals with a comma, blanks in place of columns, semicolons.
module deck_body_crowd
    use base_fault, only: fault_list_type
    use base_text, only: to_text
    use deck_body_card, only: blame, card_type, field_text
    use deck_body_value, only: looks_like_number
    implicit none (type, external)
    private

    public :: blame_crowded, check_surplus

    !> What a comma is on a card, and what it is not.
    character(*), parameter :: comma_rule = 'a comma ends a field, and decimals have a point: 22.5'

contains

    !> Blames a number behind the last field of a layout: the first one, for all of them.
    pure subroutine check_surplus(card, number, last, faults)
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: number                   !! field of the number
        integer, intent(in) :: last                     !! last field of the layout
        type(fault_list_type), intent(inout) :: faults  !! gets the fault
        character(:), allocatable :: words
        integer :: i

        do i = last + 1, number - 1
            if (looks_like_number(field_text(card, i))) return
        end do
        words = 'a number behind the last field of the card, which is field '//to_text(last)
        if (has_comma(card)) words = words//'; '//comma_rule
        call blame(card, number, words, faults)
    end subroutine check_surplus

    !> Says of a card that its first field holds more than its word, and how fields are told apart.
    pure subroutine blame_crowded(card, faults)
        type(card_type), intent(in) :: card             !! the card
        type(fault_list_type), intent(inout) :: faults  !! gets the fault
        character(*), parameter :: crowded = 'more than the word in the first field; '

        if (index(field_text(card, 1), ';') > 0) then
            call blame(card, 1, crowded//'fields end with their columns or with a comma, not '// &
                'with a semicolon', faults)
        else if (has_comma(card)) then
            call blame(card, 1, crowded//'on a card with a comma all fields are between '// &
                'commas: '//comma_rule, faults)
        else
            call blame(card, 1, crowded//'the next field begins in column 9, or put commas '// &
                'between all fields', faults)
        end if
    end subroutine blame_crowded

    !> True for a card with a comma in its first line.
    pure logical function has_comma(card)
        type(card_type), intent(in) :: card !! the card
        has_comma = index(card%sheet(1)%image, ',') > 0
    end function has_comma

end module deck_body_crowd
