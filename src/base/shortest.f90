!> The fewest figures that read back as the same double, written into the columns of a line.
module base_shortest
    use base_figures, only: put_text, put_whole
    use base_kinds, only: dp, i64
    use base_rounding, only: shortest_figures
    implicit none (type, external)
    private

    public :: put_shortest, shortest_length, put_power

    !> Columns of the longest number that `put_shortest` writes.
    integer, parameter, public :: widest_shortest = 24

contains

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

    !> How many characters `shortest` needs.
    pure integer function shortest_length(value) result(length)
        real(dp), intent(in) :: value !! a finite number
        character(widest_shortest) :: line
        integer :: next
        next = 1
        call put_shortest(value, line, next)
        length = next - 1
    end function shortest_length

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

end module base_shortest
