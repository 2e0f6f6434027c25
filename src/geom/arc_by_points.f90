!> Arcs given by points alone or by points and one slope. Of the conics through the points 1, A, B
!> and 3, which are the pencil
!>
!>     l (1A)(B3) + m (1B)(A3) = 0,     (PQ) the equation of the line from P to Q,
!>
!> the slope at point 1, or a further point C, chooses one; the tangents at 1 and 3 follow in closed
!> form and make the arc, which passes one of the inner points by construction and so all of them:
!>
!>     tangent at 1:  l (B3)(1) (A - 1) + m (A3)(1) (B - 1)
!>     tangent at 3:  l (1A)(3) (B - 3) + m (1B)(3) (A - 3)
!>
!> All is done in twofold numbers. Source: G. Salmon, "A Treatise on Conic Sections", 6th ed., 1879,
!> art. 259-260 (conic through five points); R. A. Liming, "Practical Analytic Geometry with
!> Applications to Aircraft", 1944, ch. 3.
module geom_arc_by_points
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use geom_arc, only: arc_type, line_between, reversed
    use geom_points, only: are_in_line, check_distinct, find_in_line, has_inner_point, &
        is_in_order, noise_of
    use geom_span, only: arc_past, is_level, is_passed_before, new_span, share_type, shares_of, &
        span_type, way
    use geom_triangle, only: end_type, is_straight, new_triangle
    use geom_twofold, only: operator(*), operator(+), operator(-), to_real, twofold, twofold_type
    use geom_vector, only: at_text, cross
    implicit none (type, external)
    private

    public :: line_by_points, arc_by_four_points, arc_by_five_points

contains

    !> The straight line between two points.
    !>
    !> Fails with `cause%points_coincide`.
    pure subroutine line_by_points(start, finish, arc, error)
        real(dp), intent(in) :: start(2)                    !! first point, deck units
        real(dp), intent(in) :: finish(2)                   !! last point, deck units
        type(arc_type), intent(out) :: arc                  !! the line, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        call check_distinct(reshape([start, finish], [2, 2]), '13', error)
        if (.not. allocated(error)) arc = line_between(start, finish)
    end subroutine line_by_points

    !> The arc through four points in their order with the tangent at the first or at the last; a
    !> straight line where all are in line and the tangent along it.
    !>
    !> Fails with `cause%points_coincide`, or with `cause%no_arc` where three points are in line,
    !> the tangent passes another point, or the conic does not pass the points in order on one
    !> branch.
    pure subroutine arc_by_four_points(points, tangent, is_last, arc, error)
        real(dp), intent(in) :: points(2, 4)                !! points 1, A, B, 3, deck units
        real(dp), intent(in) :: tangent(2)                  !! at an end, either way, not zero
        logical, intent(in) :: is_last                      !! it is the tangent at point 3
        type(arc_type), intent(out) :: arc                  !! the arc, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: back(2, 4)

        if (is_last) then
            back = points(:, 4:1:-1)
            call arc_from_tangent(tangent, back, '3BA1', arc, error)
            arc = reversed(arc)
        else
            call arc_from_tangent(tangent, points, '1AB3', arc, error)
        end if
    end subroutine arc_by_four_points

    !> The arc from a point with its tangent through two points to a last one.
    !>
    !> Fails as `arc_by_four_points`.
    pure subroutine arc_from_tangent(tangent, points, names, arc, error)
        real(dp), intent(in) :: tangent(2)                  !! at the first point
        real(dp), intent(in) :: points(2, 4)                !! from first to last, deck units
        character(4), intent(in) :: names                   !! their names
        type(arc_type), intent(out) :: arc                  !! the arc, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(twofold_type) :: l, m
        type(span_type) :: span
        logical :: is_line

        call check_distinct(points, names, error)
        if (allocated(error)) return
        is_line = is_straight(new_triangle(end_type(points(:, 1), tangent), points(:, 2), &
            end_type(points(:, 4), tangent)))
        call line_of_points(points, names, is_line, arc, error)
        if (is_line .or. allocated(error)) return
        call check_tangent(tangent, points, names, error)
        if (allocated(error)) return
        l = cross(way(points(:, 1), points(:, 3)), tangent) &
            *area(points(:, 2), points(:, 4), points(:, 1))
        m = -(cross(way(points(:, 1), points(:, 2)), tangent) &
            *area(points(:, 3), points(:, 4), points(:, 1)))
        span = new_span(points(:, 1), twofold(tangent), points(:, 4), finish_tangent(points, l, m))
        call arc_in_order(span, points, names, arc, error)
    end subroutine arc_from_tangent

    !> The arc through five points in their order; a straight line where all are in line.
    !>
    !> Fails with `cause%points_coincide`, or with `cause%no_arc` where three points are in line or
    !> the conic does not pass the points in order on one branch.
    pure subroutine arc_by_five_points(points, arc, error)
        real(dp), intent(in) :: points(2, 5)                !! points 1, A, B, C, 3, deck units
        type(arc_type), intent(out) :: arc                  !! the arc, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(twofold_type) :: l, m
        type(span_type) :: span
        real(dp) :: four(2, 4), fifth(2)
        logical :: is_line

        is_line = .true.
        call line_of_points(points, '1ABC3', is_line, arc, error)
        if (is_line .or. allocated(error)) return
        four = points(:, [1, 2, 3, 5])
        fifth = points(:, 4)
        l = area(four(:, 1), four(:, 3), fifth)*area(four(:, 2), four(:, 4), fifth)
        m = -(area(four(:, 1), four(:, 2), fifth)*area(four(:, 3), four(:, 4), fifth))
        span = new_span(four(:, 1), start_tangent(four, l, m), four(:, 4), &
            finish_tangent(four, l, m))
        call arc_in_order(span, points, '1ABC3', arc, error)
    end subroutine arc_by_five_points

    !> The equation of the line from a point to another, at a point: twice the area of the triangle.
    pure type(twofold_type) function area(from, to, point)
        real(dp), intent(in) :: from(2)  !! deck units
        real(dp), intent(in) :: to(2)    !! deck units
        real(dp), intent(in) :: point(2) !! deck units
        area = cross(way(from, to), way(from, point))
    end function area

    !> The tangent at point 1 of a conic of the pencil.
    pure function start_tangent(four, l, m) result(tangent)
        real(dp), intent(in) :: four(2, 4)  !! points 1, A, B, 3
        type(twofold_type), intent(in) :: l !! factor of (1A)(B3)
        type(twofold_type), intent(in) :: m !! factor of (1B)(A3)
        type(twofold_type) :: tangent(2)
        tangent = l*area(four(:, 3), four(:, 4), four(:, 1))*way(four(:, 1), four(:, 2)) &
            + m*area(four(:, 2), four(:, 4), four(:, 1))*way(four(:, 1), four(:, 3))
    end function start_tangent

    !> The tangent at point 3 of a conic of the pencil.
    pure function finish_tangent(four, l, m) result(tangent)
        real(dp), intent(in) :: four(2, 4)  !! points 1, A, B, 3
        type(twofold_type), intent(in) :: l !! factor of (1A)(B3)
        type(twofold_type), intent(in) :: m !! factor of (1B)(A3)
        type(twofold_type) :: tangent(2)
        tangent = l*area(four(:, 1), four(:, 2), four(:, 4))*way(four(:, 4), four(:, 3)) &
            + m*area(four(:, 1), four(:, 3), four(:, 4))*way(four(:, 4), four(:, 2))
    end function finish_tangent

    !> The straight line of points that are all in line; else no three may be.
    !>
    !> Fails with `cause%points_coincide` or `cause%no_arc`.
    pure subroutine line_of_points(points, names, is_line, arc, error)
        real(dp), intent(in) :: points(:, :)                !! shape (2, number), deck units
        character(*), intent(in) :: names                   !! a letter for each
        logical, intent(inout) :: is_line                   !! may be one; is one
        type(arc_type), intent(out) :: arc                  !! the line, where it is one
        type(error_type), allocatable, intent(out) :: error !! see above
        character(:), allocatable :: words
        integer :: i, last

        call check_distinct(points, names, error)
        if (allocated(error)) return
        last = size(points, 2)
        is_line = is_line .and. is_in_order(points) .and. &
            all([(are_in_line(points(:, [1, i, last])), i = 2, last - 1)])
        if (is_line) then
            arc = line_between(points(:, 1), points(:, last))
            return
        end if
        call find_in_line(points, names, words)
        if (words == '') return
        call fail(error, cause%no_arc, &
            words//', and a curved conic has no three such points; move '// &
            'one, or put all in line and in order for a straight line')
    end subroutine line_of_points

    !> Fails with `cause%no_arc` where the tangent at the first point passes another.
    pure subroutine check_tangent(tangent, points, names, error)
        real(dp), intent(in) :: tangent(2)                  !! at the first point
        real(dp), intent(in) :: points(2, 4)                !! from first to last, deck units
        character(4), intent(in) :: names                   !! their names
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: i

        do i = 2, 4
            if (abs(to_real(cross(way(points(:, 1), points(:, i)), tangent))) &
                > noise_of(points)*norm2(tangent)) cycle
            call fail(error, cause%no_arc, 'the tangent at point '//names(1:1)//' passes point '// &
                names(i:i)//' '//at_text(points(:, i))// &
                ', and a tangent meets its conic once; correct the slope')
            return
        end do
    end subroutine check_tangent

    !> The arc of a span past the middle one of the points, on which all others are in their order.
    !>
    !> Fails with `cause%no_arc` where they are not.
    pure subroutine arc_in_order(span, points, names, arc, error)
        type(span_type), intent(in) :: span                 !! the ends with their tangents
        real(dp), intent(in) :: points(:, :)                !! shape (2, number), deck units
        character(*), intent(in) :: names                   !! a letter for each
        type(arc_type), intent(out) :: arc                  !! the arc, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(share_type) :: share(size(points, 2))
        character(:), allocatable :: words
        logical :: passes
        integer :: i, last

        last = size(points, 2)
        passes = .not. is_level(span)
        if (passes) call arc_past(span, points(:, (last + 1)/2), arc, passes)
        if (passes) then
            share = [(shares_of(span, points(:, i)), i = 1, last)]
            do i = 2, last - 1
                passes = passes .and. is_on_side(share(i), share((last + 1)/2))
            end do
            do i = 2, last - 2
                passes = passes .and. is_passed_before(share(i), share(i + 1))
            end do
        end if
        if (passes) return
        call explain_refusal(points, names, words)
        call fail(error, cause%no_arc, words)
    end subroutine arc_in_order

    !> True where a point is within both end tangents and on the same side of the chord as another.
    pure logical function is_on_side(share, model)
        type(share_type), intent(in) :: share !! where the point is
        type(share_type), intent(in) :: model !! where the other is
        is_on_side = share%start%high > 0.0_dp .and. share%finish%high > 0.0_dp .and. &
            (share%off_chord%high > 0.0_dp .eqv. model%off_chord%high > 0.0_dp)
    end function is_on_side

    !> Why the conic through some points is no arc through them in order.
    pure subroutine explain_refusal(points, names, words)
        real(dp), intent(in) :: points(:, :)                !! shape (2, number), deck units
        character(*), intent(in) :: names                   !! a letter for each
        character(:), allocatable, intent(out) :: words     !! a sentence
        integer :: i

        words = names(1:1)
        do i = 2, len(names)
            words = words//', '//names(i:i)
        end do
        if (has_inner_point(points)) then
            words = 'the conic through points '//words// &
                ' is a hyperbola that has them on both of '// &
                'its branches; points of one arc bulge to one side only'
        else
            words = 'the conic through the points does not pass them in the order '//words// &
                ' on one arc; give them in order along the curve, or correct the slope'
        end if
    end subroutine explain_refusal

end module geom_arc_by_points
