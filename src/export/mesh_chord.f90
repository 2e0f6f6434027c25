!> How far triangles between two rows of a section are from its exact skin: normal to the skin, at
!> the middles of their sides and of their faces. On a stop, where the skin may break, a side along
!> the row is measured in the plane of the section.
module export_mesh_chord
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_section, only: is_point, trace_at
    use body_taylor, only: taylor_type
    use cut_measure_sheet, only: frame_at, frame_type, span_type, spot_at, spot_type, station_of
    use export_mesh_form, only: distance_from, distance_in_plane, form_at, form_type
    use export_mesh_share, only: parameter_at
    implicit none (type, external)
    private

    public :: gauge_type, corner_type, new_gauge, measure_triangle, middle_distance, normal_at

    !> Steps of the parameter around a section that are small enough for the second order, and how
    !> many larger ones are taken.
    real(dp), parameter :: small_step = 1.0e-3_dp
    integer, parameter :: most_steps = 8

    !> The exact skin of a section between two rows: at the fore row, a third, a half and two thirds
    !> of the way, and the aft row.
    type :: gauge_type
        type(frame_type) :: frames(0:6)         !! at sixths of the way; 1 and 5 are not used
        logical :: is_there(0:6) = .false.      !! the section is not a point there
        logical :: is_stop(2) = .false.         !! the fore, the aft row is a stop
        real(dp) :: sta(2) = 0.0_dp             !! of both rows, deck units
    end type gauge_type

    !> A corner of a triangle.
    type :: corner_type
        real(dp) :: at(3) = 0.0_dp              !! STA, BL, WL, deck units
        real(dp) :: share = 0.0_dp              !! around the section
        integer :: row = 0                      !! 0: on the fore row, 6: on the aft row
        logical :: is_tip = .false.             !! the section is a point there, it has any share
    end type corner_type

contains

    !> The skin between two rows. Fails as `section_arc` where the section has no arc.
    pure subroutine new_gauge(body, section, span, u, gauge, error)
        type(body_type), intent(in) :: body                 !! finished
        integer, intent(in) :: section                      !! in the body's list
        type(span_type), intent(in) :: span                 !! the stretch of the rows
        real(dp), intent(in) :: u(2)                        !! of the rows
        type(gauge_type), intent(out) :: gauge              !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(taylor_type) :: sta
        real(dp) :: way
        integer :: i

        gauge%is_stop = [.not. u(1) > 0.0_dp, .not. u(2) < 1.0_dp]
        do i = 0, 6
            if (i == 1 .or. i == 5) cycle
            way = real(i, dp)/6.0_dp
            sta = station_of(span, (1.0_dp - way)*u(1) + way*u(2))
            if (i == 0 .and. gauge%is_stop(1)) sta%value = span%from
            if (i == 6 .and. gauge%is_stop(2)) sta%value = span%to
            if (i == 0) gauge%sta(1) = sta%value
            if (i == 6) gauge%sta(2) = sta%value
            gauge%is_there(i) = .not. is_point(trace_at(body%lines, body%sections(section), &
                sta%value))
            if (.not. gauge%is_there(i)) cycle
            call frame_at(body, body%sections(section), sta, gauge%frames(i), error)
            if (allocated(error)) return
        end do
    end subroutine new_gauge

    !> Measures a triangle at the middles of its sides and its own.
    pure subroutine measure_triangle(gauge, corners, largest, worst)
        type(gauge_type), intent(in) :: gauge           !! the skin
        type(corner_type), intent(in) :: corners(3)     !! of the triangle
        real(dp), intent(inout) :: largest              !! distance so far, deck units
        real(dp), intent(inout) :: worst(3)             !! where it is: STA, BL, WL
        integer :: i

        do i = 1, 3
            call measure_mean(gauge, [corners(i), corners(mod(i, 3) + 1)], largest, worst)
        end do
        call measure_mean(gauge, corners, largest, worst)
    end subroutine measure_triangle

    !> Measures the mean of some corners.
    pure subroutine measure_mean(gauge, corners, largest, worst)
        type(gauge_type), intent(in) :: gauge           !! the skin
        type(corner_type), intent(in) :: corners(:)     !! two or three
        real(dp), intent(inout) :: largest              !! distance so far, deck units
        real(dp), intent(inout) :: worst(3)             !! where it is: STA, BL, WL
        real(dp) :: at(3), distance
        integer :: i

        distance = middle_distance(gauge, corners)
        if (distance <= largest) return
        largest = distance
        do i = 1, 3
            at(i) = sum(corners%at(i))/real(size(corners), dp)
        end do
        worst = at
    end subroutine measure_mean

    !> How far the mean of some corners is from the skin.
    pure real(dp) function middle_distance(gauge, corners) result(distance)
        type(gauge_type), intent(in) :: gauge       !! the skin
        type(corner_type), intent(in) :: corners(:) !! two or three
        type(spot_type) :: spot
        real(dp) :: at(3), share
        integer :: row, i

        distance = 0.0_dp
        row = sum(corners%row)/size(corners)
        if (.not. gauge%is_there(row)) return
        share = sum(corners%share, mask=.not. corners%is_tip) &
            /real(max(1, count(.not. corners%is_tip)), dp)
        do i = 1, 3
            at(i) = sum(corners%at(i))/real(size(corners), dp)
        end do
        spot = spot_beside(gauge%frames(row), share, at)
        if ((row == 0 .and. gauge%is_stop(1)) .or. (row == 6 .and. gauge%is_stop(2))) then
            distance = distance_in_plane(spot, at)
        else
            distance = distance_from(spot, at)
        end if
    end function middle_distance

    !> A point of the skin at the station of a frame and near to another: that of a share, from
    !> where it is gone on around the section by Newton's method as long as the other is far on.
    pure type(spot_type) function spot_beside(frame, share, at) result(spot)
        type(frame_type), intent(in) :: frame   !! the section
        real(dp), intent(in) :: share           !! where to begin
        real(dp), intent(in) :: at(3)           !! the other point
        real(dp) :: t, step, way(3), pace
        integer :: i

        t = parameter_at(share, frame%fullness%value - 1.0_dp)
        do i = 1, most_steps
            spot = spot_at(frame, t)
            way = at - spot%at
            pace = dot_product(spot%t, spot%t)
            pace = max(pace - dot_product(way, spot%tt), 0.5_dp*pace)
            if (.not. pace > 0.0_dp) return
            step = dot_product(way, spot%t)/pace
            if (abs(step) < small_step) return
            t = min(1.0_dp, max(0.0_dp, t + step))
        end do
        spot = spot_at(frame, t)
    end function spot_beside

    !> The normal of the skin at a share of the fore or the aft row, along u x t, of unit length;
    !> zero where it is not to be had from there.
    pure function normal_at(gauge, row, share) result(normal)
        type(gauge_type), intent(in) :: gauge   !! the skin
        integer, intent(in) :: row              !! 0 or 6
        real(dp), intent(in) :: share           !! around the section
        real(dp) :: normal(3)
        type(form_type) :: form

        normal = 0.0_dp
        if (.not. gauge%is_there(row)) return
        associate (frame => gauge%frames(row))
            form = form_at(spot_at(frame, parameter_at(share, frame%fullness%value - 1.0_dp)))
        end associate
        if (form%is_there) normal = form%normal
    end function normal_at

end module export_mesh_chord
