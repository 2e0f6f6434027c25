!> Twofold numbers against real128, which holds 113 bits of the 107 or so of a twofold one.
program test_twofold
    use, intrinsic :: iso_fortran_env, only: real128
    use base_kinds, only: dp
    use geom_twofold, only: exact_difference, exact_product, exact_sum, operator(*), operator(+), &
        operator(-), operator(/), sqrt, to_real, twofold, twofold_type
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    integer, parameter :: qp = real128
    !> A unit in the 102nd bit.
    real(dp), parameter :: few = 2.0_dp**(-102)
    type(tap_type) :: tap
    type(random_type) :: random
    type(twofold_type) :: a, b, c
    real(dp) :: x, y, worst(6)
    integer :: i

    c = exact_sum(1.0e16_dp, 1.0_dp)
    call tap%ok(c%high == 1.0e16_dp .and. c%low == 1.0_dp, 'a sum keeps what a double loses')
    c = exact_difference(0.3_dp, 0.1_dp)
    call tap%ok(wide(c) == real(0.3_dp, qp) - real(0.1_dp, qp), 'a difference is exact')
    c = exact_product(0.1_dp, 3.0_dp) - 0.3_dp
    call tap%ok(to_real(c) == 2.0_dp**(-55), &
        'three times the double .1 exceeds the double .3 by 2**-55')
    c = exact_sum(1.0_dp, 2.0_dp**(-60)) - 1.0_dp
    call tap%ok(to_real(c) == 2.0_dp**(-60), 'cancellation leaves the low part')
    c = sqrt(twofold(0.0_dp))
    call tap%ok(to_real(c) == 0.0_dp, 'the root of zero is zero')
    c = sqrt(twofold(2.0_dp))
    call tap%ok(off(c, sqrt(2.0_qp)) <= few, 'the root of two has some 31 figures')

    worst = 0.0_dp
    do i = 1, 20000
        x = random%sign()*10.0_dp**random%between(-9.0_dp, 9.0_dp)
        y = random%sign()*10.0_dp**random%between(-9.0_dp, 9.0_dp)
        a = exact_product(x, 1.1_dp) + random%unit()
        b = exact_sum(y, random%unit()*1.0e-12_dp)
        worst(1) = max(worst(1), abs(real(wide(exact_product(x, y)) - real(x, qp)*real(y, qp), dp)))
        worst(2) = max(worst(2), off(a + b, wide(a) + wide(b)))
        worst(3) = max(worst(3), off(a - b, wide(a) - wide(b)))
        worst(4) = max(worst(4), off(a*b, wide(a)*wide(b)))
        worst(5) = max(worst(5), off(a/b, wide(a)/wide(b)))
        c = a*a
        worst(6) = max(worst(6), off(sqrt(c), sqrt(wide(c))))
    end do
    call tap%ok(worst(1) <= 0.0_dp, 'products of doubles are exact')
    call tap%near(worst(2), 0.0_dp, few, 'sums are right to 102 bits')
    call tap%near(worst(3), 0.0_dp, few, 'differences are right to 102 bits')
    call tap%near(worst(4), 0.0_dp, few, 'products are right to 102 bits')
    call tap%near(worst(5), 0.0_dp, few, 'quotients are right to 102 bits')
    call tap%near(worst(6), 0.0_dp, few, 'roots are right to 102 bits')
    call tap%finish()

contains

    !> A twofold number in real128.
    pure real(qp) function wide(t)
        type(twofold_type), intent(in) :: t
        wide = real(t%high, qp) + real(t%low, qp)
    end function wide

    !> The relative error of a twofold number.
    pure real(dp) function off(t, exact)
        type(twofold_type), intent(in) :: t
        real(qp), intent(in) :: exact
        off = 0.0_dp
        if (abs(exact) > 0.0_qp) off = real(abs((wide(t) - exact)/exact), dp)
    end function off

end program test_twofold
