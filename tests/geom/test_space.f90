!> Products of vectors in space, and angles between normals.
program test_space
    use base_constants, only: pi
    use base_kinds, only: dp
    use geom_space, only: across, angle_between
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call tap%ok(all(abs(across([1.0_dp, 2.0_dp, 3.0_dp], [4.0_dp, 5.0_dp, 6.0_dp]) &
        - [-3.0_dp, 6.0_dp, -3.0_dp]) <= 0.0_dp), 'a vector product')
    call tap%near(angle_between([1.0_dp, 0.0_dp, 0.0_dp], [0.0_dp, 1.0_dp, 0.0_dp]), 0.5_dp*pi, &
        1.0e-15_dp, 'a right angle')
    call tap%near(angle_between([1.0_dp, 0.0_dp, 0.0_dp], [1.0_dp, 1.0e-9_dp, 0.0_dp]), 1.0e-9_dp, &
        1.0e-24_dp, 'a small angle, which a cosine would lose')
    call tap%near(angle_between([1.0_dp, 0.0_dp, 0.0_dp], [-1.0_dp, 0.0_dp, 0.0_dp]), pi, 0.0_dp, &
        'opposite ways')
    call tap%near(angle_between([1.0_dp, 0.0_dp, 0.0_dp], [0.0_dp, 0.0_dp, 0.0_dp]), 0.0_dp, &
        0.0_dp, 'none with no way')
    call tap%finish()
end program test_space
