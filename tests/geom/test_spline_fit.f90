!> Interpolation against scipy's (make_interp_spline, written in by hand), against polynomials,
!> which it gives back, and with breaks that are one.
program test_spline_fit
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_bspline, only: bspline_type, spline_point
    use geom_spline_fit, only: fit_knots, fit_nodes, fit_values
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    real(dp), parameter :: breaks(5) = [0.0_dp, 0.1_dp, 0.25_dp, 0.6_dp, 1.0_dp]
    !> Poles of the quintic spline through exp at Greville's nodes, by scipy.
    real(dp), parameter :: scipy(9) = [1.0_dp, 1.0200000192536969_dp, 1.0712498852853047_dp, &
        1.202000608191884_dp, 1.4535392097452597_dp, 1.7730094517358874_dp, 2.1338492314070154_dp, &
        2.5008196037807457_dp, 2.718281828459045_dp]
    type(bspline_type) :: s
    type(error_type), allocatable :: error
    real(dp) :: nodes(9), poles(2, 9), away, t, at(2)
    integer :: i, degree

    nodes = fit_nodes(breaks, 5)
    call tap%ok(all(abs(nodes - [0.0_dp, 0.02_dp, 0.07_dp, 0.19_dp, 0.39_dp, 0.59_dp, 0.77_dp, &
        0.92_dp, &
        1.0_dp]) < 2.0e-16_dp), 'nodes are averages of knots')
    call tap%ok(nodes(1) == 0.0_dp .and. nodes(9) == 1.0_dp, 'the ends exactly')
    call tap%ok(all(fit_knots(breaks, 2) == [0.0_dp, 0.0_dp, breaks, 1.0_dp, 1.0_dp]), 'knots')
    call fit_values(breaks, 5, reshape([exp(nodes), [(7.3_dp, i=1, 9)]], [2, 9], order=[2, 1]), &
        poles, &
        error)
    call tap%ok(.not. allocated(error), 'the system has a solution')
    call tap%ok(all(abs(poles(1, :) - scipy) < 1.0e-14_dp), 'it is scipy''s')
    call tap%ok(poles(1, 1) == 1.0_dp .and. poles(1, 9) == exp(1.0_dp), 'its ends are the values')
    call tap%ok(all(poles(2, :) == 7.3_dp), 'what is constant stays so exactly')

    do degree = 1, 7
        call check_polynomial(degree)
    end do

    call fit_values([0.0_dp, 0.5_dp, 0.5_dp, 0.5_dp, 0.5_dp, 1.0_dp], 3, reshape([(1.0_dp, i=1, &
        16)], &
        [2, 8]), poles(:, :8), error)
    call tap%ok(allocated(error), 'breaks that are one have no spline')
    if (allocated(error)) call tap%ok(error%cause == cause%singular, 'and this is why')
    call tap%finish()

contains

    !> A polynomial of the degree of the splines is given back.
    subroutine check_polynomial(degree)
        integer, intent(in) :: degree !! of both
        real(dp), allocatable :: nodes(:), values(:, :)
        integer :: j

        allocate (nodes, source=fit_nodes(breaks, degree))
        allocate (values(2, size(nodes)))
        do j = 1, size(nodes)
            values(:, j) = polynomial(nodes(j), degree)
        end do
        s%degree = degree
        s%knot = fit_knots(breaks, degree)
        s%weight = [(1.0_dp, j=1, size(nodes))]
        s%pole = values
        call fit_values(breaks, degree, values, s%pole, error)
        away = 0.0_dp
        do j = 0, 50
            t = real(j, dp)/50.0_dp
            at = spline_point(s, t)
            away = max(away, norm2(at - polynomial(t, degree)))
        end do
        call tap%near(away, 0.0_dp, 3.0e-15_dp, 'a polynomial of the degree is given back')
    end subroutine check_polynomial

    !> Two polynomials with all their terms.
    pure function polynomial(t, degree) result(value)
        real(dp), intent(in) :: t       !! 0 to 1
        integer, intent(in) :: degree   !! of both
        real(dp) :: value(2)
        value = [((1.0_dp + 2.0_dp*t)/3.0_dp)**degree, (0.3_dp - 1.3_dp*t)**degree]
    end function polynomial

end program test_spline_fit
