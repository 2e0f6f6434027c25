!> What stands in a field of a body deck: a number, read as it looks, or a word. Nothing is found
!> wrong here; `deck_body_check` has done that.
module deck_body_value
    use base_decimal, only: decimal_type, to_real
    use base_kinds, only: dp
    use deck_body_card, only: card_type, field_text
    use deck_number, only: number_type, read_number
    implicit none (type, external)
    private

    public :: looks_like_number, number_in, decimal_in, real_in, whole_in, is_filled

contains

    !> The number in a text. A blank inside is a fault: here it is no zero, as it was in 1970.
    pure type(number_type) function number_in(text, is_whole) result(number)
        character(*), intent(in) :: text        !! without blanks around it
        logical, intent(in) :: is_whole         !! a point is a fault
        integer :: blank

        number = read_number(text, merge(-1, 0, is_whole))
        if (number%first > 0) return
        blank = index(text, ' ')
        if (blank == 0) return
        number%value = decimal_type()
        number%first = blank
        number%last = blank
        number%trouble = 'a blank inside a number; a field ends with its columns or with a comma'
    end function number_in

    !> True for a text that begins as a number does.
    pure logical function looks_like_number(text)
        character(*), intent(in) :: text !! without blanks around it
        looks_like_number = .false.
        if (len(text) > 0) looks_like_number = index('+-.0123456789', text(1:1)) > 0
    end function looks_like_number

    !> True for a field with something in it.
    pure logical function is_filled(card, field)
        type(card_type), intent(in) :: card !! the card
        integer, intent(in) :: field        !! which field, from 1
        is_filled = field_text(card, field) /= ''
    end function is_filled

    !> The number in a field that was found sound; zero where it is blank.
    pure type(decimal_type) function decimal_in(card, field) result(value)
        type(card_type), intent(in) :: card !! the card
        integer, intent(in) :: field        !! which field, from 1
        type(number_type) :: number
        number = number_in(field_text(card, field), .false.)
        value = number%value
    end function decimal_in

    !> The same as a double.
    pure real(dp) function real_in(card, field)
        type(card_type), intent(in) :: card !! the card
        integer, intent(in) :: field        !! which field, from 1
        real_in = to_real(decimal_in(card, field))
    end function real_in

    !> The whole number in a field that was found sound, no larger than a default integer.
    pure integer function whole_in(card, field)
        type(card_type), intent(in) :: card !! the card
        integer, intent(in) :: field        !! which field, from 1
        whole_in = nint(min(real_in(card, field), real(huge(0), dp)))
    end function whole_in

end module deck_body_value
