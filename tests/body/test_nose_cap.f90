!> Caps of single views: circle, its oblique and its narrow image, parabolas, views without a cap.
program test_nose_cap
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use body_nose_cap, only: cap_and_rest, check_cap, new_nose, nose_type, put_cap
    use body_nose_cone, only: cone_type
    use deck_job, only: view
    use geom_arc, only: end_type, weight
    use geom_arc_point, only: curvature, tangent
    use geom_chain, only: chain_type, chain_value
    use geom_place, only: at_finish, at_start
    use geom_stroke, only: stroke_type
    use support_bodies, only: conic_view, constant_view, straight_view
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: good = 1.0e-14_dp
    type(tap_type) :: tap
    type(nose_type) :: nose
    type(chain_type) :: chain
    type(stroke_type), allocatable :: strokes(:)
    type(error_type), allocatable :: error

    !> Slope 3/4 from (100, 5), axis level, radius 15.
    nose = new_nose(cone_type(apex=[100.0_dp, 5.0_dp], axis=0.0_dp, steepness=0.75_dp, &
        aft=180.0_dp), 15.0_dp)
    nose%height = 12.0_dp
    call tap%ok(nose%blend == 116.0_dp, 'the cap ends where the sphere touches the cone')
    call tap%ok(all(nose%tip == [110.0_dp, 5.0_dp]), 'and begins at its pole')
    chain = straight_view([100.0_dp, 5.0_dp], [180.0_dp, 65.0_dp])
    call check_cap(nose, chain, view%side, error)
    call tap%ok(.not. allocated(error), 'the steepest line has a cap')
    call cap_and_rest(nose, view%side, chain, strokes, error)
    call tap%ok(size(strokes) == 2 .and. strokes(2)%arc%is_line, 'before a straight rest')
    call tap%ok(all(strokes(1)%arc%finish == [116.0_dp, 17.0_dp]), 'they share the blend')
    call tap%near(weight(strokes(1)%arc), cos(0.5_dp*acos(0.6_dp)), good, &
        'it is the arc of a circle')
    call tap%near(curvature(strokes(1)%arc, at_start), -1.0_dp/15.0_dp, good, 'of that radius')
    call tap%near(curvature(strokes(1)%arc, at_finish), -1.0_dp/15.0_dp, good, 'all the way')
    call put_cap(nose, view%side, 0.0_dp, chain, error)
    call tap%near(chain_value(chain, 113.0_dp), 14.0_dp, good, 'through (113, 14)')
    call tap%ok(all(chain%knot == [110.0_dp, 116.0_dp, 180.0_dp]), 'and a chain with the rest')

    chain = straight_view([100.0_dp, 0.0_dp], [180.0_dp, -36.0_dp])
    call put_cap(nose, view%plan, 0.0_dp, chain, error)
    call tap%near(chain_value(chain, 113.0_dp), -5.4_dp, good, 'a lesser line gets the ellipse')
    chain = constant_view(5.0_dp)
    call put_cap(nose, view%side, 0.0_dp, chain, error)
    call tap%ok(chain%is_constant, 'a constant on the axis stays')
    chain = straight_view([90.0_dp, 5.0_dp], [180.0_dp, 5.0_dp])
    call put_cap(nose, view%side, 0.0_dp, chain, error)
    call tap%ok(all(chain%knot == [110.0_dp, 116.0_dp, 180.0_dp]) .and. &
        chain%stroke(1)%arc%is_line, &
        'a line on it stays straight')

    chain = straight_view([110.0_dp, 5.0_dp], [180.0_dp, 75.0_dp])
    call check_cap(nose, chain, view%side, error)
    call tap%ok(error%cause == cause%no_arc, 'a tangent through the tip leaves no triangle')
    chain = straight_view([110.0_dp, 6.0_dp], [180.0_dp, 76.0_dp])
    call check_cap(nose, chain, view%side, error)
    call tap%ok(.not. allocated(error), 'one above it does')
    chain = straight_view([116.0_dp - 4.0_dp, 2.0_dp], [120.0_dp, 8.0_dp])
    call check_cap(nose, chain, view%side, error)
    call tap%ok(error%cause == cause%no_arc, 'a line that crosses the axis at the blend has none')

    !> A cone whose axis rises by .2; a parabola y = x/2 - x**2/200 of offsets.
    nose = new_nose(cone_type(apex=[0.0_dp, 7.0_dp], axis=0.2_dp, steepness=0.75_dp, &
        aft=80.0_dp), 15.0_dp)
    nose%height = 12.0_dp
    chain = straight_view([0.0_dp, 7.0_dp], [80.0_dp, -37.0_dp])
    call put_cap(nose, view%side, 0.0_dp, chain, error)
    call tap%near(chain_value(chain, 13.0_dp), 7.0_dp + 2.6_dp - 9.0_dp, good, &
        'on an oblique axis it is the circle, sheared')
    chain = conic_view(end_type([0.0_dp, 0.0_dp], [1.0_dp, 0.5_dp]), [20.0_dp, 8.0_dp], &
        end_type([40.0_dp, 12.0_dp], [1.0_dp, 0.1_dp]))
    call cap_and_rest(nose, view%plan, chain, strokes, error)
    call tap%near(curvature(strokes(1)%arc, at_start), &
        -1.0_dp/(15.0_dp*(6.72_dp/12.0_dp)**2), good, &
        'a curved line gets the radius of its share')
    call tap%ok(strokes(1)%arc%start_tangent(1) == 0.0_dp .and. &
        strokes(1)%arc%start_tangent(2) > 0.0_dp, 'upright')
    associate (along => tangent(strokes(1)%arc, at_finish))
        call tap%near(along(2)/along(1), 0.34_dp, good, 'up to its own slope')
    end associate
    call put_cap(nose, view%plan, 0.0_dp, chain, error)
    call tap%near(chain_value(chain, 30.0_dp), 15.0_dp - 4.5_dp, good, 'and is itself behind it')
    call tap%finish()

end program test_nose_cap
