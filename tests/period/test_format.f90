!> F fields of the 1970 page: by hand, and on random words against the runtime's own output of the
!> same number in 113 bits, told to round half away from zero.
program test_format
    use, intrinsic :: iso_fortran_env, only: real128
    use base_decimal, only: decimal_type
    use base_kinds, only: dp, i64
    use period_convert, only: from_decimal
    use period_format, only: fixed, put_fixed
    use period_word, only: from_bits, hex_type, whole
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_plain()
    call check_ties()
    call check_zero()
    call check_width()
    call check_random()
    call tap%finish()

contains

    !> The word of a decimal.
    type(hex_type) function word(digits, power)
        integer, intent(in) :: digits, power
        word = from_decimal(decimal_type(int(digits, i64), power))
    end function word

    !> As on the page.
    subroutine check_plain()
        call tap%same(fixed(whole(-30), 10, 5), ' -30.00000', 'a whole number')
        call tap%same(fixed(word(114, -3), 10, 5), '   0.11400', 'a zero before the point')
        call tap%same(fixed(word(-268, -3), 10, 5), '  -0.26800', 'a minus before that zero')
        call tap%same(fixed(word(999999, -3), 10, 5), ' 999.99900', 'the vertical slope')
        call tap%same(fixed(word(-2608, -8), 11, 8), '-0.00002608', 'a coefficient')
        call tap%same(fixed(whole(7), 5, 0), '   7.', 'no decimals')
        call tap%same(fixed(word(1, -20), 17, 12), '   0.000000000000', &
            'a small number in a wide field')
        call tap%same(fixed(word(1, -70), 9, 3), '    0.000', 'a tiny number')
        call tap%same(fixed(whole(2147483647), 14, 3), '2147483647.000', &
            'a large number that just fits')
    end subroutine check_plain

    !> Exact halves, in binary too, go away from zero; what is just below a half does not.
    subroutine check_ties()
        call tap%same(fixed(word(625, -4), 9, 3), '    0.063', '.0625 goes up')
        call tap%same(fixed(word(-625, -4), 9, 3), '   -0.063', '-.0625 goes down')
        call tap%same(fixed(word(1875, -4), 9, 3), '    0.188', '.1875 goes up')
        call tap%same(fixed(word(5, -1), 4, 0), '  1.', '.5 goes up')
        call tap%same(fixed(word(25, -1), 4, 0), '  3.', '2.5 goes up')
        call tap%same(fixed(word(5, -4), 9, 3), '    0.000', &
            '.0005, cut to a word, is below a half')
        call tap%same(fixed(word(99995, -1), 9, 0), '   10000.', 'rounding makes a digit more')
        call tap%same(fixed(word(9999, -4), 9, 3), '    1.000', 'rounding carries through')
    end subroutine check_ties

    !> An exact zero, and what only rounds to it.
    subroutine check_zero()
        call tap%same(fixed(whole(0), 10, 5), '   0.0    ', 'exact zero, F10.5')
        call tap%same(fixed(whole(0), 9, 3), '    0.0  ', 'exact zero, F9.3')
        call tap%same(fixed(whole(0), 11, 8), ' 0.0       ', 'exact zero, F11.8')
        call tap%same(fixed(whole(0), 5, 1), '  0.0', 'exact zero, F5.1')
        call tap%same(fixed(whole(0), 5, 0), '   0.', 'exact zero, F5.0')
        call tap%same(fixed(whole(0), 3, 2), '***', 'exact zero without room for its digit')
        call tap%same(fixed(word(-4, -4), 9, 3), '    0.000', &
            'below zero and rounded to zero: no minus')
        call tap%same(fixed(word(-6, -4), 9, 3), '   -0.001', 'below zero and not rounded to zero')
    end subroutine check_zero

    !> Figures and their fields.
    subroutine check_width()
        character(9) :: field
        call tap%same(fixed(word(99999999, -3), 9, 3), '99999.999', 'a figure as wide as its field')
        call tap%same(fixed(word(999999996, -4), 9, 3), '*********', 'rounding makes it too wide')
        call tap%same(fixed(word(-99999999, -3), 9, 3), '*********', 'a minus makes it too wide')
        call tap%same(fixed(whole(100000), 9, 3), '*********', 'a figure too wide')
        call tap%same(fixed(from_bits(int(z'7FFFFFFFFFFFFFFF', i64)), 9, 3), '*********', &
            'the largest word')
        call tap%same(fixed(from_bits(int(z'4F10000000000000', i64)), 17, 0), '*****************', &
            '16**14 has 17 digits and no room for its point')
        call tap%same(fixed(from_bits(int(z'4E10000000000000', i64)), 17, 0), '4503599627370496.', &
            '16**13 has 16 digits')
        call tap%same(fixed(word(5, -1), 4, 3), '****', 'no room for the zero before the point')
        call put_fixed(word(-5, -1), 3, field)
        call tap%same(field, '   -0.500', 'a field given has its own width')
    end subroutine check_width

    !> Random words from 16**-3 to 16**4 in F13.3, and in F13.8.
    subroutine check_random()
        type(hex_type) :: a
        character(13) :: mine, runtime
        real(dp) :: r(3)
        real(real128) :: exact
        integer :: i, wrong(2)

        wrong = 0
        call random_init(.true., .true.)
        do i = 1, 20000
            call random_number(r)
            a = from_bits(int(1.0_dp + 15.0_dp*r(1), i64)*16_i64**13 + int(r(2)*2.0_dp**52, i64) &
                + int(61.0_dp + 8.0_dp*r(3), i64)*2_i64**56)
            if (modulo(i, 2) == 0) a%fraction = -a%fraction
            exact = scale(real(a%fraction, real128), 4*(a%exponent - 14))
            write (runtime, '(rc,f13.3)') exact
            if (index(runtime, '-0.000') > 0) runtime = '        0.000'
            mine = fixed(a, 13, 3)
            if (mine /= runtime) wrong(1) = wrong(1) + 1
            write (runtime, '(rc,f13.8)') exact
            mine = fixed(a, 13, 8)
            if (mine /= runtime) wrong(2) = wrong(2) + 1
        end do
        call tap%ok(wrong(1) == 0, &
            'random words in F13.3 are as the runtime writes them in 113 bits')
        call tap%ok(wrong(2) == 0, &
            'random words in F13.8 are as the runtime writes them in 113 bits')
    end subroutine check_random

end program test_format
