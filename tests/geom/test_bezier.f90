!> Bezier curves: the acceptance facts of seed 001, and what holds of every curve.
program test_bezier
    use base_constants, only: pi
    use base_kinds, only: dp
    use geom_bezier, only: bernstein, bezier_derivative, bezier_from_sides, bezier_jet, &
        bezier_part, bezier_point, bezier_raised, bezier_sides, bezier_split
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    !> The curve of the seed's facts.
    real(dp), parameter :: seed(2, 5) = reshape([0.0_dp, 0.0_dp, 1.0_dp, 3.0_dp, 4.0_dp, 4.0_dp, &
        6.0_dp, 1.0_dp, 7.0_dp, 2.0_dp], [2, 5])
    type(tap_type) :: tap

    call check_facts(tap)
    call check_bernstein(tap)
    call check_approximation()
    call check_any_curve(tap)
    call tap%finish()

contains

    !> The figures worked out from the seed's formulas.
    subroutine check_facts(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp), dimension(2) :: point, first, second
        real(dp), dimension(2, 5) :: before, after
        real(dp) :: third(2, 2)

        call bezier_jet(seed, 0.4_dp, point, first, second)
        call tap%near(point(1), 2.8288_dp, 1.0e-14_dp, 'x at .4')
        call tap%near(point(2), 2.624_dp, 1.0e-14_dp, 'y at .4')
        call tap%near(maxval(abs(first - [8.608_dp, 1.12_dp])), 0.0_dp, 1.0e-13_dp, 'C'' at .4')
        call tap%near(maxval(abs(second - [0.96_dp, -24.0_dp])), 0.0_dp, 1.0e-12_dp, 'C" at .4')
        call bezier_split(seed, 0.4_dp, before, after)
        call tap%near(maxval(abs(before - reshape([0.0_dp, 0.0_dp, 0.4_dp, 1.2_dp, 1.12_dp, &
            2.08_dp, 1.968_dp, 2.512_dp, 2.8288_dp, 2.624_dp], [2, 5]))), 0.0_dp, 1.0e-14_dp, &
            'the part before .4')
        call tap%near(maxval(abs(after - reshape([2.8288_dp, 2.624_dp, 4.12_dp, 2.792_dp, &
            5.44_dp, 2.24_dp, 6.4_dp, 1.4_dp, 7.0_dp, 2.0_dp], [2, 5]))), 0.0_dp, 1.0e-14_dp, &
            'the part after .4')
        call tap%near(maxval(abs(bezier_raised(seed) - reshape([0.0_dp, 0.0_dp, 0.8_dp, 2.4_dp, &
            2.8_dp, 3.6_dp, 4.8_dp, 2.8_dp, 6.2_dp, 1.2_dp, 7.0_dp, 2.0_dp], [2, 6]))), 0.0_dp, &
            1.0e-14_dp, 'raised to degree 5')
        third = bezier_derivative(bezier_derivative(bezier_derivative(seed)))
        call tap%near(maxval(abs(third(:, 1) - [-72.0_dp, -48.0_dp])), 0.0_dp, 1.0e-12_dp, &
            'third derivative at the start')
        call tap%ok(all(abs(bezier_sides(seed) - reshape([0.0_dp, 0.0_dp, 1.0_dp, 3.0_dp, &
            3.0_dp, 1.0_dp, 2.0_dp, -3.0_dp, 1.0_dp, 1.0_dp], [2, 5])) <= 0.0_dp), &
            'sides of the polygon')
        call tap%ok(all(abs(bezier_from_sides(bezier_sides(seed)) - seed) <= 0.0_dp), &
            'sides give the polygon back')
        call tap%ok(all(abs(bezier_derivative(seed(:, :1))) <= 0.0_dp), &
            'a point does not move')
    end subroutine check_facts

    !> The basis.
    subroutine check_bernstein(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp) :: sum
        integer :: i

        call tap%near(bernstein(4, 1, 0.25_dp), 0.421875_dp, 1.0e-16_dp, 'B(1, 4) at 1/4')
        call tap%near(bernstein(4, 2, 0.5_dp), 0.375_dp, 1.0e-16_dp, 'B(2, 4) at 1/2')
        call tap%near(bernstein(5, 2, 0.4_dp), 0.3456_dp, 1.0e-15_dp, 'greatest B(2, 5)')
        sum = 0.0_dp
        do i = 0, 5
            sum = sum + exp(real(i, dp)/5.0_dp)*bernstein(5, i, 0.3_dp)
        end do
        call tap%near(sum, 1.37925031497083_dp, 1.0e-14_dp, 'Bernstein approximation of exp')
        sum = 0.0_dp
        do i = 0, 10
            sum = sum + sin(pi*real(i, dp)/10.0_dp)*bernstein(10, i, 0.25_dp)
        end do
        call tap%near(sum, 0.641405242767585_dp, 1.0e-15_dp, 'Bernstein approximation of sin')
    end subroutine check_bernstein

    !> Bernstein approximation: B(s**2) = s**2 + s (1 - s)/m (the seed prints s (s - 1)), lines are
    !> kept, the poles are those of a polynomial's derivatives at an end (4), and derivatives keep
    !> their bounds (theorem 2.1, for exp).
    subroutine check_approximation()
        integer, parameter :: degrees(3) = [3, 5, 9]
        real(dp), allocatable :: pole(:, :)
        real(dp) :: at(1), scale, worst
        integer :: i, m, p
        logical :: is_bounded

        worst = 0.0_dp
        do m = 2, 8
            at = bezier_point(reshape([((real(i, dp)/real(m, dp))**2, i=0, m)], [1, m + 1]), 0.3_dp)
            worst = max(worst, abs(at(1) - 0.09_dp - 0.21_dp/real(m, dp)))
            at = bezier_point(reshape([(2.0_dp - real(i, dp)/real(m, dp), i=0, m)], [1, m + 1]), &
                0.3_dp)
            worst = max(worst, abs(at(1) - 1.7_dp))
        end do
        call tap%near(worst, 0.0_dp, 1.0e-15_dp, 'of s**2 and of lines')
        at = bezier_point(reshape([0.0_dp, 0.25_dp, 1.0_dp], [1, 3]), 0.5_dp)
        call tap%near(at(1), 0.375_dp, 0.0_dp, 'B2 of s**2 at .5')
        at = bezier_point(reshape([((real(i, dp)/8.0_dp)**2, i=0, 8)], [1, 9]), 0.5_dp)
        call tap%near(at(1), 0.28125_dp, 1.0e-16_dp, 'B8 of s**2 at .5')
        ! 1 + 2 s + 3 s**2 - s**3: its derivatives at 0 are 1, 2, 6, -6.
        worst = 0.0_dp
        do i = 0, 10
            at = bezier_point(reshape([(1.0_dp + real(2*p, dp)/3.0_dp + real(p*(p - 1), dp)/2.0_dp &
                - real(p*(p - 1)*(p - 2), dp)/6.0_dp, p=0, 3)], [1, 4]), 0.1_dp*real(i, dp))
            scale = 0.1_dp*real(i, dp)
            worst = max(worst, abs(at(1) - 1.0_dp - scale*(2.0_dp + scale*(3.0_dp - scale))))
        end do
        call tap%near(worst, 0.0_dp, 1.0e-14_dp, 'poles of a cubic from its derivatives at 0')
        is_bounded = .true.
        do m = 1, 3
            pole = reshape([(exp(real(i, dp)/real(degrees(m), dp)), i=0, degrees(m))], &
                [1, degrees(m) + 1])
            scale = 1.0_dp
            do p = 1, degrees(m)
                pole = bezier_derivative(pole)
                scale = scale*real(degrees(m), dp)/real(degrees(m) + 1 - p, dp)
                is_bounded = is_bounded .and. all(scale*pole >= 1.0_dp) &
                    .and. all(scale*pole <= exp(1.0_dp))
            end do
        end do
        call tap%ok(is_bounded, 'derivatives keep the bounds of those of exp')
    end subroutine check_approximation

    !> What holds of all curves: parts, elevation, reversal, affine images, the hull, and no more
    !> crossings of a line than the polygon has.
    subroutine check_any_curve(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(random_type) :: random
        real(dp), allocatable :: pole(:, :), before(:, :), after(:, :)
        real(dp) :: worst(5), t, s, line(2), beyond
        integer :: i, k, degree
        logical :: is_hulled, is_diminishing

        worst = 0.0_dp
        is_hulled = .true.
        is_diminishing = .true.
        do i = 1, 500
            degree = 1 + mod(i, 9)
            if (allocated(pole)) deallocate (pole)
            allocate (pole(2, degree + 1))
            do k = 1, degree + 1
                pole(:, k) = [random%between(-1.0_dp, 1.0_dp), random%between(-1.0_dp, 1.0_dp)]
            end do
            t = random%between(0.0_dp, 1.0_dp)
            s = random%between(0.0_dp, 1.0_dp)
            before = pole
            after = pole
            call bezier_split(pole, t, before, after)
            worst(1) = max(worst(1), norm2(bezier_point(before, s) - bezier_point(pole, s*t)))
            worst(2) = max(worst(2), &
                norm2(bezier_point(after, s) - bezier_point(pole, t + s*(1.0_dp - t))))
            worst(3) = max(worst(3), norm2(bezier_point(bezier_raised(pole), t) &
                - bezier_point(pole, t)))
            worst(4) = max(worst(4), norm2(bezier_point(pole(:, degree + 1:1:-1), t) &
                - bezier_point(pole, 1.0_dp - t)))
            worst(5) = max(worst(5), norm2(bezier_point(bezier_part(pole, t, s), 0.3_dp) &
                - bezier_point(pole, t + 0.3_dp*(s - t))))
            line = [cos(6.0_dp*t), sin(6.0_dp*t)]
            beyond = maxval(matmul(line, pole))
            is_hulled = is_hulled .and. &
                dot_product(line, bezier_point(pole, s)) <= beyond + 1.0e-14_dp
            is_diminishing = is_diminishing .and. &
                crossings(pole, line) <= changes(matmul(line, pole))
        end do
        call tap%near(maxval(worst), 0.0_dp, 1.0e-14_dp, &
            'parts, elevation and reversal are the same curve')
        call tap%ok(is_hulled, 'no curve leaves the hull of its poles')
        call tap%ok(is_diminishing, 'no line is crossed more often than by the polygon')
    end subroutine check_any_curve

    !> How often a curve crosses a line through the origin, as 400 samples show.
    pure integer function crossings(pole, line)
        real(dp), intent(in) :: pole(:, :)  !! the curve
        real(dp), intent(in) :: line(2)     !! across the line
        real(dp) :: side(0:400)
        integer :: i
        side = [(dot_product(line, bezier_point(pole, real(i, dp)/400.0_dp)), i=0, 400)]
        crossings = changes(side)
    end function crossings

    !> Changes of sign in a row of numbers.
    pure integer function changes(side)
        real(dp), intent(in) :: side(:) !! the row
        changes = count(side(2:)*side(:size(side) - 1) < 0.0_dp)
    end function changes

end program test_bezier
