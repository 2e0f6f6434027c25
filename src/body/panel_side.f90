!> A side of a panel: a part of a control line in space, of the arc of a section at a station, of a
!> curve that a plane cuts from the skin, or a point.
!>
!> A part of a line is run through evenly in STA; where a view of it is vertical at an end, by the
!> square of the parameter from there, so that the side has a tangent like any other.
module body_panel_side
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_line, only: line_point, line_type
    use geom_arc, only: arc_type, reversed
    use geom_arc_point, only: arc_point => point
    use geom_bspline, only: bspline_type, spline_point
    use geom_chain, only: chain_jet, chain_type
    use geom_curve_fit, only: curve_function_type, fit_curve
    use geom_jet, only: jet_type
    use geom_place, only: place_at
    use geom_spline_fit, only: fit_knots
    use geom_subarc, only: part_of
    implicit none (type, external)
    private

    public :: side_type, line_side, arc_side, curve_side, point_side, side_part, side_spline
    public :: place_on

    !> A side, run through from its first corner to its last.
    type, extends(curve_function_type) :: side_type
        logical :: is_point = .false.           !! it is the point `corner`
        logical :: is_arc = .false.             !! it is `arc` at station `from`
        logical :: is_curve = .false.           !! it is `curve` from parameter `from` to `to`
        real(dp) :: corner(3) = 0.0_dp          !! deck units
        type(arc_type) :: arc                   !! x is BL, y is WL
        type(bspline_type) :: curve             !! over 0 to 1
        type(line_type) :: line                 !! else: a part of this line
        real(dp) :: from = 0.0_dp               !! STA where it begins, deck units; of a curve: t
        real(dp) :: to = 0.0_dp                 !! STA where it ends, deck units; of a curve: t
        logical :: is_vertical(2) = .false.     !! a view of the line is at its first, last corner
    contains
        procedure :: at => side_point
    end type side_type

    !> Degree of the splines.
    integer, parameter :: degree = 5

contains

    !> The part of a line between two stations, from the first to the second.
    pure type(side_type) function line_side(line, from, to) result(side)
        type(line_type), intent(in) :: line !! a control line with a side view
        real(dp), intent(in) :: from        !! deck units, where the line is
        real(dp), intent(in) :: to          !! deck units, where the line is

        side%line = line
        side%from = from
        side%to = to
        side%is_vertical = [is_vertical_at(line%side, from), is_vertical_at(line%side, to)]
        if (.not. line%has_plan) return
        side%is_vertical = side%is_vertical .or. &
            [is_vertical_at(line%plan, from), is_vertical_at(line%plan, to)]
    end function line_side

    !> True where a view is vertical.
    pure logical function is_vertical_at(view, sta)
        type(chain_type), intent(in) :: view    !! of a line
        real(dp), intent(in) :: sta             !! deck units
        type(jet_type) :: jet
        call chain_jet(view, sta, jet, is_vertical_at)
    end function is_vertical_at

    !> The arc of a section at a station.
    pure type(side_type) function arc_side(arc, sta) result(side)
        type(arc_type), intent(in) :: arc   !! as the side runs
        real(dp), intent(in) :: sta         !! deck units
        side%is_arc = .true.
        side%arc = arc
        side%from = sta
        side%to = sta
    end function arc_side

    !> A curve in space, from its start to its end.
    pure type(side_type) function curve_side(curve) result(side)
        type(bspline_type), intent(in) :: curve !! over 0 to 1
        side%is_curve = .true.
        side%curve = curve
        side%to = 1.0_dp
    end function curve_side

    !> The part of a side between two parameters of it, from the first to the second.
    pure type(side_type) function side_part(side, first, second) result(part)
        type(side_type), intent(in) :: side !! any but a point
        real(dp), intent(in) :: first       !! 0 to 1
        real(dp), intent(in) :: second      !! 0 to 1, another
        real(dp) :: ends(2)

        if (side%is_arc) then
            part = side
            part%arc = part_of(side%arc, place_at(min(first, second)), place_at(max(first, second)))
            if (first > second) part%arc = reversed(part%arc)
        else if (side%is_curve) then
            part = side
            part%from = side%from + first*(side%to - side%from)
            part%to = side%from + second*(side%to - side%from)
        else
            ends = [station_at(side, first), station_at(side, second)]
            part = line_side(side%line, ends(1), ends(2))
        end if
    end function side_part

    !> A point.
    pure type(side_type) function point_side(corner) result(side)
        real(dp), intent(in) :: corner(3) !! deck units
        side%is_point = .true.
        side%corner = corner
        side%from = corner(1)
        side%to = corner(1)
    end function point_side

    !> A point of a side.
    pure function side_point(f, t) result(point)
        class(side_type), intent(in) :: f   !! the side
        real(dp), intent(in) :: t           !! 0 at its first corner to 1 at its last
        real(dp) :: point(3), sta

        if (f%is_point) then
            point = f%corner
        else if (f%is_arc) then
            point = [f%from, arc_point(f%arc, place_at(t))]
        else if (f%is_curve) then
            point = spline_point(f%curve, (1.0_dp - t)*f%from + t*f%to)
        else
            sta = station_at(f, t)
            point = [sta, line_point(f%line, sta)]
        end if
    end function side_point

    !> The station of a parameter.
    pure real(dp) function station_at(f, t) result(sta)
        class(side_type), intent(in) :: f   !! a part of a line
        real(dp), intent(in) :: t           !! 0 to 1
        real(dp) :: share, left

        share = t
        left = 1.0_dp - t
        if (all(f%is_vertical)) then
            share = t**2*(3.0_dp - 2.0_dp*t)
            left = left**2*(1.0_dp + 2.0_dp*t)
        else if (f%is_vertical(1)) then
            share = t**2
            left = left*(1.0_dp + t)
        else if (f%is_vertical(2)) then
            share = t*(2.0_dp - t)
            left = left**2
        end if
        if (share < left) then
            sta = f%from + share*(f%to - f%from)
        else
            sta = f%to - left*(f%to - f%from)
        end if
    end function station_at

    !> A side as a spline over 0 to 1, run through backwards if wanted. Fails as `fit_curve`.
    pure subroutine side_spline(side, is_turned, tolerance, spline, error)
        type(side_type), intent(in) :: side                 !! any
        logical, intent(in) :: is_turned                    !! from its last corner to its first
        real(dp), intent(in) :: tolerance                   !! deck units
        type(bspline_type), intent(out) :: spline           !! of degree 5
        type(error_type), allocatable, intent(out) :: error !! see above
        type(side_type) :: run
        real(dp) :: largest, place

        if (side%is_point) then
            spline%degree = degree
            spline%knot = fit_knots([0.0_dp, 1.0_dp], degree)
            spline%pole = spread(side%corner, 2, degree + 1)
            allocate (spline%weight(degree + 1), source=1.0_dp)
            return
        end if
        run = side
        if (is_turned) run = turned(side)
        call fit_curve(run, tolerance, spline, largest, place, error)
    end subroutine side_spline

    !> A side run through from its last corner to its first.
    pure type(side_type) function turned(side) result(back)
        type(side_type), intent(in) :: side !! any
        back = side
        if (side%is_arc) back%arc = reversed(side%arc)
        back%from = side%to
        back%to = side%from
        back%is_vertical = side%is_vertical(2:1:-1)
    end function turned

    !> The parameters u and v of a place on a side of a panel: side 1 is v = 0, side 2 is u = 1, and
    !> so round.
    pure function place_on(number, t) result(uv)
        integer, intent(in) :: number   !! of the side
        real(dp), intent(in) :: t       !! 0 at its first corner to 1 at its last
        real(dp) :: uv(2)
        select case (number)
        case (1)
            uv = [t, 0.0_dp]
        case (2)
            uv = [1.0_dp, t]
        case (3)
            uv = [1.0_dp - t, 1.0_dp]
        case default
            uv = [0.0_dp, 1.0_dp - t]
        end select
    end function place_on

end module body_panel_side
