!> Numbers as figures: fixed decimals for listings, figures with a power of ten for coefficients,
!> and for CSV the shortest figures that read back as the same number. There is no `-0.000`, and a
!> number that does not fit its columns is given with a power of ten, never as asterisks.
!>
!> Each is worked by a product that says how sure it is; where it leaves a doubt, because the number
!> is a tie or next to one, the figures are worked exactly.
module base_digits
    use base_figures, only: figure_count, put_text, put_units, put_whole
    use base_kinds, only: dp, i128, i64
    use base_rounding, only: figures_of, shortest_figures, units_of
        implicit none (type, external)
    private

    public :: fixed, scientific, shortest, put_scientific, put_shortest

    !> Columns of the longest numbers that `put_shortest` and `put_scientific` write.
    integer, parameter, public :: widest_shortest = 24, widest_scientific = 24

contains

    !> A number with a fixed count of decimals, right in its columns; halves go to even, as the
    !> runtime rounds them.
    pure function fixed(value, width, decimals) result(text)
        real(dp), intent(in) :: value   !! a finite number
        integer, intent(in) :: width    !! columns, at least 9
        integer, intent(in) :: decimals !! figures behind the point, 0 to 12
        character(:), allocatable :: text
        character(40) :: line
        integer(i64) :: units
        logical :: is_negative
        integer :: used

        units = units_of(abs(value), decimals)
        is_negative = value < 0.0_dp .and. units > 0
        used = max(figure_count(units), decimals + 1) + merge(2, 1, is_negative)
        if (used > width) then
            text = scientific(value, width, max(1, width - 8))
        else
            call put_units(units, is_negative, decimals, line, len(line))
            allocate (character(width) :: text)
            text(:) = ''
            text(width - used + 1:) = line(len(line) - used + 1:)
        end if
    end function fixed

    !> A number with one figure before the point and a power of ten of two figures, or three where
    !> it needs them, right in its columns.
    pure function scientific(value, width, figures) result(text)
        real(dp), intent(in) :: value   !! a finite number
        integer, intent(in) :: width    !! columns, at least figures + 7
        integer, intent(in) :: figures  !! figures in all, 1 to 17
        character(:), allocatable :: text
        character(widest_scientific) :: line
        integer :: next

        next = 1
        call put_scientific(value, figures, line, next)
        allocate (character(max(width, next - 1)) :: text)
        text(:) = ''
        text(len(text) - next + 2:) = line(:next - 1)
    end function scientific

    !> Writes a number with a power of ten, as `scientific`, from a column on.
    pure subroutine put_scientific(value, figures, line, next)
        real(dp), intent(in) :: value       !! a finite number
        integer, intent(in) :: figures      !! figures in all, 1 to 17
        character(*), intent(inout) :: line !! has figures + 7 columns from there on
        integer, intent(inout) :: next      !! the first column; behind the last on return
        integer(i64) :: units
        integer :: power, i

        if (value < 0.0_dp) call put_text('-', line, next)
        if (abs(value) > 0.0_dp) then
            call figures_of(abs(value), figures, units, power)
            next = next + 1
            call put_whole(units, line, next)
            power = power + figures - 1
        else
            power = 0
            do i = 0, figures
                call put_text('0', line, next)
            end do
        end if
        associate (point => next - figures)
            line(point - 1:point - 1) = line(point:point)
            line(point:point) = '.'
        end associate
        call put_power('E', power, line, next)
    end subroutine put_scientific

    !> Writes a power of ten with its sign, at least two figures.
    pure subroutine put_power(letter, power, line, next)
        character, intent(in) :: letter     !! what begins it
        integer, intent(in) :: power        !! power of ten, -999 to 999
        character(*), intent(inout) :: line !! gets it
        integer, intent(inout) :: next      !! the first column; behind the last on return
        call put_text(letter//merge('-', '+', power < 0), line, next)
        if (abs(power) < 10) call put_text('0', line, next)
        call put_whole(int(abs(power), i64), line, next)
    end subroutine put_power

    !> The fewest figures that read back as the same double: `-30`, `0.1`, `1e-07`.
    pure function shortest(value) result(text)
        real(dp), intent(in) :: value !! a finite number
        character(:), allocatable :: text
        character(widest_shortest) :: line
        integer :: next

        next = 1
        call put_shortest(value, line, next)
        text = line(:next - 1)
    end function shortest

    !> Writes the fewest figures that read back as the same double, from a column on.
    pure subroutine put_shortest(value, line, next)
        real(dp), intent(in) :: value       !! a finite number
        character(*), intent(inout) :: line !! has `widest_shortest` columns from there on
        integer, intent(inout) :: next      !! the first column; behind the last on return
        integer(i64) :: figures
        integer :: power

        if (.not. abs(value) > 0.0_dp) then
            line(next:next) = '0'
            next = next + 1
            return
        end if
        if (value < 0.0_dp) then
            line(next:next) = '-'
            next = next + 1
        end if
        call shortest_figures(abs(value), figures, power)
        call put_figures(figures, power, line, next)
    end subroutine put_shortest

    !> Writes figures and a power of ten: plain where that is short, else with an `e`.
    pure subroutine put_figures(figures, power, line, next)
        integer(i64), intent(in) :: figures !! positive whole number
        integer, intent(in) :: power        !! power of ten
        character(*), intent(inout) :: line !! gets the text
        integer, intent(inout) :: next      !! the first column; behind the last on return
        character(17) :: digits
        integer :: count, point, i

        count = 1
        call put_whole(figures, digits, count)
        count = count - 1
        point = count + power
        if (point > 16 .or. point < -4) then
            call put_text(digits(:1), line, next)
            if (count > 1) call put_text('.'//digits(2:count), line, next)
            call put_power('e', point - 1, line, next)
        else if (power >= 0) then
            call put_text(digits(:count), line, next)
            do i = 1, power
                call put_text('0', line, next)
            end do
        else if (point > 0) then
            call put_text(digits(:point), line, next)
            call put_text('.', line, next)
            call put_text(digits(point + 1:count), line, next)
        else
            call put_text('0.', line, next)
            do i = 1, -point
                call put_text('0', line, next)
            end do
            call put_text(digits(:count), line, next)
        end if
    end subroutine put_figures

end module base_digits
