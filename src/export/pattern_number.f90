!> Numbers for paper: as few figures as the decimals asked for need.
module export_pattern_number
    use base_digits, only: fixed
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: short, ordinate, inches, bevel_text

    !> Decimals of an ordinate.
    integer, parameter :: ordinate_decimals = 6

contains

    !> A number with so many decimals, zeros at their end left out: `12.5`, `-0.001`, `7`.
    pure function short(value, decimals) result(text)
        real(dp), intent(in) :: value   !! a finite number of less than 1e12
        integer, intent(in) :: decimals !! 0 to 9
        character(:), allocatable :: text
        integer :: last

        text = trim(adjustl(fixed(value, 24, decimals)))
        last = index(text, '.')
        if (decimals > 0) last = verify(text, '0', back=.true.)
        if (text(last:last) == '.') last = last - 1
        text = text(:last)
    end function short

    !> An ordinate, in whatever unit.
    pure function ordinate(value) result(text)
        real(dp), intent(in) :: value !! a finite number of less than 1e12
        character(:), allocatable :: text
        text = short(value, ordinate_decimals)
    end function ordinate

    !> A length in inches with three decimals: `10.000`.
    pure function inches(value) result(text)
        real(dp), intent(in) :: value !! in
        character(:), allocatable :: text
        text = trim(adjustl(fixed(value, 24, 3)))
    end function inches

    !> A bevel with its sign, degrees to a tenth.
    pure function bevel_text(bevel) result(text)
        real(dp), intent(in) :: bevel !! degrees
        character(:), allocatable :: text
        text = trim(adjustl(fixed(bevel, 12, 1)))
        if (bevel > 0.0_dp .and. text /= '0.0') text = '+'//text
    end function bevel_text

end module export_pattern_number
