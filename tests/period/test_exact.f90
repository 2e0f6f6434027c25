!> System/360 arithmetic on random words against whole numbers of 128 bits, where sums, products,
!> quotients and squares are exact.
program test_exact
    use base_kinds, only: dp, i128, i64
    use period_arithmetic, only: abs, operator(*), operator(+), operator(-), operator(/), short_sqrt
    use period_word, only: bits, from_bits, hex_type
    use support_tap, only: tap_type
    implicit none (type, external)

    integer, parameter :: trials = 20000
    type(tap_type) :: tap

    call random_init(.true., .true.)
    call check_random_sums()
    call check_random_products()
    call check_random_quotients()
    call check_random_roots()
    call tap%finish()

contains

    !> A random word: 14 random digits, the first not zero, a power of 16 between two.
    type(hex_type) function random_word(least, most) result(a)
        integer, intent(in) :: least, most
        real(dp) :: r(4)
        integer(i64) :: stored
        call random_number(r)
        stored = int(1.0_dp + 15.0_dp*r(1), i64)*16_i64**13 + int(r(2)*2.0_dp**26, i64)*2_i64**26 &
            + int(r(3)*2.0_dp**26, i64)
        stored = stored + int(64 + least + int(real(most - least + 1, dp)*r(4)), i64)*2_i64**56
        call random_number(r)
        if (r(1) < 0.5_dp) stored = ibset(stored, 63)
        a = from_bits(stored)
    end function random_word

    !> True where a word is an exact whole number over 16**below, cut to 14 digits.
    logical function is_cut(a, exact, below)
        type(hex_type), intent(in) :: a
        integer(i128), intent(in) :: exact
        integer, intent(in) :: below
        integer(i128) :: rest
        integer :: places

        if (exact == 0) then
            is_cut = bits(a) == 0
            return
        end if
        rest = abs(exact)
        places = 0
        do while (rest >= 16_i128**14_i128)
            rest = rest/16_i128
            places = places + 1
        end do
        do while (rest < 16_i128**13_i128)
            rest = rest*16_i128
            places = places - 1
        end do
        is_cut = abs(int(a%fraction, i128)) == rest .and. (a%fraction < 0 .eqv. exact < 0) &
            .and. a%exponent == 14 + places - below
    end function is_cut

    !> Sums of like sign are the exact sum cut; of unlike sign too where the exponents differ by one
    !> at most; else what lies below the guard digit is dropped first.
    subroutine check_random_sums()
        type(hex_type) :: a, b
        integer(i128) :: high, low, unit
        integer :: i, apart, wrong(3)

        wrong = 0
        do i = 1, trials
            a = random_word(0, 13)
            b = random_word(0, 13)
            if (b%exponent > a%exponent) call swap(a, b)
            apart = a%exponent - b%exponent
            high = int(a%fraction, i128)*16_i128**int(apart, i128)
            low = int(b%fraction, i128)
            if ((a%fraction < 0 .eqv. b%fraction < 0) .or. apart <= 1) then
                if (.not. is_cut(a + b, high + low, 14 - b%exponent)) wrong(1) = wrong(1) + 1
            else
                unit = 16_i128**int(apart - 1, i128)
                low = (low/unit)*unit
                if (.not. is_cut(a + b, high + low, 14 - b%exponent)) wrong(2) = wrong(2) + 1
            end if
            if (bits(a + b) /= bits(b + a)) wrong(3) = wrong(3) + 1
            if (bits(a - b) /= bits(-(b - a))) wrong(3) = wrong(3) + 1
        end do
        call tap%ok(wrong(1) == 0, &
            'random sums that need no more than a guard digit are the exact sum cut')
        call tap%ok(wrong(2) == 0, 'random differences are exact to the guard digit')
        call tap%ok(wrong(3) == 0, 'sums commute and differences turn their sign')
    end subroutine check_random_sums

    !> Changes places.
    subroutine swap(a, b)
        type(hex_type), intent(inout) :: a, b
        type(hex_type) :: kept
        kept = a
        a = b
        b = kept
    end subroutine swap

    !> Products are the exact product cut.
    subroutine check_random_products()
        type(hex_type) :: a, b
        integer :: i, wrong

        wrong = 0
        do i = 1, trials
            a = random_word(-30, 30)
            b = random_word(-30, 30)
            if (.not. is_cut(a*b, int(a%fraction, i128)*int(b%fraction, i128), &
                28 - a%exponent - b%exponent)) wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, 'random products are the exact product cut')
    end subroutine check_random_products

    !> A quotient times the divisor is the dividend or below; one more in the last digit: above.
    subroutine check_random_quotients()
        type(hex_type) :: a, b, q
        integer(i128) :: dividend, divisor, quotient
        integer :: i, wrong

        wrong = 0
        do i = 1, trials
            a = random_word(-30, 30)
            b = random_word(-30, 30)
            q = a/b
            quotient = int(abs(q%fraction), i128)
            divisor = int(abs(b%fraction), i128)
            dividend = int(abs(a%fraction), i128) &
                *16_i128**int(14 + a%exponent - b%exponent - q%exponent, i128)
            if (quotient*divisor > dividend .or. (quotient + 1_i128)*divisor <= dividend .or. &
                (q%fraction < 0 .neqv. (a%fraction < 0 .neqv. b%fraction < 0))) wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, 'random quotients are the exact quotient cut')
    end subroutine check_random_quotients

    !> The square of a root of 6 digits is the 6 digits seen or below; of the next one, above.
    subroutine check_random_roots()
        type(hex_type) :: a, r
        integer(i128) :: root, seen
        integer :: i, wrong

        wrong = 0
        do i = 1, trials
            a = abs(random_word(-60, 60))
            r = short_sqrt(a)
            root = int(r%fraction/16_i64**8, i128)
            seen = int(a%fraction/16_i64**8, i128)*16_i128**int(6 + a%exponent - 2*r%exponent, i128)
            if (root*root > seen .or. (root + 1_i128)**2 <= seen .or. &
                modulo(r%fraction, 16_i64**8) /= 0 .or. root < 16_i128**5) wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, 'random roots are the exact root of 6 digits cut to 6 digits')
    end subroutine check_random_roots

end program test_exact
