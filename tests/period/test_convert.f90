!> Decimals as words. The patterns come from whole-number arithmetic by another program, the short
!> ones by hand: .999*16 = 15.984, .984*16 = 15.744, .744*16 = 11.904 ..., so .FFBE76C8B43.
program test_convert
    use base_decimal, only: decimal_type
    use base_error, only: cause
    use base_kinds, only: dp, i128, i64
    use period_convert, only: from_decimal, single_constant
    use period_word, only: bits, hex_type, is_zero
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_card_numbers()
    call check_far_powers()
    call check_range()
    call check_random()
    call tap%finish()

contains

    !> Compares the word of a decimal with its pattern.
    subroutine pattern(digits, power, expected, name)
        integer(i64), intent(in) :: digits
        integer, intent(in) :: power
        character(16), intent(in) :: expected
        character(*), intent(in) :: name
        type(hex_type) :: word
        character(16) :: text
        word = from_decimal(decimal_type(digits, power))
        write (text, '(z16.16)') bits(word)
        call tap%same(text, expected, name)
        if (word%trap /= 0) call tap%ok(.false., name//' does not trap')
    end subroutine pattern

    !> What is punched on cards.
    subroutine check_card_numbers()
        character(16) :: text
        call pattern(0_i64, 3, '0000000000000000', '0.')
        call pattern(1_i64, 0, '4110000000000000', '1.')
        call pattern(1_i64, -1, '4019999999999999', '.1 is cut, not rounded')
        call pattern(100_i64, 0, '4264000000000000', '100.')
        call pattern(1000000_i64, -4, '4264000000000000', '100.0000 is the same number')
        call pattern(1_i64, 2, '4264000000000000', '1.E2 is the same number')
        call pattern(999999_i64, -3, '433E7FFBE76C8B43', '999.999')
        call pattern(-71_i64, -1, 'C171999999999999', '-7.1 is cut towards zero')
        call pattern(5_i64, -4, '3E20C49BA5E353F7', '.0005')
        call pattern(-314159265358979323_i64, -17, 'C13243F6A8885A30', 'minus pi')
        call pattern(huge(1_i64), 0, '507FFFFFFFFFFFFF', '19 digits')
        write (text, '(z16.16)') bits(single_constant(decimal_type(5_i64, -4)))
        call tap%same(text, '3E20C49B00000000', '.0005 as a single constant')
    end subroutine check_card_numbers

    !> Up and down to the ends of the range.
    subroutine check_far_powers()
        call pattern(1_i64, 50, '6A446C3B15F99266', '1.E50')
        call pattern(1_i64, -50, '173BDCF495A9703D', '1.E-50')
        call pattern(1_i64, 70, '7B172EBAD6DDC73C', '1.E70')
        call pattern(1_i64, 75, '7F235FADD81C2822', '1.E75')
        call pattern(999999999999999999_i64, 57, '7F235FADD81C2822', 'just below 1.E75')
        call pattern(1_i64, -78, '001DA48CE468E7C7', '1.E-78')
        call pattern(54_i64, -80, '001001D133A949F5', '5.4E-79')
        call pattern(999999999999999999_i64, -96, '001DA48CE468E7C7', 'just below 1.E-78')
        call pattern(123456789012345678_i64, -40, '2DEECCD744F5C259', '1.23...E-23')
        call pattern(-123456789012345678_i64, 30, 'E8159FFE6F22FD5C', '-1.23...E47')
        call pattern(7237005577332262213_i64, 57, '7FFFFFFFFFFFFFFF', &
            'the last 19 digits below 16**63')
    end subroutine check_far_powers

    !> Beyond the range.
    subroutine check_range()
        call traps(7237005577332262214_i64, 57, cause%overflow, 'the first 19 digits above 16**63')
        call traps(1_i64, 76, cause%overflow, '1.E76')
        call traps(-1_i64, 80, cause%overflow, '-1.E80')
        call traps(1_i64, 280, cause%overflow, '1.E280')
        call traps(123456789012345678_i64, 280, cause%overflow, '18 digits and 280 zeros')
        call traps(539760534693402789_i64, -96, cause%underflow, 'the last 18 digits below 16**-65')
        call traps(539760534693402790_i64, -96, 0, 'the first 18 digits above 16**-65')
        call traps(1_i64, -79, cause%underflow, '1.E-79')
        call traps(1_i64, -97, cause%underflow, '1.E-97')
        call traps(999999999999999999_i64, -98, cause%underflow, '18 nines, 80 places down')
        call traps(1_i64, -280, cause%underflow, '1.E-280')
        call traps(0_i64, 280, 0, 'zero with a large power')
    end subroutine check_range

    !> Checks the trap of a decimal, and that an underflow is zero.
    subroutine traps(digits, power, why, name)
        integer(i64), intent(in) :: digits
        integer, intent(in) :: power, why
        character(*), intent(in) :: name
        type(hex_type) :: word
        word = from_decimal(decimal_type(digits, power))
        call tap%ok(word%trap == why, name//trim(merge(' traps ', ' passes', why /= 0)))
        if (why == cause%underflow) call tap%ok(is_zero(word), name//' is zero')
    end subroutine traps

    !> Random numbers of up to 15 digits with up to 15 decimals: fraction*16**(e - 14) must be at
    !> most the number, and one more in the last place above it; both are
    !> multiplied by 10**decimals*16**(14 - e), which makes them whole.
    subroutine check_random()
        integer(i128) :: number, scale, fraction, raise
        type(hex_type) :: word
        real(dp) :: r(3)
        integer :: i, power, wrong

        wrong = 0
        call random_init(.true., .true.)
        do i = 1, 20000
            call random_number(r)
            number = int(10.0_dp**(15.0_dp*r(1)), i128)
            power = -int(16.0_dp*r(2))
            word = from_decimal(decimal_type(int(number, i64), power))
            fraction = int(word%fraction, i128)
            scale = 10_i128**int(-power, i128)
            raise = 16_i128**int(abs(14 - word%exponent), i128)
            if (word%exponent > 14) then
                cycle
            else if (real(number, dp)*real(raise, dp) > 1.0e38_dp) then
                cycle
            end if
            if (fraction*scale > number*raise .or. (fraction + 1_i128)*scale <= number*raise .or. &
                fraction < 16_i128**13) wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, 'random decimals are the exact value cut to 14 digits')
    end subroutine check_random

end program test_convert
