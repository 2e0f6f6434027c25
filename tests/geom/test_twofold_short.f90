!> Rows of twofold numbers against real128, which holds 113 bits of the 105 or so of a twofold one.
program test_twofold_short
    use, intrinsic :: iso_fortran_env, only: real128
    use base_kinds, only: dp
    use geom_twofold, only: twofold_type
    use geom_twofold_short, only: chosen, exact_row, negative, number_of, operator(*), &
        operator(+), operator(-), operator(/), repeated, row_of, row_type, scaled, sqrt, square, &
        width
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    integer, parameter :: qp = real128
    real(dp), parameter :: few = 2.0_dp**(-101)
    type(tap_type) :: tap
    type(random_type) :: random
    type(row_type) :: a, b, c
    type(twofold_type) :: x
    real(dp) :: worst(9), first(width), second(width)
    logical :: is_first(width)
    real(qp) :: wide_x
    integer :: i, k

    worst = 0.0_dp
    x = twofold_type(0.3_dp, 1.0e-18_dp)
    wide_x = real(0.3_dp, qp) + real(1.0e-18_dp, qp)
    do k = 1, 200
        do i = 1, width
            first(i) = random%sign()*10.0_dp**random%between(-9.0_dp, 9.0_dp)
            second(i) = random%sign()*10.0_dp**random%between(-9.0_dp, 9.0_dp)
        end do
        c = exact_row(first, second)
        worst(1) = max(worst(1), maxval(abs(real(wide(c) - (real(first, qp) - &
            real(second, qp)), dp))))
        a = row_of(first)*exact_row(second, 0.1_dp)
        b = exact_row(second, 1.0e-3_dp*first)
        worst(2) = max(worst(2), part(a + b, wide(a) + wide(b), abs(wide(a)) + abs(wide(b))))
        worst(3) = max(worst(3), part(a - b, wide(a) - wide(b), abs(wide(a)) + abs(wide(b))))
        worst(4) = max(worst(4), part(a*b, wide(a)*wide(b), wide(a)*wide(b)))
        worst(5) = max(worst(5), part(a/b, wide(a)/wide(b), wide(a)/wide(b)))
        worst(6) = max(worst(6), part(square(a), wide(a)**2, wide(a)**2))
        worst(7) = max(worst(7), part(sqrt(square(a)), abs(wide(a)), wide(a)))
        worst(8) = max(worst(8), part(x*a, wide_x*wide(a), wide(a)))
        worst(9) = max(worst(9), part(a + x, wide(a) + wide_x, abs(wide(a)) + wide_x))
    end do
    call tap%ok(worst(1) <= 0.0_dp, 'differences of doubles are exact')
    call tap%near(worst(2), 0.0_dp, few, 'sums are right to 101 bits of their terms')
    call tap%near(worst(3), 0.0_dp, few, 'differences, too')
    call tap%near(worst(4), 0.0_dp, few, 'products are right to 101 bits')
    call tap%near(worst(5), 0.0_dp, few, 'quotients, too')
    call tap%near(worst(6), 0.0_dp, few, 'squares, too')
    call tap%near(worst(7), 0.0_dp, few, 'roots, too')
    call tap%near(worst(8), 0.0_dp, few, 'multiples, too')
    call tap%near(worst(9), 0.0_dp, few, 'sums with one number, too')
    c = sqrt(row_of(-abs(first)))
    call tap%ok(all(wide(c) == 0.0_qp), 'the root of what is below zero is zero')
    is_first = first > second
    c = chosen(row_of(first), negative(row_of(second)), is_first)
    call tap%ok(all(merge(first, -second, is_first) == c%high), 'one row or another')
    c = scaled(spread(0.25_dp, 1, width), repeated(x))
    call tap%ok(all(c%high == 0.075_dp) .and. all(c%low == 0.25e-18_dp), 'a quarter is exact')
    x = number_of(b, 3)
    call tap%ok(x%high == b%high(3) .and. x%low == b%low(3), 'a number of a row')
    call tap%finish()

contains

    !> The numbers of a row.
    pure function wide(row)
        type(row_type), intent(in) :: row
        real(qp) :: wide(width)
        wide = real(row%high, qp) + real(row%low, qp)
    end function wide

    !> The largest error as a part of what it is measured by.
    pure real(dp) function part(row, exact, measure)
        type(row_type), intent(in) :: row
        real(qp), intent(in) :: exact(width), measure(width)
        part = real(maxval(abs((wide(row) - exact)/measure)), dp)
    end function part

end program test_twofold_short
