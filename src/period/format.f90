!> F output of the 1970 page, worked exactly in whole numbers:
!>
!> - rounded half away from zero, whatever digits binary would have dropped;
!> - an exact zero is `0.0`, the point in its place and the further decimals blank;
!> - a figure below zero that rounds to zero has no minus;
!> - a zero stands before the point where there is no other digit;
!> - a figure wider than its field is all asterisks.
!>
!> Source: the printed page of SAE 700202, appendix B.
module period_format
    use base_kinds, only: i128, i64
    use period_word, only: hex_type, is_zero, long_digits
    implicit none (type, external)
    private

    public :: fixed, put_fixed

    !> Widest field.
    integer, parameter, public :: most_width = 17
    !> Most decimals: scaled by them a fraction of 56 bits stays within 96.
    integer, parameter, public :: most_decimals = 12

    !> Powers of ten, `ten_to(k)` is 10**k.
    integer(i64), parameter :: ten_to(0:most_width - 1) = &
        10_i64**int([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16], i64)
    !> What is printed where there is no room.
    character(*), parameter :: asterisks = '*****************'

    !> Shifts beyond this leave nothing of a scaled fraction, not even after rounding.
    integer, parameter :: most_shift = 120

contains

    !> A word in an F field.
    pure function fixed(word, width, decimals) result(text)
        type(hex_type), intent(in) :: word !! any word
        integer, intent(in) :: width       !! columns, up to `most_width`
        integer, intent(in) :: decimals    !! digits after the point, up to `most_decimals`
        character(width) :: text
        call put_fixed(word, decimals, text)
    end function fixed

    !> Writes a word into a field as wide as it is.
    pure subroutine put_fixed(word, decimals, field)
        type(hex_type), intent(in) :: word      !! any word
        integer, intent(in) :: decimals         !! digits after the point, up to `most_decimals`
        character(*), intent(out) :: field      !! up to `most_width` columns
        integer(i128) :: scaled

        if (is_zero(word)) then
            call put_zero(decimals, field)
            return
        end if
        scaled = scaled_magnitude(word, decimals)
        if (scaled >= int(ten_to(len(field) - 1), i128)) then
            field = asterisks
        else
            call put_digits(int(scaled, i64), word%fraction < 0, decimals, field)
        end if
    end subroutine put_fixed

    !> Writes an exact zero: `0.0`, the point in its place.
    pure subroutine put_zero(decimals, field)
        integer, intent(in) :: decimals     !! digits after the point
        character(*), intent(out) :: field  !! as `put_fixed`
        integer :: point

        point = len(field) - decimals
        field = ''
        if (point < 2) then
            field = asterisks
        else if (decimals == 0) then
            field(point - 1:) = '0.'
        else
            field(point - 1:) = '0.0'
        end if
    end subroutine put_zero

    !> `abs(word)*10**decimals`, rounded half up; the largest integer where no field holds it.
    pure integer(i128) function scaled_magnitude(word, decimals) result(scaled)
        type(hex_type), intent(in) :: word !! any word
        integer, intent(in) :: decimals    !! digits after the point
        integer :: shift

        shift = 4*(long_digits - word%exponent)
        scaled = merge(huge(scaled), 0_i128, shift < 0)
        if (shift < 0 .or. shift > most_shift) return
        scaled = int(abs(word%fraction), i128)*int(ten_to(decimals), i128)
        if (shift > 0) scaled = shiftr(scaled + shiftl(1_i128, shift - 1), shift)
    end function scaled_magnitude

    !> Writes digits with their point and sign, or asterisks where the field is too narrow.
    pure subroutine put_digits(scaled, negative, decimals, field)
        integer(i64), intent(in) :: scaled  !! the digits without their point, not negative
        logical, intent(in) :: negative     !! true for a number below zero
        integer, intent(in) :: decimals     !! digits after the point
        character(*), intent(out) :: field  !! as `put_fixed`
        character(most_width + 2) :: text
        integer(i64) :: left
        integer :: column

        text = ''
        left = scaled
        column = len(text)
        do while (left > 0 .or. column >= len(text) - decimals - 1)
            if (column == len(text) - decimals) then
                text(column:column) = '.'
            else
                text(column:column) = achar(iachar('0') + int(modulo(left, 10_i64)))
                left = left/10
            end if
            column = column - 1
        end do
        if (negative .and. scaled > 0) then
            text(column:column) = '-'
            column = column - 1
        end if
        if (len(text) - column > len(field)) then
            field = asterisks
        else
            field = text(len(text) - len(field) + 1:)
        end if
    end subroutine put_digits

end module period_format
