!> An arc of a conic: from a point with its tangent, through a shoulder point, to another point
!> with its tangent. It is kept as a rational quadratic about the middle m of its chord c, with
!> h = c/2:
!>
!>     p = m + (2 a b g + (b**2 - a**2) h)/((a - b)**2 + 2 a b q)        a : b from 1 : 0 to 0 : 1
!>
!> where q = 1 + w is the fullness, w the weight of the conic, and g = v1 - w h the bulge, v1 the
!> weighted way from the start to the intersection of the end tangents. No term cancels another,
!> also not where w nears -1 and the arc nears a whole ellipse; parallel end tangents (w = 0),
!> vertical ones and straight lines (g = 0, w = 1) are no special cases. The numbers are twofold
!> and in units of `size`, a power of two, so that evaluation rounds once.
!>
!> Source: E. Lee, "The rational Bezier representation for conics", in G. Farin (ed.), "Geometric
!> Modeling", SIAM 1987, pp. 3-19; here written about the middle of the chord.
module geom_arc
    use base_constants, only: vertical_slope
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc_fault, only: check_apart, explain_flat, explain_no_arc
    use geom_triangle, only: corner_of, end_type, has_arc, is_flat, is_straight, new_triangle, &
        triangle_type
    use geom_twofold, only: operator(*), operator(+), operator(-), to_real, twofold, twofold_type
    use geom_vector, only: dot
    implicit none (type, external)
    private

    public :: arc_type, end_type, arc_through, line_between, direction_of_slope, reversed
    public :: weight, rho, turns_past_180

    !> An arc of a conic, or a straight line.
    type :: arc_type
        real(dp) :: start(2) = 0.0_dp          !! first point as given, deck units
        real(dp) :: finish(2) = 0.0_dp         !! last point as given, deck units
        real(dp) :: start_tangent(2) = 0.0_dp  !! as given, pointed forward along the arc
        real(dp) :: finish_tangent(2) = 0.0_dp !! as given, pointed forward along the arc
        logical :: is_line = .false.           !! a straight line
        real(dp) :: size = 1.0_dp              !! a power of two, deck units: unit of what follows
        type(twofold_type) :: half(2)          !! h, half the chord
        type(twofold_type) :: bulge(2)         !! g, see above
        type(twofold_type) :: leaving(2)       !! v1 = g + w h, forward tangent at the start
        type(twofold_type) :: arriving(2)      !! v3 = w h - g, forward tangent at the finish
        type(twofold_type) :: fullness         !! q = 1 + w, above zero
    end type arc_type

contains

    !> The arc from `start` through the shoulder point to `finish`; the straight line where all are
    !> in line (shoulder point within `decimal_noise` of the chord and between the ends, tangents
    !> within `slope_resolution` of it).
    !>
    !> Fails with `cause%points_coincide`, `cause%shoulder_on_chord`, `cause%tangent_on_chord`,
    !> `cause%inflection`, `cause%shoulder_outside` or `cause%other_branch`; the message says what
    !> would be right.
    pure subroutine arc_through(start, shoulder, finish, arc, error)
        type(end_type), intent(in) :: start                 !! first point and its tangent
        real(dp), intent(in) :: shoulder(2)                 !! shoulder point, deck units
        type(end_type), intent(in) :: finish                !! last point and its tangent
        type(arc_type), intent(out) :: arc                  !! the arc, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(triangle_type) :: triangle

        call check_apart(start, shoulder, finish, error)
        if (allocated(error)) return
        triangle = new_triangle(start, shoulder, finish)
        if (is_straight(triangle)) then
            arc = straight(triangle)
        else if (is_flat(triangle)) then
            call explain_flat(triangle, error)
        else if (has_arc(triangle)) then
            arc = curved(triangle)
        else
            call explain_no_arc(triangle, error)
        end if
    end subroutine arc_through

    !> The arc of a control triangle that has one.
    pure type(arc_type) function curved(triangle) result(arc)
        type(triangle_type), intent(in) :: triangle !! not flat

        arc = framed(triangle)
        call corner_of(triangle, arc%leaving, arc%arriving)
        arc%fullness = triangle%weight + 1.0_dp
        arc%bulge(1) = arc%leaving(1) - triangle%weight*arc%half(1)
        arc%bulge(2) = arc%leaving(2) - triangle%weight*arc%half(2)
        arc%start_tangent = forward(triangle%start%tangent, arc%leaving)
        arc%finish_tangent = forward(triangle%finish%tangent, arc%arriving)
    end function curved

    !> The straight line of a triangle that is one. Its slope is that of an end tangent where this
    !> leads from end to end as well as decimals can say, else that of the chord.
    pure type(arc_type) function straight(triangle) result(arc)
        type(triangle_type), intent(in) :: triangle !! straight
        real(dp) :: along(2)

        arc = line_between(triangle%start%point, triangle%finish%point)
        along = arc%start_tangent
        if (leads(triangle%chord_off_finish, triangle%t3)) along = triangle%finish%tangent
        if (leads(triangle%chord_off_start, triangle%t1)) along = triangle%start%tangent
        arc%start_tangent = forward(along, arc%half)
        arc%finish_tangent = arc%start_tangent
    contains
        !> True where a tangent meets the other end within rounding.
        pure logical function leads(product, tangent)
            type(twofold_type), intent(in) :: product !! chord x tangent, either sign
            real(dp), intent(in) :: tangent(2)        !! the tangent
            leads = abs(to_real(product)) <= triangle%noise*norm2(tangent)
        end function leads
    end function straight

    !> The straight line between two different points, as an arc.
    pure type(arc_type) function line_between(start, finish) result(arc)
        real(dp), intent(in) :: start(2)  !! first point, deck units
        real(dp), intent(in) :: finish(2) !! last point, deck units
        type(end_type) :: first, last

        first = end_type(start, finish - start)
        last = end_type(finish, finish - start)
        arc = framed(new_triangle(first, start, last))
        arc%is_line = .true.
        arc%fullness = twofold(2.0_dp)
        arc%leaving = arc%half
        arc%arriving = arc%half
        arc%start_tangent = to_real(arc%half)
        arc%finish_tangent = arc%start_tangent
    end function line_between

    !> The parts of an arc that its ends fix.
    pure type(arc_type) function framed(triangle) result(arc)
        type(triangle_type), intent(in) :: triangle !! any control triangle
        arc%start = triangle%start%point
        arc%finish = triangle%finish%point
        arc%size = triangle%size
        arc%half(1) = 0.5_dp*triangle%chord(1)
        arc%half(2) = 0.5_dp*triangle%chord(2)
    end function framed

    !> A tangent, turned about where it does not point forward.
    pure function forward(tangent, ahead) result(turned)
        real(dp), intent(in) :: tangent(2)         !! either way
        type(twofold_type), intent(in) :: ahead(2) !! a forward vector along it
        real(dp) :: turned(2)
        turned = tangent
        if (to_real(dot(ahead, tangent)) < 0.0_dp) turned = -tangent
    end function forward

    !> The direction of a slope dy/dx; vertical from `vertical_slope` on, either sign.
    pure function direction_of_slope(slope) result(direction)
        real(dp), intent(in) :: slope !! dy/dx
        real(dp) :: direction(2)
        direction = [1.0_dp, slope]
        if (abs(slope) >= vertical_slope) direction = [0.0_dp, 1.0_dp]
    end function direction_of_slope

    !> The same arc, run through backwards.
    pure type(arc_type) function reversed(arc) result(back)
        type(arc_type), intent(in) :: arc !! any arc
        back = arc
        back%start = arc%finish
        back%finish = arc%start
        back%start_tangent = -arc%finish_tangent
        back%finish_tangent = -arc%start_tangent
        back%half = -arc%half
        back%leaving = -arc%arriving
        back%arriving = -arc%leaving
    end function reversed

    !> The weight w of the conic: below 1 an ellipse, 1 a parabola, above 1 a hyperbola; negative
    !> where the arc turns by more than 180 degrees. 1 for a line.
    pure real(dp) function weight(arc)
        type(arc_type), intent(in) :: arc !! any arc
        weight = to_real(arc%fullness - 1.0_dp)
    end function weight

    !> The shape ratio of the trade, rho = w/(1 + w): how far from the middle of the chord to the
    !> intersection of the end tangents the arc rises. Zero where the end tangents are parallel,
    !> .5 for a parabola.
    pure real(dp) function rho(arc)
        type(arc_type), intent(in) :: arc !! any arc
        rho = weight(arc)/to_real(arc%fullness)
    end function rho

    !> True where the arc turns by more than 180 degrees: the shoulder point and the intersection of
    !> the end tangents are on different sides of the chord.
    pure logical function turns_past_180(arc)
        type(arc_type), intent(in) :: arc !! any arc
        turns_past_180 = weight(arc) < 0.0_dp
    end function turns_past_180

end module geom_arc
