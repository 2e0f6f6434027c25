!> A stroke: one piece of a line, of whatever kind. A control line is a chain of strokes; what is
!> done with lines is done with strokes and asks for no kind.
!>
!> A place on a stroke that is no conic is alpha : beta with the parameter t = beta/(alpha + beta).
module geom_stroke
    use base_kinds, only: dp
    use geom_arc, only: arc_type, reversed
    use geom_arc_point, only: arc_curvature => curvature, arc_point => point, arc_tangent => tangent
    use geom_bezier, only: bezier_jet, bezier_part, bezier_point
    use geom_crossing, only: crossing
    use geom_cyclic, only: cyclic_jet, cyclic_part, cyclic_point
    use geom_place, only: at_finish, at_start, is_finish, is_start, place_at, place_type
    use geom_subarc, only: part_of
    use geom_twofold, only: operator(+), operator(/), to_real
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: stroke_type, conic_stroke, bezier_stroke, cyclic_stroke, reversed_stroke, stroke_part
    public :: is_straight, stroke_point, stroke_tangent, stroke_curvature, stroke_place
    public :: stroke_jet

    !> The kinds of stroke.
    type, public :: stroke_list
        integer :: conic = 1        !! an arc of a conic, or a straight line
        integer :: bezier = 2       !! a polynomial curve
        integer :: cyclic = 3       !! a cubic C-Bezier curve
    end type stroke_list

    !> The kinds by name.
    type(stroke_list), parameter, public :: stroke_kind = stroke_list()

    !> A stroke, y over x, deck units.
    type :: stroke_type
        integer :: kind = 1                     !! one of `stroke_kind%...`
        real(dp) :: start(2) = 0.0_dp           !! its first point
        real(dp) :: finish(2) = 0.0_dp          !! its last point
        type(arc_type) :: arc                   !! of a conic
        real(dp), allocatable :: pole(:, :)     !! of a Bezier or C-Bezier curve, shape (2, poles)
        real(dp) :: alpha = 0.0_dp              !! of a C-Bezier curve, radians
    end type stroke_type

    !> Halvings of the parameter that place a point: as many as a double has bits, and some.
    integer, parameter :: most_steps = 80

contains

    !> A conic arc as a stroke.
    elemental type(stroke_type) function conic_stroke(arc) result(stroke)
        type(arc_type), intent(in) :: arc !! any arc
        stroke%kind = stroke_kind%conic
        stroke%start = arc%start
        stroke%finish = arc%finish
        stroke%arc = arc
    end function conic_stroke

    !> A Bezier curve as a stroke.
    pure type(stroke_type) function bezier_stroke(pole) result(stroke)
        real(dp), intent(in) :: pole(:, :) !! two or more poles, shape (2, degree + 1)
        stroke%kind = stroke_kind%bezier
        stroke%start = pole(:, 1)
        stroke%finish = pole(:, size(pole, 2))
        stroke%pole = pole
    end function bezier_stroke

    !> A C-Bezier curve as a stroke.
    pure type(stroke_type) function cyclic_stroke(pole, alpha) result(stroke)
        real(dp), intent(in) :: pole(:, :)  !! four poles, shape (2, 4)
        real(dp), intent(in) :: alpha       !! radians, above 0, not above pi
        stroke = bezier_stroke(pole)
        stroke%kind = stroke_kind%cyclic
        stroke%alpha = alpha
    end function cyclic_stroke

    !> True for a straight line.
    elemental logical function is_straight(stroke)
        type(stroke_type), intent(in) :: stroke !! any
        is_straight = stroke%kind == stroke_kind%conic .and. stroke%arc%is_line
    end function is_straight

    !> The same stroke, run through backwards.
    pure type(stroke_type) function reversed_stroke(stroke) result(back)
        type(stroke_type), intent(in) :: stroke !! any
        if (stroke%kind == stroke_kind%conic) then
            back = conic_stroke(reversed(stroke%arc))
        else
            back = bezier_stroke(stroke%pole(:, size(stroke%pole, 2):1:-1))
            back%kind = stroke%kind
            back%alpha = stroke%alpha
        end if
    end function reversed_stroke

    !> The part of a stroke between two places.
    pure type(stroke_type) function stroke_part(stroke, first, second) result(part)
        type(stroke_type), intent(in) :: stroke     !! any
        type(place_type), intent(in) :: first       !! where the part begins
        type(place_type), intent(in) :: second      !! where it ends
        real(dp) :: pole(2, 4), alpha

        select case (stroke%kind)
        case (stroke_kind%conic)
            part = conic_stroke(part_of(stroke%arc, first, second))
        case (stroke_kind%bezier)
            part = bezier_stroke(bezier_part(stroke%pole, parameter_of(first), &
                parameter_of(second)))
        case default
            call cyclic_part(stroke%pole, stroke%alpha, parameter_of(first), &
                parameter_of(second), pole, alpha)
            part = cyclic_stroke(pole, alpha)
        end select
    end function stroke_part

    !> The usual parameter of a place.
    elemental real(dp) function parameter_of(place) result(t)
        type(place_type), intent(in) :: place !! any
        t = to_real(place%beta/(place%alpha + place%beta))
    end function parameter_of

    !> The point at a place, deck units.
    pure function stroke_point(stroke, place) result(point)
        type(stroke_type), intent(in) :: stroke !! any
        type(place_type), intent(in) :: place   !! where on it
        real(dp) :: point(2)

        if (stroke%kind == stroke_kind%conic) then
            point = arc_point(stroke%arc, place)
        else if (is_start(place)) then
            point = stroke%start
        else if (is_finish(place)) then
            point = stroke%finish
        else if (stroke%kind == stroke_kind%bezier) then
            point = bezier_point(stroke%pole, parameter_of(place))
        else
            point = cyclic_point(stroke%pole, stroke%alpha, parameter_of(place))
        end if
    end function stroke_point

    !> The point of a stroke that is no conic, and its first two derivatives over the parameter.
    pure subroutine stroke_jet(stroke, t, point, first, second)
        type(stroke_type), intent(in) :: stroke     !! no conic
        real(dp), intent(in) :: t                   !! 0 to 1
        real(dp), intent(out) :: point(2)           !! deck units
        real(dp), intent(out) :: first(2)           !! first derivative
        real(dp), intent(out) :: second(2)          !! second derivative

        if (stroke%kind == stroke_kind%bezier) then
            call bezier_jet(stroke%pole, t, point, first, second)
        else
            call cyclic_jet(stroke%pole, stroke%alpha, t, point, first, second)
        end if
    end subroutine stroke_jet

    !> The tangent at a place, forward along the stroke; its length has no meaning. Where the first
    !> derivative vanishes, at an end whose poles are one, it is the way to the next pole.
    pure function stroke_tangent(stroke, place) result(tangent)
        type(stroke_type), intent(in) :: stroke !! any
        type(place_type), intent(in) :: place   !! where on it
        real(dp) :: tangent(2)
        real(dp) :: point(2), second(2)
        integer :: i

        if (stroke%kind == stroke_kind%conic) then
            tangent = arc_tangent(stroke%arc, place)
            return
        end if
        call stroke_jet(stroke, parameter_of(place), point, tangent, second)
        if (any(abs(tangent) > 0.0_dp)) return
        do i = 2, size(stroke%pole, 2)
            tangent = stroke%pole(:, i) - stroke%start
            if (is_finish(place)) &
                tangent = stroke%finish - stroke%pole(:, size(stroke%pole, 2) - i + 1)
            if (any(abs(tangent) > 0.0_dp)) return
        end do
    end function stroke_tangent

    !> The curvature at a place, 1/deck unit, positive where the stroke turns left.
    pure real(dp) function stroke_curvature(stroke, place) result(curvature)
        type(stroke_type), intent(in) :: stroke !! any
        type(place_type), intent(in) :: place   !! where on it
        real(dp) :: point(2), first(2), second(2), pace

        if (stroke%kind == stroke_kind%conic) then
            curvature = arc_curvature(stroke%arc, place)
            return
        end if
        call stroke_jet(stroke, parameter_of(place), point, first, second)
        pace = norm2(first)
        curvature = 0.0_dp
        if (pace > 0.0_dp) curvature = cross(first, second)/pace**3
    end function stroke_curvature

    !> The place of an x on a stroke towards greater x that turns back nowhere; beyond its ends the
    !> nearer one.
    pure type(place_type) function stroke_place(stroke, x) result(place)
        type(stroke_type), intent(in) :: stroke !! towards greater x
        real(dp), intent(in) :: x               !! deck units

        if (x <= stroke%start(1)) then
            place = at_start
        else if (x >= stroke%finish(1)) then
            place = at_finish
        else if (stroke%kind == stroke_kind%conic) then
            place = crossing(stroke%arc, 1, x, rising=.true.)
        else
            place = place_at(parameter_at(stroke, x))
        end if
    end function stroke_place

    !> The parameter where a stroke that is no conic takes an x between those of its ends: Newton's
    !> method, kept between bounds that close in.
    pure real(dp) function parameter_at(stroke, x) result(t)
        type(stroke_type), intent(in) :: stroke     !! towards greater x
        real(dp), intent(in) :: x                   !! deck units
        real(dp) :: bounds(2), at(2), pace(2), bend(2), off
        integer :: i

        bounds = [0.0_dp, 1.0_dp]
        t = (x - stroke%start(1))/(stroke%finish(1) - stroke%start(1))
        do i = 1, most_steps
            call stroke_jet(stroke, t, at, pace, bend)
            off = at(1) - x
            if (abs(off) <= 0.0_dp) return
            bounds(merge(1, 2, off < 0.0_dp)) = t
            if (abs(off) < abs(pace(1))*(bounds(2) - bounds(1))) then
                t = t - off/pace(1)
            else
                t = 0.5_dp*sum(bounds)
            end if
            if (t <= bounds(1) .or. t >= bounds(2)) t = 0.5_dp*sum(bounds)
            if (t <= bounds(1) .or. t >= bounds(2)) return
        end do
    end function parameter_at

end module geom_stroke
