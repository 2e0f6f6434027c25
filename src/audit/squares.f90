!> The conic nearest to many figures by robust least squares: each round gives less weight to a
!> figure the further it is off, none beyond a bound that shrinks from round to round.
!>
!> Source: A. E. Beaton, J. W. Tukey, "The fitting of power series", Technometrics 16 (1974),
!> pp. 147-185: the weight (1 - (r/c)**2)**2; iteratively reweighted steps of Gauss and Newton.
module audit_squares
    use audit_condition, only: bound_rows, residual
    use audit_problem, only: problem_type
    use audit_span, only: free_basis
    use base_kinds, only: dp
    use geom_lapack, only: solve_least_squares
    implicit none (type, external)
    private

    public :: improve, chart_at

contains

    !> Improves a conic by robust least squares over the figures chosen.
    pure subroutine improve(problem, chosen, bounds, k)
        type(problem_type), intent(in) :: problem !! the readings
        logical, intent(in) :: chosen(:)          !! figures that may count, one a condition
        real(dp), intent(in) :: bounds(:)         !! a round each: weight up to here, in units
        real(dp), intent(inout) :: k(6)           !! the conic
        real(dp) :: a(size(chosen), problem%freedom), b(size(chosen)), step(problem%freedom)
        real(dp) :: chart(6, 6), rows(6, 2), off, excess, weight
        integer :: round, i, n
        logical :: exists

        if (problem%freedom == 0) return
        do round = 1, size(bounds)
            chart = chart_at(problem, k)
            n = 0
            do i = 1, size(chosen)
                if (.not. chosen(i)) cycle
                call residual(problem%condition(i), k, problem%frame, off, excess, exists)
                if (.not. exists .or. abs(off) >= bounds(round)) cycle
                weight = 1.0_dp - (off/bounds(round))**2
                call bound_rows(problem%condition(i), k, problem%frame, rows)
                n = n + 1
                rows(:, 1) = 0.5_dp*(rows(:, 1) - rows(:, 2))
                a(n, :) = weight*matmul(rows(:, 1), chart(:, :problem%freedom))
                b(n) = -weight*dot_product(rows(:, 1), k)
            end do
            if (n < problem%freedom) return
            call solve_least_squares(a(:n, :), b(:n), step)
            if (norm2(step) > 1.0_dp) step = step/norm2(step)
            k = k + matmul(chart(:, :problem%freedom), step)
            k = k/norm2(k)
        end do
    end subroutine improve

    !> The directions in which a conic may change: orthonormal, at right angles to it.
    pure function chart_at(problem, k) result(chart)
        type(problem_type), intent(in) :: problem !! the readings
        real(dp), intent(in) :: k(6)              !! a conic of its free ones
        real(dp) :: chart(6, 6), weights(problem%freedom + 1, 1)
        real(dp) :: across(problem%freedom + 1, problem%freedom + 1)
        integer :: free

        chart = 0.0_dp
        weights(:, 1) = matmul(k, problem%free_to(:, :problem%freedom + 1))
        call free_basis(weights, across, free)
        chart(:, :problem%freedom) = matmul(problem%free_to(:, :problem%freedom + 1), &
            across(:, :problem%freedom))
    end function chart_at

end module audit_squares
