!> The fewest figures that read back as the same double, written into the columns of a line.
module base_shortest
    use base_exact, only: is_finite
    use base_figures, only: put_text, put_whole
    use base_kinds, only: dp, i64
    use base_rounding, only: shortest_figures
    implicit none (type, external)
    private

    public :: put_shortest, shortest_length, put_power

    !> Columns of the longest number that `put_shortest` writes.
    integer, parameter, public :: widest_shortest = 24
    !> Characters moved at a time: no fewer than a double has figures.
    integer, parameter :: piece = 24

contains

    !> Writes the fewest figures that read back as the same double, from a column on; NaN where it
    !> is no finite number.
    pure subroutine put_shortest(value, line, next)
        real(dp), intent(in) :: value       !! any
        character(*), intent(inout) :: line !! has `widest_shortest` columns from there on
        integer, intent(inout) :: next      !! the first column; behind the last on return
        integer(i64) :: figures
        integer :: power

        if (.not. is_finite(value)) then
            call put_text('NaN', line, next)
            return
        end if
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
        real(dp), intent(in) :: value !! any
        character(widest_shortest) :: line
        integer :: next
        next = 1
        call put_shortest(value, line, next)
        length = next - 1
    end function shortest_length

    !> Writes figures and a power of ten: plain where that is short, else with an `e`. The text is
    !> put together of pieces of one size, longer than needed: these move faster than exact ones.
    pure subroutine put_figures(figures, power, line, next)
        integer(i64), intent(in) :: figures !! positive whole number
        integer, intent(in) :: power        !! power of ten
        character(*), intent(inout) :: line !! gets the text
        integer, intent(inout) :: next      !! the first column; behind the last on return
        character(*), parameter :: zeros = repeat('0', piece)
        character(2*piece) :: digits, text
        integer :: count, point, used

        count = 1
        call put_whole(figures, digits, count)
        count = count - 1
        point = count + power
        if (point > 16 .or. point < -4) then
            call put_text(digits(:1), line, next)
            if (count > 1) then
                call put_text('.', line, next)
                call put_text(digits(2:count), line, next)
            end if
            call put_power('e', point - 1, line, next)
            return
        end if
        if (point <= 0) then
            text(:piece) = '0.'//zeros
            text(3 - point:2 - point + piece) = digits(:piece)
            used = 2 - point + count
        else
            text(:piece) = digits(:piece)
            if (power >= 0) then
                text(count + 1:count + piece) = zeros
                used = point
            else
                text(point + 1:point + 1) = '.'
                text(point + 2:point + 1 + piece) = digits(point + 1:point + piece)
                used = count + 1
            end if
        end if
        line(next:next + used - 1) = text(:used)
        next = next + used
    end subroutine put_figures

    !> Writes a power of ten with its sign, at least two figures.
    pure subroutine put_power(letter, power, line, next)
        character, intent(in) :: letter     !! what begins it
        integer, intent(in) :: power        !! power of ten, -999 to 999
        character(*), intent(inout) :: line !! gets it
        integer, intent(inout) :: next      !! the first column; behind the last on return
        integer :: size

        line(next:next) = letter
        line(next + 1:next + 1) = merge('-', '+', power < 0)
        size = abs(power)
        next = next + 2
        if (size < 100) then
            line(next:next) = achar(iachar('0') + size/10)
            line(next + 1:next + 1) = achar(iachar('0') + mod(size, 10))
            next = next + 2
        else
            call put_whole(int(size, i64), line, next)
        end if
    end subroutine put_power

end module base_shortest
