!> The shape of a faired outline: exact, closed, on the points of the outline.
program test_drawing_faired
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_outline, only: outline_type
    use export_drawing, only: shape_kind, shape_type
    use export_drawing_faired, only: outline_shape
    use geom_bspline, only: spline_from, spline_jet, spline_point, spline_to
    use geom_fairing, only: fair
    use geom_fairing_system, only: fairing_end
    use support_inlet, only: inlet
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    integer :: count

    do count = 14, 3, -11
        call check(tap, count)
    end do
    call tap%finish()

contains

    !> Checks the shape of the first points of the inlet.
    subroutine check(tap, count)
        type(tap_type), intent(inout) :: tap    !! the tally
        integer, intent(in) :: count            !! of points
        type(outline_type) :: outline
        type(shape_type) :: shape
        type(error_type), allocatable :: error
        real(dp) :: at(3), one(3, 2), two(3, 2), worst
        integer :: i, half

        outline%name = 'INLET'
        outline%sta = 5.0_dp
        outline%measured%point = inlet(:, :count)
        allocate (outline%measured%weight(count), source=100.0_dp)
        outline%measured%ends = fairing_end%closed
        call fair(outline%measured, 0.0_dp, outline%fairing, error)
        shape = outline_shape(outline)
        call tap%ok(shape%name == 'STA_5_INLET' .and. shape%kind == shape_kind%station, 'a station')
        call tap%ok(shape%contours(1)%is_closed .and. all(shape%contours(1)%curves%is_exact), &
            'closed and exact')
        half = int(0.5_dp*real(count, dp))
        associate (curve => shape%contours(1)%curves)
            call tap%ok(all(spline_point(curve(2)%spline, spline_to(curve(2)%spline)) == &
                spline_point(curve(1)%spline, 0.0_dp)) .and. all(curve(1)%spline%pole(:, &
                size(curve(1)%spline%pole, 2)) == curve(2)%spline%pole(:, 1)), &
                'its halves meet to the bit')
            worst = 0.0_dp
            do i = 1, count
                if (i <= half) then
                    at = spline_point(curve(1)%spline, real(i - 1, dp))
                else
                    at = spline_point(curve(2)%spline, real(i - 1 - half, dp))
                end if
                worst = max(worst, norm2(at - [5.0_dp, outline%fairing%near(:, i)]))
            end do
            call tap%near(worst, 0.0_dp, 1.0e-15_dp, 'it goes through the faired points')
            call spline_jet(curve(1)%spline, spline_from(curve(1)%spline), at, one(:, 1), &
                two(:, 1))
            call spline_jet(curve(2)%spline, spline_to(curve(2)%spline), at, one(:, 2), two(:, 2))
            call tap%near(norm2(one(:, 1) - one(:, 2)) + norm2(two(:, 1) - two(:, 2)), 0.0_dp, &
                1.0e-13_dp, 'its derivatives go on at the seam')
        end associate
    end subroutine check

end program test_drawing_faired
