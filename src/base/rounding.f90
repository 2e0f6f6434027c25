!> Doubles rounded to decimal figures: to a count of decimals, to a count of figures, and to as few
!> figures as tell them from their neighbours. Always rounded correctly, halves to even.
!>
!> Each is one product, with an error of which the bound is known. Where the product is so near to a
!> half, or to the edge of what reads as the same double, that the bound does not settle it, the
!> figures are worked exactly.
!>
!> Source: R. Giulietti, "The Schubfach way to render doubles", 2021 (the coarser of two powers of
!> ten has at most one multiple that reads as the double, the finer at least one).
module base_rounding
    use base_decimal, only: tens
    use base_exact, only: is_equal
    use base_figures, only: ten_to
    use base_kinds, only: dp, i128, i64
    use base_power, only: decade_of_binary, half_bits, power_of_ten, power_type, product_with
    implicit none (type, external)
    private

    public :: units_of, figures_of, shortest_figures

    !> Figures that a double always keeps, and that always tell it from its neighbours.
    integer, parameter :: kept_figures = 15, telling_figures = 17
    !> The first bit of the whole number of a double.
    integer, parameter :: leading_bit = 61
    !> More than the product of a power of ten is off by, in its last unit.
    integer(i128), parameter :: doubt = 8_i128

    !> A double as a whole number of 62 bits, `whole*2**binary`.
    type :: parts_type
        integer(i64) :: whole = 0   !! 2**61 to 2**62 - 1
        integer :: binary = 0       !! power of two behind it
        integer :: half_gap = 0     !! half the gap to the next double is `2**half_gap` of its units
        logical :: is_edge = .false. !! the gap below is half of that above
    end type parts_type

    !> A product `value*10**k` as a fixed-point number, `fixed/2**bits`.
    type :: product_type
        integer(i128) :: fixed = 0 !! short of the truth by less than `doubt`
        integer :: bits = 0        !! bits behind the point
    end type product_type

contains

    !> A number in units of its last decimal; the largest whole number where it is too large to be
    !> printed so.
    !>
    !> The product with a power of ten is off by half an ulp at most, and the ulp of a number below
    !> 2**43 leaves at least ten bits behind the point.
    pure integer(i64) function units_of(value, decimals) result(units)
        real(dp), intent(in) :: value   !! not negative, finite
        integer, intent(in) :: decimals !! 0 to 12
        real(dp), parameter :: most = 2.0_dp**43, safe = 1.0e30_dp
        real(dp) :: scaled, rest

        if (value < safe) then
            scaled = value*tens(decimals)
            if (scaled < most) then
                units = int(scaled, i64)
                rest = (scaled - real(units, dp)) - 0.5_dp
                if (abs(rest) > scaled*epsilon(scaled)) then
                    if (rest > 0.0_dp) units = units + 1_i64
                    return
                end if
            end if
        end if
        units = exact_units(value, decimals)
    end function units_of

    !> The same, worked in 128 bits.
    pure integer(i64) function exact_units(value, decimals) result(units)
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
    end function exact_units

    !> A number rounded to a count of figures, `figures*10**power`.
    pure subroutine figures_of(value, count, figures, power)
        real(dp), intent(in) :: value        !! a finite positive number
        integer, intent(in) :: count         !! how many figures, 1 to 17
        integer(i64), intent(out) :: figures !! the figures as a whole number
        integer, intent(out) :: power        !! the power of ten behind them
        type(parts_type) :: parts
        type(product_type) :: product
        integer(i128) :: beyond_half

        parts = parts_of(value)
        power = decade_of_binary(parts%binary + leading_bit, .false.) - count + 1
        product = scaled_by(parts, power_of_ten(-power))
        figures = whole_of(product)
        if (figures >= ten_to(count)) then
            power = power + 1
            product = scaled_by(parts, power_of_ten(-power))
            figures = whole_of(product)
        end if
        beyond_half = rest_of(product) - shiftl(1_i128, product%bits - 1)
        if (abs(beyond_half) <= doubt) then
            call rounded(value, count, figures, power)
            return
        end if
        if (beyond_half > 0) figures = figures + 1
        if (figures < ten_to(count)) return
        figures = figures/10
        power = power + 1
    end subroutine figures_of

    !> The whole number with the fewest figures such that `figures * 10**power` reads as the value;
    !> of several the one nearest to it.
    pure subroutine shortest_figures(value, figures, power)
        real(dp), intent(in) :: value        !! a finite positive number
        integer(i64), intent(out) :: figures !! the figures, without zeros at their end
        integer, intent(out) :: power        !! the power of ten behind them
        logical :: is_sure

        call likely_figures(value, figures, power, is_sure)
        if (.not. is_sure) call tried_figures(value, figures, power)
        if (mod(figures, 10_i64) == 0) call drop_zeros(figures, power)
    end subroutine shortest_figures

    !> Takes the zeros off the end of a number: first many at a time, then what is left of them.
    pure subroutine drop_zeros(figures, power)
        integer(i64), intent(inout) :: figures !! a positive whole number
        integer, intent(inout) :: power        !! the power of ten behind it
        integer(i64), parameter :: ten_to_eight = 100000000_i64
        do while (mod(figures, ten_to_eight) == 0)
            figures = figures/ten_to_eight
            power = power + 8
        end do
        do while (mod(figures, 10_i64) == 0)
            figures = figures/10
            power = power + 1
        end do
    end subroutine drop_zeros

    !> The shortest figures by Schubfach, from products that are not exact.
    pure subroutine likely_figures(value, figures, power, is_sure)
        real(dp), intent(in) :: value        !! a finite positive number
        integer(i64), intent(out) :: figures !! the figures
        integer, intent(out) :: power        !! the power of ten behind them
        logical, intent(out) :: is_sure      !! false: the figures may be others
        type(parts_type) :: parts
        type(power_type) :: ten
        type(product_type) :: product
        integer(i128) :: low, high, below, above

        parts = parts_of(value)
        power = decade_of_binary(parts%binary + parts%half_gap + 1, parts%is_edge)
        ten = power_of_ten(-power)
        product = scaled_by(parts, ten)
        high = product_with(ten, shiftl(1_i64, parts%half_gap))
        low = high
        if (parts%is_edge) low = product_with(ten, shiftl(1_i64, parts%half_gap - 1))
        figures = whole_of(product)
        ! Ways from the value to the multiples of the power of ten next below and above it.
        below = rest_of(product)
        above = shiftl(1_i128, product%bits) - below
        associate (coarse => mod(figures, 10_i64))
            if (is_within(below + shiftl(int(coarse, i128), product%bits), low)) then
                figures = figures - coarse
            else if (is_within(above + shiftl(int(9_i64 - coarse, i128), product%bits), high)) then
                figures = figures + (10_i64 - coarse)
            else if (is_within(above, high) .and. (above < below .or. .not. &
                is_within(below, low))) then
                figures = figures + 1
            end if
            is_sure = .not. (is_close(below + shiftl(int(coarse, i128), product%bits), low) .or. &
                is_close(above + shiftl(int(9_i64 - coarse, i128), product%bits), high) .or. &
                is_close(above, high) .or. is_close(below, low) .or. is_close(above, below))
        end associate
    contains
        !> True where a way is no longer than half the gap.
        pure logical function is_within(way, gap)
            integer(i128), intent(in) :: way !! from the value to a decimal
            integer(i128), intent(in) :: gap !! to the middle between two doubles
            is_within = way <= gap
        end function is_within

        !> True where two lengths can't be told apart.
        pure logical function is_close(a, b)
            integer(i128), intent(in) :: a !! a length
            integer(i128), intent(in) :: b !! another
            is_close = abs(a - b) <= doubt
        end function is_close
    end subroutine likely_figures

    !> A double taken apart.
    elemental type(parts_type) function parts_of(value) result(parts)
        real(dp), intent(in) :: value !! a finite positive number
        integer, parameter :: stored = digits(value) - 1
        integer, parameter :: lowest = minexponent(value) - digits(value)
        integer(i64) :: bits
        integer :: characteristic

        bits = transfer(value, bits)
        characteristic = int(shiftr(bits, stored))
        bits = ibits(bits, 0, stored)
        parts%is_edge = bits == 0 .and. characteristic > 1
        if (characteristic > 0) bits = ibset(bits, stored)
        parts%half_gap = leadz(bits) - 3
        parts%binary = lowest + max(characteristic - 1, 0) - parts%half_gap - 1
        parts%whole = shiftl(bits, parts%half_gap + 1)
    end function parts_of

    !> A double times a power of ten.
    elemental type(product_type) function scaled_by(parts, ten) result(product)
        type(parts_type), intent(in) :: parts !! the double
        type(power_type), intent(in) :: ten   !! the power
        product%fixed = product_with(ten, parts%whole)
        product%bits = -(parts%binary + ten%binary + half_bits)
    end function scaled_by

    !> The whole part of a product.
    elemental integer(i64) function whole_of(product)
        type(product_type), intent(in) :: product !! below 2**62
        whole_of = int(shiftr(product%fixed, product%bits), i64)
    end function whole_of

    !> The rest of a product behind its point.
    elemental integer(i128) function rest_of(product)
        type(product_type), intent(in) :: product !! not negative
        rest_of = iand(product%fixed, shiftl(1_i128, product%bits) - 1_i128)
    end function rest_of

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

end module base_rounding
