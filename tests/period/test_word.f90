!> Words by bit pattern: sign, characteristic (power of 16 plus 64), 14 hexadecimal digits.
program test_word
    use base_error, only: cause
    use base_kinds, only: dp, i64
    use period_word, only: bits, from_bits, hex_type, is_negative, is_positive, is_zero, &
        normalised, single, to_real, whole
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_whole()
    call check_normalising()
    call check_range()
    call check_reals()
    call check_predicates()
    call tap%finish()

contains

    !> Compares a word with its pattern, both shown in hexadecimal where they differ.
    subroutine pattern(word, expected, name)
        type(hex_type), intent(in) :: word
        character(16), intent(in) :: expected
        character(*), intent(in) :: name
        character(16) :: actual
        write (actual, '(z16.16)') bits(word)
        call tap%same(actual, expected, name)
    end subroutine pattern

    !> Whole numbers: 1 is .1 times 16**1, so 41 10...; 100 = 64 hex; 4096 = 16**3.
    subroutine check_whole()
        call pattern(whole(0), '0000000000000000', 'zero is all zeros')
        call pattern(whole(1), '4110000000000000', 'one')
        call pattern(whole(-1), 'C110000000000000', 'minus one')
        call pattern(whole(100), '4264000000000000', 'a hundred')
        call pattern(whole(-118), 'C276000000000000', &
            'minus 118, the example of the manual without .625')
        call pattern(whole(15), '41F0000000000000', 'fifteen is one digit')
        call pattern(whole(16), '4210000000000000', 'sixteen is two digits')
        call pattern(whole(2147483647), '487FFFFFFF000000', 'the largest whole number')
    end subroutine check_whole

    !> 15 digits in, the first 14 that are not leading zeros kept.
    subroutine check_normalising()
        integer(i64), parameter :: guard_f = int(z'123456789ABCDEF', i64)
        call pattern(normalised(guard_f, 1, 0), '41123456789ABCDE', &
            'the guard digit is cut, not rounded')
        call pattern(normalised(-guard_f, 1, 0), 'C1123456789ABCDE', &
            'below zero it is cut towards zero')
        call pattern(normalised(int(z'0123456789ABCDE', i64), 1, 0), '40123456789ABCDE', &
            'one leading zero: the guard digit moves in')
        call pattern(normalised(int(z'000000000000001', i64), 1, 0), '3310000000000000', &
            'only a guard digit: 14 places left')
        call pattern(normalised(int(z'1FFFFFFFFFFFFFFF', i64), 1, 0), '421FFFFFFFFFFFFF', &
            'a carry: one place right')
        call pattern(normalised(0_i64, 5, 0), '0000000000000000', 'no digits at all: true zero')
        call pattern(from_bits(int(z'4200100000000000', i64)), '4010000000000000', &
            'a pattern that is not normalised becomes so')
        call pattern(from_bits(int(z'4200000000000000', i64)), '0000000000000000', &
            'a pattern without fraction is true zero')
        call pattern(from_bits(int(z'7FFFFFFFFFFFFFFF', i64)), '7FFFFFFFFFFFFFFF', &
            'the largest word')
        call pattern(from_bits(int(z'0010000000000000', i64)), '0010000000000000', &
            'the smallest word')
        call pattern(from_bits(ibset(int(z'40123456789ABCDE', i64), 63)), 'C0123456789ABCDE', &
            'the sign bit is a minus')
        call pattern(single(from_bits(int(z'40123456FFFFFFFF', i64))), '4012345600000000', &
            'single precision keeps 6 digits')
        call pattern(single(from_bits(ibset(int(z'40123456FFFFFFFF', i64), 63))), &
            'C012345600000000', 'single precision cuts towards zero')
    end subroutine check_normalising

    !> The powers 16**-65 to 16**63; a trap that is there already stays.
    subroutine check_range()
        integer(i64), parameter :: one = 16_i64**14
        type(hex_type) :: word
        word = normalised(one, 63, 0)
        call tap%ok(word%trap == 0, 'the power 63 is in range')
        word = normalised(one, 64, 0)
        call tap%ok(word%trap == cause%overflow, 'the power 64 overflows')
        word = normalised(16_i64*one, 63, 0)
        call tap%ok(word%trap == cause%overflow, 'a carry out of the power 63 overflows')
        word = normalised(one/16_i64, 64, 0)
        call tap%ok(word%trap == 0, 'the power 64 with a leading zero is brought into range')
        word = normalised(one, -64, 0)
        call tap%ok(word%trap == 0, 'the power -64 is in range')
        word = normalised(one, -65, 0)
        call tap%ok(word%trap == cause%underflow .and. is_zero(word) .and. bits(word) == 0, &
            'the power -65 underflows to true zero')
        word = normalised(one/16_i64, -64, 0)
        call tap%ok(word%trap == cause%underflow, 'normalising below the power -64 underflows')
        word = normalised(16_i64*one, -65, 0)
        call tap%ok(word%trap == 0, 'a carry brings the power -65 into range')
        word = normalised(one, -65, cause%divide)
        call tap%ok(word%trap == cause%divide .and. is_zero(word), &
            'an older trap wins over an underflow')
        word = normalised(one, 64, cause%divide)
        call tap%ok(word%trap == cause%divide, 'an older trap wins over an overflow')
        word = normalised(0_i64, 64, cause%divide)
        call tap%ok(word%trap == cause%divide, 'a zero keeps its trap')
    end subroutine check_range

    !> Words as doubles, rounded.
    subroutine check_reals()
        call tap%near(to_real(from_bits(ibset(int(z'4276A00000000000', i64), 63))), &
            -118.625_dp, 0.0_dp, 'C276A is -118.625, the example of the manual')
        call tap%near(to_real(from_bits(int(z'4019999999999999', i64))), 0.1_dp, 2.0_dp**(-56), &
            'a tenth cut to 14 digits is a tenth')
        call tap%near(to_real(from_bits(int(z'0010000000000000', i64))), 16.0_dp**(-65), 0.0_dp, &
            'the smallest word')
        call tap%near(to_real(from_bits(int(z'7FFFFFFFFFFFFFFF', i64))), 16.0_dp**63, 0.0_dp, &
            'the largest word rounds to 16**63')
        call tap%near(to_real(whole(0)), 0.0_dp, 0.0_dp, 'zero')
    end subroutine check_reals

    !> Signs.
    subroutine check_predicates()
        call tap%ok(all(is_zero(whole([-1, 0, 1])) .eqv. [.false., .true., .false.]), &
            'only zero is zero')
        call tap%ok(all(is_positive(whole([-1, 0, 1])) .eqv. [.false., .false., .true.]), &
            'zero is not positive')
        call tap%ok(all(is_negative(whole([-1, 0, 1])) .eqv. [.true., .false., .false.]), &
            'zero is not negative')
    end subroutine check_predicates

end program test_word
