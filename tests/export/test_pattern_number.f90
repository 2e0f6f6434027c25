!> Tests of numbers on paper.
program test_pattern_number
    use base_kinds, only: dp
    use export_pattern_number, only: bevel_text, inches, ordinate, short
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call tap%same(short(12.5_dp, 3), '12.5', 'no zeros at the end')
    call tap%same(short(100.0_dp, 3), '100', 'no point behind a whole number, its zeros stay')
    call tap%same(short(-1.0e-3_dp, 3), '-0.001', 'a small negative number')
    call tap%same(short(-1.0e-9_dp, 3), '0', 'there is no -0')
    call tap%same(short(120.0_dp, 0), '120', 'without decimals')
    call tap%same(ordinate(3.0_dp*0.1_dp), '0.3', 'an ordinate without the noise of binary')
    call tap%same(inches(10.0_dp), '10.000', 'inches with three decimals')
    call tap%same(bevel_text(3.46_dp)//' '//bevel_text(-3.44_dp), '+3.5 -3.4', &
        'a bevel has its sign')
    call tap%same(bevel_text(0.04_dp)//' '//bevel_text(-0.04_dp), '0.0 0.0', 'none has no bevel')
    call tap%finish()
end program test_pattern_number
