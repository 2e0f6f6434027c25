!> Square systems.
program test_square_system
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_square_system, only: solve
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(error_type), allocatable :: error
    real(dp) :: a(2, 2), hilbert(4, 4), x(2), y(4), rcond
    integer :: i, j

    a(1, :) = [0.0_dp, 2.0_dp]
    a(2, :) = [3.0_dp, 1.0_dp]
    call solve(a, [4.0_dp, 11.0_dp], x, rcond, error)
    call tap%ok(.not. allocated(error), 'a system that needs its rows exchanged is solved')
    call tap%near(maxval(abs(x - [3.0_dp, 2.0_dp])), 0.0_dp, 1.0e-15_dp, 'its solution is (3, 2)')
    call tap%ok(rcond > 0.1_dp, 'its condition is good')
    call tap%ok(all(a(1, :) == [0.0_dp, 2.0_dp]), 'the matrix is left as it was')

    do i = 1, 4
        do j = 1, 4
            hilbert(i, j) = 1.0_dp/real(i + j - 1, dp)
        end do
    end do
    call solve(hilbert, [1.0_dp, 0.0_dp, 0.0_dp, 0.0_dp], y, rcond, error)
    call tap%near(maxval(abs(y - [16.0_dp, -120.0_dp, 240.0_dp, -140.0_dp])), 0.0_dp, 1.0e-10_dp, &
        'the first column of the inverse of Hilbert''s matrix of order 4 is whole')
    call tap%ok(rcond > 1.0e-5_dp .and. rcond < 1.0e-3_dp, 'whose condition is bad')

    a(1, :) = [1.0_dp, 2.0_dp]
    a(2, :) = [2.0_dp, 4.0_dp]
    call solve(a, [1.0_dp, 1.0_dp], x, rcond, error)
    call tap%ok(allocated(error), 'a singular system is refused')
    call tap%ok(error%cause == cause%singular, '... as singular')
    call tap%ok(all(x == 0.0_dp) .and. rcond == 0.0_dp, '... and leaves zeros')
    a(2, :) = [2.0_dp, 4.0_dp*(1.0_dp + epsilon(1.0_dp))]
    call solve(a, [1.0_dp, 1.0_dp], x, rcond, error)
    call tap%ok(allocated(error), 'so is one singular to working precision')
    call tap%finish()

end program test_square_system
