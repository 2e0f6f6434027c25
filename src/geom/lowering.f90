!> Bezier curves of lower degree: the nearest one in the mean square, weighted by (1 - t)**a t**b,
!> that keeps position and derivatives at both ends; and a B-spline of low degree for a Bezier curve
!> of high degree, in as many pieces as a tolerance asks for.
!>
!> The poles at the ends follow from the derivatives there. What is left of the curve is then
!> t**p (1 - t)**s S(t), and S is cut off in its series of Jacobi polynomials with the exponents
!> a + 2 s and b + 2 p. How far poles of the two curves, raised to one degree, are apart bounds how
!> far the curves are.
!>
!> Source: seed 001, contents of chapter 2.3 (best degree reduction); M. Eck, "Least squares degree
!> reduction of Bezier curves", Computer-Aided Design 27 (1995), pp. 845-851.
module geom_lowering
    use base_kinds, only: dp
    use geom_bezier, only: bezier_part, bezier_raised
    use geom_bspline, only: bspline_type
    use geom_jacobi, only: binomial, jacobi_inverse, jacobi_matrix, jacobi_norm
    implicit none (type, external)
    private

    public :: bezier_lowered, bezier_unraised, lowered_apart, lower_spline

    !> Halvings of the parameter after which no more are tried.
    integer, parameter :: most_halvings = 8
    !> Derivatives, from 0, that pieces keep at their ends: position and tangent.
    integer, parameter :: kept = 2

contains

    !> The nearest curve of a lower degree.
    pure subroutine bezier_lowered(pole, keep, weight, lower, rest)
        real(dp), intent(in) :: pole(:, :)      !! of degree n: (dimensions, n + 1)
        integer, intent(in) :: keep(2)          !! derivatives kept at start and end, with the 0th;
                                                !! in all at most m + 1
        real(dp), intent(in) :: weight(2)       !! exponents a of 1 - t and b of t, above -1
        real(dp), intent(out) :: lower(:, :)    !! of degree m < n: (dimensions, m + 1)
        real(dp), intent(out) :: rest(:)        !! square root of the integral of w (difference)**2
        real(dp), allocatable :: s(:, :), c(:, :)
        real(dp) :: a, b
        integer :: n, m, free, inner, i

        n = size(pole, 2) - 1
        m = size(lower, 2) - 1
        free = m - sum(keep)
        inner = n - sum(keep)
        a = weight(1) + 2.0_dp*real(keep(2), dp)
        b = weight(2) + 2.0_dp*real(keep(1), dp)
        lower = 0.0_dp
        lower(:, :keep(1)) = kept_poles(pole, m, keep(1))
        lower(:, m + 1:m + 2 - keep(2):-1) = kept_poles(pole(:, n + 1:1:-1), m, keep(2))
        s = pole - raised_to(lower, n)
        s = s(:, keep(1) + 1:n + 1 - keep(2))
        do i = 0, inner
            s(:, i + 1) = s(:, i + 1)*binomial(real(n, dp), i + keep(1)) &
                /binomial(real(inner, dp), i)
        end do
        c = matmul(s, transpose(jacobi_inverse(inner, a, b)))
        rest = 0.0_dp
        do i = free + 1, inner
            rest = rest + jacobi_norm(i, a, b)*c(:, i + 1)**2
        end do
        rest = sqrt(rest)
        if (free < 0) return
        s = matmul(c(:, :free + 1), transpose(jacobi_matrix(free, a, b)))
        do i = 0, free
            lower(:, keep(1) + i + 1) = s(:, i + 1)*binomial(real(free, dp), i) &
                /binomial(real(m, dp), i + keep(1))
        end do
    end subroutine bezier_lowered

    !> The first poles of a curve of degree m that begins as another does: its differences are those
    !> of the other times n (n - 1) .../(m (m - 1) ...).
    pure function kept_poles(pole, m, count) result(first)
        real(dp), intent(in) :: pole(:, :)  !! of the other curve
        integer, intent(in) :: m            !! degree
        integer, intent(in) :: count        !! how many
        real(dp) :: first(size(pole, 1), count)
        real(dp) :: row(size(pole, 1), count), scale
        integer :: i, k

        row = pole(:, :count)
        first = 0.0_dp
        scale = 1.0_dp
        do k = 0, count - 1
            do i = k, count - 1
                first(:, i + 1) = first(:, i + 1) + scale*binomial(real(i, dp), k)*row(:, 1)
            end do
            row(:, :count - k - 1) = row(:, 2:count - k) - row(:, :count - k - 1)
            scale = scale*real(size(pole, 2) - 1 - k, dp)/real(max(m - k, 1), dp)
        end do
    end function kept_poles

    !> The curve that was raised by one degree, from both ends to the middle; a near one of another.
    pure function bezier_unraised(pole) result(lower)
        real(dp), intent(in) :: pole(:, :) !! of degree n, 1 or more
        real(dp) :: lower(size(pole, 1), size(pole, 2) - 1)
        real(dp) :: n
        integer :: i, last

        last = size(pole, 2) - 1
        n = real(last, dp)
        lower(:, 1) = pole(:, 1)
        lower(:, last) = pole(:, last + 1)
        do i = 1, (last - 1)/2
            lower(:, i + 1) = (n*pole(:, i + 1) - real(i, dp)*lower(:, i))/(n - real(i, dp))
        end do
        do i = last - 1, (last + 1)/2 + 1, -1
            lower(:, i) = (n*pole(:, i + 1) - (n - real(i, dp))*lower(:, i + 1))/real(i, dp)
        end do
    end function bezier_unraised

    !> A curve raised to a degree.
    pure function raised_to(pole, degree) result(raised)
        real(dp), intent(in) :: pole(:, :)  !! of one or more poles
        integer, intent(in) :: degree       !! not below its own
        real(dp), allocatable :: raised(:, :)
        allocate (raised, source=pole)
        do while (size(raised, 2) <= degree)
            raised = bezier_raised(raised)
        end do
    end function raised_to

    !> How far a curve and one of lower degree are apart at most: the largest distance of their
    !> poles, both of the higher degree.
    pure real(dp) function lowered_apart(pole, lower) result(apart)
        real(dp), intent(in) :: pole(:, :)  !! a curve
        real(dp), intent(in) :: lower(:, :) !! another, of no higher degree
        apart = maxval(norm2(pole - raised_to(lower, size(pole, 2) - 1), dim=1))
    end function lowered_apart

    !> A B-spline of low degree for one of a single span, polynomial and of high degree: in halves,
    !> quarters and so on of its parameter, until it is near enough. Pieces share their tangents, so
    !> that their joints need no pole. Where 256 pieces do not do the spline stays as it is.
    pure subroutine lower_spline(spline, degree, tolerance, lower, apart)
        type(bspline_type), intent(in) :: spline    !! of one span, all weights 1
        integer, intent(in) :: degree               !! wanted, 3 or more, less than it has
        real(dp), intent(in) :: tolerance           !! largest distance, deck units
        type(bspline_type), intent(out) :: lower    !! over the same parameters, 0 to 1
        real(dp), intent(out) :: apart              !! at most so far off
        real(dp), allocatable :: piece(:, :, :)
        real(dp) :: part(size(spline%pole, 1), size(spline%pole, 2)), rest(size(spline%pole, 1))
        integer :: halving, i, count

        do halving = 0, most_halvings
            count = 2**halving
            if (allocated(piece)) deallocate (piece)
            allocate (piece(size(spline%pole, 1), degree + 1, count))
            apart = 0.0_dp
            do i = 1, count
                part = bezier_part(spline%pole, real(i - 1, dp)/real(count, dp), &
                    real(i, dp)/real(count, dp))
                call bezier_lowered(part, [kept, kept], [0.0_dp, 0.0_dp], piece(:, :, i), rest)
                apart = max(apart, lowered_apart(part, piece(:, :, i)))
            end do
            if (apart <= tolerance) then
                lower = joined(piece)
                return
            end if
        end do
        lower = spline
        apart = 0.0_dp
    end subroutine lower_spline

    !> The B-spline of Bezier pieces of equal parameter length that share tangents at their joints.
    pure type(bspline_type) function joined(piece) result(spline)
        real(dp), intent(in) :: piece(:, :, :)  !! poles: (dimensions, degree + 1, pieces)
        integer :: degree, inner, count, i

        degree = size(piece, 2) - 1
        inner = degree - 1
        count = size(piece, 3)
        spline%degree = degree
        allocate (spline%pole(size(piece, 1), count*inner + 2), spline%weight(count*inner + 2))
        allocate (spline%knot(count*inner + degree + 3))
        spline%weight = 1.0_dp
        spline%pole(:, 1) = piece(:, 1, 1)
        spline%knot(:degree + 1) = 0.0_dp
        do i = 1, count
            spline%pole(:, (i - 1)*inner + 2:i*inner + 1) = piece(:, 2:degree, i)
            spline%knot(i*inner + 3:(i + 1)*inner + 2) = real(i, dp)/real(count, dp)
        end do
        spline%pole(:, count*inner + 2) = piece(:, degree + 1, count)
        spline%knot(count*inner + 3:) = 1.0_dp
    end function joined

end module geom_lowering
