!> Values of an audited line against the parabola that its figures are of.
program test_value
    use audit_deck, only: deck_audit_type
    use audit_reading, only: sort
    use audit_value, only: row_at, value_at, value_type
    use base_kinds, only: dp
    use support_audit_deck, only: audit_of, parabola
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(deck_audit_type) :: found
    type(value_type) :: at

    call audit_of(parabola, found)
    at = value_at(found%item(1), sort%ordinate, 22.0_dp)
    call tap%ok(at%exists .and. abs(at%value - 4.84_dp) <= 0.5e-3_dp .and. at%low <= 4.84_dp .and. &
        at%high >= 4.84_dp .and. at%high - at%low < 1.1e-3_dp, 'between rows, within bounds')
    at = value_at(found%item(1), sort%ordinate, 50.5_dp)
    call tap%ok(.not. at%exists, 'none beyond the last point')
    call tap%ok(row_at(found%item(1), sort%ordinate, 20.0_dp) == 4 .and. &
        row_at(found%item(1), sort%ordinate, 21.0_dp) == 0 .and. &
        row_at(found%item(1), sort%abscissa, 20.0_dp) == 0, 'rows are found')
    call tap%finish()

end program test_value
