!> Operations on rows against the same on one number, bit for bit.
program test_twofold_same
    use base_kinds, only: dp, i64
    use geom_twofold, only: exact_sum, operator(*), operator(+), operator(-), operator(/), sqrt, &
        twofold_type
    use geom_twofold_same, only: operator(*), operator(+), operator(-), operator(/), &
        rows_at_once, rows_type, sqrt, to_real
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(random_type) :: random
    type(twofold_type) :: a(rows_at_once), b(rows_at_once)
    type(rows_type) :: x, y
    integer :: turn, i, sums = 0, products = 0, quotients = 0, roots = 0

    do turn = 1, 500
        do i = 1, rows_at_once
            a(i) = exact_sum(next(), 1.0e-17_dp*next())
            b(i) = exact_sum(next(), 1.0e-17_dp*next())
            x%high(i) = a(i)%high
            x%low(i) = a(i)%low
            y%high(i) = b(i)%high
            y%low(i) = b(i)%low
        end do
        sums = sums + differing(x + y, a + b) + differing(x - y, a - b)
        products = products + differing(x*y, a*b) + differing(3.0_dp*x, 3.0_dp*a) &
            + differing(x*b(1), a*b(1)) + differing(b(1) + x, b(1) + a)
        quotients = quotients + differing(x/y, a/b)
        roots = roots + differing(sqrt(x*x), sqrt(a*a)) + differing(sqrt(-(x*x)), sqrt(-(a*a)))
    end do
    call tap%ok(sums == 0, 'sums and differences')
    call tap%ok(products == 0, 'products')
    call tap%ok(quotients == 0, 'quotients')
    call tap%ok(roots == 0, 'square roots, of what is not positive too')
    call tap%ok(all(to_real(x) == x%high), 'the high part is the nearest double')
    call tap%finish()

contains

    !> A random number of either sign, of many sizes.
    real(dp) function next()
        next = random%sign()*10.0_dp**random%between(-6.0_dp, 6.0_dp)
    end function next

    !> How many rows differ from the numbers worked alone.
    integer function differing(rows, alone)
        type(rows_type), intent(in) :: rows                 !! side by side
        type(twofold_type), intent(in) :: alone(rows_at_once) !! one by one
        real(dp), dimension(rows_at_once) :: high, low
        high = alone%high
        low = alone%low
        differing = count(transfer(rows%high, [0_i64]) /= transfer(high, [0_i64]) .or. &
            transfer(rows%low, [0_i64]) /= transfer(low, [0_i64]))
    end function differing

end program test_twofold_same
