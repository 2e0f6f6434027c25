!> The shape of a control line in space: one curve between any two of its joints.
module export_drawing_line
    use base_error, only: error_type
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_order, only: rising
    use base_tolerances, only: agreement_ulps, meeting_tolerance, ulp
    use body_line, only: line_type
    use cut_plane, only: buttock_plane
    use export_drawing, only: contour_type, curve_type, shape_kind, shape_type
    use export_drawing_join, only: gap_between, join, last_point
    use export_drawing_name, only: safe_name
    use export_drawing_stretch, only: draw_stretch, stretch_of
    use geom_chain, only: chain_joints
    implicit none (type, external)
    private

    public :: draw_line

contains

    !> The shape of a control line, whose axes are those of the side view. Of a line that is but an
    !> angle, or is constant without an end, the contours are not allocated.
    !>
    !> Fails with `cause%no_convergence` where a curve can't be fitted.
    pure subroutine draw_line(line, number, tolerance, shape, error)
        type(line_type), intent(in) :: line                 !! of a body
        integer, intent(in) :: number                       !! which of its lines
        real(dp), intent(in) :: tolerance                   !! of fitted curves, deck units
        type(shape_type), intent(out) :: shape              !! see above
        type(error_type), allocatable, intent(out) :: error !! see above
        type(curve_type), allocatable :: curves(:)
        real(dp), allocatable :: stops(:)
        integer :: i

        shape%name = safe_name(line%name)
        shape%title = 'LINE '//trim(line%name)
        shape%kind = shape_kind%line
        shape%number = number
        shape%plane = buttock_plane(level_of(line))
        if (.not. line%has_side .or. .not. line%from < line%to) return
        if (max(-line%from, line%to) >= huge(1.0_dp)) return
        allocate (stops(0))
        stops = stops_of(line)
        allocate (curves(size(stops) - 1))
        do i = 1, size(curves)
            call draw_stretch(stretch_of(line, stops(i:i + 1)), tolerance, curves(i), error)
            if (allocated(error)) return
            if (curves(i)%is_conic) curves(i)%is_conic = &
                all(is_equal(curves(i)%spline%pole(2, :), level_of(line)))
        end do
        call make_contours(curves, shape%contours)
    end subroutine draw_line

    !> The butt line in which all of a line is, or 0.
    pure real(dp) function level_of(line) result(level)
        type(line_type), intent(in) :: line !! any
        level = 0.0_dp
        if (line%has_plan .and. line%plan%is_constant) level = line%plan%constant
    end function level_of

    !> The ends of a line and, between them, the joints of its views, in order.
    pure function stops_of(line) result(stops)
        type(line_type), intent(in) :: line !! with a side view, of finite length
        real(dp), allocatable :: stops(:), joints(:)

        allocate (joints(0))
        joints = chain_joints(line%side)
        if (line%has_plan) joints = [joints, chain_joints(line%plan)]
        joints = pack(joints, joints > line%from .and. joints < line%to)
        stops = rising([line%from, joints, line%to])
    end function stops_of

    !> Puts the curves of a line end to end; where they do not meet, as several contours.
    pure subroutine make_contours(curves, contours)
        type(curve_type), intent(inout) :: curves(:)                    !! in order
        type(contour_type), allocatable, intent(out) :: contours(:)     !! of the line
        logical :: meets(size(curves))
        real(dp) :: reach
        integer :: i, first

        meets = .false.
        do i = 1, size(curves) - 1
            reach = maxval(abs(curves(i)%spline%pole))
            meets(i) = gap_between(curves(i), curves(i + 1)) <= meeting_tolerance*reach
            if (meets(i)) call join(last_point(curves(i)), agreement_ulps*ulp*reach, &
                curves(i + 1))
        end do
        allocate (contours(count(.not. meets)))
        first = 1
        do i = 1, size(contours)
            associate (last => first - 1 + findloc(meets(first:), .false., dim=1))
                allocate (contours(i)%marks(0))
                contours(i)%curves = curves(first:last)
                first = last + 1
            end associate
        end do
    end subroutine make_contours

end module export_drawing_line
