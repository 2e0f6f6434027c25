!> Linear systems.
program test_lapack
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_lapack, only: solve_banded, solve_hermitian, solve_least_squares
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(error_type), allocatable :: error
    real(dp) :: band(4, 5), both(5, 2), x(2)
    complex(dp) :: hermitian(2, 3), z(3, 1)

    ! Two diagonals above, one below; the first pivot is zero, so that rows are exchanged.
    band(1, :) = [0.0_dp, 0.0_dp, 1.0_dp, 2.0_dp, 3.0_dp]
    band(2, :) = [0.0_dp, 4.0_dp, 5.0_dp, 6.0_dp, 7.0_dp]
    band(3, :) = [0.0_dp, 9.0_dp, 8.0_dp, 7.0_dp, 6.0_dp]
    band(4, :) = [2.0_dp, 3.0_dp, 4.0_dp, 5.0_dp, 0.0_dp]
    both(:, 1) = [11.0_dp, 43.0_dp, 69.0_dp, 75.0_dp, 50.0_dp]
    both(:, 2) = [0.0_dp, 2.0_dp, 0.0_dp, 0.0_dp, 0.0_dp]
    call solve_banded(band, 1, both, error)
    call tap%ok(.not. allocated(error), 'a banded system is solved')
    call tap%ok(all(abs(both(:, 1) - [1.0_dp, 2.0_dp, 3.0_dp, 4.0_dp, 5.0_dp]) < 1.0e-13_dp), &
        'its solution is 1 to 5')
    call tap%ok(norm2(matmul(whole(band), both(:, 2)) - [0.0_dp, 2.0_dp, 0.0_dp, 0.0_dp, &
        0.0_dp]) < &
        1.0e-14_dp, 'so is another with the same matrix')
    band(:, 3) = 0.0_dp
    call solve_banded(band, 1, both, error)
    call tap%ok(allocated(error), 'one with a column of zeros is refused')
    call tap%ok(all(both == 0.0_dp), '... and leaves zeros')

    ! Rows (2, i, 0), (-i, 3, 1 + i), (0, 1 - i, 4).
    hermitian(1, :) = [(0.0_dp, 0.0_dp), (0.0_dp, 1.0_dp), (1.0_dp, 1.0_dp)]
    hermitian(2, :) = [(2.0_dp, 0.0_dp), (3.0_dp, 0.0_dp), (4.0_dp, 0.0_dp)]
    z(:, 1) = [(1.0_dp, 0.0_dp), (-1.0_dp, 5.0_dp), (5.0_dp, 9.0_dp)]
    call solve_hermitian(hermitian, z, error)
    call tap%ok(.not. allocated(error), 'a Hermitian band is solved')
    call tap%near(maxval(abs(z(:, 1) - [(1.0_dp, 0.0_dp), (0.0_dp, 1.0_dp), (1.0_dp, 2.0_dp)])), &
        0.0_dp, 1.0e-14_dp, 'its solution is (1, i, 1 + 2i)')
    hermitian(2, 2) = (0.4_dp, 0.0_dp)
    call solve_hermitian(hermitian, z, error)
    call tap%ok(allocated(error), 'one that is not positive definite is refused')
    call tap%ok(error%cause == cause%singular, '... as singular')
    ! y = a + b t nearest to 1, 3, 4 at t = 0, 1, 2: a = 7/6, b = 3/2.
    call solve_least_squares(reshape([1.0_dp, 1.0_dp, 1.0_dp, 0.0_dp, 1.0_dp, 2.0_dp], [3, 2]), &
        [1.0_dp, 3.0_dp, 4.0_dp], x)
    call tap%near(maxval(abs(x - [7.0_dp/6.0_dp, 1.5_dp])), 0.0_dp, 1.0e-14_dp, &
        'the straight line nearest to three points is the one worked by hand')
    call solve_least_squares(reshape([1.0_dp, 2.0_dp, 1.0_dp, 2.0_dp], [2, 2]), &
        [2.0_dp, 4.0_dp], x)
    call tap%near(maxval(abs(x - 1.0_dp)), 0.0_dp, 1.0e-14_dp, &
        'of many solutions the shortest is given')
    call tap%finish()

contains

    !> The matrix of a band with two diagonals above and one below.
    function whole(band) result(matrix)
        real(dp), intent(in) :: band(4, 5)  !! its diagonals
        real(dp) :: matrix(5, 5)
        integer :: m, n
        matrix = 0.0_dp
        do n = 1, 5
            do m = max(1, n - 2), min(5, n + 1)
                matrix(m, n) = band(3 + m - n, n)
            end do
        end do
    end function whole

end program test_lapack
