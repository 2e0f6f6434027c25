!> Tests of what goes into a file.
program test_drawn
    use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_quiet_nan, ieee_value
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use export_drawing, only: drawing_type, shape_kind, shape_type
    use export_drawn, only: check_shapes, check_tolerance, draw_shapes
    use support_sketch, only: add_contour, add_shape, ellipse, new_drawing, new_shape, segment
    use support_tap, only: tap_type
    implicit none (type, external)
    type(tap_type) :: tap

    call check_choice()
    call check_refusals()
    call tap%finish()

contains

    subroutine check_choice()
        type(drawing_type) :: drawing
        type(shape_type) :: shape
        type(shape_type), allocatable :: shapes(:)

        drawing = new_drawing(1.0e-3_dp)
        shape = new_shape('STA-1', 1.0_dp)
        call add_contour(shape, segment([1.0_dp, 0.0_dp, -2.0_dp], [1.0_dp, 3.0_dp, 2.0_dp]))
        shape%is_half = .true.
        call add_shape(drawing, shape)
        shape = new_shape('MHB', 0.0_dp)
        shape%kind = shape_kind%line
        deallocate (drawing%lines)
        allocate (drawing%lines(1))
        drawing%lines(1) = shape
        call draw_shapes(drawing, .true., .false., shapes)
        call tap%ok(size(shapes) == 1, 'cuts alone')
        call tap%ok(size(shapes(1)%contours(1)%curves) == 1 .and. shapes(1)%is_half, &
            'a half stays one where this is asked')
        call draw_shapes(drawing, .false., .true., shapes)
        call tap%ok(size(shapes) == 2, 'cuts and control lines')
        call tap%same(shapes(2)%name, 'MHB', 'lines come behind the cuts')
        call tap%ok(.not. shapes(1)%is_half, 'a half becomes whole')
        call tap%near(least_butt(shapes(1)), -3.0_dp, 1.0e-15_dp, 'with its port side')
    end subroutine check_choice

    !> The least BL of a shape's poles.
    real(dp) function least_butt(shape) result(least)
        type(shape_type), intent(in) :: shape   !! any
        integer :: i, k
        least = huge(least)
        do i = 1, size(shape%contours)
            do k = 1, size(shape%contours(i)%curves)
                least = min(least, minval(shape%contours(i)%curves(k)%spline%pole(2, :)))
            end do
        end do
    end function least_butt

    subroutine check_refusals()
        type(drawing_type) :: drawing
        type(shape_type) :: shape
        type(error_type), allocatable :: error

        drawing = new_drawing(1.0e-3_dp)
        call check_shapes(drawing%cuts, error)
        call says(error, cause%usage, 'nothing to draw', 'a drawing without cuts')
        shape = new_shape('STA-1', 1.0_dp)
        call check_shapes([shape], error)
        call says(error, cause%usage, 'nothing to draw', 'a cut without contours')
        call add_contour(shape, ellipse(shape%plane, [0.0_dp, 0.0_dp], [2.0_dp, 1.0_dp]))
        call check_shapes([shape], error)
        call tap%ok(.not. allocated(error), 'a cut with a contour is drawn')
        shape%contours(1)%curves(2)%spline%pole(3, 2) = ieee_value(1.0_dp, ieee_quiet_nan)
        call check_shapes([shape], error)
        call says(error, cause%no_arc, 'no finite number', 'a coordinate that is not a number')
        call check_tolerance(1.0e-6_dp, error)
        call tap%ok(.not. allocated(error), 'a millionth is a tolerance')
        call check_tolerance(0.0_dp, error)
        call says(error, cause%usage, 'above zero', 'no tolerance')
        call check_tolerance(-1.0_dp, error)
        call says(error, cause%usage, '-1', 'a tolerance below zero')
        call check_tolerance(ieee_value(1.0_dp, ieee_positive_inf), error)
        call says(error, cause%usage, 'finite', 'an infinite tolerance')
    end subroutine check_refusals

    subroutine says(error, why, words, name)
        type(error_type), allocatable, intent(in) :: error  !! as it came back
        integer, intent(in) :: why                          !! its cause
        character(*), intent(in) :: words                   !! in its message
        character(*), intent(in) :: name                    !! of the case
        call tap%ok(allocated(error), name//' is refused')
        if (.not. allocated(error)) return
        call tap%ok(error%cause == why, name//': with its cause')
        call tap%has(error%message, words, name//': and says why')
    end subroutine says

end program test_drawn
