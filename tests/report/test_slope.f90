!> Slopes as text.
program test_slope
    use base_kinds, only: dp
    use geom_arc_point, only: slope_type
    use report_slope, only: slope_text
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call tap%same(slope_text(slope_type(0.1_dp, .false.)), '0.1', 'a slope is its fewest figures')
    call tap%same(slope_text(slope_type(-2.0_dp, .false.)), '-2', 'with its sign')
    call tap%same(slope_text(slope_type(0.0_dp, .true.)), 'inf', 'a vertical one is inf')
    call tap%finish()

end program test_slope
