!> Decimal to hexadecimal: what a punched number or a constant is in a System/360 word, truncated.
!> Worked exactly, in a whole number of as many limbs of 7 hexadecimal digits as it takes.
module period_convert
    use base_decimal, only: decimal_type
    use base_error, only: cause
    use base_kinds, only: i128, i64
    use period_word, only: hex_type, long_digits, normalised, single
    implicit none (type, external)
    private

    public :: from_decimal, single_constant

    !> From this power of ten on every whole number overflows: 16**63 is 7.2e75.
    integer, parameter :: overflow_power = 76
    !> From this power of ten down every number of 19 digits underflows: 16**-65 is 5.4e-79.
    integer, parameter :: underflow_power = -98

    !> Hexadecimal digits of a limb.
    integer, parameter :: limb_digits = 7
    !> One more than the largest limb.
    integer(i64), parameter :: radix = shiftl(1_i64, 4*limb_digits)
    !> Limbs enough for 16 digits above a point and, below it, 15 and as many as `underflow_power`.
    integer, parameter :: most_limbs = 20
    !> Powers of ten taken at a time: radix*10**9 is well inside 63 bits.
    integer, parameter :: chunk = 9

    !> A whole number, `sum of limb(i)*radix**(i - 1)`.
    type :: large_type
        integer :: used = 0                   !! limbs in use, the highest one not zero
        integer(i64) :: limb(most_limbs) = 0  !! each 0 to radix - 1
    end type large_type

contains

    !> The word of a decimal, truncated to 14 hexadecimal digits. Traps on overflow and underflow.
    elemental type(hex_type) function from_decimal(decimal) result(word)
        type(decimal_type), intent(in) :: decimal !! any decimal
        type(large_type) :: large
        integer :: lowered

        if (decimal%digits == 0) return
        if (decimal%power >= overflow_power) then
            word%trap = cause%overflow
        else if (decimal%power <= underflow_power) then
            word%trap = cause%underflow
        else if (decimal%power >= 0) then
            large = new_large(abs(decimal%digits), 0)
            call multiply(large, decimal%power)
            word = leading_word(large, 0, decimal%digits < 0)
        else
            lowered = (long_digits + 1 - decimal%power)/limb_digits + 1
            large = new_large(abs(decimal%digits), lowered)
            call divide(large, -decimal%power)
            word = leading_word(large, lowered, decimal%digits < 0)
        end if
    end function from_decimal

    !> A constant written in single precision: truncated to 6 hexadecimal digits.
    elemental type(hex_type) function single_constant(decimal) result(word)
        type(decimal_type), intent(in) :: decimal !! any decimal
        word = single(from_decimal(decimal))
    end function single_constant

    !> A whole number times a power of the radix.
    pure type(large_type) function new_large(number, zeros) result(large)
        integer(i64), intent(in) :: number !! above zero
        integer, intent(in) :: zeros       !! limbs of zero below it
        integer(i64) :: rest

        large%used = zeros
        rest = number
        do while (rest > 0)
            large%used = large%used + 1
            large%limb(large%used) = modulo(rest, radix)
            rest = rest/radix
        end do
    end function new_large

    !> Multiplies by a power of ten.
    pure subroutine multiply(large, power)
        type(large_type), intent(inout) :: large !! the number
        integer, intent(in) :: power             !! power of ten, 0 or more
        integer(i64) :: factor, carry
        integer :: i, left

        left = power
        do while (left > 0)
            factor = 10_i64**int(min(left, chunk), i64)
            carry = 0
            do i = 1, large%used
                carry = carry + large%limb(i)*factor
                large%limb(i) = modulo(carry, radix)
                carry = carry/radix
            end do
            do while (carry > 0)
                large%used = large%used + 1
                large%limb(large%used) = modulo(carry, radix)
                carry = carry/radix
            end do
            left = left - chunk
        end do
    end subroutine multiply

    !> Divides by a power of ten and drops the remainder; quotients cut one after the other are the
    !> quotient of all, cut.
    pure subroutine divide(large, power)
        type(large_type), intent(inout) :: large !! the number
        integer, intent(in) :: power             !! power of ten, 0 or more
        integer(i64) :: divisor, rest
        integer :: i, left

        left = power
        do while (left > 0)
            divisor = 10_i64**int(min(left, chunk), i64)
            rest = 0
            do i = large%used, 1, -1
                rest = rest*radix + large%limb(i)
                large%limb(i) = rest/divisor
                rest = modulo(rest, divisor)
            end do
            left = left - chunk
        end do
        do while (large%limb(large%used) == 0)
            large%used = large%used - 1
        end do
    end subroutine divide

    !> The word of `large/radix**lowered`: its first 15 digits out of its first three limbs, and its
    !> power of 16.
    pure type(hex_type) function leading_word(large, lowered, negative) result(word)
        type(large_type), intent(in) :: large !! not zero
        integer, intent(in) :: lowered        !! power of the radix to take off
        logical, intent(in) :: negative       !! true for a number below zero
        integer(i128) :: first
        integer(i64) :: digits
        integer :: i, in_limb

        first = 0
        do i = large%used, large%used - 2, -1
            first = shiftl(first, 4*limb_digits)
            if (i >= 1) first = first + int(large%limb(i), i128)
        end do
        in_limb = limb_digits - (leadz(large%limb(large%used)) - leadz(radix) - 1)/4
        digits = int(shiftr(first, 4*(in_limb - 1)), i64)
        if (negative) digits = -digits
        word = normalised(digits, in_limb + limb_digits*(large%used - 1 - lowered), 0)
    end function leading_word

end module period_convert
