!> A rational B-spline curve of any degree, in a plane or in space: what CAD files carry. A conic
!> arc is one exactly; other curves of LOFT are fitted by them.
!>
!> A point is worked from the pole next to it, as the way there, so that it rounds like that short
!> way: poles in one plane give points exactly in it, and the ends are exactly as given.
!>
!> Source: L. Piegl and W. Tiller, "The NURBS Book", 2nd ed., Springer 1997, 4.1 to 4.3.
module geom_bspline
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use geom_bspline_basis, only: basis, basis_jet, breaks_of, span_of
    use geom_vector, only: image
    implicit none (type, external)
    private

    public :: bspline_type, spline_point, spline_jet, spline_from, spline_to, spline_breaks
    public :: is_rational, reversed_spline, mapped_spline

    !> A rational B-spline curve from knot(1) to knot(size(knot)). The first and the last knot stand
    !> degree + 1 times, so that the curve goes from its first pole to its last; inner ones at most
    !> degree times. All weights are above zero; all are 1 where the curve is a polynomial one.
    type :: bspline_type
        integer :: degree = 0                   !! 1 or more
        real(dp), allocatable :: knot(:)        !! not falling, shape (poles + degree + 1)
        real(dp), allocatable :: pole(:, :)     !! control points, deck units: (dimensions, poles)
        real(dp), allocatable :: weight(:)      !! shape (poles)
    end type bspline_type

contains

    !> Where the parameter begins.
    pure real(dp) function spline_from(s)
        type(bspline_type), intent(in) :: s !! any spline
        spline_from = s%knot(1)
    end function spline_from

    !> Where the parameter ends.
    pure real(dp) function spline_to(s)
        type(bspline_type), intent(in) :: s !! any spline
        spline_to = s%knot(size(s%knot))
    end function spline_to

    !> The different knots, rising: between two of them the curve is one rational polynomial.
    pure function spline_breaks(s) result(breaks)
        type(bspline_type), intent(in) :: s !! any spline
        real(dp), allocatable :: breaks(:)
        allocate (breaks, source=breaks_of(s%knot))
    end function spline_breaks

    !> True where the weights differ.
    pure logical function is_rational(s)
        type(bspline_type), intent(in) :: s !! any spline
        is_rational = .not. all(is_equal(s%weight, s%weight(1)))
    end function is_rational

    !> The point of a spline, deck units.
    pure function spline_point(s, t) result(point)
        type(bspline_type), intent(in) :: s !! any spline
        real(dp), intent(in) :: t           !! parameter from its start to its end
        real(dp) :: point(size(s%pole, 1))
        real(dp) :: share(s%degree + 1)
        integer :: span, first, base, j

        span = span_of(s%knot, s%degree, t)
        first = span - s%degree
        share = basis(s%knot, s%degree, span, t)*s%weight(first:span)
        base = first - 1 + maxloc(share, dim=1)
        point = 0.0_dp
        do j = 1, size(share)
            point = point + share(j)*(s%pole(:, first + j - 1) - s%pole(:, base))
        end do
        point = s%pole(:, base) + point/sum(share)
    end function spline_point

    !> The point of a spline with its first and second derivative by the parameter; at an inner knot
    !> those of the span that begins there.
    pure subroutine spline_jet(s, t, point, first, second)
        type(bspline_type), intent(in) :: s     !! any spline
        real(dp), intent(in) :: t               !! parameter from its start to its end
        real(dp), intent(out) :: point(:)       !! shape (dimensions), deck units
        real(dp), intent(out) :: first(:)       !! first derivative
        real(dp), intent(out) :: second(:)      !! second derivative
        real(dp) :: share(s%degree + 1, 0:2), sums(0:2), way(size(s%pole, 1), 0:2)
        integer :: span, base, j, k

        span = span_of(s%knot, s%degree, t)
        share = basis_jet(s%knot, s%degree, span, t)
        do k = 0, 2
            share(:, k) = share(:, k)*s%weight(span - s%degree:span)
        end do
        base = span - s%degree - 1 + maxloc(share(:, 0), dim=1)
        sums = sum(share, dim=1)
        way = 0.0_dp
        do k = 0, 2
            do j = 1, size(share, 1)
                way(:, k) = way(:, k) + share(j, k)* &
                    (s%pole(:, span - s%degree + j - 1) - s%pole(:, base))
            end do
        end do
        way(:, 0) = way(:, 0)/sums(0)
        point = s%pole(:, base) + way(:, 0)
        first = (way(:, 1) - sums(1)*way(:, 0))/sums(0)
        second = (way(:, 2) - 2.0_dp*sums(1)*first - sums(2)*way(:, 0))/sums(0)
    end subroutine spline_jet

    !> The same curve, run through backwards over the same parameters.
    pure type(bspline_type) function reversed_spline(s) result(back)
        type(bspline_type), intent(in) :: s !! any spline
        integer :: knots, poles
        real(dp) :: from, to

        from = spline_from(s)
        to = spline_to(s)
        knots = size(s%knot)
        poles = size(s%weight)
        back = s
        back%knot = from + (to - s%knot(knots:1:-1))
        back%knot(knots - s%degree:) = to
        back%pole = s%pole(:, poles:1:-1)
        back%weight = s%weight(poles:1:-1)
    end function reversed_spline

    !> The image of a spline: each point p becomes `matrix p + shift`, in as many dimensions as
    !> these have rows.
    pure subroutine mapped_spline(s, matrix, shift, mapped)
        type(bspline_type), intent(in) :: s         !! any spline
        real(dp), intent(in) :: matrix(:, :)        !! shape (new dimensions, dimensions)
        real(dp), intent(in) :: shift(:)            !! shape (new dimensions), deck units
        type(bspline_type), intent(out) :: mapped   !! the image
        integer :: i

        mapped%degree = s%degree
        mapped%knot = s%knot
        mapped%weight = s%weight
        allocate (mapped%pole(size(shift), size(s%weight)))
        do i = 1, size(s%weight)
            mapped%pole(:, i) = image(matrix, s%pole(:, i)) + shift
        end do
    end subroutine mapped_spline

end module geom_bspline
