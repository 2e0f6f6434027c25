!> Small deeds on text that Fortran leaves out: case, numbers as words, lists.
!>
!> No function that threads may call has a result of deferred length (`character(:), allocatable`):
!> gfortran keeps that length in one place for all threads (`slen`, a static variable of the
!> caller), so that two of them may not call it from one line at the same time. So
!>
!> - a text whose length follows from the arguments has it declared (`to_text`);
!> - a text that is one of a few, or short, has a declared length that is enough, with blanks behind
!>   it, which whoever puts it in a sentence trims;
!> - a sentence of any length is the last argument of a subroutine, allocatable.
module base_text
    use base_exact, only: is_finite, is_zero
    use base_figures, only: figure_count
    use base_kinds, only: dp, i64
    implicit none (type, external)
    private

    public :: upper, to_text, compact, counted, columns, row_of, right, characters, first_bytes
    public :: limited, printable, compact_length

    !> Characters of `compact` at most.
    integer, parameter, public :: widest_compact = 16

    interface to_text
        module procedure integer_text, long_text
    end interface to_text

contains

    !> The same text with a-z made A-Z; other bytes stay.
    pure function upper(text) result(raised)
        character(*), intent(in) :: text !! any text
        character(len(text, i64)) :: raised
        integer :: i, letter
        raised = text
        do i = 1, len(text)
            letter = iachar(text(i:i))
            if (letter >= iachar('a') .and. letter <= iachar('z')) then
                raised(i:i) = achar(letter - 32)
            end if
        end do
    end function upper

    !> Columns of a card image, with blanks where it is shorter.
    pure function columns(image, first, last) result(text)
        character(*), intent(in) :: image !! any text
        integer, intent(in) :: first      !! first column, from 1
        integer, intent(in) :: last       !! last column
        character(max(int(last, i64) - int(first, i64) + 1_i64, 0_i64)) :: text
        text = ''
        if (first <= len(image)) text = image(first:min(last, len(image)))
    end function columns

    !> The same text with a `?` for every control byte, so that none reaches a printer.
    pure function printable(text) result(shown)
        character(*), intent(in) :: text !! any text
        character(len(text)) :: shown
        integer :: i
        shown = text
        do i = 1, len(text)
            if (iachar(text(i:i)) < 32 .or. iachar(text(i:i)) == 127) shown(i:i) = '?'
        end do
    end function printable

    !> The same text with another letter for every byte that is not among those it may have.
    pure function limited(text, letters, other) result(kept)
        character(*), intent(in) :: text    !! any text
        character(*), intent(in) :: letters !! bytes it may have
        character, intent(in) :: other      !! in place of any other
        character(len(text)) :: kept
        integer :: i
        kept = text
        do i = 1, len(text)
            if (verify(text(i:i), letters) > 0) kept(i:i) = other
        end do
    end function limited

    !> A character many times over; none where the count is not positive.
    pure function row_of(letter, count) result(text)
        character, intent(in) :: letter !! which
        integer, intent(in) :: count    !! how many
        character(max(int(count, i64), 0_i64)) :: text
        integer :: i
        do i = 1, count
            text(i:i) = letter
        end do
    end function row_of

    !> A text moved to the right end of its columns, or as it is where it needs more.
    pure function right(text, width) result(moved)
        character(*), intent(in) :: text !! any text; blanks around it do not count
        integer, intent(in) :: width     !! columns
        character(max(int(width, i64), len_trim(text, i64) - &
            max(verify(text, ' ', kind=i64) - 1_i64, 0_i64))) :: moved
        integer(i64) :: first, last
        first = max(verify(text, ' ', kind=i64), 1_i64)
        last = len_trim(text, i64)
        moved = ''
        moved(len(moved, i64) - (last - first):) = text(first:last)
    end function right

    !> Characters of a whole number.
    elemental integer(i64) function places(value)
        integer(i64), intent(in) :: value !! any whole number
        places = int(figure_count(abs(max(value, -huge(value)))), i64)
        if (value < 0) places = places + 1
    end function places

    !> A whole number in as few characters as it needs.
    pure function integer_text(value) result(text)
        integer, intent(in) :: value !! any whole number
        character(places(int(value, i64))) :: text
        text = long_text(int(value, i64))
    end function integer_text

    !> A long whole number in as few characters as it needs.
    pure function long_text(value) result(text)
        integer(i64), intent(in) :: value !! any whole number
        character(places(value)) :: text
        integer(i64) :: rest
        integer :: i

        ! Below zero there is one number more than above.
        rest = value
        if (value > 0) rest = -value
        do i = len(text), 1, -1
            text(i:i) = achar(iachar('0') - int(mod(rest, 10_i64)))
            rest = rest/10
        end do
        if (value < 0) text(1:1) = '-'
    end function long_text

    !> The text of `compact` with blanks behind it. What is no finite number is said as Fortran says
    !> it.
    pure function compact_field(value) result(text)
        real(dp), intent(in) :: value !! any
        character(widest_compact) :: text
        character(32) :: field
        integer :: power

        if (.not. is_finite(value)) then
            write (text, '(g0)') value
            return
        end if
        if (abs(value) < 1.0e7_dp .and. (abs(value) >= 1.0e-4_dp .or. is_zero(value))) then
            write (field, '(f0.6)') merge(0.0_dp, value, is_zero(value))
            power = len_trim(field) + 1
        else
            write (field, '(es15.5e3)') value
            field = adjustl(field)
            power = index(field, 'E')
            if (field(power + 2:power + 2) == '0') field(power + 2:) = field(power + 3:)
        end if
        text = field(:verify(field(:power - 1), '0', back=.true.))//trim(field(power:))
        if (text(1:1) == '.') text = '0'//text(:widest_compact - 1)
        if (index(text, '-.') == 1) text = '-0'//text(2:widest_compact - 1)
    end function compact_field

    !> Characters of `compact`.
    elemental integer(i64) function compact_length(value) result(length)
        real(dp), intent(in) :: value !! any
        length = len_trim(compact_field(value), i64)
    end function compact_length

    !> A number for a sentence: up to six decimals, or up to six figures and a power of ten, no
    !> zeros at the end (`12.5`, `-0.001`, `7.`, `3.E+20`).
    pure function compact(value) result(text)
        real(dp), intent(in) :: value !! any
        character(compact_length(value)) :: text
        text = compact_field(value)
    end function compact

    !> A count with its noun: `1 card`, `2 cards`.
    pure function counted(number, noun) result(text)
        integer(i64), intent(in) :: number !! how many
        character(*), intent(in) :: noun   !! what, in the singular; the plural adds an s
        character(places(number) + 1_i64 + len(noun, i64) + merge(0_i64, 1_i64, &
            number == 1_i64)) :: text
        text = long_text(number)//' '//noun
        if (number /= 1) text = long_text(number)//' '//noun//'s'
    end function counted

    !> Characters of a text in UTF-8: bytes that don't continue one.
    pure integer function characters(text)
        character(*), intent(in) :: text !! any text
        integer :: i
        characters = 0
        do i = 1, len(text)
            if (begins_character(text(i:i))) characters = characters + 1
        end do
    end function characters

    !> Bytes that the first characters of a text in UTF-8 take: all of it where it has no more.
    pure integer function first_bytes(text, count)
        character(*), intent(in) :: text !! any text
        integer, intent(in) :: count     !! how many characters
        integer :: met
        met = 0
        do first_bytes = 0, len(text) - 1
            if (begins_character(text(first_bytes + 1:first_bytes + 1))) met = met + 1
            if (met > count) return
        end do
    end function first_bytes

    !> True for a byte that begins a character in UTF-8, as every ASCII byte does.
    elemental logical function begins_character(byte)
        character, intent(in) :: byte !! any byte
        begins_character = iand(ichar(byte), 192) /= 128
    end function begins_character

end module base_text
