!> Arcs of a circle: through three points, or between two with a given radius.
!>
!> With c the chord and s the way to the middle point, as complex numbers, the end tangents are
!> s c conj(c - s) and c (c - s) conj(s): the angle of tangent and chord is that at the
!> circumference (Euclid III.32). Of a radius R, h = c/2 turned by the half angle of the arc, sin =
!> |h|/R, is the weighted way to the intersection of the end tangents, and cos is the weight.
module geom_arc_by_circle
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_text, only: compact
    use geom_arc, only: arc_type, line_between
    use geom_points, only: are_in_line, check_distinct, is_in_order, noise_of
    use geom_span, only: arc_of_ends, arc_past, new_span, span_type, way
    use geom_twofold, only: operator(*), operator(+), operator(-), operator(/), sqrt, to_real, &
        twofold, twofold_type
    use geom_vector, only: dot
    implicit none (type, external)
    private

    public :: circle_by_points, circle_by_radius

contains

    !> The arc of a circle through three points; a straight line where they are in line.
    !>
    !> Fails with `cause%points_coincide`, or with `cause%no_arc` where the points are in line and
    !> the second is not between the others.
    pure subroutine circle_by_points(start, middle, finish, arc, error)
        real(dp), intent(in) :: start(2)                    !! first point, deck units
        real(dp), intent(in) :: middle(2)                   !! a point of the arc, deck units
        real(dp), intent(in) :: finish(2)                   !! last point, deck units
        type(arc_type), intent(out) :: arc                  !! the arc, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(twofold_type) :: c(2), s(2), rest(2)
        real(dp) :: points(2, 3)
        logical :: exists

        points = reshape([start, middle, finish], [2, 3])
        call check_distinct(points, '123', error)
        if (allocated(error)) return
        exists = .not. are_in_line(points)
        if (exists) then
            c = way(start, finish)
            s = way(start, middle)
            rest = way(middle, finish)
            call arc_past(new_span(start, times(times(s, c), mirrored(rest)), finish, &
                times(times(c, rest), mirrored(s))), middle, arc, exists)
        else if (is_in_order(points)) then
            arc = line_between(start, finish)
            return
        end if
        if (.not. exists) call fail(error, cause%no_arc, &
            'the three points are in line and point 2 '// &
            'is not between the others; no circle passes them in order: move it off the line')
    end subroutine circle_by_points

    !> The arc of a circle between two points that turns by at most 180 degrees, to the left on the
    !> way where the radius is positive, else to the right.
    !>
    !> Fails with `cause%points_coincide`, or with `cause%no_arc` where the radius is less than half
    !> the distance of the points (by more than their decimals lose).
    pure subroutine circle_by_radius(start, finish, radius, arc, error)
        real(dp), intent(in) :: start(2)                    !! first point, deck units
        real(dp), intent(in) :: finish(2)                   !! last point, deck units
        real(dp), intent(in) :: radius                      !! signed, deck units
        type(arc_type), intent(out) :: arc                  !! the arc, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(twofold_type) :: h(2), half, sine, cosine, one
        type(span_type) :: span
        real(dp) :: points(2, 2)

        points = reshape([start, finish], [2, 2])
        call check_distinct(points, '13', error)
        if (allocated(error)) return
        h = 0.5_dp*way(start, finish)
        half = sqrt(dot(h, h))
        if (abs(radius) < to_real(half) - noise_of(points)) then
            call fail(error, cause%no_arc, &
                'the radius is '//compact(radius)//', less than half the '// &
                'distance of points 1 and 3; it must be '//compact(to_real(half))//' or more, '// &
                'positive where the curve turns left on the way from 1 to 3, else negative')
            return
        end if
        one = twofold(1.0_dp)
        sine = half/twofold(radius)
        cosine = sqrt((one - sine)*(one + sine))
        if (is_zero(cosine%high)) sine = twofold(sign(1.0_dp, radius))
        span = new_span(start, h, finish, h)
        h = 0.5_dp*span%chord
        span%t1 = times(h, [cosine, -sine])
        span%t3 = times(h, [cosine, sine])
        arc = arc_of_ends(span, cosine, one, one)
    end subroutine circle_by_radius

    !> The product of two vectors as complex numbers.
    pure function times(u, v)
        type(twofold_type), intent(in) :: u(2) !! real and imaginary part
        type(twofold_type), intent(in) :: v(2) !! real and imaginary part
        type(twofold_type) :: times(2)
        times(1) = u(1)*v(1) - u(2)*v(2)
        times(2) = u(1)*v(2) + u(2)*v(1)
    end function times

    !> The conjugate of a complex number.
    pure function mirrored(u)
        type(twofold_type), intent(in) :: u(2) !! real and imaginary part
        type(twofold_type) :: mirrored(2)
        mirrored = [u(1), -u(2)]
    end function mirrored

end module geom_arc_by_circle
