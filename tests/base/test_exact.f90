!> Exact comparisons by bit pattern.
program test_exact
    use base_exact, only: is_equal, is_finite, is_zero
    use base_kinds, only: dp, i64
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    real(dp), parameter :: minus_zero = transfer(ishft(1_i64, 63), 0.0_dp)
    real(dp), parameter :: infinity = transfer(int(z'7FF0000000000000', i64), 0.0_dp)
    real(dp), parameter :: not_a_number = transfer(int(z'7FF8000000000000', i64), 0.0_dp)
    real(dp), parameter :: smallest = transfer(1_i64, 0.0_dp)

    call tap%ok(all(is_zero([0.0_dp, minus_zero])), 'zero of either sign is zero')
    call tap%ok(.not. any(is_zero([smallest, -smallest, tiny(1.0_dp), infinity])), &
        'the smallest number is not zero')
    call tap%ok(.not. is_zero(not_a_number), 'NaN is not zero')

    call tap%ok(is_equal(0.0_dp, minus_zero), 'zeros of either sign are one number')
    call tap%ok(is_equal(0.1_dp, 0.1_dp), 'a number equals itself')
    call tap%ok(.not. is_equal(1.0_dp, nearest(1.0_dp, 1.0_dp)), 'neighbours are not equal')
    call tap%ok(.not. is_equal(0.1_dp + 0.2_dp, 0.3_dp), '.1 + .2 is not .3')
    call tap%ok(.not. is_equal(smallest, 0.0_dp), 'the smallest number does not equal zero')
    call tap%ok(.not. is_equal(1.0_dp, -1.0_dp), 'numbers of different sign are not equal')

    call tap%ok(all(is_finite([0.0_dp, minus_zero, huge(1.0_dp), -huge(1.0_dp), smallest])), &
        'every number is finite')
    call tap%ok(.not. any(is_finite([infinity, -infinity])), 'infinity is not finite')
    call tap%ok(.not. is_finite(not_a_number), 'NaN is not finite')
    call tap%finish()
end program test_exact
