!> The inside of a skin: feet, curvatures and ways through it on a sphere and an ellipsoid.
program test_offset
    use base_kinds, only: dp
    use body_body, only: body_type, mirrored_body
    use body_offset, only: foot_at, foot_type, parallel_curvature, steepest_curvature, way_inside
    use support_bodies, only: ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(foot_type) :: foot
    real(dp) :: n(3), way(3)
    logical :: is_there

    body = mirrored_body(ellipsoid([5.0_dp, 5.0_dp, 5.0_dp], 0.0_dp, 0.0_dp))
    call foot_at(body, 2, [3.0_dp, 2.4_dp, 3.2_dp]*1.01_dp, [1.0_dp, 1.0_dp, 1.0_dp], foot, &
        is_there)
    call tap%ok(is_there, 'a point next to a sphere has a foot')
    call tap%near(norm2(foot%at), 5.0_dp, 1.0e-14_dp, 'on the sphere')
    call tap%near(norm2(foot%normal - foot%at/5.0_dp), 0.0_dp, 1.0e-14_dp, 'with its normal')
    call tap%near(steepest_curvature(foot), 0.2_dp, 1.0e-13_dp, 'and its curvature')
    call tap%near(parallel_curvature(foot, 1.0_dp, foot%axes(:, 1)), 0.25_dp, 1.0e-13_dp, &
        'a unit inside the curvature is 1/4')
    way = [0.0_dp, 0.0_dp, -1.0_dp]
    call way_inside(body, 1.0_dp, way, foot, is_there)
    call tap%ok(is_there, 'a way down meets the inside')
    n = foot%at - foot%normal
    call tap%near(norm2(n), 4.0_dp, 1.0e-14_dp, 'a unit from the sphere')
    call tap%near(abs(n(1)/n(2)), 3.0_dp/2.4_dp, 1.0e-3_dp, 'straight below')
    call foot_at(body, 2, [0.0_dp, 0.3_dp, sqrt(25.0_dp - 0.09_dp)], [0.0_dp, 0.0_dp, 1.0_dp], &
        foot, is_there)
    way = [0.0_dp, -1.0_dp, -1.0_dp]*sqrt(0.5_dp)
    call way_inside(body, 1.0_dp, way, foot, is_there)
    call tap%ok(is_there, 'a way across BL 0 meets the inside, too')
    call tap%ok(foot%section == 4, 'of the port section')
    call tap%near(norm2(foot%at - foot%normal), 4.0_dp, 1.0e-14_dp, 'also a unit from the sphere')
    call foot_at(body, 2, [3.0_dp, 2.4_dp, 3.2_dp], [1.0_dp, 1.0_dp, 1.0_dp], foot, is_there)
    call way_inside(body, 5.5_dp, -foot%normal, foot, is_there)
    call tap%ok(.not. is_there, 'a skin thicker than the radius has no inside')
    call foot_at(body, 2, [7.0_dp, 0.0_dp, 0.0_dp], [1.0_dp, 0.0_dp, 0.0_dp], foot, is_there)
    call tap%ok(.not. is_there, 'beyond the tail there is no foot')
    body = ellipsoid([5.0_dp, 2.0_dp, 1.0_dp], 0.0_dp, 0.0_dp)
    call foot_at(body, 1, [0.0_dp, 2.0_dp, 0.0_dp], [0.0_dp, 1.0_dp, 0.0_dp], foot, is_there)
    call tap%near(steepest_curvature(foot), 2.0_dp, 1.0e-13_dp, &
        'amidships an ellipsoid is steepest up and down')
    call tap%near(parallel_curvature(foot, 0.1_dp, [1.0_dp, 0.0_dp, 0.0_dp]), &
        0.08_dp/(1.0_dp - 0.008_dp), 1.0e-14_dp, 'and its inside is k/(1 - t k) along STA')
    call tap%finish()
end program test_offset
