!> Splines through points: knots, nodes and poles. Breaks are the ends of the spans, simple inner
!> knots, so that the curve's derivatives up to the last but one are continuous; the nodes are the
!> averages of neighbouring knots (Greville), one for each pole, for which the system is banded and
!> never singular.
!>
!> Source: C. de Boor, "A Practical Guide to Splines", revised ed., Springer 2001, chapter XIII,
!> theorem of Schoenberg and Whitney.
module geom_spline_fit
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use geom_bspline_basis, only: basis, span_of
    use geom_lapack, only: solve_banded
    implicit none (type, external)
    private

    public :: fit_knots, fit_nodes, fit_values

contains

    !> The knots to breaks: the ends degree + 1 times, the others once.
    pure function fit_knots(breaks, degree) result(knots)
        real(dp), intent(in) :: breaks(:)   !! rising, two or more
        integer, intent(in) :: degree       !! 1 or more
        real(dp) :: knots(size(breaks) + 2*degree)
        integer :: spans

        spans = size(breaks) - 1
        knots(:degree) = breaks(1)
        knots(degree + 1:degree + 1 + spans) = breaks
        knots(degree + 2 + spans:) = breaks(spans + 1)
    end function fit_knots

    !> Where the values to interpolate are taken, as many as there are poles; the ends are in it.
    pure function fit_nodes(breaks, degree) result(nodes)
        real(dp), intent(in) :: breaks(:)   !! rising, two or more
        integer, intent(in) :: degree       !! 1 or more
        real(dp) :: nodes(size(breaks) + degree - 1)
        real(dp) :: knots(size(breaks) + 2*degree)
        integer :: i

        knots = fit_knots(breaks, degree)
        do i = 2, size(nodes) - 1
            nodes(i) = knots(i) + sum(knots(i + 1:i + degree) - knots(i))/real(degree, dp)
        end do
        nodes(1) = breaks(1)
        nodes(size(nodes)) = breaks(size(breaks))
    end function fit_nodes

    !> The poles of the splines with given values at the nodes. The first and the last pole are the
    !> first and the last value, exactly; what is the same at all nodes is so at all poles.
    !>
    !> Fails with `cause%singular` where breaks do not rise, or are so close that nodes are one.
    pure subroutine fit_values(breaks, degree, values, poles, error)
        real(dp), intent(in) :: breaks(:)                   !! rising, two or more
        integer, intent(in) :: degree                       !! 1 or more
        real(dp), intent(in) :: values(:, :)                !! at the nodes: (splines, nodes)
        real(dp), intent(out) :: poles(:, :)                !! same shape
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: knots(size(breaks) + 2*degree), nodes(size(breaks) + degree - 1)
        real(dp) :: band(2*degree + 1, size(breaks) + degree - 1)
        real(dp) :: x(size(values, 2), size(values, 1)), row(degree + 1)
        integer :: span, i, j, n

        poles = 0.0_dp
        if (.not. all(breaks(2:) > breaks(:size(breaks) - 1))) then
            call fail(error, cause%singular, 'the breaks of a spline do not rise')
            return
        end if
        n = size(nodes)
        knots = fit_knots(breaks, degree)
        nodes = fit_nodes(breaks, degree)
        band = 0.0_dp
        do i = 1, n
            span = span_of(knots, degree, nodes(i))
            row = basis(knots, degree, span, nodes(i))
            do j = span - degree, span
                band(degree + 1 + i - j, j) = row(j - span + degree + 1)
            end do
        end do
        x = transpose(values - spread(values(:, 1), 2, n))
        call solve_banded(band, degree, x, error)
        poles = transpose(x) + spread(values(:, 1), 2, n)
        if (allocated(error)) return
        poles(:, 1) = values(:, 1)
        poles(:, n) = values(:, n)
    end subroutine fit_values

end module geom_spline_fit
