!> Tests of how far triangles are from the skin: sagittas in closed form.
program test_mesh_chord
    use base_constants, only: pi
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_taylor, only: taylor_type
    use cut_measure_sheet, only: new_span, span_type, station_of
    use export_mesh_chord, only: corner_type, gauge_type, measure_triangle, middle_distance, &
        new_gauge, normal_at
    use support_bodies, only: ellipsoid
    use support_cylinders, only: cylinders
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(span_type) :: span
    type(gauge_type) :: gauge
    type(corner_type) :: corner(3)
    type(error_type), allocatable :: error
    real(dp) :: largest, worst(3), sagitta

    body = cylinders([50.0_dp, 50.0_dp], [30.0_dp, 30.0_dp], 0.0_dp)
    span = new_span(body, [1, 2], 0.0_dp, 50.0_dp)
    call new_gauge(body, 1, span, [0.0_dp, 0.5_dp], gauge, error)
    call tap%ok(.not. allocated(error) .and. all(gauge%is_stop .eqv. [.true., .false.]), &
        'a gauge knows which row is a stop')
    call tap%near(gauge%sta(2), 25.0_dp, 0.0_dp, 'and where they are')
    sagitta = 50.0_dp*(1.0_dp - cos(pi/40.0_dp))
    corner(1) = on_cylinder(0.1_dp, 0)
    corner(2) = on_cylinder(0.2_dp, 0)
    corner(3) = on_cylinder(0.1_dp, 6)
    call tap%near(middle_distance(gauge, corner(:2)), sagitta, 1.0e-4_dp*sagitta, &
        'a chord along the row at a stop')
    call tap%near(middle_distance(gauge, corner(2:)), sagitta, 1.0e-4_dp*sagitta, &
        'a chord across both ways')
    call tap%near(middle_distance(gauge, corner([1, 3])), 0.0_dp, 1.0e-13_dp, &
        'a chord along a straight line')
    largest = 0.0_dp
    worst = -1.0_dp
    call measure_triangle(gauge, corner, largest, worst)
    call tap%near(largest, sagitta, 1.0e-4_dp*sagitta, 'a triangle by its worst side')
    call tap%near(worst(1)*(worst(1) - 12.5_dp), 0.0_dp, 1.0e-12_dp, 'which is in its middle')
    largest = 1.0_dp
    worst = -1.0_dp
    call measure_triangle(gauge, corner, largest, worst)
    call tap%near(largest, 1.0_dp, 0.0_dp, 'a larger distance before stays')
    call tap%near(worst(2), -1.0_dp, 0.0_dp, 'with its place')
    call tap%near(abs(dot_product(normal_at(gauge, 6, 0.1_dp), &
        [0.0_dp, sin(pi/20.0_dp), -cos(pi/20.0_dp)])), 1.0_dp, 1.0e-14_dp, 'the normal is radial')

    body = ellipsoid([50.0_dp, 50.0_dp, 50.0_dp], 50.0_dp, 0.0_dp)
    span = new_span(body, [1, 2], 0.0_dp, 100.0_dp)
    call new_gauge(body, 2, span, [0.0_dp, 0.1_dp], gauge, error)
    call tap%ok(.not. gauge%is_there(0) .and. gauge%is_there(6), 'a tip has no arc')
    ! From the pole to 18 degrees along the meridian: half angle 9 degrees.
    corner(1) = corner_type([0.0_dp, 0.0_dp, 0.0_dp], 0.5_dp, 0, .true.)
    corner(2) = on_sphere(0.25_dp)
    corner(3) = on_sphere(0.35_dp)
    sagitta = 50.0_dp*(1.0_dp - cos(pi/20.0_dp))
    call tap%near(middle_distance(gauge, corner(:2)), sagitta, 2.0e-3_dp*sagitta, &
        'a chord from the tip')
    call tap%near(middle_distance(gauge, corner(2:)), 50.0_dp - norm2(0.5_dp*(corner(2)%at &
        + corner(3)%at) - [50.0_dp, 0.0_dp, 0.0_dp]), 1.0e-6_dp, 'a chord around')
    call tap%near(middle_distance(gauge, corner), 50.0_dp - norm2((corner(1)%at + corner(2)%at &
        + corner(3)%at)/3.0_dp - [50.0_dp, 0.0_dp, 0.0_dp]), 2.0e-3_dp, 'the middle of a fan')
    call tap%near(norm2(normal_at(gauge, 0, 0.5_dp)), 0.0_dp, 0.0_dp, 'the tip has no normal here')
    body = cylinders([50.0_dp, 50.0_dp], [30.0_dp, 30.0_dp], 0.0_dp)
    body%lines(4)%plan%constant = 60.0_dp
    call new_gauge(body, 1, new_span(body, [1], 0.0_dp, 50.0_dp), [0.0_dp, 0.5_dp], gauge, error)
    call tap%ok(allocated(error), 'a section without an arc is told')
    call tap%finish()

contains

    !> A corner on the lower quarter of the cylinder.
    type(corner_type) function on_cylinder(share, row) result(corner)
        real(dp), intent(in) :: share
        integer, intent(in) :: row
        corner%at = [25.0_dp*real(row, dp)/6.0_dp, 50.0_dp*sin(0.5_dp*pi*share), &
            -50.0_dp*cos(0.5_dp*pi*share)]
        corner%share = share
        corner%row = row
    end function on_cylinder

    !> A corner on the upper quarter of the sphere, on the aft row.
    type(corner_type) function on_sphere(share) result(corner)
        real(dp), intent(in) :: share
        type(taylor_type) :: sta
        real(dp) :: radius
        sta = station_of(span, 0.1_dp)
        radius = sqrt(sta%value*(100.0_dp - sta%value))
        corner%at = [sta%value, radius*cos(0.5_dp*pi*share), radius*sin(0.5_dp*pi*share)]
        corner%share = share
        corner%row = 6
    end function on_sphere

end program test_mesh_chord
