!> What an arc is at a place: point, tangent, slope, curvature. With the notation of `geom_arc` and
!> D = (a - b)**2 + 2 a b q:
!>
!>     tangent    n = a**2 v1 + 2 a b h + b**2 v3          (dp = 2 n/D**2 dt for a = 1 - t, b = t)
!>     curvature  k = (g x h) D**3/|n|**3                  positive where the arc turns left
!>
!> Source: G. Farin, "Curves and Surfaces for CAGD", 5th ed., 12.6 (derivatives and curvature of
!> conics), written about the middle of the chord.
module geom_arc_point
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_tolerances, only: ulp
    use geom_arc, only: arc_type
    use geom_place, only: is_finish, is_start, place_type
    use geom_twofold, only: exact_sum, operator(*), operator(+), operator(-), operator(/), sqrt, &
        to_real, twofold_type
    use geom_vector, only: cross, dot
    implicit none (type, external)
    private

    public :: point, offset, tangent, curvature, slope_type, slope, slope_along

    !> A slope dy/dx, or none.
    type :: slope_type
        real(dp) :: value = 0.0_dp       !! dy/dx; zero where vertical
        logical :: is_vertical = .false. !! dy/dx is infinite
    end type slope_type

contains

    !> The point of an arc, x and y in deck units, each within half an ulp of the largest
    !> coordinate; the ends are exactly as given.
    pure function point(arc, place)
        type(arc_type), intent(in) :: arc     !! any arc
        type(place_type), intent(in) :: place !! where on it
        real(dp) :: point(2)
        type(twofold_type) :: way
        integer :: axis

        if (is_start(place)) then
            point = arc%start
        else if (is_finish(place)) then
            point = arc%finish
        else
            do axis = 1, 2
                way = exact_sum(arc%start(axis), 0.0_dp)
                point(axis) = to_real(way + arc%size*offset(arc, axis, place))
            end do
        end if
    end function point

    !> One coordinate of a point from the start of the arc, in `size` of the arc.
    pure type(twofold_type) function offset(arc, axis, place)
        type(arc_type), intent(in) :: arc     !! any arc
        integer, intent(in) :: axis           !! 1: x, 2: y
        type(place_type), intent(in) :: place !! where on it
        type(twofold_type) :: rise, along

        associate (a => place%alpha, b => place%beta)
            rise = 2.0_dp*(a*b)*arc%bulge(axis)
            along = (b - a)*(b + a)*arc%half(axis)
            offset = arc%half(axis) + (rise + along)/denominator(arc, place)
        end associate
    end function offset

    !> D, above zero on the arc.
    pure type(twofold_type) function denominator(arc, place)
        type(arc_type), intent(in) :: arc     !! any arc
        type(place_type), intent(in) :: place !! where on it
        type(twofold_type) :: apart

        apart = place%alpha - place%beta
        denominator = apart*apart + 2.0_dp*(place%alpha*place%beta)*arc%fullness
    end function denominator

    !> The tangent n, forward along the arc; its length has no meaning. For a line and at the ends
    !> it has the direction given.
    pure function tangent(arc, place)
        type(arc_type), intent(in) :: arc     !! any arc
        type(place_type), intent(in) :: place !! where on it
        real(dp) :: tangent(2)

        if (arc%is_line .or. is_start(place)) then
            tangent = arc%start_tangent
        else if (is_finish(place)) then
            tangent = arc%finish_tangent
        else
            tangent = to_real(hodograph(arc, place))
        end if
    end function tangent

    !> The vector n of the module's head, in `size` of the arc.
    pure function hodograph(arc, place) result(n)
        type(arc_type), intent(in) :: arc     !! any arc
        type(place_type), intent(in) :: place !! where on it
        type(twofold_type) :: n(2)
        integer :: axis

        associate (a => place%alpha, b => place%beta)
            do axis = 1, 2
                n(axis) = a*a*arc%leaving(axis) + 2.0_dp*(a*b)*arc%half(axis) &
                    + b*b*arc%arriving(axis)
            end do
        end associate
    end function hodograph

    !> The slope of an arc.
    pure type(slope_type) function slope(arc, place)
        type(arc_type), intent(in) :: arc     !! any arc
        type(place_type), intent(in) :: place !! where on it
        slope = slope_along(tangent(arc, place))
    end function slope

    !> The slope of a direction; vertical where rounding can't tell it from that.
    pure type(slope_type) function slope_along(direction) result(slope)
        real(dp), intent(in) :: direction(2) !! not zero, either way
        if (abs(direction(1)) <= ulp*abs(direction(2))) then
            slope%is_vertical = .true.
        else if (.not. is_zero(direction(2))) then
            slope%value = direction(2)/direction(1)
        end if
    end function slope_along

    !> The curvature of an arc, 1/deck unit, positive where it turns left on the way from start to
    !> finish; zero for a line.
    pure real(dp) function curvature(arc, place)
        type(arc_type), intent(in) :: arc     !! any arc
        type(place_type), intent(in) :: place !! where on it
        type(twofold_type) :: n(2), pace

        curvature = 0.0_dp
        if (arc%is_line) return
        n = hodograph(arc, place)
        pace = denominator(arc, place)/sqrt(dot(n, n))
        curvature = to_real(cross(arc%bulge, arc%half)*pace*pace*pace)/arc%size
    end function curvature

end module geom_arc_point
