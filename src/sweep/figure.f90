!> A number as it stands in a field of a card: as many figures as fit its eight columns, no more
!> than it has.
!>
!>     .3333333        -7.1        1.2346E9
module sweep_figure
    use base_decimal, only: to_real
    use base_digits, only: fixed, scientific
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use deck_body_card, only: field_width
    use deck_number, only: number_type, read_number
    implicit none (type, external)
    private

    public :: field_figure, figure_value

    !> Room to write a number before it is cut to a field.
    integer, parameter :: room = 40
    !> Above this a number has no decimals in eight columns.
    real(dp), parameter :: most = 1.0e8_dp

contains

    !> The text of eight columns or fewer that reads nearest to a number, the shortest of those.
    pure function field_figure(value) result(text)
        real(dp), intent(in) :: value !! a finite number, of a size that a card may hold
        character(field_width) :: text
        integer :: i

        text = '0.'
        if (is_zero(value)) return
        text = ''
        if (abs(value) < most) then
            do i = 0, field_width - 1
                call take(trim(point_figure(value, i)), value, text)
            end do
        end if
        do i = 1, field_width - 2
            call take(trim(power_figure(value, i)), value, text)
        end do
    end function field_figure

    !> The number that a text of `field_figure` reads as on a card.
    pure real(dp) function figure_value(text)
        character(*), intent(in) :: text !! a number
        type(number_type) :: number
        number = read_number(trim(text), 0)
        figure_value = to_real(number%value)
    end function figure_value

    !> Takes a text where it fits a field and reads nearer than what there is.
    pure subroutine take(offered, value, text)
        character(*), intent(in) :: offered                 !! a way to write the number
        real(dp), intent(in) :: value                       !! the number
        character(field_width), intent(inout) :: text       !! the best so far; blank: none
        logical :: is_better

        if (len(offered) > field_width) return
        is_better = text == ''
        if (.not. is_better) is_better = abs(figure_value(offered) - value) < &
            abs(figure_value(text) - value)
        if (is_better) text = offered
    end subroutine take

    !> A number with a point and so many decimals, no zero before the point.
    pure function point_figure(value, decimals) result(text)
        real(dp), intent(in) :: value   !! a finite number
        integer, intent(in) :: decimals !! figures behind the point
        character(room) :: text
        integer :: zero

        text = adjustl(fixed(value, room, decimals))
        if (index(text, '.') == 0) text = trim(text)//'.'
        zero = index(text, '0.')
        if (zero == 1) text = text(2:)
        if (index(text, '-0.') == 1) text = '-'//text(3:)
        if (text == '.' .or. verify(trim(text), '.0-') == 0) text = '0.'
    end function point_figure

    !> A number with so many figures and a power of ten.
    pure function power_figure(value, figures) result(text)
        real(dp), intent(in) :: value   !! a finite number
        integer, intent(in) :: figures  !! figures in all
        character(room) :: text
        character :: sign
        integer :: power

        text = adjustl(scientific(value, room, figures))
        power = index(text, 'E')
        sign = text(power + 1:power + 1)
        if (sign == '+') sign = ''
        text = text(:power)//trim(sign)//text(power + 1 + max(1, verify(text(power + 2:), '0')):)
    end function power_figure

end module sweep_figure
