!> Strokes as B-splines: the same points at the same parameters.
program test_stroke_spline
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, end_type
    use geom_bezier, only: bezier_point
    use geom_bspline, only: bspline_type, is_rational, spline_point
    use geom_stroke, only: bezier_stroke, conic_stroke
    use geom_stroke_spline, only: stroke_spline
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(arc_type) :: arc
    type(bspline_type) :: spline
    type(random_type) :: random
    type(error_type), allocatable :: error
    real(dp) :: pole(2, 8), at(2), worst
    integer :: i, degree

    worst = 0.0_dp
    do degree = 1, 7
        do i = 1, degree + 1
            pole(:, i) = [random%unit(), random%unit()]
        end do
        spline = stroke_spline(bezier_stroke(pole(:, :degree + 1)))
        if (spline%degree /= degree .or. is_rational(spline)) worst = 1.0_dp
        do i = 0, 10
            worst = max(worst, norm2(spline_point(spline, 0.1_dp*real(i, dp)) &
                - bezier_point(pole(:, :degree + 1), 0.1_dp*real(i, dp))))
        end do
    end do
    call tap%near(worst, 0.0_dp, 2.0e-15_dp, 'Bezier curves of degree 1 to 7')
    call arc_through(end_type([-5.0_dp, 0.0_dp], [0.0_dp, 1.0_dp]), [-4.0_dp, 3.0_dp], &
        end_type([0.0_dp, 5.0_dp], [1.0_dp, 0.0_dp]), arc, error)
    spline = stroke_spline(conic_stroke(arc))
    call tap%ok(is_rational(spline), 'a conic is rational')
    worst = 0.0_dp
    do i = 0, 10
        at = spline_point(spline, 0.1_dp*real(i, dp))
        worst = max(worst, abs(norm2(at) - 5.0_dp))
    end do
    call tap%near(worst, 0.0_dp, 4.0e-15_dp, 'a quarter of a circle is one')
    call tap%finish()
end program test_stroke_spline
