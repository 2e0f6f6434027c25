!> Jacobi polynomials on 0 to 1 and the Bernstein basis: from one to the other and back, without a
!> matrix being inverted.
!>
!> With the weight w = (1 - t)**a t**b, a and b above -1, the polynomial of degree r is
!>
!>     P(r) = sum over j of (-1)**(r - j) C(r + a, j) C(r + b, r - j)/C(r, j) B(j, r)
!>
!> and is orthogonal to all others, of the square norm h(r). The matrix M has the poles of P(0) to
!> P(n), raised to degree n, in its columns; its inverse is diag(1/h) M' G, where G has the products
!> of Bernstein polynomials.
!>
!> Source: seed 001, contents of chapter 2.2 (conversion between Jacobi and Bernstein bases); the
!> formulas are standard: G. Szego, "Orthogonal Polynomials", AMS 1939, chapter 4.
module geom_jacobi
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: binomial, jacobi_poles, jacobi_matrix, jacobi_inverse, jacobi_norm, bernstein_gram

contains

    !> C(x, k) = x (x - 1) ... (x - k + 1)/k! for any real x.
    elemental real(dp) function binomial(x, k) result(value)
        real(dp), intent(in) :: x   !! any
        integer, intent(in) :: k    !! 0 or more
        integer :: i
        value = 1.0_dp
        do i = 1, k
            value = value*(x - real(k - i, dp))/real(i, dp)
        end do
    end function binomial

    !> The Bernstein poles of the Jacobi polynomial of a degree.
    pure function jacobi_poles(degree, a, b) result(pole)
        integer, intent(in) :: degree   !! 0 or more
        real(dp), intent(in) :: a       !! exponent of 1 - t, above -1
        real(dp), intent(in) :: b       !! exponent of t, above -1
        real(dp) :: pole(0:degree), r
        integer :: j

        r = real(degree, dp)
        do j = 0, degree
            pole(j) = real((-1)**(degree - j), dp)*binomial(r + a, j)*binomial(r + b, degree - j) &
                /binomial(r, j)
        end do
    end function jacobi_poles

    !> The matrix from Jacobi to Bernstein: column r has the poles of P(r), raised to a degree.
    pure function jacobi_matrix(degree, a, b) result(matrix)
        integer, intent(in) :: degree   !! n, 0 or more
        real(dp), intent(in) :: a       !! exponent of 1 - t
        real(dp), intent(in) :: b       !! exponent of t
        real(dp) :: matrix(0:degree, 0:degree), pole(0:degree), n
        integer :: r, i, k

        n = real(degree, dp)
        do r = 0, degree
            pole(:r) = jacobi_poles(r, a, b)
            do i = 0, degree
                matrix(i, r) = 0.0_dp
                do k = max(0, i - degree + r), min(i, r)
                    matrix(i, r) = matrix(i, r) + binomial(n - real(r, dp), i - k) &
                        *binomial(real(r, dp), k)*pole(k)/binomial(n, i)
                end do
            end do
        end do
    end function jacobi_matrix

    !> The matrix from Bernstein to Jacobi.
    pure function jacobi_inverse(degree, a, b) result(inverse)
        integer, intent(in) :: degree   !! n, 0 or more
        real(dp), intent(in) :: a       !! exponent of 1 - t
        real(dp), intent(in) :: b       !! exponent of t
        real(dp) :: inverse(0:degree, 0:degree)
        integer :: r

        inverse = matmul(transpose(jacobi_matrix(degree, a, b)), &
            bernstein_gram(degree, degree, a, b))
        do r = 0, degree
            inverse(r, :) = inverse(r, :)/jacobi_norm(r, a, b)
        end do
    end function jacobi_inverse

    !> h(r): the integral of w P(r)**2.
    elemental real(dp) function jacobi_norm(degree, a, b) result(norm)
        integer, intent(in) :: degree   !! r, 0 or more
        real(dp), intent(in) :: a       !! exponent of 1 - t
        real(dp), intent(in) :: b       !! exponent of t
        real(dp) :: r

        r = real(degree, dp)
        norm = exp(log_gamma(r + a + 1.0_dp) + log_gamma(r + b + 1.0_dp) - log_gamma(r + 1.0_dp))
        if (degree == 0) then
            norm = norm/gamma(a + b + 2.0_dp)
        else
            norm = norm/(2.0_dp*r + a + b + 1.0_dp)/exp(log_gamma(r + a + b + 1.0_dp))
        end if
    end function jacobi_norm

    !> The integrals of w B(i, n) B(j, m).
    pure function bernstein_gram(n, m, a, b) result(gram)
        integer, intent(in) :: n    !! a degree
        integer, intent(in) :: m    !! another
        real(dp), intent(in) :: a   !! exponent of 1 - t
        real(dp), intent(in) :: b   !! exponent of t
        real(dp) :: gram(0:n, 0:m), x, y
        integer :: i, j

        do j = 0, m
            do i = 0, n
                x = real(i + j, dp) + b + 1.0_dp
                y = real(n + m - i - j, dp) + a + 1.0_dp
                gram(i, j) = binomial(real(n, dp), i)*binomial(real(m, dp), j) &
                    *exp(log_gamma(x) + log_gamma(y) - log_gamma(x + y))
            end do
        end do
    end function bernstein_gram

end module geom_jacobi
