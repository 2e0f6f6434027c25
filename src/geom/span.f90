!> Two ends with their tangents, and the arcs that join them: one for each weight, one for each
!> point passed. As `geom_triangle`, but the tangents are twofold, so that they may come from points
!> (the intersection of the end tangents, further points of the curve) without loss.
!>
!> With c the chord, t1 and t3 the end tangents, s a point from the start, x the product `cross`:
!>
!>     b2 = (s x t1)/(c x t1)     b0 = ((s - c) x t3)/(t3 x c)     a : b = sqrt(b0) : sqrt(b2)
!>
!> are the shares of the ends in s and the place of s on the arc through it; the end tangents meet
!> at p1 + a1 t1, a1 = (c x t3)/(t1 x t3).
!>
!> Source: G. Farin, "Curves and Surfaces for CAGD", 5th ed., 12.5; the end curvatures 12.6.
module geom_span
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_tolerances, only: ulp
    use geom_arc, only: arc_type, line_between
    use geom_triangle, only: end_type
    use geom_twofold, only: exact_difference, operator(*), operator(+), operator(-), operator(/), &
        sqrt, to_real, twofold, twofold_type
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: span_type, new_span, span_by_corner, way
    public :: share_type, shares_of, is_passed_before
    public :: has_corner, is_level, arc_of_weight, arc_past, arc_of_ends

    !> Two different ends with their tangents, in units of `size`, relative to the start.
    type :: span_type
        real(dp) :: start(2) = 0.0_dp           !! first point, deck units
        real(dp) :: finish(2) = 0.0_dp          !! last point, deck units
        real(dp) :: size = 1.0_dp               !! a power of two near the chord, deck units
        type(twofold_type) :: chord(2)          !! c, start to finish
        type(twofold_type) :: t1(2)             !! tangent at the start, either way, near 1
        type(twofold_type) :: t3(2)             !! tangent at the finish, either way, near 1
        type(twofold_type) :: chord_off_start   !! c x t1
        type(twofold_type) :: chord_off_finish  !! t3 x c
        type(twofold_type) :: tangents          !! t1 x t3
    end type span_type

    !> Where a point is in a span.
    type :: share_type
        type(twofold_type) :: start     !! b0, share of the start; zero on the tangent at the finish
        type(twofold_type) :: finish    !! b2, share of the finish; zero on the tangent at the start
        type(twofold_type) :: off_chord !! s x c, positive to the right of the chord
    end type share_type

    interface new_span
        module procedure span_of_ends, span_of_tangents
    end interface new_span

contains

    !> The way from a point to another, exactly, deck units.
    pure function way(from, to)
        real(dp), intent(in) :: from(2) !! a point, deck units
        real(dp), intent(in) :: to(2)   !! another
        type(twofold_type) :: way(2)
        way = exact_difference(to, from)
    end function way

    !> The span of two ends with their tangents as doubles.
    pure type(span_type) function span_of_ends(start, finish) result(span)
        type(end_type), intent(in) :: start  !! first point and its tangent
        type(end_type), intent(in) :: finish !! last point, another, and its tangent
        span = span_of_tangents(start%point, twofold(start%tangent), finish%point, &
            twofold(finish%tangent))
    end function span_of_ends

    !> The span of two ends whose tangents meet at a point that is none of them.
    pure type(span_type) function span_by_corner(start, corner, finish) result(span)
        real(dp), intent(in) :: start(2)  !! first point, deck units
        real(dp), intent(in) :: corner(2) !! where the end tangents meet, deck units
        real(dp), intent(in) :: finish(2) !! last point, another, deck units
        span = span_of_tangents(start, way(start, corner), finish, way(corner, finish))
    end function span_by_corner

    !> The span of two ends with their tangents in twofold numbers.
    pure type(span_type) function span_of_tangents(start, t1, finish, t3) result(span)
        real(dp), intent(in) :: start(2)       !! first point, deck units
        type(twofold_type), intent(in) :: t1(2) !! tangent there, of any length, either way
        real(dp), intent(in) :: finish(2)      !! last point, another, deck units
        type(twofold_type), intent(in) :: t3(2) !! tangent there, of any length, either way

        span%start = start
        span%finish = finish
        span%chord = way(start, finish)
        span%size = 1.0_dp/near_one(to_real(span%chord))
        span%chord = near_one(to_real(span%chord))*span%chord
        span%t1 = near_one(to_real(t1))*t1
        span%t3 = near_one(to_real(t3))*t3
        span%chord_off_start = cross(span%chord, span%t1)
        span%chord_off_finish = cross(span%t3, span%chord)
        span%tangents = cross(span%t1, span%t3)
    end function span_of_tangents

    !> The power of two that brings the larger part of a vector between 1/2 and 1.
    pure real(dp) function near_one(vector) result(power)
        real(dp), intent(in) :: vector(2) !! not zero
        power = scale(1.0_dp, -exponent(maxval(abs(vector))))
    end function near_one

    !> The shares of the ends in a point. No end tangent may run along the chord.
    pure type(share_type) function shares_of(span, point) result(share)
        type(span_type), intent(in) :: span  !! two ends with their tangents
        real(dp), intent(in) :: point(2)     !! deck units
        type(twofold_type) :: s(2)

        s = (1.0_dp/span%size)*way(span%start, point)
        share%finish = cross(s, span%t1)/span%chord_off_start
        share%start = cross((1.0_dp/span%size)*way(span%finish, point), span%t3) &
            /span%chord_off_finish
        share%off_chord = cross(s, span%chord)
    end function shares_of

    !> True where two points that an arc passes are passed in this order; both on the same side of
    !> the chord and within both end tangents.
    pure logical function is_passed_before(first, second) result(passed)
        type(share_type), intent(in) :: first  !! where a point is
        type(share_type), intent(in) :: second !! where another is
        type(twofold_type) :: lead
        lead = first%start*second%finish - first%finish*second%start
        passed = lead%high > 0.0_dp
    end function is_passed_before

    !> True where the end tangents meet in one point off the chord, as far as doubles can say.
    pure logical function has_corner(span)
        type(span_type), intent(in) :: span !! two ends with their tangents
        has_corner = abs(to_real(span%tangents)) > ulp .and. .not. is_level(span)
    end function has_corner

    !> True where an end tangent runs along the chord, as far as doubles can say.
    pure logical function is_level(span)
        type(span_type), intent(in) :: span !! two ends with their tangents
        is_level = abs(to_real(span%chord_off_start)) <= ulp .or. &
            abs(to_real(span%chord_off_finish)) <= ulp
    end function is_level

    !> The arc of a weight in the triangle of the ends and the intersection of their tangents.
    pure type(arc_type) function arc_of_weight(span, w) result(arc)
        type(span_type), intent(in) :: span     !! `has_corner`
        type(twofold_type), intent(in) :: w     !! weight, above -1, not zero
        type(twofold_type) :: reach, rest

        reach = -(w*span%chord_off_finish/span%tangents)
        rest = -(w*span%chord_off_start/span%tangents)
        arc = arc_of_ends(span, w, reach, rest)
    end function arc_of_weight

    !> The arc that passes a point off the chord, where there is one: the point is within both end
    !> tangents and on the same branch.
    pure subroutine arc_past(span, point, arc, exists)
        type(span_type), intent(in) :: span  !! not `is_level`
        real(dp), intent(in) :: point(2)     !! deck units
        type(arc_type), intent(out) :: arc   !! the arc, where it exists
        logical, intent(out) :: exists       !! there is one
        type(share_type) :: share
        type(twofold_type) :: bulge, w, fullness

        share = shares_of(span, point)
        exists = share%start%high > 0.0_dp .and. share%finish%high > 0.0_dp &
            .and. .not. is_zero(share%off_chord%high)
        if (.not. exists) return
        bulge = share%off_chord/(2.0_dp*(sqrt(share%start)*sqrt(share%finish)))
        w = (bulge/span%chord_off_start)*(span%tangents/span%chord_off_finish)
        fullness = w + 1.0_dp
        exists = fullness%high > 0.0_dp
        if (exists) arc = arc_of_ends(span, w, -(bulge/span%chord_off_start), &
            -(bulge/span%chord_off_finish))
    end subroutine arc_past

    !> The arc of a weight and of the multiples of the end tangents that lead, weighted, to their
    !> intersection and from there on (`leaving` and `arriving` of `geom_arc`).
    pure type(arc_type) function arc_of_ends(span, w, reach, rest) result(arc)
        type(span_type), intent(in) :: span     !! two ends with their tangents
        type(twofold_type), intent(in) :: w     !! weight, above -1
        type(twofold_type), intent(in) :: reach !! multiple of `t1`, not zero
        type(twofold_type), intent(in) :: rest  !! multiple of `t3`, not zero
        integer :: axis

        arc = line_between(span%start, span%finish)
        arc%is_line = .false.
        arc%size = span%size
        arc%fullness = w + 1.0_dp
        do axis = 1, 2
            arc%half(axis) = 0.5_dp*span%chord(axis)
            arc%leaving(axis) = reach*span%t1(axis)
            arc%arriving(axis) = rest*span%t3(axis)
            arc%bulge(axis) = arc%leaving(axis) - w*arc%half(axis)
        end do
        arc%start_tangent = sign(1.0_dp, reach%high)*to_real(span%t1)
        arc%finish_tangent = sign(1.0_dp, rest%high)*to_real(span%t3)
    end function arc_of_ends

end module geom_span
