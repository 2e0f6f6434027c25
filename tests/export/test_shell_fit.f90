!> Tests of fitted rows: values at nodes, ends, shared poles, curves of tracks and ribs.
program test_shell_fit
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use export_shell_fit, only: fit_rows, fit_type, rib_spline, slot_surface, track_spline
    use export_shell_ribs, only: ribs_of, ribs_type
    use export_shell_rows, only: form, rows_at, rows_type
    use export_shell_stretch, only: stretch_type, stretches_of, track_at
    use geom_bspline, only: bspline_type, spline_point
    use geom_bspline_surface, only: bspline_surface_type, surface_point
    use geom_spline_fit, only: fit_nodes
    use support_skins, only: deck_body
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(stretch_type), allocatable :: stretches(:)
    type(ribs_type) :: ribs
    type(fit_type) :: fit
    type(error_type), allocatable :: error
    type(bspline_surface_type) :: side, fillet, halves
    type(bspline_type) :: curve
    type(rows_type) :: rows
    real(dp), allocatable :: nodes(:)
    real(dp) :: worst, at(3)
    integer :: i

    body = deck_body('fuselage')
    call stretches_of(body, 1.0e-3_dp, .false., stretches)
    call ribs_of(stretches, ribs, error)
    fit%pace = stretches(5)%pace
    fit%degree = 5
    fit%breaks = [0.0_dp, 0.3_dp, 1.0_dp]
    call fit_rows(stretches(5), ribs%ends(5), fit, error)
    call tap%ok(.not. allocated(error), 'the aft fuselage is fitted')
    side = slot_surface(fit, stretches(5), ribs%ends(5), 2, form%arc)
    fillet = slot_surface(fit, stretches(5), ribs%ends(5), 3, form%arc)
    halves = slot_surface(fit, stretches(5), ribs%ends(5), 2, form%halves)
    call tap%ok(all(shape(side%weight) == [7, 3]) .and. all(shape(halves%weight) == [7, 5]), &
        'two spans of degree 5 have seven poles, around three, in halves five')
    call tap%ok(all(side%pole(:, :, 1) == fillet%pole(:, :, 3)), 'neighbours share their poles')
    call tap%ok(all(side%weight(:, [1, 3]) == 1.0_dp), 'ends of sections weigh 1')

    allocate (nodes, source=fit_nodes(fit%breaks, 5))
    worst = 0.0_dp
    do i = 2, size(nodes) - 1
        at = surface_point(side, nodes(i), 0.0_dp)
        worst = max(worst, norm2(at - [200.0_dp + 80.0_dp*nodes(i), track_at(stretches(5), &
            stretches(5)%tracks(stretches(5)%slots(2)%track(1)), 200.0_dp + 80.0_dp*nodes(i))]))
        call rows_at(stretches(5), stretches(5)%slots(2), 200.0_dp + 80.0_dp*nodes(i), rows, error)
        at = surface_point(side, nodes(i), 0.5_dp)
        worst = max(worst, norm2(at(2:) - (0.25_dp*(rows%start + rows%finish) + &
            0.5_dp*rows%middle)/(0.5_dp + 0.5_dp*rows%weight)))
    end do
    call tap%ok(worst < 1.0e-12_dp, 'at its nodes the surface is the skin')
    worst = 0.0_dp
    do i = 0, 20
        worst = max(worst, norm2(surface_point(side, 0.37_dp, real(i, dp)/20.0_dp) - &
            surface_point(halves, 0.37_dp, real(i, dp)/20.0_dp)))
    end do
    call tap%ok(worst < 1.0e-13_dp, 'in halves it is the same surface')

    call tap%ok(all(fillet%pole(:, 1, :) == spread([200.0_dp, 0.0_dp, 26.0_dp], 2, 3)), &
        'a section that is a point has all poles there, exactly')
    curve = track_spline(fit, stretches(5)%slots(2)%track(1))
    call tap%ok(all(curve%pole == side%pole(:, :, 1)) .and. all(curve%knot == side%u_knot), &
        'the curve of a track is an edge of its surfaces')
    curve = rib_spline(ribs%ends(5)%rows(2, 2), 280.0_dp, form%arc)
    call tap%ok(all(curve%pole == side%pole(:, 7, :)) .and. &
        all(curve%weight == side%weight(7, :)), 'so is that of a rib')
    curve = rib_spline(ribs%ends(5)%rows(2, 2), 280.0_dp, form%halves)
    call tap%ok(all(curve%pole == halves%pole(:, 7, :)) .and. all(curve%knot == halves%v_knot), &
        'in halves, too')
    curve = rib_spline(ribs%ends(5)%rows(2, 2), 280.0_dp, form%line)
    at = spline_point(curve, 0.5_dp)
    call tap%ok(curve%degree == 1 .and. at(1) == 280.0_dp, 'a straight one is of degree 1')
    fit%breaks = [0.0_dp, 0.3_dp, 0.3_dp, 1.0_dp]
    call fit_rows(stretches(5), ribs%ends(5), fit, error)
    call tap%ok(allocated(error), 'breaks that do not rise are refused')
    if (allocated(error)) call tap%ok(error%cause == cause%singular, 'as singular')
    call tap%finish()
end program test_shell_fit
