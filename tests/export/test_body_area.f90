!> Tests of the area curve: on an ellipsoid it is a parabola.
program test_body_area
    use base_kinds, only: dp
    use body_body, only: body_type, finish_body
    use cut_measure_body, only: body_measure_type, measure_body
    use export_body_area, only: area_drawing
    use export_body_drawing, only: drawing_type
    use support_solids, only: ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(drawing_type) :: drawing
    type(body_type) :: body
    type(body_measure_type) :: measure
    real(dp), parameter :: pi = acos(-1.0_dp)
    real(dp), allocatable :: at(:, :)

    body = ellipsoid([5.0_dp, 3.0_dp, 2.0_dp])
    call measure_body(body, [1.0_dp], measure)
    drawing = area_drawing(body, measure, [1.0_dp, 9.0_dp], 'EGG', 'inches')
    allocate (at, source=drawing%layer(1)%stroke(1)%at)
    call tap%ok(all(abs(at(2, :) - 6.0_dp*pi*(1.0_dp - (at(1, :)/5.0_dp)**2)) < 1.0e-10_dp), &
        'the areas of an ellipsoid: a parabola over the stations')
    call tap%ok(all(at(1, 2:) >= at(1, :size(at, 2) - 1)), 'from fore to aft')
    call tap%ok(abs(at(1, 1) + 5.0_dp) < 1.0e-5_dp .and. abs(at(1, size(at, 2)) - &
        5.0_dp) < 1.0e-5_dp, &
        'from end to end')
    call tap%ok(index(drawing%view, 'volume 125.664 cubic inches, centroid STA 0, BL 0, WL 0') &
        > 0, 'volume and centroid are told')
    call tap%ok(drawing%layer(2)%count == 1, 'a station asked is marked, one off the body is not')
    body%sections = body%sections(2:2)
    body%is_closed = .false.
    call finish_body(body)
    call measure_body(body, [1.0_dp], measure)
    drawing = area_drawing(body, measure, [1.0_dp], 'HALF', 'inches')
    call tap%ok(index(drawing%view, 'Girth of the sections; no area: ') == 1, &
        'where sections are open: girths, and why')
    call tap%finish()
end program test_body_area
