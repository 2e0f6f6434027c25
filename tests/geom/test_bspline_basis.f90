!> B-splines against Bernstein polynomials, their own sums, and figures worked by scipy.
program test_bspline_basis
    use base_kinds, only: dp
    use geom_bspline_basis, only: basis, basis_jet, breaks_of, span_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    real(dp), parameter :: bezier(8) = [0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 1.0_dp, &
        1.0_dp]
    real(dp), parameter :: knot(11) = [0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 2.5_dp, 2.5_dp, &
        4.0_dp, 4.0_dp, 4.0_dp, 4.0_dp]
    real(dp) :: jet(4, 0:2), t, away, sums(3), lowest, ahead(4), behind(4)
    integer :: i, span

    call tap%ok(all([span_of(knot, 3, -1.0_dp), span_of(knot, 3, 0.0_dp), span_of(knot, 3, &
        0.99_dp), &
        span_of(knot, 3, 1.0_dp), span_of(knot, 3, 2.5_dp), span_of(knot, 3, 4.0_dp), &
        span_of(knot, 3, 9.0_dp)] == [4, 4, 4, 5, 7, 7, 7]), 'spans, also at knots and beyond')
    call tap%ok(all(breaks_of(knot) == [0.0_dp, 1.0_dp, 2.5_dp, 4.0_dp]), 'different knots')

    away = 0.0_dp
    do i = 0, 10
        t = real(i, dp)/10.0_dp
        jet = basis_jet(bezier, 3, 4, t)
        away = max(away, maxval(abs(jet(:, 0) - [(1 - t)**3, 3*t*(1 - t)**2, 3*t**2*(1 - t), &
            t**3])), &
            maxval(abs(jet(:, 1) - [-3*(1 - t)**2, 3*(1 - t)*(1 - 3*t), 3*t*(2 - 3*t), 3*t**2])), &
            maxval(abs(jet(:, 2) - [6*(1 - t), 18*t - 12, 6 - 18*t, 6*t])))
    end do
    call tap%near(away, 0.0_dp, 8.0e-15_dp, 'without inner knots they are Bernstein''s')

    sums = 0.0_dp
    lowest = 1.0_dp
    do i = 0, 400
        t = real(i, dp)/100.0_dp
        jet = basis_jet(knot, 3, span_of(knot, 3, t), t)
        sums = max(sums, abs(sum(jet, dim=1) - [1.0_dp, 0.0_dp, 0.0_dp]))
        lowest = min(lowest, minval(jet(:, 0)))
    end do
    call tap%ok(sums(1) <= 4.0e-16_dp, 'their sum is 1')
    call tap%ok(all(sums(2:) <= 1.0e-14_dp), 'the sums of derivatives are 0')
    call tap%ok(lowest >= 0.0_dp, 'none is negative')

    t = 1.7_dp
    span = span_of(knot, 3, t)
    jet = basis_jet(knot, 3, span, t)
    ahead = basis(knot, 3, span, t + 1.0e-5_dp)
    behind = basis(knot, 3, span, t - 1.0e-5_dp)
    call tap%ok(all(abs((ahead - behind)/2.0e-5_dp - jet(:, 1)) < 1.0e-9_dp), &
        'the first derivative is the limit of differences')
    call tap%ok(all(abs((ahead - 2.0_dp*jet(:, 0) + behind)/1.0e-10_dp - jet(:, 2)) < 1.0e-5_dp), &
        'so is the second')
    jet(:2, :) = basis_jet([0.0_dp, 0.0_dp, 2.0_dp, 2.0_dp], 1, 2, 0.5_dp)
    call tap%ok(all(jet(:2, 0) == [0.75_dp, 0.25_dp]) .and. all(jet(:2, 1) == [-0.5_dp, 0.5_dp]) &
        .and. all(jet(:2, 2) == 0.0_dp), 'degree 1')
    call tap%finish()
end program test_bspline_basis
