!> The degree of lines in files.
program test_drawing_degree
    use base_kinds, only: dp
    use export_drawing_degree, only: limit_degree, most_degree
    use geom_bezier, only: bezier_point, bezier_raised
    use geom_bspline, only: bspline_type, spline_point
    use geom_stroke, only: bezier_stroke
    use geom_stroke_spline, only: stroke_spline
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(bspline_type) :: spline
    real(dp) :: pole(2, 14)
    real(dp) :: bound
    integer :: i

    call tap%ok(most_degree == 9, 'degree 9 is the highest written')
    do i = 1, 14
        pole(:, i) = [real(i, dp), 10.0_dp*cos(real(i, dp))]
    end do
    spline = stroke_spline(bezier_stroke(pole(:, :10)))
    call limit_degree(spline, 1.0e-4_dp, bound)
    call tap%ok(bound <= 0.0_dp .and. all(abs(spline%pole - pole(:, :10)) <= 0.0_dp), &
        'degree 9 is left alone')
    spline = stroke_spline(bezier_stroke(pole))
    call limit_degree(spline, 1.0e-4_dp, bound)
    call tap%ok(spline%degree == 5 .and. size(spline%weight) > 6, 'degree 13 becomes 5, in pieces')
    call tap%ok(apart() <= bound .and. apart() > 0.01_dp*bound .and. bound <= 1.0e-4_dp, &
        'within the tolerance, as is told')
    do i = 4, 13
        pole(:, :i + 1) = bezier_raised(pole(:, :i))
    end do
    spline = stroke_spline(bezier_stroke(pole))
    call limit_degree(spline, 1.0e-4_dp, bound)
    call tap%ok(spline%degree == 3 .and. size(spline%knot) == 8, &
        'a raised cubic is a cubic again')
    call tap%near(apart(), 0.0_dp, 1.0e-13_dp, 'the same')
    spline = stroke_spline(bezier_stroke(pole))
    call limit_degree(spline, 0.0_dp, bound)
    call tap%ok(spline%degree == 3, 'whatever the tolerance')
    call tap%finish()

contains

    !> The largest distance of the spline from the curve of `pole`.
    real(dp) function apart()
        integer :: k
        apart = 0.0_dp
        do k = 0, 500
            apart = max(apart, norm2(spline_point(spline, real(k, dp)/500.0_dp) &
                - bezier_point(pole, real(k, dp)/500.0_dp)))
        end do
    end function apart

end program test_drawing_degree
