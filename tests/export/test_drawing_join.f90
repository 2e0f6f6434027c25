!> Tests of curves end to end.
program test_drawing_join
    use base_kinds, only: dp
    use cut_plane, only: buttock_plane, plane_type, waterline_plane
    use export_drawing, only: contour_type, curve_type
    use export_drawing_fit, only: arc_curve
    use export_drawing_join, only: first_point, gap_between, in_plane, join, last_point, &
        put_in_space, seat_ends
    use geom_arc, only: line_between
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(curve_type) :: first, second
    type(contour_type) :: contour
    type(plane_type) :: plane
    logical :: meets(2)
    real(dp), parameter :: tiny_gap = 1.0e-14_dp

    first = arc_curve(line_between([0.0_dp, 1.0_dp], [3.0_dp, 5.0_dp]))
    second = arc_curve(line_between([3.0_dp, 5.0_dp + 2.0_dp*tiny_gap], [9.0_dp, 5.0_dp]))
    call tap%ok(gap_between(first, second) > 0.0_dp, 'two curves that miss each other by rounding')
    call join(last_point(first), 10.0_dp*tiny_gap, second)
    call tap%near(gap_between(first, second), 0.0_dp, 0.0_dp, 'meet when joined')
    call tap%ok(second%is_exact .and. second%is_conic .and. &
        all(abs(second%arc%start - first%arc%finish) <= 0.0_dp), 'exact as before, the arc, too')
    call join([3.0_dp, 5.001_dp], 10.0_dp*tiny_gap, second)
    call tap%ok(.not. second%is_exact .and. .not. second%is_conic, 'a real gap makes them inexact')
    call tap%near(second%error, 1.0e-3_dp, 1.0e-12_dp, 'by what it is')
    call tap%near(second%worst(2), 5.001_dp, 0.0_dp, 'where it is')

    plane = buttock_plane(7.0_dp)
    second = first
    call put_in_space(plane, second)
    call tap%ok(all(abs(first_point(second) - [0.0_dp, 7.0_dp, 1.0_dp]) <= 0.0_dp) .and. &
        all(abs(last_point(second) - [3.0_dp, 7.0_dp, 5.0_dp]) <= 0.0_dp), &
        'a curve of a butt line in space is in it, to the last bit')
    call tap%near(second%worst(2), 7.0_dp, 0.0_dp, 'and so is its worst place')
    call tap%ok(all(abs(in_plane(plane, second%spline%pole) - first%spline%pole) <= 0.0_dp), &
        'its points have u and v as before')

    plane = waterline_plane(2.0_dp)
    allocate (contour%curves(1), contour%marks(0))
    contour%curves(1) = arc_curve(line_between([10.0_dp, 1.0e-16_dp], [20.0_dp, -4.0_dp]))
    call put_in_space(plane, contour%curves(1))
    call seat_ends(plane, contour, meets)
    call tap%ok(meets(1) .and. .not. meets(2), 'an end at BL 0 but for rounding is found')
    call tap%ok(abs(contour%curves(1)%spline%pole(2, 1)) <= 0.0_dp .and. &
        abs(contour%curves(1)%arc%start(2)) <= 0.0_dp, 'and put there')
    contour%curves(1)%spline%pole(2, 1) = 1.0e-6_dp
    call seat_ends(plane, contour, meets)
    call tap%ok(.not. any(meets), 'one that is 1e-6 off is not')
    contour%curves(1)%spline%pole(2, 1) = 0.0_dp
    contour%is_closed = .true.
    call seat_ends(plane, contour, meets)
    call tap%ok(.not. any(meets), 'a closed contour has no ends')
    call tap%finish()
end program test_drawing_join
