!> Tests of the fundamental forms, on surfaces whose derivatives are known.
program test_mesh_form
    use base_kinds, only: dp
    use cut_measure_sheet, only: spot_type
    use export_mesh_form, only: distance_from, distance_in_plane, form_at, form_type, turn_along
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(spot_type) :: spot
    type(form_type) :: form
    real(dp), parameter :: radius = 50.0_dp
    real(dp) :: way(3), b, c

    ! A cylinder about STA: u along it, 3 to one of u; t the angle. At BL 30, WL 40.
    spot%at = [10.0_dp, 30.0_dp, 40.0_dp]
    spot%u = [3.0_dp, 0.0_dp, 0.0_dp]
    spot%t = [0.0_dp, -40.0_dp, 30.0_dp]
    spot%tt = [0.0_dp, -30.0_dp, -40.0_dp]
    form = form_at(spot)
    call tap%ok(form%is_there, 'a cylinder has a tangent plane')
    call tap%near(norm2(form%normal - [0.0_dp, -0.6_dp, -0.8_dp]), 0.0_dp, 1.0e-15_dp, &
        'its normal is along u x t')
    call tap%near(form%first(1, 1) + form%first(2, 2) + abs(form%first(1, 2)), 2509.0_dp, &
        1.0e-12_dp, 'first form 9, 0, 2500')
    call tap%near(form%second(2, 2) + abs(form%second(1, 1)) + abs(form%second(1, 2)), 50.0_dp, &
        1.0e-13_dp, 'second form 0, 0, 50: curvature 1/50')
    call tap%near(turn_along(form, [0.0_dp, 0.01_dp]), 0.01_dp, 1.0e-16_dp, &
        'it turns by the angle around')
    call tap%near(turn_along(form, [1.0_dp, 0.0_dp]), 0.0_dp, 1.0e-16_dp, 'not along')
    ! A point 2 off the cylinder, .03 further round and 1 further aft than the spot.
    c = cos(0.03_dp)
    b = sin(0.03_dp)
    way = (radius + 2.0_dp)*[0.0_dp, 0.6_dp*c - 0.8_dp*b, 0.8_dp*c + 0.6_dp*b]
    way(1) = 11.0_dp
    call tap%near(distance_from(spot, way), 2.0_dp, 3.0e-3_dp, &
        'distance to second order, from a spot beside the foot')
    call tap%near(distance_from(spot, [10.0_dp, 30.6_dp, 40.8_dp]), 1.0_dp, 1.0e-13_dp, &
        'and exactly above the spot')
    call tap%near(distance_in_plane(spot, [10.0_dp, way(2), way(3)]), 2.0_dp, 3.0e-3_dp, &
        'the same in the plane of the section')
    ! Middle of a chord of half angle .03, seen from a spot .01 beside: radius (1 - cos).
    way = radius*cos(0.03_dp)*[0.0_dp, 0.6_dp*cos(0.01_dp) - 0.8_dp*sin(0.01_dp), &
        0.8_dp*cos(0.01_dp) + 0.6_dp*sin(0.01_dp)]
    way(1) = 10.0_dp
    call tap%near(distance_from(spot, way), radius*(1.0_dp - cos(0.03_dp)), 2.0e-6_dp, &
        'the sagitta of a chord')
    call tap%near(distance_in_plane(spot, way), radius*(1.0_dp - cos(0.03_dp)), 2.0e-6_dp, &
        'in the plane too')
    ! A saddle z = x y: M alone.
    spot = spot_type()
    spot%u = [1.0_dp, 0.0_dp, 0.0_dp]
    spot%t = [0.0_dp, 1.0_dp, 0.0_dp]
    spot%ut = [0.0_dp, 0.0_dp, 1.0_dp]
    form = form_at(spot)
    call tap%near(turn_along(form, [0.25_dp, 0.0_dp]), 0.25_dp, 1.0e-15_dp, &
        'a saddle turns across the way')
    call tap%near(distance_from(spot, [0.1_dp, 0.1_dp, 0.01_dp]), 0.0_dp, 1.0e-15_dp, &
        'a point of it is on it')
    spot%t = 0.0_dp
    form = form_at(spot)
    call tap%ok(.not. form%is_there, 'where t stands still there is no tangent plane')
    call tap%near(distance_from(spot, [0.0_dp, 3.0_dp, 4.0_dp]), 5.0_dp, 1.0e-15_dp, &
        'the distance is then that of the points')
    call tap%finish()
end program test_mesh_form
