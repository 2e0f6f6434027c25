!> Tolerances against the reasons they state.
program test_tolerances
    use base_kinds, only: dp
    use base_tolerances, only: decimal_noise, quadrature_tolerance, slope_resolution, type_tolerance, &
        ulp
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
    call tap%ok(type_tolerance > 100*ulp .and. type_tolerance < slope_resolution, &
        'the type of a conic is told above round-off and below what can be punched')
    call tap%ok(quadrature_tolerance > 100*ulp .and. quadrature_tolerance < 1.0e-8_dp, &
        'quadrature asks more than a listing shows and no more than doubles hold')
    call tap%finish()
end program test_tolerances
