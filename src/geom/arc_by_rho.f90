!> Arcs given by the intersection of their end tangents or by rho, which is how far from the middle
!> of the chord to that intersection an arc rises: w = rho/(1 - rho).
!>
!> Source: R. A. Liming, "Practical Analytic Geometry with Applications to Aircraft", 1944, ch. 4;
!> rho as in the trade, see G. Farin, "Curves and Surfaces for CAGD", 5th ed., 12.7.
module geom_arc_by_rho
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact
    use geom_arc, only: arc_through, arc_type, line_between
    use geom_points, only: are_in_line, check_distinct, is_in_order
    use geom_span, only: arc_of_weight, arc_past, has_corner, is_level, new_span, span_by_corner, &
        span_type
    use geom_triangle, only: end_type, is_straight, new_triangle
    use geom_twofold, only: exact_difference, operator(/), twofold
    use geom_vector, only: at_text
    implicit none (type, external)
    private

    public :: arc_by_rho, arc_by_corner, arc_by_corner_rho

contains

    !> The arc of two ends with their tangents and rho; a straight line where both tangents are
    !> along the chord within `slope_resolution`.
    !>
    !> Fails with `cause%points_coincide` where the ends are one, with `cause%no_arc` where rho is
    !> not between 0 and 1 or the tangents are parallel, and with `cause%tangent_on_chord`.
    pure subroutine arc_by_rho(start, rho, finish, arc, error)
        type(end_type), intent(in) :: start                 !! first point and its tangent
        real(dp), intent(in) :: rho                         !! 0 to 1, neither
        type(end_type), intent(in) :: finish                !! last point and its tangent
        type(arc_type), intent(out) :: arc                  !! the arc, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: ends(2, 2), middle(2)

        ends = reshape([start%point, finish%point], [2, 2])
        call check_distinct(ends, '13', error)
        if (.not. allocated(error)) call check_rho(rho, error)
        if (allocated(error)) return
        middle = 0.5_dp*(start%point + finish%point)
        if (is_straight(new_triangle(start, middle, finish))) then
            call arc_through(start, middle, finish, arc, error)
        else
            call arc_in_span(new_span(start, finish), rho, arc, error)
        end if
    end subroutine arc_by_rho

    !> The arc of two ends, the intersection of the end tangents and rho; a straight line where all
    !> three points are in line and in order.
    !>
    !> Fails with `cause%points_coincide`, `cause%tangent_on_chord` or, of rho, `cause%no_arc`.
    pure subroutine arc_by_corner_rho(start, corner, rho, finish, arc, error)
        real(dp), intent(in) :: start(2)                    !! first point, deck units
        real(dp), intent(in) :: corner(2)                   !! where the end tangents meet
        real(dp), intent(in) :: rho                         !! 0 to 1, neither
        real(dp), intent(in) :: finish(2)                   !! last point, deck units
        type(arc_type), intent(out) :: arc                  !! the arc, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: points(2, 3)

        points = reshape([start, corner, finish], [2, 3])
        call check_distinct(points, '1T3', error)
        if (.not. allocated(error)) call check_rho(rho, error)
        if (allocated(error)) return
        if (.not. are_in_line(points)) then
            call arc_in_span(span_by_corner(start, corner, finish), rho, arc, error)
        else if (is_in_order(points)) then
            arc = line_between(start, finish)
        else
            call fail_in_line(corner, error)
        end if
    end subroutine arc_by_corner_rho

    !> The arc of two ends, the intersection of the end tangents and the shoulder point; a
    !> straight line where all four points are in line and the inner ones between the ends.
    !>
    !> Fails with `cause%points_coincide`, `cause%tangent_on_chord` where the intersection is in
    !> line with the ends, or as `arc_through` does.
    pure subroutine arc_by_corner(start, corner, shoulder, finish, arc, error)
        real(dp), intent(in) :: start(2)                    !! first point, deck units
        real(dp), intent(in) :: corner(2)                   !! where the end tangents meet
        real(dp), intent(in) :: shoulder(2)                 !! shoulder point, deck units
        real(dp), intent(in) :: finish(2)                   !! last point, deck units
        type(arc_type), intent(out) :: arc                  !! the arc, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: with_corner(2, 3), with_shoulder(2, 3)
        logical :: exists

        with_corner = reshape([start, corner, finish], [2, 3])
        with_shoulder = reshape([start, shoulder, finish], [2, 3])
        call check_distinct(with_corner, '1T3', error)
        if (.not. allocated(error)) call check_distinct(with_shoulder, '123', error)
        if (allocated(error)) return
        exists = .false.
        if (are_in_line(with_corner)) then
            exists = are_in_line(with_shoulder)
            if (exists) exists = is_in_order(with_corner) .and. is_in_order(with_shoulder)
            if (exists) arc = line_between(start, finish)
            if (.not. exists) call fail_in_line(corner, error)
            return
        end if
        if (.not. are_in_line(with_shoulder)) then
            call arc_past(span_by_corner(start, corner, finish), shoulder, arc, exists)
        end if
        if (exists) return
        call fail(error, cause%shoulder_outside, 'the shoulder point '//at_text(shoulder)// &
            ' is not where an arc between these tangents can pass; it must lie inside the '// &
            'triangle of points 1 and 3 and the intersection of the end tangents at '// &
            at_text(corner))
    end subroutine arc_by_corner

    !> The arc of a span and rho.
    !>
    !> Fails with `cause%tangent_on_chord` or, where the tangents are parallel, `cause%no_arc`.
    pure subroutine arc_in_span(span, rho, arc, error)
        type(span_type), intent(in) :: span                 !! two ends with their tangents
        real(dp), intent(in) :: rho                         !! 0 to 1, neither
        type(arc_type), intent(out) :: arc                  !! the arc, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above

        if (has_corner(span)) then
            arc = arc_of_weight(span, twofold(rho)/exact_difference(1.0_dp, rho))
        else if (is_level(span)) then
            call fail(error, cause%tangent_on_chord, 'an end tangent runs along the chord from '// &
                at_text(span%start)//' to '//at_text(span%finish)//' and the other does not; '// &
                'turn it off the chord, or both along it for a straight line')
        else
            call fail(error, cause%no_arc, &
                'the end tangents are parallel and do not meet, so that '// &
                'rho says nothing; give the shoulder point')
        end if
    end subroutine arc_in_span

    !> Fails with `cause%no_arc` where rho is not between 0 and 1.
    pure subroutine check_rho(rho, error)
        real(dp), intent(in) :: rho                         !! as given
        type(error_type), allocatable, intent(out) :: error !! see above
        if (rho > 0.0_dp .and. rho < 1.0_dp) return
        call fail(error, cause%no_arc, &
            'rho is '//compact(rho)//'; it must be above 0, the chord, '// &
            'and below 1, the end tangents (.5 is a parabola)')
    end subroutine check_rho

    !> Fails with `cause%tangent_on_chord`: the intersection of the end tangents is on the chord.
    pure subroutine fail_in_line(corner, error)
        real(dp), intent(in) :: corner(2)                   !! as given
        type(error_type), allocatable, intent(out) :: error !! see above
        call fail(error, cause%tangent_on_chord, 'the intersection of the end tangents '// &
            at_text(corner)//' is in line with points 1 and 3; it must be off the chord, '// &
            'or for a straight line all points between the ends')
    end subroutine fail_in_line

end module geom_arc_by_rho
