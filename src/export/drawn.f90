!> What of a drawing goes into a file, and whether it can.
module export_drawn
    use base_digits, only: shortest
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_finite
    use base_kinds, only: dp
    use export_drawing, only: drawing_type, shape_type
    use export_drawing_whole, only: whole
    implicit none (type, external)
    private

    public :: draw_shapes, check_shapes, check_tolerance

contains

    !> The shapes of a drawing: its cuts, and where they are wanted its control lines; halves with
    !> their other half where they shall not be left as they are.
    pure subroutine draw_shapes(drawing, is_half, has_lines, shapes)
        type(drawing_type), intent(in) :: drawing               !! any
        logical, intent(in) :: is_half                          !! halves stay halves
        logical, intent(in) :: has_lines                        !! control lines too
        type(shape_type), allocatable, intent(out) :: shapes(:) !! cuts first
        integer :: i, count

        count = size(drawing%cuts)
        allocate (shapes(count + merge(size(drawing%lines), 0, has_lines)))
        do i = 1, size(shapes)
            if (i <= count) shapes(i) = drawing%cuts(i)
            if (i > count) shapes(i) = drawing%lines(i - count)
            if (shapes(i)%is_half .and. .not. is_half) shapes(i) = whole(shapes(i))
        end do
    end subroutine draw_shapes

    !> Fails with `cause%usage` where there is no contour, and with `cause%no_arc` where
    !> a curve has a coordinate that is infinite or not a number.
    pure subroutine check_shapes(shapes, error)
        type(shape_type), intent(in) :: shapes(:)           !! what shall be written
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: i, contours

        contours = 0
        do i = 1, size(shapes)
            contours = contours + size(shapes(i)%contours)
            if (is_finite_shape(shapes(i))) cycle
            call fail(error, cause%no_arc, shapes(i)%title// &
                ' has a coordinate that is no finite number')
            return
        end do
        if (contours == 0) call fail(error, cause%usage, &
            'there is nothing to draw: the deck makes no cut with an outline')
    end subroutine check_shapes

    !> True where all points and poles of a shape are finite.
    pure logical function is_finite_shape(shape) result(are_finite)
        type(shape_type), intent(in) :: shape   !! any shape
        integer :: i, k

        are_finite = .true.
        do i = 1, size(shape%contours)
            are_finite = are_finite .and. all(is_finite(shape%contours(i)%at))
            associate (curves => shape%contours(i)%curves)
                do k = 1, size(curves)
                    are_finite = are_finite .and. all(is_finite(curves(k)%spline%pole))
                end do
            end associate
        end do
    end function is_finite_shape

    !> Fails with `cause%usage` where a tolerance is not above zero.
    pure subroutine check_tolerance(tolerance, error)
        real(dp), intent(in) :: tolerance                   !! in the unit of the file
        type(error_type), allocatable, intent(out) :: error !! see above
        if (is_finite(tolerance)) then
            if (tolerance > 0.0_dp) return
            call fail(error, cause%usage, 'a tolerance of '//shortest(tolerance)// &
                '; it must be above zero')
        else
            call fail(error, cause%usage, 'a tolerance that is no finite number')
        end if
    end subroutine check_tolerance

end module export_drawn
