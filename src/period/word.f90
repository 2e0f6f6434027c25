!> A System/360 long floating word: sign, power of 16, fraction of 14 hexadecimal digits.
!>
!>     bit  0       sign, 1 is minus
!>     bits 1-7     characteristic: the power of 16 plus 64
!>     bits 8-63    fraction, hexadecimal point before its first digit, which is not zero
!>
!> Kept as integers. Source: IBM System/360 Principles of Operation, form A22-6821, floating-point
!> arithmetic; what the program of SAE 700202 saw of it was checked against its printed tables.
module period_word
    use base_error, only: cause
    use base_kinds, only: dp, i64
    implicit none (type, external)
    private

    public :: hex_type, normalised, whole, single, bits, from_bits, to_real
    public :: is_zero, is_positive, is_negative

    !> Hexadecimal digits of a fraction.
    integer, parameter, public :: long_digits = 14
    !> Hexadecimal digits of a single precision fraction.
    integer, parameter, public :: short_digits = 6
    !> Smallest power of 16.
    integer, parameter, public :: least_exponent = -64
    !> Largest power of 16.
    integer, parameter, public :: most_exponent = 63

    !> Added to the power of 16 to make the characteristic.
    integer, parameter :: excess = 64
    !> Bits of a fraction.
    integer, parameter :: fraction_bits = 4*long_digits
    !> A fraction of ones.
    integer(i64), parameter :: fraction_mask = 2_i64**fraction_bits - 1_i64

    !> The number `fraction/16**14 * 16**exponent`, always normalised; zero is true zero, all zeros.
    !> Only `normalised` makes words, so that this holds.
    type :: hex_type
        integer(i64) :: fraction = 0 !! signed, 14 hexadecimal digits
        integer :: exponent = 0      !! power of 16, -64 to 63
        integer :: trap = 0          !! 0, or what first interrupted: `cause%overflow`, ...
    end type hex_type

    interface to_real
        module procedure word_to_real
    end interface to_real

    interface is_zero
        module procedure is_zero_word
    end interface is_zero

contains

    !> The word `digits/16**15 * 16**exponent`: shifted left until its first
    !> digit is not zero, or right where there was a carry, and cut to 14 digits.
    !>
    !> Overflow traps and leaves the largest exponent; underflow traps and leaves true zero.
    elemental function normalised(digits, exponent, trap) result(word)
        integer(i64), intent(in) :: digits !! signed, up to 16 digits: carry, 14 of fraction, guard
        integer, intent(in) :: exponent    !! power of 16
        integer, intent(in) :: trap        !! of the operands; it wins over one that comes now
        type(hex_type) :: word
        integer :: leading_zeros

        word%trap = trap
        if (digits == 0) return
        leading_zeros = leadz(abs(digits))/4 - 1
        word%fraction = sign(ishft(abs(digits), 4*(leading_zeros - 1)), digits)
        word%exponent = exponent - leading_zeros
        if (word%exponent > most_exponent) then
            word%exponent = most_exponent
            if (trap == 0) word%trap = cause%overflow
        else if (word%exponent < least_exponent) then
            word = hex_type(trap=merge(trap, cause%underflow, trap /= 0))
        end if
    end function normalised

    !> A whole number as a word, exactly.
    elemental type(hex_type) function whole(number)
        integer, intent(in) :: number !! any whole number
        whole = normalised(int(number, i64), long_digits + 1, 0)
    end function whole

    !> A word cut to the 6 digits of single precision.
    elemental type(hex_type) function single(word)
        type(hex_type), intent(in) :: word !! any word
        integer, parameter :: cut = 4*(long_digits - short_digits)
        single = word
        single%fraction = sign(ishft(ishft(abs(word%fraction), -cut), cut), word%fraction)
    end function single

    !> The 64 bits of a word as they stand in storage.
    elemental integer(i64) function bits(word)
        type(hex_type), intent(in) :: word !! any word
        bits = 0
        if (word%fraction == 0) return
        bits = ior(ishft(int(word%exponent + excess, i64), fraction_bits), abs(word%fraction))
        if (word%fraction < 0) bits = ibset(bits, 63)
    end function bits

    !> The word that 64 bits of storage hold; one that is not normalised becomes so.
    elemental type(hex_type) function from_bits(pattern) result(word)
        integer(i64), intent(in) :: pattern !! any 64 bits
        integer(i64) :: digits
        integer :: characteristic

        digits = ishft(iand(pattern, fraction_mask), 4)
        if (btest(pattern, 63)) digits = -digits
        characteristic = int(ibits(pattern, fraction_bits, 7))
        word = normalised(digits, characteristic - excess, 0)
    end function from_bits

    !> The double nearest to a word.
    elemental real(dp) function word_to_real(word) result(x)
        type(hex_type), intent(in) :: word !! any word
        x = scale(real(word%fraction, dp), 4*(word%exponent - long_digits))
    end function word_to_real

    !> True for true zero.
    elemental logical function is_zero_word(word)
        type(hex_type), intent(in) :: word !! any word
        is_zero_word = word%fraction == 0
    end function is_zero_word

    !> True for a word above zero.
    elemental logical function is_positive(word)
        type(hex_type), intent(in) :: word !! any word
        is_positive = word%fraction > 0
    end function is_positive

    !> True for a word below zero.
    elemental logical function is_negative(word)
        type(hex_type), intent(in) :: word !! any word
        is_negative = word%fraction < 0
    end function is_negative

end module period_word
