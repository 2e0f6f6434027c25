!> Linear systems by drivers of LAPACK. Besides this module only `geom_square_system` names
!> routines of LAPACK.
!>
!> Source: E. Anderson et al., "LAPACK Users' Guide", 3rd ed., SIAM 1999, DGBSV: elimination with
!> pivoting in a band; ZPBSV: Cholesky's factors of a Hermitian band; DGELSY: orthogonal factors
!> with pivoting, of which only those that count are kept.
module geom_lapack
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: to_text
    implicit none (type, external)
    private

    public :: solve_banded, solve_hermitian, solve_least_squares

    interface
        !> LAPACK's driver for a system whose matrix is a band; names and meanings are LAPACK's.
        pure subroutine dgbsv(n, kl, ku, nrhs, ab, ldab, ipiv, b, ldb, info)
            import :: dp
            implicit none (type, external)
            integer, intent(in) :: n                  !! order
            integer, intent(in) :: kl                 !! diagonals below the main one
            integer, intent(in) :: ku                 !! diagonals above it
            integer, intent(in) :: nrhs               !! right-hand sides
            integer, intent(in) :: ldab               !! leading dimension of ab
            integer, intent(in) :: ldb                !! leading dimension of b
            real(dp), intent(inout) :: ab(ldab, *)    !! kl rows of room, then the diagonals
            integer, intent(out) :: ipiv(*)           !! pivots
            real(dp), intent(inout) :: b(ldb, *)      !! right-hand sides, then solutions
            integer, intent(out) :: info              !! 0; 1 to n: exactly singular
        end subroutine dgbsv

        !> LAPACK's driver for a Hermitian positive definite band; names and meanings are LAPACK's.
        pure subroutine zpbsv(uplo, n, kd, nrhs, ab, ldab, b, ldb, info)
            import :: dp
            implicit none (type, external)
            character, intent(in) :: uplo             !! U: ab holds the upper half
            integer, intent(in) :: n                  !! order
            integer, intent(in) :: kd                 !! diagonals above the main one
            integer, intent(in) :: nrhs               !! right-hand sides
            integer, intent(in) :: ldab               !! leading dimension of ab
            integer, intent(in) :: ldb                !! leading dimension of b
            complex(dp), intent(inout) :: ab(ldab, *) !! the diagonals, the main one last
            complex(dp), intent(inout) :: b(ldb, *)   !! right-hand sides, then solutions
            integer, intent(out) :: info              !! 0; 1 to n: not positive definite
        end subroutine zpbsv

        !> LAPACK's least squares of any rank; names and meanings are LAPACK's.
        pure subroutine dgelsy(m, n, nrhs, a, lda, b, ldb, jpvt, rcond, rank, work, lwork, info)
            import :: dp
            implicit none (type, external)
            integer, intent(in) :: m                  !! equations
            integer, intent(in) :: n                  !! unknowns
            integer, intent(in) :: nrhs               !! right-hand sides
            integer, intent(in) :: lda                !! leading dimension of a
            integer, intent(in) :: ldb                !! leading dimension of b
            real(dp), intent(inout) :: a(lda, *)      !! matrix, then its factors
            real(dp), intent(inout) :: b(ldb, *)      !! right-hand sides, then solutions
            integer, intent(inout) :: jpvt(*)         !! columns to stay in front, then their order
            real(dp), intent(in) :: rcond             !! condition that is still kept
            integer, intent(out) :: rank              !! unknowns that the equations fix
            real(dp), intent(inout) :: work(*)        !! see its source
            integer, intent(in) :: lwork              !! size of work
            integer, intent(out) :: info              !! 0
        end subroutine dgelsy
    end interface

contains

    !> Solves systems `a x = b` of one matrix that is zero off a band: `a(i, j)` stands in
    !> `band(above + 1 + i - j, j)`, `above` being the diagonals above the main one.
    !>
    !> Fails with `cause%singular` where the matrix is exactly singular; `x` is zero then.
    pure subroutine solve_banded(band, below, x, error)
        real(dp), intent(in) :: band(:, :)                  !! shape (above + 1 + below, n)
        integer, intent(in) :: below                        !! diagonals below the main one
        real(dp), intent(inout) :: x(:, :)                  !! b, then x; shape (n, systems)
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp), allocatable :: factors(:, :)
        integer, allocatable :: pivots(:)
        integer :: n, rows, info

        n = size(band, 2)
        rows = size(band, 1)
        allocate (factors(below + rows, n), pivots(n))
        factors(:below, :) = 0.0_dp
        factors(below + 1:, :) = band
        call dgbsv(n, below, rows - 1 - below, size(x, 2), factors, below + rows, pivots, x, n, &
            info)
        if (info == 0) return
        x = 0.0_dp
        call fail(error, cause%singular, 'the banded system of '//to_text(n)// &
            ' equations has no unique solution')
    end subroutine solve_banded

    !> Solves systems `a x = b` of one Hermitian matrix that is zero off a band: `a(i, j)` of its
    !> upper half stands in `band(above + 1 + i - j, j)`, `above` being the diagonals above the main
    !> one.
    !>
    !> Fails with `cause%singular` where the matrix is not positive definite; `x` is zero then.
    pure subroutine solve_hermitian(band, x, error)
        complex(dp), intent(in) :: band(:, :)               !! shape (above + 1, n)
        complex(dp), intent(inout) :: x(:, :)               !! b, then x; shape (n, systems)
        type(error_type), allocatable, intent(out) :: error !! see above
        complex(dp) :: factors(size(band, 1), size(band, 2))
        integer :: n, rows, info

        n = size(band, 2)
        rows = size(band, 1)
        factors = band
        call zpbsv('U', n, rows - 1, size(x, 2), factors, rows, x, n, info)
        if (info == 0) return
        x = (0.0_dp, 0.0_dp)
        call fail(error, cause%singular, 'the Hermitian system of '//to_text(n)// &
            ' equations is not positive definite')
    end subroutine solve_hermitian

    !> The x of least length for which the sum of squares of `a x - b` is least.
    pure subroutine solve_least_squares(a, b, x)
        real(dp), intent(in) :: a(:, :) !! matrix, shape (m, n); of any m and rank
        real(dp), intent(in) :: b(:)    !! right-hand side, shape (m)
        real(dp), intent(out) :: x(:)   !! see above, shape (n)
        real(dp), parameter :: kept = 1.0e-12_dp
        real(dp) :: matrix(size(b), size(x)), sides(max(size(b), size(x)), 1)
        real(dp) :: work(4*size(x) + size(b) + 8)
        integer :: order(size(x)), rank, info

        x = 0.0_dp
        if (size(b) == 0 .or. size(x) == 0) return
        matrix = a
        sides = 0.0_dp
        sides(:size(b), 1) = b
        order = 0
        call dgelsy(size(b), size(x), 1, matrix, size(b), sides, size(sides), order, kept, rank, &
            work, size(work), info)
        if (info == 0) x = sides(:size(x), 1)
    end subroutine solve_least_squares

end module geom_lapack
