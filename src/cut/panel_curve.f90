!> A track of a panel as a cubic spline with a continuous tangent: through points of the track with
!> its tangents there, as many as bring it within `panel_curve_tolerance` of the panel's size. A
!> whole section of a duct is the line of its surface around, exactly.
module cut_panel_curve
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_tolerances, only: panel_curve_tolerance
    use cut_meeting, only: is_across
    use cut_outline, only: cut_point_type, panel_curve_type
    use cut_panel_point, only: point_on_panel
    use cut_panel_walk, only: last_place, point_at, walk_type
    use geom_bspline, only: bspline_type, reversed_spline, spline_jet
    use geom_bspline_surface, only: surface_line
    implicit none (type, external)
    private

    public :: curve_of_walk

    !> Halvings of a piece at most, and the step by which a direction is taken where the panel has
    !> no tangent.
    integer, parameter :: most_halvings = 12
    real(dp), parameter :: short_step = 1.0e-3_dp

contains

    !> The curve of a track, from its first point to its last.
    pure type(panel_curve_type) function curve_of_walk(walk) result(curve)
        type(walk_type), intent(in) :: walk !! the track
        real(dp), allocatable :: place(:), more(:)
        real(dp) :: tolerance, off, t, at(3)
        integer :: i, round

        if (walk%panel%is_round .and. walk%track%is_closed .and. is_across(walk%plane)) then
            curve%spline = line_around(walk)
            curve%is_exact = .true.
            return
        end if
        tolerance = panel_curve_tolerance*maxval([(maxval(walk%panel%surface%pole(i, :, :)) &
            - minval(walk%panel%surface%pole(i, :, :)), i = 1, 3)])
        allocate (place(0), more(0))
        place = [(real(i, dp), i = 0, nint(last_place(walk)))]
        do round = 1, most_halvings
            curve%spline = through(walk, place)
            curve%error = 0.0_dp
            more = [place(1)]
            do i = 1, size(place) - 1
                at = point_at(walk, 0.5_dp*(place(i) + place(i + 1)))
                t = 0.5_dp*(curve%spline%knot(2*i + 1) + curve%spline%knot(2*i + 3))
                off = beside(curve%spline, t, at)
                if (off > tolerance) more = [more, 0.5_dp*(place(i) + place(i + 1))]
                more = [more, place(i + 1)]
                if (off <= curve%error) cycle
                curve%error = off
                curve%worst = at
            end do
            if (size(more) == size(place)) exit
            place = more
        end do
    end function curve_of_walk

    !> The line of a duct around, at the station of a track and as it runs.
    pure type(bspline_type) function line_around(walk) result(spline)
        type(walk_type), intent(in) :: walk !! the track, which begins where u is 0

        spline = surface_line(walk%panel%surface, walk%track%uv(2, 1))
        spline%pole(1, :) = walk%plane%through(1)
        if (walk%track%uv(1, 2) > 0.5_dp) spline = reversed_spline(spline)
    end function line_around

    !> How far a point is from a spline near a parameter: across its tangent there.
    pure real(dp) function beside(spline, t, at) result(off)
        type(bspline_type), intent(in) :: spline    !! any
        real(dp), intent(in) :: t                   !! a parameter
        real(dp), intent(in) :: at(3)               !! deck units
        real(dp) :: point(3), first(3), second(3), way(3)
        call spline_jet(spline, t, point, first, second)
        way = at - point
        off = norm2(way)
        if (is_zero(norm2(first))) return
        first = first/norm2(first)
        off = norm2(way - dot_product(way, first)*first)
    end function beside

    !> The spline through the points of some places with the tangents there; its parameter is the
    !> length of the chords. Inner knots are double, so that the tangent is continuous.
    pure type(bspline_type) function through(walk, place) result(spline)
        type(walk_type), intent(in) :: walk     !! the track
        real(dp), intent(in) :: place(:)        !! rising
        real(dp) :: at(3, size(place)), way(3, size(place)), t(size(place))
        integer :: i, n

        n = size(place)
        do i = 1, n
            at(:, i) = point_at(walk, place(i))
            way(:, i) = direction(walk, place(i))
        end do
        t(1) = 0.0_dp
        do i = 2, n
            t(i) = t(i - 1) + norm2(at(:, i) - at(:, i - 1))
        end do
        spline%degree = 3
        allocate (spline%knot(2*n + 4), spline%pole(3, 2*n), spline%weight(2*n))
        spline%knot(:2) = t(1)
        spline%knot(2*n + 3:) = t(n)
        do i = 1, n
            spline%knot(2*i + 1:2*i + 2) = t(i)
        end do
        spline%pole(:, 1) = at(:, 1)
        do i = 1, n - 1
            spline%pole(:, 2*i) = at(:, i) + (t(i + 1) - t(i))/3.0_dp*way(:, i)
            spline%pole(:, 2*i + 1) = at(:, i + 1) - (t(i + 1) - t(i))/3.0_dp*way(:, i + 1)
        end do
        spline%pole(:, 2*n) = at(:, n)
        spline%weight = 1.0_dp
    end function through

    !> The unit tangent of a track, ahead; 0 where all of it is one point.
    pure function direction(walk, s) result(way)
        type(walk_type), intent(in) :: walk     !! the track
        real(dp), intent(in) :: s               !! place
        real(dp) :: way(3), next, step
        type(cut_point_type) :: point

        step = short_step
        do
            next = min(s + step, last_place(walk))
            way = point_at(walk, next) - point_at(walk, max(next - step, 0.0_dp))
            if (.not. is_zero(norm2(way))) exit
            if (step > last_place(walk)) return
            step = 2.0_dp*step
        end do
        way = way/norm2(way)
        point = point_on_panel(walk, s, way, .false.)
        if (.not. point%has_slope) return
        if (point%slope%is_vertical) then
            way = sign(1.0_dp, dot_product(way, walk%plane%v))*walk%plane%v
        else
            associate (along => walk%plane%u + point%slope%value*walk%plane%v)
                way = sign(1.0_dp, dot_product(way, along))*along/norm2(along)
            end associate
        end if
    end function direction

end module cut_panel_curve
