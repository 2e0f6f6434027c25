!> Tolerances against the reasons they state.
program test_tolerances
    use base_kinds, only: dp
    use base_tolerances, only: decimal_noise, foot_tolerance, outline_gap, quadrature_tolerance, &
        segment_tolerance, slope_resolution, type_tolerance, ulp
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call tap%near(ulp, 2.0_dp**(-52), 0.0_dp, 'ulp is 2**-52')
    call tap%ok(1.0_dp + ulp > 1.0_dp, 'ulp tells 1 from its neighbour')
    call tap%near(1.0_dp + 0.5_dp*ulp, 1.0_dp, 0.0_dp, 'half an ulp does not')
    call tap%near(2.0_dp*slope_resolution, 0.00001_dp, 0.0_dp, &
        'the resolution of a slope is half the last decimal of F8.5')
    call tap%ok(decimal_noise >= 1.0_dp .and. decimal_noise < 16.0_dp, &
        'decimal noise is a few units in the last place')
    call tap%ok(type_tolerance > 100.0_dp*ulp .and. type_tolerance < slope_resolution, &
        'the type of a conic is told above round-off and below what can be punched')
    call tap%ok(quadrature_tolerance > 100.0_dp*ulp .and. quadrature_tolerance < 1.0e-8_dp, &
        'quadrature asks more than a listing shows and no more than doubles hold')
    call tap%ok(segment_tolerance > 50.0_dp*ulp &
        .and. 50.0_dp*segment_tolerance < quadrature_tolerance, &
        'moments of a segment are asked better than what is summed from them')
    call tap%ok(outline_gap > type_tolerance .and. outline_gap < 1.0e-4_dp, &
        'arcs that meet are told above round-off and below what can be built')
    call tap%ok(foot_tolerance > 2.0_dp*ulp .and. foot_tolerance**2 < ulp, &
        'a step to the foot of a normal is above rounding, its square far below')
    call tap%finish()
end program test_tolerances
