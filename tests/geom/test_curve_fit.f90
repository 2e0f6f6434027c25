!> Curves fitted within tolerances: the distance is measured again here, from points of the curve's
!> own formula, at other parameters than the fit's.
program test_curve_fit
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_bspline, only: bspline_type, spline_point
    use geom_curve_fit, only: fit_curve
    use support_curves, only: example_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(bspline_type) :: s
    type(error_type), allocatable :: error
    real(dp) :: largest, worst, p(3)

    ! Tolerances and the spans they may take: a thousandth takes 1000**(1/6) = 3.2 times as many.
    call check_curve(1, 1.0e-3_dp, 2)
    call check_curve(1, 1.0e-6_dp, 8)
    call check_curve(1, 1.0e-9_dp, 24)
    call check_curve(2, 1.0e-3_dp, 40)
    call check_curve(2, 1.0e-6_dp, 90)
    call check_curve(3, 1.0e-6_dp, 420)
    call check_curve(4, 1.0e-6_dp, 30)
    call check_curve(5, 1.0e-6_dp, 14)
    call tap%ok(all(s%pole(1, :) == 17.3_dp), 'what is in a plane stays in it exactly')
    call check_curve(6, 1.0e-6_dp, 1)
    call tap%ok(largest == 0.0_dp, 'and off by nothing')
    call check_curve(8, 1.0e-12_dp, 1)

    call fit_curve(example_type(7), 1.0e-6_dp, s, largest, worst, error)
    call tap%ok(allocated(error), 'a step is refused')
    if (allocated(error)) then
        call tap%ok(error%cause == cause%no_convergence, 'and this is why')
        call tap%has(error%message, 'within 1.E-06: a spline of', 'the tolerance is named')
    end if
    call tap%ok(largest > 0.1_dp .and. abs(worst - 0.3_dp) < 1.0e-3_dp, 'it says where it failed')
    call fit_curve(example_type(1), 1.0e-17_dp, s, largest, worst, error)
    call tap%ok(allocated(error), 'a tolerance below rounding is refused')
    call tap%finish()

contains

    !> Fits a curve and measures it again.
    subroutine check_curve(number, tolerance, most_spans)
        integer, intent(in) :: number       !! of the curve
        real(dp), intent(in) :: tolerance   !! deck units
        integer, intent(in) :: most_spans   !! how many it may take
        type(example_type) :: f
        real(dp) :: away
        integer :: i
        character(20) :: name

        write (name, '(a,i0,a,es7.0)') 'curve ', number, ' to', tolerance
        f = example_type(number)
        call fit_curve(f, tolerance, s, largest, worst, error)
        call tap%ok(.not. allocated(error), name//': is fitted')
        call tap%ok(largest <= tolerance, name//': says that it is within')
        call tap%ok(size(s%weight) <= most_spans + 5, name//': takes few spans')
        if (size(s%weight) > most_spans + 5) print *, size(s%weight) - 5
        call tap%ok(s%degree == 5 .and. all(s%weight == 1.0_dp), name//': of degree 5')
        call tap%ok(all(s%pole(:, 1) == f%at(0.0_dp)) .and. all(s%pole(:, size(s%weight)) == &
            f%at(1.0_dp)), name//': its ends are the curve''s')
        away = 0.0_dp
        do i = 0, 20011
            away = max(away, nearness(f, real(i, dp)/20011.0_dp))
        end do
        call tap%ok(away <= 1.02_dp*largest + 1.0e-13_dp, name//': is not off by more than it says')
        p = spline_point(s, worst)
        call tap%ok(nearness(f, worst) >= 0.9_dp*largest - 1.0e-13_dp, &
            name//': is off so much there')
    end subroutine check_curve

    !> Distance of a point of the spline from the curve, by golden section around its parameter.
    real(dp) function nearness(f, t)
        type(example_type), intent(in) :: f !! the curve
        real(dp), intent(in) :: t           !! 0 to 1
        real(dp), parameter :: golden = 0.6180339887498949_dp
        real(dp) :: low, high, one, two
        integer :: i

        p = spline_point(s, t)
        low = max(0.0_dp, t - 1.0e-6_dp)
        high = min(1.0_dp, t + 1.0e-6_dp)
        do i = 1, 30
            one = high - golden*(high - low)
            two = low + golden*(high - low)
            if (norm2(f%at(one) - p) < norm2(f%at(two) - p)) then
                high = two
            else
                low = one
            end if
        end do
        nearness = min(norm2(f%at(0.5_dp*(low + high)) - p), norm2(f%at(t) - p))
    end function nearness

end program test_curve_fit
