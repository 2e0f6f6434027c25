!> How many characters a number takes as text, said before the text is made.
!>
!> gfortran keeps the length of a text that a function makes as it goes in one place for all threads
!> (`slen`, a static variable of the caller), so that two threads may not call such a function from
!> one line at the same time. A result whose length is declared by these functions has no such
!> place. They stand in a module of their own because a length may not be declared by a function of
!> the same module.
module base_length
    use base_exact, only: is_finite, is_zero
    use base_figures, only: figure_count
    use base_kinds, only: dp, i64
    implicit none (type, external)
    private

    public :: places, compact_length, compact_field

contains

    !> Characters of a whole number.
    elemental integer(i64) function places(value)
        integer(i64), intent(in) :: value !! any whole number
        places = int(figure_count(abs(max(value, -huge(value)))), i64)
        if (value < 0) places = places + 1
    end function places

    !> Characters of `compact`, of base_text.
    pure integer(i64) function compact_length(value) result(length)
        real(dp), intent(in) :: value !! any
        length = len_trim(compact_field(value), i64)
    end function compact_length

    !> A number for a sentence: up to six decimals, or up to six figures and a power of ten, no
    !> zeros at the end (`12.5`, `-0.001`, `7.`, `3.E+20`); blanks behind it. What is no finite
    !> number is said as Fortran says it.
    pure function compact_field(value) result(text)
        real(dp), intent(in) :: value !! any
        character(32) :: text
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
        if (text(1:1) == '.') text = '0'//text(:31)
        if (index(text, '-.') == 1) text = '-0'//text(2:31)
    end function compact_field

end module base_length
