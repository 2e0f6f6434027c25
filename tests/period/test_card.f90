!> A card nobody punched is zeros.
program test_card
    use base_decimal, only: decimal_type
    use base_kinds, only: i64
    use period_card, only: period_card_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(period_card_type) :: card
    type(decimal_type) :: value(10)

    value = [card%x1, card%y1, card%s1, card%x2, card%y2, card%x3, card%y3, card%s3, &
        card%xi, card%yi]
    call tap%ok(all(value%digits == 0_i64) .and. all(value%power == 0), &
        'every number of a blank card is zero')
    call tap%ok(card%ityp == 0, 'a blank card asks for no Y table')
    call tap%finish()

end program test_card
