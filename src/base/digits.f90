!> Numbers as figures: fixed decimals for listings, figures with a power of ten for coefficients,
!> and for CSV the shortest figures that read back as the same number. There is no `-0.000`, and a
!> number that does not fit its columns is given with a power of ten, never as asterisks.
module base_digits
    use base_exact, only: is_equal, is_zero
    use base_kinds, only: dp, i128, i64
    use base_text, only: right, row_of
    implicit none (type, external)
    private

    public :: fixed, scientific, shortest

    !> Figures that a double always keeps, and that always tell it from its neighbours.
    integer, parameter :: kept_figures = 15, telling_figures = 17

contains

    !> A number with a fixed count of decimals, right in its columns; halves go to even, as the
    !> runtime rounds them.
    pure function fixed(value, width, decimals) result(text)
        real(dp), intent(in) :: value   !! a finite number
        integer, intent(in) :: width    !! columns, at least 9
        integer, intent(in) :: decimals !! figures behind the point, 0 to 12
        character(:), allocatable :: text
        character(24) :: field
        integer(i64) :: rest
        integer :: first, place
        logical :: is_negative

        rest = units_of(abs(value), decimals)
        is_negative = value < 0.0_dp .and. rest > 0
        first = len(field) + 1
        place = 0
        do while (rest > 0 .or. place <= decimals)
            if (place == decimals) call put_before('.', field, first)
            call put_before(achar(iachar('0') + int(mod(rest, 10_i64))), field, first)
            rest = rest/10
            place = place + 1
        end do
        if (is_negative) call put_before('-', field, first)
        if (len(field) - first < width) then
            text = right(field(first:), width)
        else
            text = scientific(value, width, max(1, width - 8))
        end if
    end function fixed

    !> Puts a character in front of a text that grows from its end.
    pure subroutine put_before(letter, field, first)
        character, intent(in) :: letter         !! which
        character(*), intent(inout) :: field    !! where the text stands
        integer, intent(inout) :: first         !! where it begins
        first = first - 1
        field(first:first) = letter
    end subroutine put_before

    !> A number in units of its last decimal, rounded exactly, halves to even; the largest whole
    !> number where it is too large to be printed so.
    pure integer(i64) function units_of(value, decimals) result(units)
        real(dp), intent(in) :: value   !! not negative, finite
        integer, intent(in) :: decimals !! 0 to 12
        real(dp), parameter :: most = 1.0e17_dp
        integer(i128) :: scaled, part, half
        integer :: drop

        units = huge(units)
        if (value >= most/10.0_dp**decimals) return
        units = 0
        drop = digits(value) - exponent(value)
        if (drop > 100) return
        scaled = int(scale(fraction(value), digits(value)), i128)*10_i128**int(decimals, i128)
        if (drop <= 0) then
            units = int(shiftl(scaled, -drop), i64)
            return
        end if
        units = int(shiftr(scaled, drop), i64)
        part = iand(scaled, shiftl(1_i128, drop) - 1_i128)
        half = shiftl(1_i128, drop - 1)
        if (part > half .or. (part == half .and. mod(units, 2_i64) == 1)) units = units + 1
    end function units_of

    !> A number with one figure before the point and a power of ten of two figures, or three where
    !> it needs them, right in its columns.
    pure function scientific(value, width, figures) result(text)
        real(dp), intent(in) :: value   !! a finite number
        integer, intent(in) :: width    !! columns, at least figures + 7
        integer, intent(in) :: figures  !! figures in all
        character(:), allocatable :: text
        character(48) :: format, field
        integer :: power

        write (format, '(a,i0,a)') '(es48.', figures - 1, 'e3)'
        write (field, format) merge(0.0_dp, value, is_zero(value))
        power = index(field, 'E') + 2
        if (field(power:power) == '0') field(power:) = field(power + 1:)
        text = right(field, width)
    end function scientific

    !> The fewest figures that read back as the same double: `-30`, `0.1`, `1e-07`.
    pure function shortest(value) result(text)
        real(dp), intent(in) :: value !! a finite number
        character(:), allocatable :: text
        integer(i64) :: figures
        integer :: power

        if (is_zero(value)) then
            text = '0'
            return
        end if
        call fewest_figures(abs(value), figures, power)
        text = written(figures, power)
        if (value < 0.0_dp) text = '-'//text
    end function shortest

    !> The whole number with the fewest figures such that `figures * 10**power` reads as the value.
    pure subroutine fewest_figures(value, figures, power)
        real(dp), intent(in) :: value        !! a finite positive number
        integer(i64), intent(out) :: figures !! the figures, without zeros at their end
        integer, intent(out) :: power        !! the power of ten behind them
        real(dp), parameter :: least = 1.0e-12_dp, most = 1.0e15_dp

        if (value >= least .and. value < most) then
            call short_figures(value, figures, power)
        else
            call tried_figures(value, figures, power)
        end if
        do while (mod(figures, 10_i64) == 0)
            figures = figures/10
            power = power + 1
        end do
    end subroutine fewest_figures

    !> Works the fewest figures in whole numbers, all in one small unit: the decimals between the
    !> two halfway points to the neighbours read as the value, the halfway points themselves where
    !> its last bit is even. The coarsest power of ten with a multiple there gives the fewest
    !> figures; of its multiples the one nearest to the value is taken, of two the even one.
    pure subroutine short_figures(value, figures, power)
        real(dp), intent(in) :: value        !! 1e-12 to 1e15
        integer(i64), intent(out) :: figures !! the figures
        integer, intent(out) :: power        !! the power of ten behind them
        integer(i128) :: bits, five, step, low, middle, high, multiple
        integer :: places

        places = telling_figures - floor(log10(value))
        bits = int(scale(fraction(value), digits(value)), i128)
        five = 5_i128**int(places, i128)
        ! The unit is 2**(exponent - digits - 2) / 5**places, so that a quarter bit is `five`.
        middle = 4*bits*five
        high = middle + 2*five
        low = middle - merge(five, 2*five, is_equal(fraction(value), 0.5_dp))
        if (mod(bits, 2_i128) == 1) then
            high = high - 1
            low = low + 1
        end if
        step = 2_i128**int(digits(value) + 2 - exponent(value) - places, i128)
        power = -places
        do while (high/(10*step)*(10*step) >= low)
            step = 10*step
            power = power + 1
        end do
        multiple = (middle + step/2)/step
        if (multiple*step - middle == step/2) multiple = multiple - mod(multiple, 2_i128)
        if (multiple*step < low) multiple = multiple + 1
        if (multiple*step > high) multiple = multiple - 1
        figures = int(multiple, i64)
    end subroutine short_figures

    !> Tries more and more figures until they tell a very large or small value from all others.
    !> Beside a power of two the nearest decimal may read as another double, and the next one
    !> beyond it as the value. Subnormal numbers have few figures.
    pure subroutine tried_figures(value, figures, power)
        real(dp), intent(in) :: value        !! a finite positive number
        integer(i64), intent(out) :: figures !! the figures
        integer, intent(out) :: power        !! the power of ten behind them
        integer :: count
        integer(i64) :: shift

        do count = merge(kept_figures, 1, value >= tiny(value)), telling_figures
            call rounded(value, count, figures, power)
            if (is_equal(read_back(figures, power), value)) return
            do shift = -1_i64, 1_i64, 2_i64
                if (.not. is_equal(read_back(figures + shift, power), value)) cycle
                figures = figures + shift
                return
            end do
        end do
    end subroutine tried_figures

    !> A number correctly rounded to a count of figures.
    pure subroutine rounded(value, count, figures, power)
        real(dp), intent(in) :: value        !! a finite positive number
        integer, intent(in) :: count         !! how many figures
        integer(i64), intent(out) :: figures !! the figures as a whole number
        integer, intent(out) :: power        !! the power of ten behind them
        character(32) :: format, field
        integer :: e

        write (format, '(a,i0,a)') '(es32.', count - 1, 'e3)'
        write (field, format) value
        field = adjustl(field)
        e = index(field, 'E')
        read (field(e + 1:), *) power
        power = power - (count - 1)
        field = field(1:1)//field(3:e - 1)
        read (field, *) figures
    end subroutine rounded

    !> The double that figures and a power of ten read as; zero for what is above the largest.
    pure real(dp) function read_back(figures, power) result(value)
        integer(i64), intent(in) :: figures !! positive whole number of at most 17 figures
        integer, intent(in) :: power        !! power of ten
        character(48) :: field
        integer :: status
        ! The largest double is 17976931348623157 * 10**292.
        integer(i128), parameter :: largest_figures = 17976931348623157_i128
        integer, parameter :: their_power = 292

        value = 0.0_dp
        if (power >= their_power) then
            if (int(figures, i128)*10_i128**int(power - their_power, i128) > largest_figures) return
        end if
        write (field, '(i0,a,i0)') figures, 'e', power
        read (field, *, iostat=status) value
        if (status /= 0) value = 0.0_dp
    end function read_back

    !> Figures and a power of ten as text: plain where that is short, else with an `e`.
    pure function written(figures, power) result(text)
        integer(i64), intent(in) :: figures !! positive whole number
        integer, intent(in) :: power        !! power of ten
        character(:), allocatable :: text
        character(24) :: field
        integer :: count, point

        write (field, '(i0)') figures
        count = len_trim(field)
        point = count + power
        if (point > 16 .or. point < -4) then
            text = field(1:1)
            if (count > 1) text = text//'.'//field(2:count)
            write (field, '(sp,i0.2)') point - 1
            text = text//'e'//trim(field)
        else if (power >= 0) then
            text = trim(field)//row_of('0', power)
        else if (point > 0) then
            text = field(:point)//'.'//field(point + 1:count)
        else
            text = '0.'//row_of('0', -point)//trim(field)
        end if
    end function written

end module base_digits
