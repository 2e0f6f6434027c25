!> A number in a field that is what most are: blanks, a sign, figures, and among them a point, or
!> none in a whole number. `deck_number` follows all that a number may be, five times as long.
module deck_plain_number
    use base_decimal, only: decimal_type
    use base_kinds, only: i64
    implicit none (type, external)
    private

    public :: read_plain

    !> Figures that a number may have.
    integer, parameter, public :: most_figures = 18

contains

    !> Reads a field where it is such a number; any other leaves the value as it was.
    pure subroutine read_plain(field, is_whole, value, is_plain)
        character(*), intent(in) :: field           !! the columns of the field, not blank
        logical, intent(in) :: is_whole             !! a whole number is asked for
        type(decimal_type), intent(inout) :: value  !! the number, exact
        logical, intent(out) :: is_plain            !! it was read
        integer(i64) :: digits
        integer :: i, first, point
        logical :: is_negative

        is_plain = .false.
        if (len(field) > most_figures) return
        first = 1
        do while (field(first:first) == ' ')
            first = first + 1
        end do
        is_negative = field(first:first) == '-'
        if (is_negative .or. field(first:first) == '+') first = first + 1
        digits = 0
        point = 0
        do i = first, len(field)
            if (field(i:i) >= '0' .and. field(i:i) <= '9') then
                digits = 10*digits + int(iachar(field(i:i)) - iachar('0'), i64)
            else if (field(i:i) == '.' .and. point == 0) then
                point = i
            else
                return
            end if
        end do
        is_plain = len(field) - first >= merge(1, 0, point > 0) .and. (point > 0 .neqv. is_whole)
        if (.not. is_plain) return
        value = decimal_type()
        if (digits == 0) return
        value%digits = merge(-digits, digits, is_negative)
        if (point > 0) value%power = point - len(field)
    end subroutine read_plain

end module deck_plain_number
