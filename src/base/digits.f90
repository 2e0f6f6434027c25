!> Numbers as figures: fixed decimals for listings, figures with a power of ten for coefficients,
!> and for CSV the shortest figures that read back as the same number. There is no `-0.000`, and a
!> number that does not fit its columns is given with a power of ten, never as asterisks.
!>
!> Each is worked by a product that says how sure it is; where it leaves a doubt, because the number
!> is a tie or next to one, the figures are worked exactly.
module base_digits
    use base_exact, only: is_finite
    use base_figures, only: figure_count, put_padded, put_text, put_units
    use base_kinds, only: dp, i128, i64
    use base_rounding, only: figures_of, units_of
    use base_shortest, only: put_power, put_shortest, shortest_length
    implicit none (type, external)
    private

    public :: fixed, scientific, shortest, put_fixed, put_scientific

    !> Columns of the longest number that `put_scientific` writes.
    integer, parameter, public :: widest_scientific = 24
    !> Columns of the longest number that `put_fixed` writes; a longer one has a power of ten.
    integer, parameter :: widest_fixed = 16

contains

    !> A number with a fixed count of decimals, right in its columns; halves go to even, as the
    !> runtime rounds them.
    pure function fixed(value, width, decimals) result(text)
        real(dp), intent(in) :: value   !! any; NaN is said where it is no finite number
        integer, intent(in) :: width    !! columns, at least 9
        integer, intent(in) :: decimals !! figures behind the point, 0 to 12
        character(int(width, i64)) :: text
        character(40) :: line
        integer(i64) :: units
        logical :: is_negative
        integer :: used

        if (.not. is_finite(value)) then
            text = ''
            text(width - 2:) = 'NaN'
            return
        end if
        units = units_of(abs(value), decimals)
        is_negative = value < 0.0_dp .and. units > 0
        used = max(figure_count(units), decimals + 1) + merge(2, 1, is_negative)
        if (used > width) then
            text = scientific(value, width, max(1, width - 8))
        else
            call put_units(units, is_negative, decimals, line, len(line))
            text = ''
            text(width - used + 1:) = line(len(line) - used + 1:)
        end if
    end function fixed

    !> Writes a number with a fixed count of decimals, as `fixed`, in as few columns as it needs,
    !> from a column on.
    pure subroutine put_fixed(value, decimals, line, next)
        real(dp), intent(in) :: value       !! a finite number
        integer, intent(in) :: decimals     !! figures behind the point, 0 to 12
        character(*), intent(inout) :: line !! has `widest_fixed` columns from there on
        integer, intent(inout) :: next      !! the first column; behind the last on return
        character(widest_fixed) :: text
        text = fixed(value, widest_fixed, decimals)
        call put_text(text(verify(text, ' '):), line, next)
    end subroutine put_fixed

    !> A number with one figure before the point and a power of ten of two figures, or three where
    !> it needs them, right in its columns.
    pure function scientific(value, width, figures) result(text)
        real(dp), intent(in) :: value   !! any
        integer, intent(in) :: width    !! columns, at least figures + 7
        integer, intent(in) :: figures  !! figures in all, 1 to 17
        character(int(width, i64)) :: text
        character(widest_scientific) :: line
        integer :: next

        next = 1
        call put_scientific(value, figures, line, next)
        text = ''
        text(width - next + 2:) = line(:next - 1)
    end function scientific

    !> Writes a number with a power of ten, as `scientific`, from a column on.
    pure subroutine put_scientific(value, figures, line, next)
        real(dp), intent(in) :: value       !! any
        integer, intent(in) :: figures      !! figures in all, 1 to 17
        character(*), intent(inout) :: line !! has figures + 7 columns from there on
        integer, intent(inout) :: next      !! the first column; behind the last on return
        integer(i64) :: units
        integer :: power

        if (.not. is_finite(value)) then
            call put_text('NaN', line, next)
            return
        end if
        if (value < 0.0_dp) call put_text('-', line, next)
        units = 0
        power = 1 - figures
        if (abs(value) > 0.0_dp) call figures_of(abs(value), figures, units, power)
        call put_padded(units, line(next + 1:next + figures))
        line(next:next) = line(next + 1:next + 1)
        line(next + 1:next + 1) = '.'
        next = next + figures + 1
        call put_power('E', power + figures - 1, line, next)
    end subroutine put_scientific

    !> The fewest figures that read back as the same double: `-30`, `0.1`, `1e-07`.
    pure function shortest(value) result(text)
        real(dp), intent(in) :: value !! any
        character(int(shortest_length(value), i64)) :: text
        integer :: next
        next = 1
        call put_shortest(value, text, next)
    end function shortest

end module base_digits
