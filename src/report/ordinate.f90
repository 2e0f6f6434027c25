!> Ordinates of a body listing in the unit the deck asks for: decimal inches, millimetres or feet,
!> or feet, inches and eighths as lofts write them.
!>
!>     1-07-4    1 ft 7 4/8 in        1-07-4+   a sixteenth more        -0-03-0   below zero
module report_ordinate
    use base_kinds, only: dp, i64
    use base_text, only: right, to_text
    use base_digits, only: fixed
    implicit none (type, external)
    private

    public :: ordinate_form_type, new_form, ordinate_text, ordinate_words, largest_rounding

    !> Millimetres in an inch: exact by definition.
    real(dp), parameter :: mm_per_inch = 25.4_dp
    !> Inches in a foot.
    real(dp), parameter :: inches_per_foot = 12.0_dp
    !> Columns of the longest ordinate of feet, inches and eighths.
    integer, parameter, public :: widest_ordinate = 24

    !> How ordinates are printed.
    type :: ordinate_form_type
        real(dp) :: factor = 1.0_dp         !! printed unit over deck unit
        integer :: decimals = 3             !! decimals printed
        logical :: is_fie = .false.         !! feet, inches and eighths
        character(:), allocatable :: unit   !! what the printed figures are, in words
    end type ordinate_form_type

contains

    !> The form for a deck in `units` (INCHES, MM, FEET) printed in `output` (these, or FIE).
    pure type(ordinate_form_type) function new_form(units, output, decimals) result(form)
        character(*), intent(in) :: units   !! of the deck's numbers
        character(*), intent(in) :: output  !! of the listing
        integer, intent(in) :: decimals     !! decimals printed

        form%is_fie = output == 'FIE'
        form%decimals = decimals
        form%unit = trim(output)
        if (form%is_fie) form%unit = 'FEET-INCHES-EIGHTHS'
        if (units == output) return
        form%factor = inches_in(units)/inches_in(output)
    end function new_form

    !> Inches in a unit; FIE is worked in inches.
    pure real(dp) function inches_in(unit) result(inches)
        character(*), intent(in) :: unit !! INCHES, MM, FEET or FIE
        select case (unit)
        case ('MM')
            inches = 1.0_dp/mm_per_inch
        case ('FEET')
            inches = inches_per_foot
        case default
            inches = 1.0_dp
        end select
    end function inches_in

    !> Columns of an ordinate: more than asked where feet and inches need them.
    pure integer(i64) function ordinate_width(form, value, width) result(columns)
        type(ordinate_form_type), intent(in) :: form !! how
        real(dp), intent(in) :: value                !! deck units
        integer, intent(in) :: width                 !! columns asked
        columns = int(width, i64)
        if (form%is_fie) columns = max(columns, &
            len_trim(feet_inches_eighths(form%factor*value), i64))
    end function ordinate_width

    !> An ordinate, right in its columns.
    pure function ordinate_text(form, value, width) result(text)
        type(ordinate_form_type), intent(in) :: form !! how
        real(dp), intent(in) :: value                !! deck units
        integer, intent(in) :: width                 !! columns
        character(ordinate_width(form, value, width)) :: text
        if (form%is_fie) then
            text = right(feet_inches_eighths(form%factor*value), width)
        else
            text = fixed(form%factor*value, width, form%decimals)
        end if
    end function ordinate_text

    !> An ordinate for a sentence, without blanks.
    pure function ordinate_words(form, value) result(text)
        type(ordinate_form_type), intent(in) :: form !! how
        real(dp), intent(in) :: value                !! deck units
        character(len_trim(adjustl(ordinate_text(form, value, widest_ordinate)), i64)) :: text
        text = adjustl(ordinate_text(form, value, widest_ordinate))
    end function ordinate_words

    !> Inches as feet, inches and eighths; an odd sixteenth is a `+` behind the eighth below it.
    !> Blanks behind them.
    pure function feet_inches_eighths(inches) result(text)
        real(dp), intent(in) :: inches !! any number
        character(widest_ordinate) :: text
        character(2) :: whole_inches
        integer(i64) :: sixteenths

        sixteenths = nint(16.0_dp*abs(inches), i64)
        write (whole_inches, '(i2.2)') mod(sixteenths/16, 12_i64)
        text = to_text(sixteenths/192)//'-'//whole_inches//'-'//to_text(mod(sixteenths, 16_i64)/2)
        if (mod(sixteenths, 2_i64) == 1) text = trim(text)//'+'
        if (inches < 0.0_dp .and. sixteenths > 0) text = '-'//text(:widest_ordinate - 1)
    end function feet_inches_eighths

    !> The most a printed ordinate is off by its rounding, in words.
    pure function largest_rounding(form) result(words)
        type(ordinate_form_type), intent(in) :: form !! how
        character(44) :: words
        if (form%is_fie) then
            words = 'ROUNDED TO THE NEAREST SIXTEENTH OF AN INCH'
        else
            words = 'ROUNDED TO '//to_text(form%decimals)//' DECIMALS'
        end if
    end function largest_rounding

end module report_ordinate
