!> One table of the 1970 page: u is stepped, both roots in v are printed.
!>
!> The conic is `p u**2 + b u v + q v**2 + d u + e v = -1`; for the X table u is X and v is Y, for
!> the Y table the other way round. One root is the contour, the other the far side of the conic.
!>
!>     columns  1        8-16   18-26   28-36
!>              control  u      root 1  root 2      (1H ,6X,F9.3,1X,F9.3,1X,F9.3)
!>
!> Source: SAE 700202, appendix A, statements 54 to 70 and 75 to the end.
module period_table
    use base_constants, only: largest_table
    use base_decimal, only: decimal_type
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp, i64
    use base_output, only: output_type
    use base_text, only: compact, to_text
    use period_arithmetic, only: abs, operator(*), operator(+), operator(-), operator(/), short_sqrt
    use period_convert, only: single_constant
    use period_format, only: put_fixed
    use period_printer, only: printer_type
    use period_trap, only: interrupt
    use period_word, only: hex_type, is_positive, is_zero, to_real, whole
    implicit none (type, external)
    private

    public :: table_type, print_table

    !> What a table is made of. All ordinates shifted.
    type :: table_type
        character :: axis             !! X or Y, the stepped one
        type(hex_type) :: first       !! ordinate of point 1
        type(hex_type) :: last        !! ordinate of point 3
        type(hex_type) :: step        !! increment, not zero
        type(hex_type) :: p, b, q     !! coefficients of u**2, u v, v**2
        type(hex_type) :: d, e        !! coefficients of u, v
        type(hex_type) :: shift       !! added to every ordinate, taken off before printing
    end type table_type

    !> Added to each ordinate before it is printed; a single precision constant of the program.
    type(decimal_type), parameter :: half_of_last_place = decimal_type(5_i64, -4)

contains

    !> Prints the rows from the first ordinate and one step on, until the last ordinate is reached;
    !> one row at least.
    !>
    !> Fails with `cause%too_many` before any row where there would be more than `largest_table`, or
    !> where the step is lost in the ordinate; with `cause%overflow`, `%underflow` or `%divide`
    !> at the row where the machine would have stopped.
    subroutine print_table(table, printer, out, error)
        type(table_type), intent(in) :: table               !! what to print
        type(printer_type), intent(in) :: printer           !! how lines leave
        type(output_type), intent(inout) :: out             !! where to
        type(error_type), allocatable, intent(out) :: error !! see above
        type(hex_type) :: u, next, half, figure(3)
        character(36) :: line
        integer :: row

        call check_length(table, error)
        if (allocated(error)) return
        half = single_constant(half_of_last_place)
        line = ''
        u = table%first + table%step
        do row = 1, largest_table
            figure = ([u, roots(table, u)] - table%shift) + half
            call check_row(table, u, figure, error)
            if (allocated(error)) return
            call put_fixed(figure(1), 3, line(8:16))
            call put_fixed(figure(2), 3, line(18:26))
            call put_fixed(figure(3), 3, line(28:36))
            call printer%print(line, out)
            next = u + table%step
            if (is_past(table, next)) return
            if (is_zero(next - u)) exit
            u = next
        end do
        call fail(error, cause%too_many, 'the '//table%axis//' table does not reach point 3 in '// &
            to_text(row - 1)//' rows: punch a larger '//table%axis//'I')
    end subroutine print_table

    !> Both roots in v at an ordinate u: the contour and the far side.
    pure function roots(table, u) result(v)
        type(table_type), intent(in) :: table !! the coefficients
        type(hex_type), intent(in) :: u       !! the stepped ordinate, shifted
        type(hex_type) :: v(2)
        type(hex_type) :: g, h, r, divisor

        g = (table%p*(u*u) + table%d*u) + whole(1)
        h = table%b*u + table%e
        if (is_zero(table%q)) then
            v = [-(g/h), whole(0)]
        else
            r = short_sqrt(abs(h*h - (whole(4)*table%q)*g))
            divisor = whole(2)*table%q
            v = [(-h + r)/divisor, (-h - r)/divisor]
        end if
    end function roots

    !> True where an ordinate has reached point 3, from the side the step comes from.
    pure logical function is_past(table, u)
        type(table_type), intent(in) :: table !! the last ordinate and the step
        type(hex_type), intent(in) :: u       !! an ordinate, shifted
        if (is_positive(table%step)) then
            is_past = .not. is_positive(table%last - u)
        else
            is_past = .not. is_positive(u - table%last)
        end if
    end function is_past

    !> Looks for a trap in the figures of a row.
    pure subroutine check_row(table, u, figure, error)
        type(table_type), intent(in) :: table               !! the axis and the shift
        type(hex_type), intent(in) :: u                     !! the stepped ordinate, shifted
        type(hex_type), intent(in) :: figure(3)             !! what is to be printed
        type(error_type), allocatable, intent(out) :: error !! `cause%overflow`, ...
        integer :: i

        do i = 1, 3
            if (figure(i)%trap == 0) cycle
            call interrupt(figure(i)%trap, 'in the row at '//table%axis//' = '// &
                compact(to_real(u - table%shift)), error)
            return
        end do
    end subroutine check_row

    !> Refuses a table that is too long, or would not end.
    pure subroutine check_length(table, error)
        type(table_type), intent(in) :: table               !! ordinates and step
        type(error_type), allocatable, intent(out) :: error !! `cause%too_many`
        real(dp), parameter :: most_counted = 1.0e15_dp
        character(:), allocatable :: rows
        real(dp) :: steps

        steps = (to_real(table%last) - to_real(table%first))/to_real(table%step)
        if (steps > real(largest_table, dp) + 1.5_dp) then
            rows = compact(steps)
            if (steps < most_counted) rows = to_text(ceiling(steps, i64) - 1)
            call fail(error, cause%too_many, 'the '//table%axis//' table would have '// &
                rows//' rows, and the most is '//to_text(largest_table)// &
                ': punch a larger '//table%axis//'I')
        else if (steps > 1.0_dp .and. is_zero((table%first + table%step) - table%first)) then
            call fail(error, cause%too_many, 'the '//table%axis//' table would not end: '// &
                table%axis//'I is too small to change '//table%axis//': punch a larger one')
        end if
    end subroutine check_length

end module period_table
