!> A section at a row of stations: an ellipsoid in closed form; points, traces and arcs are those of
!> one station after another.
program test_section_row
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_line, only: line_point
    use body_section, only: section_arc, trace_at, trace_type
    use body_section_row, only: find_arcs, line_points, row_arcs, row_patches, traces_at
    use body_surface_row, only: patch_row_type
    use geom_arc, only: arc_type
    use geom_arc_row, only: arc_row_type
    use geom_twofold_short, only: width
    use support_bodies, only: ellipsoid, nose_of_the_book
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(patch_row_type) :: patch
    type(arc_row_type) :: row
    type(arc_type) :: arc
    type(trace_type) :: trace
    type(trace_type) :: traces(100)
    type(error_type), allocatable :: error
    real(dp) :: sta(width), at(2, 100), many(100)
    logical :: is_sure(width), is_smooth(width), is_there(100)
    integer :: i, wrong(3)

    body = ellipsoid([5.0_dp, 3.0_dp, 2.0_dp], 0.0_dp, 0.0_dp)
    sta = [(-5.0_dp + 10.0_dp*real(i - 1, dp)/real(width - 1, dp), i=1, width)]
    call row_patches(body%lines, body%sections(1), sta, .true., patch, is_smooth)
    call tap%ok(.not. is_smooth(1) .and. .not. is_smooth(width) .and. &
        all(is_smooth(2:width - 1)), 'the ends of an ellipsoid are not smooth')
    call tap%near(maxval(abs(patch%point(2, 1)%value + 2.0_dp*sqrt(1.0_dp - (sta/5.0_dp)**2))), &
        0.0_dp, 1.0e-15_dp, 'its keel')
    call tap%near(maxval(abs(patch%point(2, 1)%value*patch%point(2, 1)%first &
        + 0.16_dp*sta), mask=is_smooth), 0.0_dp, 1.0e-14_dp, 'the slope of its keel')
    call row_arcs(patch, row, is_sure)
    call tap%ok(all(is_sure(2:width - 1)) .and. .not. is_sure(1), 'and arcs but at its ends')

    body = nose_of_the_book()
    many = [(-30.0_dp + 80.0_dp*real(i - 1, dp)/99.0_dp, i=1, 100)]
    call line_points(body%lines(2), many, at)
    call traces_at(body%lines, body%sections(1), many, traces)
    call find_arcs(body%lines, body%sections(1), many, is_there)
    wrong = 0
    do i = 1, 100
        if (any(at(:, i) /= line_point(body%lines(2), many(i)))) wrong(1) = wrong(1) + 1
        trace = trace_at(body%lines, body%sections(1), many(i))
        if (any(traces(i)%shoulder /= trace%shoulder)) wrong(2) = wrong(2) + 1
        if (any(traces(i)%finish%tangent /= trace%finish%tangent)) wrong(2) = wrong(2) + 1
        call section_arc(body%lines, body%sections(1), many(i), arc, error)
        if (is_there(i) .eqv. allocated(error)) wrong(3) = wrong(3) + 1
    end do
    call tap%ok(wrong(1) == 0, 'points of a line are those of one station after another')
    call tap%ok(wrong(2) == 0, 'traces, too')
    call tap%ok(wrong(3) == 0, 'arcs are where one alone is')
    call traces_at(body%lines, body%sections(1), spread(20.0_dp, 1, 7), traces(:7))
    trace = trace_at(body%lines, body%sections(1), 20.0_dp)
    call tap%ok(all(traces(7)%start%point == trace%start%point), 'one station, often')
    call tap%finish()
end program test_section_row
