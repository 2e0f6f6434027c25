!> The card of a line: the round numbers behind the figures of a parabola.
program test_card
    use audit_card, only: card_type, make_card
    use audit_curve, only: quantity_at, quantity_type
    use audit_fit, only: fit_readings, fit_type
    use audit_parameter, only: bound_parameter, parameter_type
    use audit_reading, only: line_type, sort
    use base_kinds, only: dp
    use support_audited_lines, only: parabola_line, whole
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type) :: line
    type(fit_type) :: fit
    type(parameter_type) :: parameter(5)
    type(card_type) :: card
    real(dp) :: value
    logical :: exists

    line = parabola_line()
    call fit_readings(line, line%scale, whole(line), fit)
    parameter(1) = bound_parameter(fit, 'Y1', quantity_type(sort%ordinate, along=0.0_dp))
    parameter(2) = bound_parameter(fit, 'S1', quantity_type(sort%slope, along=0.0_dp))
    parameter(3) = bound_parameter(fit, 'Y2', quantity_type(sort%ordinate, along=50.0_dp, &
        near=25.0_dp))
    parameter(4) = bound_parameter(fit, 'Y3', quantity_type(sort%ordinate, along=90.0_dp, &
        near=81.0_dp))
    parameter(5) = bound_parameter(fit, 'S3', quantity_type(sort%slope, along=90.0_dp, &
        near=81.0_dp))
    call make_card(fit, parameter, card)
    call tap%ok(card%is_whole, 'the card is whole')
    call tap%same(trim(card%number(1))//' '//trim(card%number(2))//' '// &
        trim(card%number(3))//' '//trim(card%number(4))//' '//trim(card%number(5)), &
        '0 0 25 81 1.8', &
        'it is that of y = x**2/100 from 0 to 90')
    call tap%ok(all(abs(card%x - [0.0_dp, 50.0_dp, 90.0_dp]) < 1.0e-12_dp), 'at its abscissae')
    call quantity_at(fit%k, fit%problem%frame, quantity_type(sort%ordinate, along=35.0_dp, &
        near=12.0_dp), value, exists)
    call tap%near(value, 12.25_dp, 1.0e-8_dp, 'its conic is the parabola')

    parameter(1)%exists = .false.
    call make_card(fit, parameter, card)
    call tap%ok(.not. card%is_whole, 'where a number does not exist there is no card')
    call tap%finish()
end program test_card
