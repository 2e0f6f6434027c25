!> Jacobi polynomials in the Bernstein basis: printed matrices, orthogonality, the inverse, and the
!> recurrence of Legendre's polynomials.
program test_jacobi
    use base_kinds, only: dp
    use geom_bezier, only: bernstein, bezier_point
    use geom_jacobi, only: bernstein_gram, binomial, jacobi_inverse, jacobi_matrix, jacobi_norm, &
        jacobi_poles
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_figures()
    call check_any(0.0_dp, 0.0_dp, '(0, 0)')
    call check_any(1.0_dp, 2.0_dp, '(1, 2)')
    call check_any(0.5_dp, -0.5_dp, '(.5, -.5)')
    call check_any(-0.5_dp, -0.5_dp, '(-.5, -.5)')
    call check_gram()
    call check_legendre()
    call tap%finish()

contains

    !> Degree 3.
    subroutine check_figures()
        real(dp), parameter :: third = 1.0_dp/3.0_dp
        real(dp) :: matrix(4, 4)

        matrix = jacobi_matrix(3, 0.0_dp, 0.0_dp)
        call tap%near(maxval(abs(transpose(matrix) - reshape([1.0_dp, -1.0_dp, 1.0_dp, -1.0_dp, &
            1.0_dp, -third, -1.0_dp, 3.0_dp, 1.0_dp, third, -1.0_dp, -3.0_dp, &
            1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp], [4, 4]))), 0.0_dp, 1.0e-15_dp, 'M of degree 3, (0, 0)')
        matrix = jacobi_inverse(3, 0.0_dp, 0.0_dp)
        call tap%near(maxval(abs(transpose(matrix) - reshape([0.25_dp, 0.25_dp, 0.25_dp, 0.25_dp, &
            -0.45_dp, -0.15_dp, 0.15_dp, 0.45_dp, 0.25_dp, -0.25_dp, -0.25_dp, 0.25_dp, &
            -0.05_dp, 0.15_dp, -0.15_dp, 0.05_dp], [4, 4]))), 0.0_dp, 5.0e-15_dp, 'its inverse')
        matrix = jacobi_matrix(3, 1.0_dp, 2.0_dp)
        call tap%near(maxval(abs(matrix - reshape([1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp, &
            -3.0_dp, -4.0_dp*third, third, 2.0_dp, 6.0_dp, -2.0_dp, -3.0_dp, 3.0_dp, &
            -10.0_dp, 40.0_dp*third, -10.0_dp, 4.0_dp], [4, 4]))), 0.0_dp, 1.0e-14_dp, &
            'M of degree 3, (1, 2)')
        call tap%near(binomial(2.5_dp, 2), 1.875_dp, 1.0e-15_dp, 'C(2.5, 2)')
        call tap%near(binomial(5.0_dp, 3), 10.0_dp, 0.0_dp, 'C(5, 3)')
        call tap%near(binomial(2.0_dp, 3), 0.0_dp, 0.0_dp, 'C(2, 3)')
        call tap%near(jacobi_norm(3, 0.0_dp, 0.0_dp), 1.0_dp/7.0_dp, 1.0e-15_dp, 'h(3) is 1/7')
        call tap%near(jacobi_norm(0, -0.5_dp, -0.5_dp), acos(-1.0_dp), 1.0e-14_dp, &
            'h(0) of (-.5, -.5) is pi')
    end subroutine check_figures

    !> What holds for all exponents, to degree 8.
    subroutine check_any(a, b, name)
        real(dp), intent(in) :: a               !! exponent of 1 - t
        real(dp), intent(in) :: b               !! exponent of t
        character(*), intent(in) :: name        !! both in words
        integer, parameter :: n = 8
        real(dp), dimension(0:n, 0:n) :: m, unit, product
        integer :: i

        unit = 0.0_dp
        do i = 0, n
            unit(i, i) = 1.0_dp
        end do
        m = jacobi_matrix(n, a, b)
        product = matmul(transpose(m), matmul(bernstein_gram(n, n, a, b), m))
        do i = 0, n
            product(i, :) = product(i, :)/jacobi_norm(i, a, b)
        end do
        call tap%near(maxval(abs(product - unit)), 0.0_dp, 1.0e-10_dp, name//': orthogonal')
        call tap%near(maxval(abs(matmul(jacobi_inverse(n, a, b), m) - unit)), 0.0_dp, 1.0e-10_dp, &
            name//': the inverse is one')
        call tap%near(maxval(abs(matmul(jacobi_inverse(4, a, b), jacobi_matrix(4, a, b)) &
            - unit(:4, :4))), 0.0_dp, 1.0e-13_dp, name//': to rounding at degree 4')
    end subroutine check_any

    !> Products of Bernstein polynomials by Simpson's rule.
    subroutine check_gram()
        integer, parameter :: steps = 2000
        real(dp) :: gram(0:4, 0:3), sum, t, share
        integer :: k

        gram = bernstein_gram(4, 3, 1.0_dp, 2.0_dp)
        sum = 0.0_dp
        do k = 0, steps
            t = real(k, dp)/real(steps, dp)
            share = merge(4.0_dp, 2.0_dp, mod(k, 2) == 1)
            if (k == 0 .or. k == steps) share = 1.0_dp
            sum = sum + share/(3.0_dp*real(steps, dp))*(1.0_dp - t)*t**2*bernstein(4, 1, t) &
                *bernstein(3, 2, t)
        end do
        call tap%near(gram(1, 2), sum, 1.0e-13_dp, 'a product of Bernstein polynomials')
    end subroutine check_gram

    !> Exponents 0: Legendre's polynomials of 2 t - 1 by their recurrence.
    subroutine check_legendre()
        real(dp) :: before, now, next, x, t, worst, pole(1, 0:9), at(1)
        integer :: i, r

        worst = 0.0_dp
        do i = 0, 20
            t = 0.05_dp*real(i, dp)
            x = 2.0_dp*t - 1.0_dp
            before = 1.0_dp
            now = x
            do r = 1, 9
                pole(1, :r) = jacobi_poles(r, 0.0_dp, 0.0_dp)
                at = bezier_point(pole(:, :r), t)
                worst = max(worst, abs(at(1) - now))
                next = (real(2*r + 1, dp)*x*now - real(r, dp)*before)/real(r + 1, dp)
                before = now
                now = next
            end do
        end do
        call tap%near(worst, 0.0_dp, 1.0e-12_dp, 'Legendre''s polynomials to degree 9')
    end subroutine check_legendre

end program test_jacobi
