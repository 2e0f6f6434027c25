!> System/360 arithmetic by bit patterns worked out by hand; `test_exact` proves it on random words.
program test_arithmetic
    use base_error, only: cause
    use base_kinds, only: i64
    use period_arithmetic, only: abs, operator(*), operator(+), operator(-), operator(/), short_sqrt
    use period_word, only: bits, from_bits, hex_type, is_zero, whole
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(hex_type) :: one, largest, smallest

    one = whole(1)
    largest = word('7FFFFFFFFFFFFFFF')
    smallest = word('0010000000000000')
    call check_sums()
    call check_products()
    call check_quotients()
    call check_roots()
    call check_traps()
    call tap%finish()

contains

    !> The word of 16 hexadecimal digits.
    type(hex_type) function word(pattern)
        character(16), intent(in) :: pattern
        integer(i64) :: stored
        read (pattern, '(z16)') stored
        word = from_bits(stored)
    end function word

    !> Compares a word with its pattern.
    subroutine pattern(actual, expected, name)
        type(hex_type), intent(in) :: actual
        character(16), intent(in) :: expected
        character(*), intent(in) :: name
        character(16) :: text
        write (text, '(z16.16)') bits(actual)
        call tap%same(text, expected, name)
    end subroutine pattern

    !> Working beside each sum; a bar marks the guard digit.
    subroutine check_sums()
        call pattern(whole(1) + whole(2), '4130000000000000', '1 + 2 = 3')
        call pattern(whole(15) + whole(1), '4210000000000000', '15 + 1 carries into a new digit')
        call pattern(whole(-15) - whole(1), 'C210000000000000', '-15 - 1 carries too')
        call pattern(whole(7) - whole(7), '0000000000000000', 'x - x is true zero')
        call pattern(whole(0) + whole(-7), 'C170000000000000', '0 + x is x')
        call pattern(whole(-7) - whole(0), 'C170000000000000', 'x - 0 is x')
        call pattern(-whole(0), '0000000000000000', '-0 is true zero')
        ! .10000000000000|0 - .0FFFFFFFFFFFFF|F = .00000000000000|1:
        ! 14 places left, 16**-13
        call pattern(one - word('40FFFFFFFFFFFFFF'), '3310000000000000', &
            'the guard digit saves the last digit of the smaller number')
        ! .10000000000000|0 - .00000000000000|1 = .0FFFFFFFFFFFFF|F
        call pattern(one - word('3310000000000000'), '40FFFFFFFFFFFFFF', &
            'the guard digit moves in where the sum loses its first digit')
        ! .10000000000000|0 - .00000000000000|0(1 lost) = 1
        call pattern(one - word('3210000000000000'), '4110000000000000', &
            'what is shifted beyond the guard digit is lost')
        ! .10000000000000|0 + .00000000000000|F = .10000000000000|F, cut
        call pattern(one + word('33F0000000000000'), '4110000000000000', &
            'sums are cut, not rounded')
        ! .FFFFFFFFFFFFFF|0 + .00000000000000|8 = .FFFFFFFFFFFFFF|8, no carry
        call pattern(word('41FFFFFFFFFFFFFF') + word('3380000000000000'), '41FFFFFFFFFFFFFF', &
            'a guard digit of 8 carries nothing')
        ! .FFFFFFFFFFFFFF + .00000000000003 = 1.00000000000002, one place right: 2 cut
        call pattern(word('41FFFFFFFFFFFFFF') + word('3430000000000000'), '4210000000000000', &
            'a carry drops the last digit')
        call pattern(one + word('0110000000000000'), '4110000000000000', &
            'a far smaller number is lost')
        call pattern(word('0110000000000000') - one, 'C110000000000000', 'from either side')
        ! 92.9 = 5C.E66666666666, less 100 = 64.000000000000:
        ! -07.19999999999A, one place left
        call pattern(word('425CE66666666666') - whole(100), 'C1719999999999A0', '92.9 - 100')
        call pattern(abs(whole(-7)), '4170000000000000', 'the magnitude of -7')
        call pattern(abs(whole(7)), '4170000000000000', 'the magnitude of 7')
    end subroutine check_sums

    !> Products.
    subroutine check_products()
        call pattern(whole(3)*whole(5), '41F0000000000000', '3 times 5')
        call pattern(whole(-4)*whole(4), 'C210000000000000', '-4 times 4')
        call pattern(whole(-4)*whole(-4), '4210000000000000', '-4 times -4')
        ! .8 * .1 = .08, one place left
        call pattern(word('4080000000000000')*word('4010000000000000'), '3F80000000000000', &
            'a product with a leading zero is normalised')
        ! (1 - 16**-14)**2 = 1 - 2*16**-14 + 16**-28 = .FFFFFFFFFFFFFE 00000000000001
        call pattern(word('40FFFFFFFFFFFFFF')*word('40FFFFFFFFFFFFFF'), '40FFFFFFFFFFFFFE', &
            'the lower 14 digits of a product are cut')
        ! .10000000000001 * .18 = .018000000000018: one place left brings in the 15th digit
        call pattern(word('4010000000000001')*word('4018000000000000'), '3F18000000000001', &
            'normalising a product brings in a digit of its lower half')
        call pattern(whole(0)*whole(-7), '0000000000000000', 'zero times anything is true zero')
    end subroutine check_products

    !> Quotients.
    subroutine check_quotients()
        call pattern(one/whole(3), '4055555555555555', 'a third')
        call pattern(whole(2)/whole(3), '40AAAAAAAAAAAAAA', 'two thirds are cut')
        call pattern(whole(-2)/whole(3), 'C0AAAAAAAAAAAAAA', &
            'minus two thirds are cut towards zero')
        call pattern(one/whole(10), '4019999999999999', 'a tenth')
        call pattern(whole(100)/whole(10), '41A0000000000000', '100/10')
        call pattern(whole(7)/whole(7), '4110000000000000', 'x/x is 1')
        call pattern(whole(0)/whole(-7), '0000000000000000', 'zero divided is true zero')
        ! 1/(1 - 16**-14) = 1 + 16**-14 + ..., the 16**-14 beyond the 14th digit
        call pattern(one/word('40FFFFFFFFFFFFFF'), '4110000000000000', 'a quotient just above 1')
    end subroutine check_quotients

    !> Roots: of 2 1.6A09E667..., of a half .B504F333..., of 3 1.BB67AE85...
    subroutine check_roots()
        call pattern(short_sqrt(whole(4)), '4120000000000000', 'root of 4')
        call pattern(short_sqrt(whole(256)), '4210000000000000', 'root of 256')
        call pattern(short_sqrt(whole(2)), '4116A09E00000000', 'root of 2 to 6 digits')
        call pattern(short_sqrt(whole(3)), '411BB67A00000000', 'root of 3 is cut, not rounded')
        call pattern(short_sqrt(word('4080000000000000')), '40B504F300000000', 'root of a half')
        call pattern(short_sqrt(word('41100000FFFFFFFF')), '4110000000000000', &
            'root of 1.00000FF: only 6 digits are seen')
        call pattern(short_sqrt(word('41FFFFFFFFFFFFFF')), '413FFFFF00000000', &
            'root of just below 16')
        call pattern(short_sqrt(whole(0)), '0000000000000000', 'root of zero')
        call pattern(short_sqrt(smallest), '2040000000000000', 'root of 16**-65 is 4 times 16**-33')
        call pattern(short_sqrt(largest), '603FFFFF00000000', &
            'root of just below 16**63 is just below 4 times 16**31')
    end subroutine check_roots

    !> Overflow, underflow, division by zero; the first one stays.
    subroutine check_traps()
        type(hex_type) :: over, under, zero_divide

        over = largest + largest
        call tap%ok(over%trap == cause%overflow, 'a carry out of the largest word overflows')
        over = largest*whole(2)
        call tap%ok(over%trap == cause%overflow, 'a product overflows')
        over = word('6010000000000000')*word('6010000000000000')
        call pattern(over, '7F10000000000000', '16**31 squared is 16**62')
        call tap%ok(over%trap == 0, &
            'a product that normalising brings into range does not overflow')
        over = largest/word('4010000000000000')
        call tap%ok(over%trap == cause%overflow, 'a quotient overflows')
        under = smallest*word('4010000000000000')
        call tap%ok(under%trap == cause%underflow .and. is_zero(under), &
            'a product underflows to true zero')
        under = smallest/whole(16)
        call tap%ok(under%trap == cause%underflow .and. is_zero(under), &
            'a quotient underflows to true zero')
        under = word('0010000000000001') - smallest
        call tap%ok(under%trap == cause%underflow .and. is_zero(under), 'a difference underflows')
        under = smallest - smallest
        call tap%ok(under%trap == 0, 'a difference of nothing does not underflow')
        under = whole(0)*smallest
        call tap%ok(under%trap == 0, 'zero times the smallest word does not underflow')
        zero_divide = one/whole(0)
        call tap%ok(zero_divide%trap == cause%divide, 'division by zero')
        zero_divide = whole(0)/whole(0)
        call tap%ok(zero_divide%trap == cause%divide, 'zero by zero')
        over = whole(0)*(largest + largest) + one
        call tap%ok(over%trap == cause%overflow, &
            'a trap outlives multiplication by zero and addition')
        over = (largest*largest)/whole(0)
        call tap%ok(over%trap == cause%overflow, 'the first trap stays')
        over = -abs(short_sqrt(one - (one/whole(0))))
        call tap%ok(over%trap == cause%divide, &
            'a trap passes through difference, root, magnitude and sign')
        over = whole(0) + (smallest*smallest)
        call tap%ok(over%trap == cause%underflow, 'a trap passes through a sum with zero')
    end subroutine check_traps

end program test_arithmetic
