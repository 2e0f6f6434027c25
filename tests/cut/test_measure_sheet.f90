!> Points of sheets and their derivatives against central differences of the points, and these
!> against the arcs of the sections.
program test_measure_sheet
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_section, only: section_arc
    use body_taylor, only: taylor_type
    use cut_measure_sheet, only: frame_at, frame_type, new_span, span_type, spot_at, spot_type, &
        station_of
    use geom_arc, only: arc_type
    use geom_arc_point, only: point
    use geom_place, only: place_at
    use support_solids, only: cone, ellipsoid, paraboloid, waist
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: small = 1.0e-4_dp
    type(tap_type) :: tap
    type(body_type) :: body
    type(span_type) :: span
    type(taylor_type) :: sta
    type(frame_type) :: frame
    type(error_type), allocatable :: error

    body = ellipsoid([10.0_dp, 3.0_dp, 2.0_dp])
    span = new_span(body, [1, 2], -10.0_dp, 0.0_dp)
    call tap%ok(span%is_blunt(1) .and. .not. span%is_blunt(2), 'an ellipsoid is blunt before')
    call check_sheet('the fore half of an ellipsoid')
    span = new_span(body, [1, 2], 0.0_dp, 10.0_dp)
    call tap%ok(span%is_blunt(2) .and. .not. span%is_blunt(1), 'and behind')
    call check_sheet('the aft half of an ellipsoid')
    span%is_blunt = .true.
    call check_sheet('the same as if blunt at both ends')
    body = paraboloid(2.0_dp, 9.0_dp)
    span = new_span(body, [1], 0.0_dp, 9.0_dp)
    call tap%ok(span%is_blunt(1) .and. .not. span%is_blunt(2), 'a paraboloid has a blunt nose')
    call check_sheet('a paraboloid')
    body = waist()
    span = new_span(body, [2], -0.75_dp, 0.75_dp)
    call tap%ok(.not. any(span%is_blunt), 'a waist is not blunt')
    call check_sheet('a waist')
    body = cone(3.0_dp, 4.0_dp, 0.0_dp)
    span = new_span(body, [1, 2], 0.0_dp, 4.0_dp)
    call tap%ok(.not. any(span%is_blunt), 'nor is a cone')
    call check_sheet('a cone')
    call frame_at(body, body%sections(1), station_of(span, 0.0_dp), frame, error)
    call tap%ok(allocated(error), 'the apex of a cone has no arc')
    if (allocated(error)) call tap%ok(error%cause == cause%points_coincide, 'being a point')
    sta = station_of(span, 1.0_dp)
    call tap%ok(abs(sta%value - 4.0_dp) <= 0.0_dp, 'the last station is met exactly')
    call tap%finish()

contains

    !> Checks points and derivatives at some places.
    subroutine check_sheet(name)
        character(*), intent(in) :: name
        real(dp) :: u, t, first, second, off
        type(spot_type) :: s, a, b, c, d
        type(arc_type) :: arc
        integer :: i, k
        first = 0.0_dp
        second = 0.0_dp
        off = 0.0_dp
        do i = 1, 9
            do k = 1, 9
                u = 0.1_dp*real(i, dp)
                t = 0.1_dp*real(k, dp)
                s = spot(u, t)
                call section_arc(body%lines, body%sections(1), s%at(1), arc, error)
                off = max(off, norm2(s%at(2:) - point(arc, place_at(t))))
                a = spot(u - small, t)
                b = spot(u + small, t)
                c = spot(u, t - small)
                d = spot(u, t + small)
                first = max(first, norm2((b%at - a%at)/(2.0_dp*small) - s%u), &
                    norm2((d%at - c%at)/(2.0_dp*small) - s%t))
                second = max(second, norm2((b%u - a%u)/(2.0_dp*small) - s%uu), &
                    norm2((d%u - c%u)/(2.0_dp*small) - s%ut), &
                    norm2((b%t - a%t)/(2.0_dp*small) - s%ut), &
                    norm2((d%t - c%t)/(2.0_dp*small) - s%tt))
            end do
        end do
        call tap%near(off, 0.0_dp, 1.0e-13_dp, 'points of '//name)
        call tap%near(first, 0.0_dp, 1.0e-5_dp, 'first derivatives of '//name)
        call tap%near(second, 0.0_dp, 1.0e-5_dp, 'second derivatives of '//name)
    end subroutine check_sheet

    !> The point of the first section at u and t.
    type(spot_type) function spot(u, t)
        real(dp), intent(in) :: u, t
        type(frame_type) :: frame
        call frame_at(body, body%sections(1), station_of(span, u), frame, error)
        if (allocated(error)) error stop 'no frame'
        spot = spot_at(frame, t)
    end function spot

end program test_measure_sheet
