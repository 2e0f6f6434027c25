!> Whole numbers as decimal figures in the columns of a line, eight figures at a time and without a
!> branch for each: the eight are worked side by side in one 64-bit word, a byte a figure, the first
!> figure in the lowest byte, which is the byte that stands first in memory.
!>
!> Source: K. Willets, "SIMD-within-a-register decimal conversion" (2016): halves of a number are
!> split by a multiplication and a shift that divide all of them at a time.
module base_figures
    use base_kinds, only: i64
    implicit none (type, external)
    private

    public :: put_units, put_whole, put_padded, put_text, figure_count

    !> Figures worked at a time, and 10**8.
    integer, parameter :: eight = 8
    integer(i64), parameter :: ten_to_eight = 100000000_i64
    !> Columns before the point that `put_units` fills, and with the point.
    integer, parameter, public :: columns_before_point = eight
    !> Most decimals of `put_units`.
    integer, parameter, public :: most_decimals = 12
    !> Powers of ten.
    integer(i64), parameter, public :: ten_to(0:18) = 10_i64**int([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, &
        10, 11, 12, 13, 14, 15, 16, 17, 18], i64)

    !> `0` in each byte; the bit of `0` that a blank has not, in each byte.
    integer(i64), parameter :: zeros = int(z'3030303030303030', i64)
    integer(i64), parameter :: not_blank = int(z'1010101010101010', i64)
    !> What makes a minus of a blank.
    integer(i64), parameter :: minus_less_blank = int(iachar('-') - iachar(' '), i64)
    !> Eight characters, to give a word their shape.
    character(eight), parameter :: shape_of_word = ' '

contains

    !> Writes a number given in units of its last decimal, so that it ends in column `last`. At
    !> least `columns_before_point` columns before the point are filled, with blanks in front, and
    !> a larger number fills more; the line must have them.
    pure subroutine put_units(units, is_negative, decimals, line, last)
        integer(i64), intent(in) :: units       !! not negative
        logical, intent(in) :: is_negative      !! a minus stands before the figures
        integer, intent(in) :: decimals         !! figures behind the point, to `most_decimals`
        character(*), intent(inout) :: line     !! gets the figures
        integer, intent(in) :: last             !! column of the last figure, `decimals` + 9 or more
        integer(i64) :: whole, part, upper

        select case (decimals)
        case (4)
            whole = units/ten_to(4)
            part = units - whole*ten_to(4)
        case (6)
            whole = units/ten_to(6)
            part = units - whole*ten_to(6)
        case default
            whole = units/ten_to(decimals)
            part = units - whole*ten_to(decimals)
        end select
        if (decimals > eight) then
            upper = part/ten_to_eight
            call put_eight(upper, line, last - eight)
            part = part - upper*ten_to_eight
        end if
        call put_eight(part, line, last)
        line(last - decimals:last - decimals) = '.'
        call put_front(whole, is_negative, line, last - decimals - 1)
    end subroutine put_units

    !> Writes eight figures, zeros in front.
    pure subroutine put_eight(number, line, last)
        integer(i64), intent(in) :: number  !! 0 to 99999999
        character(*), intent(inout) :: line !! gets the figures
        integer, intent(in) :: last         !! column of the last one, 8 or more
        line(last - 7:last) = transfer(eight_figures(number) + zeros, shape_of_word)
    end subroutine put_eight

    !> Writes a number with its sign, blanks in front: eight columns, or as many as it needs.
    pure subroutine put_front(number, is_negative, line, last)
        integer(i64), intent(in) :: number      !! not negative
        logical, intent(in) :: is_negative      !! a minus stands before the figures
        character(*), intent(inout) :: line     !! gets the figures
        integer, intent(in) :: last             !! column of the last figure, 8 or more
        integer(i64) :: word, rest
        integer :: blanks, column

        rest = number
        column = last
        do while (rest >= ten_to_eight)
            call put_eight(mod(rest, ten_to_eight), line, column)
            rest = rest/ten_to_eight
            column = column - eight
        end do
        word = eight_figures(rest)
        blanks = leading_zeros(word)
        word = ieor(word + zeros, iand(not_blank, maskr(eight*blanks, i64)))
        if (is_negative .and. blanks > 0) then
            word = word + shiftl(minus_less_blank, eight*(blanks - 1))
        end if
        if (column >= eight) then
            line(column - 7:column) = transfer(word, shape_of_word)
        else
            call put_last_of(transfer(word, shape_of_word), line(:column))
        end if
        if (is_negative .and. blanks == 0) line(column - eight:column - eight) = '-'
    end subroutine put_front

    !> Fills a field with the end of a text.
    pure subroutine put_last_of(text, field)
        character(*), intent(in) :: text        !! no shorter than the field
        character(*), intent(inout) :: field    !! gets it
        field = text(len(text) - len(field) + 1:)
    end subroutine put_last_of

    !> Writes a number in as few columns as it needs, from a column on.
    pure subroutine put_whole(number, line, next)
        integer(i64), intent(in) :: number  !! not negative
        character(*), intent(inout) :: line !! gets the figures
        integer, intent(inout) :: next      !! the first column; behind the last on return
        integer :: count
        count = figure_count(number)
        call put_padded(number, line(next:next + count - 1))
        next = next + count
    end subroutine put_whole

    !> Fills a field with a number, zeros in front.
    pure subroutine put_padded(number, field)
        integer(i64), intent(in) :: number      !! not negative, no longer than the field
        character(*), intent(inout) :: field    !! of 24 columns at most; gets the figures
        character(3*eight) :: text
        integer(i64) :: upper

        upper = number/ten_to_eight
        call put_eight(number - upper*ten_to_eight, text, 3*eight)
        if (len(field) > eight) call put_eight(mod(upper, ten_to_eight), text, 2*eight)
        if (len(field) > 2*eight) call put_eight(upper/ten_to_eight, text, eight)
        field = text(len(text) - len(field) + 1:)
    end subroutine put_padded

    !> Writes a text, from a column on.
    pure subroutine put_text(text, line, next)
        character(*), intent(in) :: text    !! any text
        character(*), intent(inout) :: line !! gets it
        integer, intent(inout) :: next      !! the first column; behind the last on return
        line(next:next + len(text) - 1) = text
        next = next + len(text)
    end subroutine put_text

    !> Eight figures as the bytes of a word, 0 to 9 each, the first in the lowest.
    elemental integer(i64) function eight_figures(number) result(word)
        integer(i64), intent(in) :: number !! 0 to 99999999
        integer(i64), parameter :: pairs = int(z'0000007f0000007f', i64)
        integer(i64), parameter :: singles = int(z'000f000f000f000f', i64)
        integer(i64) :: upper

        upper = number/ten_to(4)
        word = upper + shiftl(number - ten_to(4)*upper, 32)
        ! 10486/2**20 is a hundredth and 103/2**10 a tenth, nearly enough for 4 and for 2 figures.
        upper = iand(shiftr(word*10486_i64, 20), pairs)
        word = upper + shiftl(word - 100_i64*upper, 16)
        upper = iand(shiftr(word*103_i64, 10), singles)
        word = upper + shiftl(word - 10_i64*upper, 8)
    end function eight_figures

    !> How many of eight figures are zeros in front; the last figure is not counted.
    elemental integer function leading_zeros(word)
        integer(i64), intent(in) :: word !! from `eight_figures`
        leading_zeros = trailz(ior(word, shiftl(1_i64, 56)))/eight
    end function leading_zeros

    !> How many figures a number has, 1 for zero.
    elemental integer function figure_count(number) result(count)
        integer(i64), intent(in) :: number !! not negative
        ! 1233/2**12 is the logarithm of 2 nearly enough for 63 bits.
        count = shiftr((64 - leadz(ior(number, 1_i64)))*1233, 12)
        if (ior(number, 1_i64) >= ten_to(count)) count = count + 1
    end function figure_count

end module base_figures
