!> Numbers of a body deck: what they read as.
program test_body_value
    use base_decimal, only: decimal_type
    use base_exact, only: is_equal
    use base_kinds, only: dp, i64
    use deck_body_card, only: card_type, new_card
    use deck_body_value, only: decimal_in, is_filled, looks_like_number, number_in, real_in, &
        whole_in
    use deck_number, only: number_type
    use deck_source, only: line_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(card_type) :: card
    type(number_type) :: number
    type(decimal_type) :: tenth

    card = new_card(line_type('-30     .1      5       1.5E2           999.999 7', 1_i64, 49_i64, &
        49))
    call tap%ok(is_equal(real_in(card, 1), -30.0_dp), &
        'a number without a point is what it reads as')
    call tap%ok(is_equal(real_in(card, 2), 0.1_dp), 'a decimal is the nearest double')
    tenth = decimal_in(card, 2)
    call tap%ok(tenth%digits == 1 .and. tenth%power == -1, 'and is kept exact')
    call tap%ok(whole_in(card, 3) == 5, 'a whole number')
    call tap%ok(is_equal(real_in(card, 4), 150.0_dp), 'an exponent')
    call tap%ok(.not. is_filled(card, 5) .and. is_filled(card, 6), 'a blank field is not filled')
    call tap%ok(is_equal(real_in(card, 5), 0.0_dp), 'the number of a blank field is zero')
    call tap%ok(.not. is_filled(card, 12) .and. is_equal(real_in(card, 12), 0.0_dp), &
        'a field behind the card is blank')
    number = number_in('1 5', .false.)
    call tap%ok(number%first == 2 .and. number%value%digits == 0, 'a blank inside is a fault')
    number = number_in('1.5', .true.)
    call tap%ok(number%first == 2, 'a point in a whole number is a fault')
    number = number_in('1.5X', .false.)
    call tap%ok(number%first == 4, 'a letter in a number is a fault')
    call tap%ok(looks_like_number('-A') .and. looks_like_number('.5') .and. &
        looks_like_number('0'), 'a sign, point or figure begins a number')
    call tap%ok(.not. looks_like_number('A5') .and. .not. looks_like_number(''), &
        'a letter does not')
    card = new_card(line_type('99999999999', 1_i64, 11_i64, 11))
    call tap%ok(whole_in(card, 1) == 99999999, 'a field ends with its columns')
    card = new_card(line_type('99999999999,', 1_i64, 12_i64, 12))
    call tap%ok(whole_in(card, 1) == huge(0), 'a whole number that is too large is the largest')
    call tap%finish()
end program test_body_value
