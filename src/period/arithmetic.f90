!> What the System/360 does with long words: add, subtract, multiply, divide, all truncating, none
!> rounding; and the single precision SQRT that the program of SAE 700202 called with them.
!> A trap of an operand is passed on, the left one first.
!>
!> Source: IBM System/360 Principles of Operation, form A22-6821, floating-point arithmetic, with
!> the guard digit of long operations.
module period_arithmetic
    use base_error, only: cause
    use base_kinds, only: dp, i128, i64
    use period_word, only: hex_type, long_digits, normalised, short_digits
    implicit none (type, external)
    private

    public :: operator(+), operator(-), operator(*), operator(/), abs, short_sqrt

    interface operator(+)
        module procedure add
    end interface operator(+)

    interface operator(-)
        module procedure subtract, negate
    end interface operator(-)

    interface operator(*)
        module procedure multiply
    end interface operator(*)

    interface operator(/)
        module procedure divide
    end interface operator(/)

    interface abs
        module procedure magnitude
    end interface abs

contains

    !> The sum: the smaller exponent is raised to the larger, its fraction shifted right keeping one
    !> guard digit; then added, and normalised with the guard digit.
    elemental type(hex_type) function add(a, b)
        type(hex_type), intent(in) :: a !! any word
        type(hex_type), intent(in) :: b !! any word
        integer :: common

        if (b%fraction == 0) then
            add = a
            add%trap = first_trap(a, b)
        else if (a%fraction == 0) then
            add = b
            add%trap = first_trap(a, b)
        else
            common = max(a%exponent, b%exponent)
            add = normalised(guarded(a, common) + guarded(b, common), common, first_trap(a, b))
        end if
    end function add

    !> The difference: the sum with the sign of the second operand turned.
    elemental type(hex_type) function subtract(a, b)
        type(hex_type), intent(in) :: a !! any word
        type(hex_type), intent(in) :: b !! any word
        subtract = add(a, negate(b))
    end function subtract

    !> The word with its sign turned; true zero stays true zero.
    elemental type(hex_type) function negate(a)
        type(hex_type), intent(in) :: a !! any word
        negate = a
        negate%fraction = -a%fraction
    end function negate

    !> The product: all 28 digits of it, normalised, the first 14 kept.
    elemental type(hex_type) function multiply(a, b)
        type(hex_type), intent(in) :: a !! any word
        type(hex_type), intent(in) :: b !! any word
        integer(i128) :: product
        integer(i64) :: digits

        product = int(abs(a%fraction), i128)*int(abs(b%fraction), i128)
        digits = int(shiftr(product, 4*(long_digits - 1)), i64)
        if (a%fraction < 0 .neqv. b%fraction < 0) digits = -digits
        multiply = normalised(digits, a%exponent + b%exponent, first_trap(a, b))
    end function multiply

    !> The quotient: its first 14 digits. Division by zero traps and leaves the dividend.
    elemental type(hex_type) function divide(a, b)
        type(hex_type), intent(in) :: a !! any word
        type(hex_type), intent(in) :: b !! any word
        integer(i64) :: digits

        if (b%fraction == 0) then
            divide = a
            divide%trap = first_trap(a, b)
            if (divide%trap == 0) divide%trap = cause%divide
            return
        end if
        digits = int(shiftl(int(abs(a%fraction), i128), 4*long_digits) &
            /int(abs(b%fraction), i128), i64)
        if (a%fraction < 0 .neqv. b%fraction < 0) digits = -digits
        divide = normalised(digits, a%exponent - b%exponent + 1, first_trap(a, b))
    end function divide

    !> The word without its sign.
    elemental type(hex_type) function magnitude(a)
        type(hex_type), intent(in) :: a !! any word
        magnitude = a
        magnitude%fraction = abs(a%fraction)
    end function magnitude

    !> The single precision SQRT handed a double: it sees 6 digits and gives 6 truncated digits. The
    !> sign is not looked at.
    !>
    !> The fraction is made a whole number of 11 or 12 digits, so that the power of 16 left is even.
    !> Its root in binary64 is good to 2**-53, and below a perfect square of 48 bits the root is at
    !> least 2**-49 short of whole, relatively: so the whole part is exact.
    elemental type(hex_type) function short_sqrt(a)
        type(hex_type), intent(in) :: a !! any word
        integer(i64) :: seen, root
        integer :: odd

        odd = modulo(a%exponent, 2)
        seen = shiftr(abs(a%fraction), 4*(long_digits - short_digits))
        root = int(sqrt(real(shiftl(seen, 4*(short_digits - odd)), dp)), i64)
        short_sqrt = normalised(shiftl(root, 4*(long_digits + 1 - short_digits)), &
            (a%exponent + odd)/2, a%trap)
    end function short_sqrt

    !> The fraction of a word shifted right to a common exponent, with its guard digit.
    elemental integer(i64) function guarded(a, common) result(digits)
        type(hex_type), intent(in) :: a !! any word
        integer, intent(in) :: common   !! power of 16, that of the word or more
        integer :: shift

        shift = 4*(common - a%exponent)
        digits = 0
        if (shift < 64) digits = sign(shiftr(shiftl(abs(a%fraction), 4), shift), a%fraction)
    end function guarded

    !> The trap of an operation: that of the left operand, else that of the right one.
    elemental integer function first_trap(a, b) result(trap)
        type(hex_type), intent(in) :: a !! left operand
        type(hex_type), intent(in) :: b !! right operand
        trap = merge(a%trap, b%trap, a%trap /= 0)
    end function first_trap

end module period_arithmetic
