!> The B-splines that are not zero between two knots, with their derivatives.
!>
!> Source: L. Piegl and W. Tiller, "The NURBS Book", 2nd ed., Springer 1997, algorithms A2.1 and
!> A2.2 and equation 2.7. Knots are numbered from 1.
module geom_bspline_basis
    use base_exact, only: is_equal
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: span_of, basis, basis_jet, breaks_of

contains

    !> The number of the knot at which the span of a parameter begins: `knot(i) <= t < knot(i + 1)`;
    !> the last span at and beyond the end, the first before the start.
    pure integer function span_of(knot, degree, t) result(span)
        real(dp), intent(in) :: knot(:) !! of `geom_bspline`
        integer, intent(in) :: degree   !! 1 or more
        real(dp), intent(in) :: t       !! any number
        integer :: beyond, middle

        span = degree + 1
        beyond = size(knot) - degree
        do while (beyond - span > 1)
            middle = (span + beyond)/2
            if (t < knot(middle)) then
                beyond = middle
            else
                span = middle
            end if
        end do
    end function span_of

    !> The degree + 1 B-splines that are not zero on a span; the first belongs to pole
    !> `span - degree`. None is negative inside the span, and their sum is 1.
    pure function basis(knot, degree, span, t) result(n)
        real(dp), intent(in) :: knot(:) !! of `geom_bspline`
        integer, intent(in) :: degree   !! 0 or more
        integer, intent(in) :: span     !! from `span_of`
        real(dp), intent(in) :: t       !! in the span
        real(dp) :: n(degree + 1)
        real(dp) :: part, carry
        integer :: j, k

        n(1) = 1.0_dp
        do k = 1, degree
            carry = 0.0_dp
            do j = 1, k
                part = n(j)/(knot(span + j) - knot(span + j - k))
                n(j) = carry + (knot(span + j) - t)*part
                carry = (t - knot(span + j - k))*part
            end do
            n(k + 1) = carry
        end do
    end function basis

    !> The same B-splines with their first and second derivatives.
    pure function basis_jet(knot, degree, span, t) result(jet)
        real(dp), intent(in) :: knot(:) !! of `geom_bspline`
        integer, intent(in) :: degree   !! 1 or more
        integer, intent(in) :: span     !! from `span_of`
        real(dp), intent(in) :: t       !! in the span
        real(dp) :: jet(degree + 1, 0:2)

        jet(:, 0) = basis(knot, degree, span, t)
        jet(:, 1) = differenced(knot, degree, span, basis(knot, degree - 1, span, t))
        jet(:, 2) = 0.0_dp
        if (degree < 2) return
        jet(:, 2) = differenced(knot, degree, span, differenced(knot, degree - 1, span, &
            basis(knot, degree - 2, span, t)))
    end function basis_jet

    !> Derivatives of B-splines from those of one degree less (equation 2.7).
    pure function differenced(knot, degree, span, lower) result(n)
        real(dp), intent(in) :: knot(:)         !! of `geom_bspline`
        integer, intent(in) :: degree           !! of the result
        integer, intent(in) :: span             !! from `span_of`
        real(dp), intent(in) :: lower(degree)   !! B-splines, or derivatives, of a degree less
        real(dp) :: n(degree + 1)
        real(dp) :: part
        integer :: j

        n = 0.0_dp
        do j = 1, degree
            part = real(degree, dp)*lower(j)/(knot(span + j) - knot(span + j - degree))
            n(j) = n(j) - part
            n(j + 1) = part
        end do
    end function differenced

    !> The different knots, rising.
    pure function breaks_of(knot) result(breaks)
        real(dp), intent(in) :: knot(:) !! of `geom_bspline`
        real(dp), allocatable :: breaks(:)
        logical :: is_new(size(knot))

        is_new(1) = .true.
        is_new(2:) = .not. is_equal(knot(2:), knot(:size(knot) - 1))
        allocate (breaks(count(is_new)))
        breaks = pack(knot, is_new)
    end function breaks_of

end module geom_bspline_basis
