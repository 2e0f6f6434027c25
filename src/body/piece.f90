!> The stroke of a data card of a control line, whichever way it is given.
module body_piece
    use base_constants, only: degrees
    use base_error, only: error_type
    use base_kinds, only: dp
    use deck_job, only: piece, piece_real, piece_type
    use geom_arc, only: arc_through, arc_type, direction_of_slope, end_type
    use geom_arc_by_circle, only: circle_by_points, circle_by_radius
    use geom_arc_by_points, only: arc_by_five_points, arc_by_four_points, line_by_points
    use geom_arc_by_rho, only: arc_by_corner, arc_by_corner_rho, arc_by_rho
    use geom_joint, only: match_finish, match_start
    use geom_place, only: at_finish
    use geom_points, only: check_distinct
    use geom_span, only: new_span, span_by_corner, span_type
    use geom_stroke, only: conic_stroke, cyclic_stroke, stroke_curvature, stroke_type
    implicit none (type, external)
    private

    public :: piece_stroke

contains

    !> The stroke of a piece, from its point 1 to its point 3; y over station.
    !>
    !> Fails as the constructor of the arc does, and with `cause%points_coincide` where poles of a
    !> C-Bezier curve are one; the message says what would be right.
    pure subroutine piece_stroke(item, before, stroke, error)
        type(piece_type), intent(in) :: item                !! the piece
        type(stroke_type), intent(in) :: before             !! the one before it, for MATCH
        type(stroke_type), intent(out) :: stroke            !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: v(9)
        type(arc_type) :: arc

        if (item%kind == piece%cyclic) then
            v = piece_real(item, [1, 2, 3, 4, 5, 6, 7, 8, 9])
            call check_distinct(reshape(v(:8), [2, 4]), '1AB3', error)
            if (.not. allocated(error)) &
                stroke = cyclic_stroke(reshape(v(:8), [2, 4]), v(9)/degrees)
        else
            call piece_arc(item, before, arc, error)
            if (.not. allocated(error)) stroke = conic_stroke(arc)
        end if
    end subroutine piece_stroke

    !> The arc of a piece that is a conic. Fails as its constructor does.
    pure subroutine piece_arc(item, before, arc, error)
        type(piece_type), intent(in) :: item                !! the piece
        type(stroke_type), intent(in) :: before             !! the one before it, for MATCH
        type(arc_type), intent(out) :: arc                  !! the arc, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: v(10)
        integer :: i

        v = 0.0_dp
        v(:size(item%value)) = [(piece_real(item, i), i = 1, size(item%value))]
        if (item%is_match) then
            call matching_arc(item, v, before, arc, error)
            return
        end if
        select case (item%kind)
        case (piece%conic)
            call arc_through(start_of(item, v(1:3)), v(4:5), finish_of(item, v(6:8)), arc, error)
        case (piece%rho)
            call arc_by_rho(start_of(item, v(1:3)), v(7), finish_of(item, v(4:6)), arc, error)
        case (piece%tangent)
            call arc_by_corner(v(1:2), v(3:4), v(5:6), v(7:8), arc, error)
        case (piece%tangent_rho)
            call arc_by_corner_rho(v(1:2), v(3:4), v(7), v(5:6), arc, error)
        case (piece%four_points)
            call arc_by_four_points(reshape(v([1, 2, 4, 5, 6, 7, 8, 9]), [2, 4]), &
                direction(v(3), any(item%is_inverse)), item%is_slope_last, arc, error)
        case (piece%five_points)
            call arc_by_five_points(reshape(v, [2, 5]), arc, error)
        case (piece%straight)
            call line_by_points(v(1:2), v(3:4), arc, error)
        case (piece%circle)
            call circle_by_points(v(1:2), v(3:4), v(5:6), arc, error)
        case (piece%radius)
            call circle_by_radius(v(1:2), v(3:4), v(5), arc, error)
        end select
    end subroutine piece_arc

    !> The arc that takes up the curvature at the end of the arc before it: at its point 1, or at
    !> its point 3 where that is the nearer to it.
    !>
    !> Fails with `cause%points_coincide` or as `match_start`.
    pure subroutine matching_arc(item, v, before, arc, error)
        type(piece_type), intent(in) :: item                !! the piece
        real(dp), intent(in) :: v(:)                        !! its numbers
        type(stroke_type), intent(in) :: before             !! the stroke before it
        type(arc_type), intent(out) :: arc                  !! the arc, where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(span_type) :: span
        real(dp) :: bend

        call span_of(item, v, span, error)
        if (allocated(error)) return
        bend = stroke_curvature(before, at_finish)
        if (norm2(span%start - before%finish) <= norm2(span%finish - before%finish)) then
            call match_start(span, bend, arc, error)
        else
            call match_finish(span, -bend, arc, error)
        end if
    end subroutine matching_arc

    !> The ends and end tangents of a piece whose shoulder point or rho is to be found.
    !>
    !> Fails with `cause%points_coincide`.
    pure subroutine span_of(item, v, span, error)
        type(piece_type), intent(in) :: item                !! the piece
        real(dp), intent(in) :: v(:)                        !! its numbers
        type(span_type), intent(out) :: span                !! ends and tangents
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: last

        last = merge(4, 6, item%kind == piece%rho)
        if (item%kind == piece%tangent_rho) last = 5
        if (item%kind == piece%tangent) last = 7
        if (item%kind == piece%conic .or. item%kind == piece%rho) then
            call check_distinct(reshape(v([1, 2, last, last + 1]), [2, 2]), '13', error)
            if (.not. allocated(error)) span = new_span(start_of(item, v(1:3)), &
                finish_of(item, v(last:last + 2)))
        else
            call check_distinct(reshape(v([1, 2, 3, 4, last, last + 1]), [2, 3]), '1T3', error)
            if (.not. allocated(error)) span = span_by_corner(v(1:2), v(3:4), v(last:last + 1))
        end if
    end subroutine span_of

    !> The first end of a piece.
    pure type(end_type) function start_of(item, v) result(start)
        type(piece_type), intent(in) :: item !! the piece
        real(dp), intent(in) :: v(3)         !! x, y and slope
        start = end_type(v(1:2), direction(v(3), item%is_inverse(1)))
    end function start_of

    !> The last end of a piece.
    pure type(end_type) function finish_of(item, v) result(finish)
        type(piece_type), intent(in) :: item !! the piece
        real(dp), intent(in) :: v(3)         !! x, y and slope
        finish = end_type(v(1:2), direction(v(3), item%is_inverse(2)))
    end function finish_of

    !> The direction of a slope dy/dx, or dx/dy: from `vertical_slope` on this is level.
    pure function direction(slope, is_inverse)
        real(dp), intent(in) :: slope        !! as on the card
        logical, intent(in) :: is_inverse    !! it is dx/dy
        real(dp) :: direction(2)
        direction = direction_of_slope(slope)
        if (is_inverse) direction = direction(2:1:-1)
    end function direction

end module body_piece
