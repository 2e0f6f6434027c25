!> Five equations: by hand, against their residuals in twice the precision, against LAPACK.
program test_five
    use, intrinsic :: iso_fortran_env, only: real128
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_five, only: five, solve_five
    use support_dense, only: solve
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_by_hand()
    call check_singular()
    call check_random()
    call tap%finish()

contains

    !> Systems of which the solution is known.
    subroutine check_by_hand()
        type(error_type), allocatable :: error
        real(dp) :: a(five, five), b(five), x(five), rcond
        integer :: i, j

        a = 0.0_dp
        do i = 1, five
            b(i) = 16.0_dp**i
            a(i, 1 + mod(i + 1, five)) = b(i)
        end do
        call solve_five(a, b, x, rcond, error)
        call tap%ok(.not. allocated(error) .and. all(x == 1.0_dp), &
            'a system that needs its rows exchanged is solved')
        call tap%ok(rcond == 1.0_dp, 'scaled, its condition is the best there is')

        do i = 1, five
            do j = 1, five
                a(i, j) = 1.0_dp/real(i + j - 1, dp)
            end do
        end do
        call solve_five(a, [1.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp], x, rcond, error)
        call tap%near(maxval(abs(x - [25.0_dp, -300.0_dp, 1050.0_dp, -1400.0_dp, 630.0_dp])), &
            0.0_dp, 1.0e-8_dp, 'the first column of the inverse of Hilbert''s matrix is whole')
        call tap%near(rcond, 1.0_dp/943656.0_dp, 1.0e-12_dp, 'whose condition is 943656')
    end subroutine check_by_hand

    !> Systems without a solution.
    subroutine check_singular()
        type(error_type), allocatable :: error
        real(dp) :: a(five, five), x(five), rcond
        integer :: i

        a = 0.0_dp
        do i = 1, five
            a(i, i) = 1.0_dp
        end do
        a(2, :) = 0.0_dp
        call solve_five(a, spread(1.0_dp, 1, five), x, rcond, error)
        call tap%ok(allocated(error), 'a row of zeros is refused')
        call tap%ok(error%cause == cause%singular, '... as singular')
        call tap%ok(all(x == 0.0_dp) .and. rcond == 0.0_dp, '... and leaves zeros')
        a(2, :) = a(1, :)
        call solve_five(a, spread(1.0_dp, 1, five), x, rcond, error)
        call tap%ok(allocated(error), 'so is a column of zeros')
        a(2, 2) = 1.0_dp
        call solve_five(a, spread(1.0_dp, 1, five), x, rcond, error)
        call tap%ok(.not. allocated(error), '(which a system beside it is not)')
        a(1, 2) = 1.0_dp
        a(2, 1:2) = [2.0_dp, 2.0_dp]
        call solve_five(a, spread(1.0_dp, 1, five), x, rcond, error)
        call tap%ok(allocated(error), 'so are two rows in proportion')
        a(2, 2) = 2.0_dp*(1.0_dp + epsilon(1.0_dp))
        call solve_five(a, spread(1.0_dp, 1, five), x, rcond, error)
        call tap%ok(allocated(error) .and. rcond > 0.0_dp, &
            '... also where only rounding tells them apart')
    end subroutine check_singular

    !> Random systems, some with zeros, some badly scaled, some of conics.
    subroutine check_random()
        type(random_type) :: random
        type(error_type), allocatable :: error, other
        real(dp) :: a(five, five), b(five), x(five), y(five), rcond, right
        integer :: i, unsolved, off, elsewhere

        unsolved = 0
        off = 0
        elsewhere = 0
        do i = 1, 20000
            call draw(random, mod(i, 4), a, b)
            call solve_five(a, b, x, rcond, error)
            call solve(a, b, y, right, other)
            if (allocated(error) .neqv. allocated(other)) unsolved = unsolved + 1
            if (allocated(error)) cycle
            if (backward_error(a, b, x) > 4.0_dp*epsilon(1.0_dp)) off = off + 1
            if (abs(rcond - right) > 1.0e-6_dp*right) elsewhere = elsewhere + 1
        end do
        call tap%ok(unsolved == 0, '20000 systems have a solution where LAPACK finds one')
        call tap%ok(off == 0, 'each solves a system that differs by 4 ulps at most')
        call tap%ok(elsewhere == 0, 'the condition is what LAPACK estimates')
    end subroutine check_random

    !> A random system.
    subroutine draw(random, kind, a, b)
        type(random_type), intent(inout) :: random !! the stream
        integer, intent(in) :: kind         !! 0: any, 1: with zeros, 2: badly scaled, 3: of a conic
        real(dp), intent(out) :: a(five, five) !! matrix
        real(dp), intent(out) :: b(five)    !! right-hand side
        real(dp) :: p(2), s
        integer :: i, j

        do j = 1, five
            do i = 1, five
                a(i, j) = random%between(-1.0_dp, 1.0_dp)
                if (kind == 1 .and. random%one_in(3)) a(i, j) = 0.0_dp
            end do
            b(j) = random%between(-1.0_dp, 1.0_dp)
        end do
        do i = 1, five
            if (kind == 2) a(i, :) = a(i, :)*10.0_dp**random%between(-9.0_dp, 9.0_dp)
            if (kind == 2) a(:, i) = a(:, i)*10.0_dp**random%between(-4.0_dp, 4.0_dp)
            if (kind /= 3) cycle
            if (i <= 3) p = [random%between(70.0_dp, 150.0_dp), random%between(70.0_dp, 150.0_dp)]
            s = random%between(-1.0_dp, 1.0_dp)
            if (i <= 3) a(i, :) = [p(1)**2, p(1)*p(2), p(2)**2, p(1), p(2)]
            if (i > 3) p = a(merge(1, 3, i == 4), 4:5)
            if (i > 3) a(i, :) = [2.0_dp*p(1), p(2) + s*p(1), 2.0_dp*s*p(2), 1.0_dp, s]
        end do
        if (kind == 3) b = [-1.0_dp, -1.0_dp, -1.0_dp, 0.0_dp, 0.0_dp]
    end subroutine draw

    !> The least change of matrix and right-hand side, relative to each of their elements, that
    !> makes x their solution (Oettli and Prager).
    real(dp) function backward_error(a, b, x) result(largest)
        real(dp), intent(in) :: a(five, five)   !! matrix
        real(dp), intent(in) :: b(five)         !! right-hand side
        real(dp), intent(in) :: x(five)         !! a solution
        real(real128) :: rest(five), size(five)
        integer :: j

        rest = real(b, real128)
        size = abs(rest)
        do j = 1, five
            rest = rest - real(a(:, j), real128)*real(x(j), real128)
            size = size + abs(real(a(:, j), real128)*real(x(j), real128))
        end do
        largest = real(maxval(abs(rest)/max(size, tiny(1.0_real128))), dp)
    end function backward_error

end program test_five
