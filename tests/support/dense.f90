!> Dense linear systems by LAPACK, as oracles.
!>
!> Source: E. Anderson et al., "LAPACK Users' Guide", 3rd ed., SIAM 1999, DGESVX: equilibration,
!> elimination with pivoting, iterative refinement, estimate of the condition.
module support_dense
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: to_text
    implicit none (type, external)
    private

    public :: solve

    interface
        !> LAPACK's expert driver for a general system; names and meanings are LAPACK's.
        pure subroutine dgesvx(fact, trans, n, nrhs, a, lda, af, ldaf, ipiv, equed, r, c, b, ldb, &
                x, ldx, rcond, ferr, berr, work, iwork, info)
            import :: dp
            implicit none (type, external)
            character, intent(in) :: fact             !! E: equilibrate, then factor
            character, intent(in) :: trans            !! N: not transposed
            integer, intent(in) :: n                  !! order
            integer, intent(in) :: nrhs               !! right-hand sides
            integer, intent(in) :: lda                !! leading dimension of a
            integer, intent(in) :: ldaf               !! leading dimension of af
            integer, intent(in) :: ldb                !! leading dimension of b
            integer, intent(in) :: ldx                !! leading dimension of x
            real(dp), intent(inout) :: a(lda, *)      !! matrix, equilibrated on return
            real(dp), intent(inout) :: af(ldaf, *)    !! its factors
            integer, intent(inout) :: ipiv(*)         !! its pivots
            character, intent(inout) :: equed         !! how it was equilibrated
            real(dp), intent(inout) :: r(*)           !! row scales
            real(dp), intent(inout) :: c(*)           !! column scales
            real(dp), intent(inout) :: b(ldb, *)      !! right-hand sides
            real(dp), intent(inout) :: x(ldx, *)      !! solutions
            real(dp), intent(out) :: rcond            !! reciprocal condition
            real(dp), intent(out) :: ferr(*)          !! forward error bounds
            real(dp), intent(out) :: berr(*)          !! backward errors
            real(dp), intent(inout) :: work(*)        !! 4 n
            integer, intent(inout) :: iwork(*)        !! n
            integer, intent(out) :: info              !! 0; 1 to n: exactly singular; n + 1: nearly
        end subroutine dgesvx
    end interface

contains

    !> Solves `a x = b`.
    !>
    !> Fails with `cause%singular` where the matrix is singular, exactly or to working precision;
    !> `x` is zero then, and `rcond` says how near to singular it is.
    pure subroutine solve(a, b, x, rcond, error)
        real(dp), intent(in) :: a(:, :)                     !! matrix, shape (n, n)
        real(dp), intent(in) :: b(:)                        !! right-hand side, shape (n)
        real(dp), intent(out) :: x(:)                       !! solution, shape (n)
        real(dp), intent(out) :: rcond                      !! reciprocal condition, 0 to 1
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp), dimension(size(b), size(b)) :: matrix, factors
        real(dp), dimension(size(b), 1) :: right, solution
        real(dp) :: rows(size(b)), columns(size(b)), forward(1), backward(1), work(4*size(b))
        integer :: pivots(size(b)), iwork(size(b)), n, info
        character :: equilibrated

        n = size(b)
        matrix = a
        right(:, 1) = b
        equilibrated = 'N'
        call dgesvx('E', 'N', n, 1, matrix, n, factors, n, pivots, equilibrated, rows, columns, &
            right, n, solution, n, rcond, forward, backward, work, iwork, info)
        x = 0.0_dp
        if (info /= 0) then
            call fail(error, cause%singular, 'the system of '//to_text(n)// &
                ' equations has no unique solution')
        else
            x = solution(:, 1)
        end if
    end subroutine solve

end module support_dense
