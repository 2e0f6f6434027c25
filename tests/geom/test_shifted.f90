!> The book's system of five equations, solved by LAPACK, against the book and against the arc.
program test_shifted
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, direction_of_slope, end_type
    use geom_conic, only: conic_of, conic_type
    use geom_shifted, only: difference_from, shifted_type, solve_shifted
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(shifted_type) :: conic
    type(conic_type) :: exact
    type(error_type), allocatable :: error
    type(arc_type) :: arc
    type(end_type) :: start, finish
    real(dp) :: expected(5), ratio(5)

    ! SAE 700202, appendix B: the coefficients printed for the first line of the nose.
    start = end_type([-30.0_dp, -10.0_dp], direction_of_slope(0.114_dp))
    finish = end_type([50.0_dp, -4.0_dp], direction_of_slope(0.0523_dp))
    call solve_shifted(start, [0.0_dp, -7.1_dp], finish, 100.0_dp, conic, error)
    call tap%ok(.not. allocated(error), 'the nose has a solution')
    expected = [0.00000088_dp, -0.00002608_dp, 0.00013696_dp, 0.00229387_dp, -0.02344400_dp]
    call tap%near(maxval(abs(conic%coefficient - expected)), 0.0_dp, 0.5e-8_dp, &
        'its coefficients are those the book prints')
    call arc_through(start, [0.0_dp, -7.1_dp], finish, arc, error)
    call tap%near(difference_from(conic, arc), 0.0_dp, 1.0e-10_dp, 'the arc lies on its conic')
    call tap%ok(conic%rcond > 1.0e-16_dp .and. conic%rcond < 1.0e-3_dp, 'its condition is stated')

    ! Shifting moves neither A, B, C beside each other nor the curve.
    exact = conic_of(arc)
    ratio = 0.0_dp
    ratio(:3) = conic%coefficient(:3)/conic%coefficient(3) &
        - exact%coefficient(:3)/exact%coefficient(3)
    call tap%near(maxval(abs(ratio)), 0.0_dp, 1.0e-9_dp, &
        'A, B and C are in the ratio of the arc''s own')

    ! The unit circle shifted by 2: x**2 + y**2 - 4 x - 4 y + 7 = 0, over 7.
    start = end_type([1.0_dp, 0.0_dp], direction_of_slope(999.999_dp))
    finish = end_type([0.0_dp, 1.0_dp], direction_of_slope(0.0_dp))
    call solve_shifted(start, [0.6_dp, 0.8_dp], finish, 2.0_dp, conic, error)
    expected = [1.0_dp, 0.0_dp, 1.0_dp, -4.0_dp, -4.0_dp]/7.0_dp
    call tap%near(maxval(abs(conic%coefficient - expected)), 0.0_dp, 1.0e-14_dp, &
        'a vertical tangent is a limit, not a large slope')
    call arc_through(start, [0.0_dp, -1.0_dp], finish, arc, error)
    call tap%near(difference_from(conic, arc), 0.0_dp, 1.0e-13_dp, &
        'the rest of the circle is on it')
    call arc_through(start, [0.61_dp, 0.8_dp], finish, arc, error)
    call tap%ok(difference_from(conic, arc) > 1.0e-3_dp, 'another arc is not')

    call solve_shifted(end_type([0.0_dp, 0.0_dp], [1.0_dp, 0.0_dp]), [1.0_dp, 1.0_dp], &
        end_type([0.0_dp, 0.0_dp], [1.0_dp, 0.0_dp]), 100.0_dp, conic, error)
    call tap%ok(allocated(error), 'coinciding points have no solution')
    call tap%ok(error%cause == cause%singular, '... and are called singular')
    call tap%finish()
end program test_shifted
