!> Ordinates in the unit asked for. Feet-inches-eighths by hand: 1 ft 7 1/2 in is 19.5 in, written
!> 1-07-4; a sixteenth more is 19.5625 in, written 1-07-4+.
program test_ordinate
    use base_kinds, only: dp
    use report_ordinate, only: largest_rounding, new_form, ordinate_form_type, ordinate_text, &
        ordinate_words
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(ordinate_form_type) :: form

    form = new_form('INCHES', 'INCHES', 3)
    call tap%same(ordinate_text(form, -18.0_dp, 10), '   -18.000', 'inches to three decimals')
    call tap%same(ordinate_text(form, -1.0e-9_dp, 10), '     0.000', 'no zero has a minus')
    call tap%same(trim(largest_rounding(form)), 'ROUNDED TO 3 DECIMALS', 'the rounding is said')
    form = new_form('INCHES', 'MM', 2)
    call tap%same(ordinate_text(form, 1.0_dp, 8), '   25.40', 'an inch is 25.4 mm')
    form = new_form('MM', 'INCHES', 4)
    call tap%same(ordinate_text(form, 254.0_dp, 8), ' 10.0000', '254 mm are ten inches')
    form = new_form('FEET', 'MM', 1)
    call tap%same(ordinate_text(form, 1.0_dp, 8), '   304.8', 'a foot is 304.8 mm')
    form = new_form('MM', 'FEET', 3)
    call tap%same(ordinate_text(form, 609.6_dp, 8), '   2.000', '609.6 mm are two feet')

    form = new_form('INCHES', 'FIE', 3)
    call tap%same(form%unit, 'FEET-INCHES-EIGHTHS', 'the unit is said in words')
    call tap%same(ordinate_text(form, 19.5_dp, 9), '   1-07-4', '1 ft 7 1/2 in')
    call tap%same(ordinate_text(form, 19.5625_dp, 9), '  1-07-4+', 'and a sixteenth')
    call tap%same(ordinate_text(form, 0.0_dp, 9), '   0-00-0', 'nothing')
    call tap%same(ordinate_text(form, -3.0_dp, 9), '  -0-03-0', 'below zero')
    call tap%same(ordinate_text(form, -0.01_dp, 9), '   0-00-0', &
        'less than half a sixteenth below zero')
    call tap%same(ordinate_text(form, 11.99_dp, 9), '   1-00-0', 'a carry through inches to feet')
    call tap%same(ordinate_text(form, 143.96875_dp, 9), '  12-00-0', 'half a sixteenth goes up')
    form = new_form('FEET', 'FIE', 3)
    call tap%same(ordinate_text(form, 1.625_dp, 9), '   1-07-4', 'from feet: 1.625 ft is 19.5 in')
    form = new_form('MM', 'FIE', 3)
    call tap%same(ordinate_text(form, 495.3_dp, 9), '   1-07-4', 'from millimetres')
    call tap%same(ordinate_words(form, 495.3_dp), '1-07-4', 'in a sentence without blanks')
    call tap%finish()

end program test_ordinate
