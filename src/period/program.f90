!> The 1970 program: one card in, its page out. Nothing is printed that the program did not print.
!>
!>     heading   (1H1,1X,8F10.5/6X,5F11.8)   X1 Y1 S1 X2 Y2 X3 Y3 S3 / A B C D E
!>     checks    (1H ,5X,F11.5)              the left side at points 1, 2, 3: -1.00000 each
!>     rows      (1H ,6X,F9.3,1X,F9.3,1X,F9.3)
!>
!> The field of the checks can't be read in the scan; it is set in line with the first coefficient.
!> Source: SAE 700202, appendix A.
module period_program
    use base_decimal, only: decimal_type
    use base_error, only: cause, error_type, fail
    use base_kinds, only: i64
    use base_output, only: output_type
    use period_arithmetic, only: operator(*), operator(+), operator(-)
    use period_card, only: period_card_type
    use period_convert, only: from_decimal
    use period_format, only: put_fixed
    use period_printer, only: printer_type
    use period_solve, only: array_of, conditions_type, solve_array
    use period_table, only: print_table, table_type
    use period_trap, only: interrupt
    use period_word, only: hex_type, is_zero
    implicit none (type, external)
    private

    public :: run_card

    !> What the program adds to every X and Y unless it is told otherwise.
    type(decimal_type), parameter, public :: default_shift = decimal_type(100_i64, 0)

    !> A card in the machine: points shifted, coefficients found.
    type :: conic_type
        type(conditions_type) :: given      !! points and slopes
        type(hex_type) :: xi                !! increment of X
        type(hex_type) :: yi                !! increment of Y
        type(hex_type) :: shift             !! added to every X and Y
        type(hex_type) :: coefficient(5)    !! A to E
    end type conic_type

contains

    !> Runs one card. What the card has printed before an error stays printed.
    !>
    !> Fails with `cause%singular` and `cause%increment` where the page has the program's own
    !> message; with `cause%overflow`, `%underflow` or `%divide` where the machine would have
    !> stopped the card; with `cause%too_many` where a table would be longer than `largest_table`;
    !> with `cause%checks_off`, all printed, where a check value is not the -1.00000 it must be.
    subroutine run_card(card, shift, printer, out, error)
        type(period_card_type), intent(in) :: card          !! the card, deck units
        type(decimal_type), intent(in) :: shift             !! added to every X and Y, deck units
        type(printer_type), intent(in) :: printer           !! how lines leave
        type(output_type), intent(inout) :: out             !! where to
        type(error_type), allocatable, intent(out) :: error !! see above
        type(conic_type) :: conic
        logical :: checks_hold

        call read_conic(card, shift, conic, error)
        if (allocated(error)) return
        call solve_conic(conic, error)
        if (allocated(error)) then
            if (error%cause == cause%singular) then
                call printer%print(' THIS ARRAY HAS NO UNIQUE SOLUTION', out)
                call printer%print(' ', out)
            end if
            return
        end if
        call print_heading(conic, printer, out)
        call print_checks(conic, printer, out, checks_hold, error)
        if (allocated(error)) return
        call print_stepped(x_table(conic), printer, out, error)
        if (.not. allocated(error) .and. card%ityp /= 0) then
            call print_heading(conic, printer, out)
            call print_stepped(y_table(conic), printer, out, error)
        end if
        if (.not. allocated(error) .and. .not. checks_hold) call fail(error, cause%checks_off, &
            'the check values are not -1.00000: the figures of this card are not of its conic; '// &
            'with a shift that takes no point near zero they may be')
    end subroutine run_card

    !> Puts the card into words and shifts the points.
    pure subroutine read_conic(card, shift, conic, error)
        type(period_card_type), intent(in) :: card          !! the card
        type(decimal_type), intent(in) :: shift             !! added to every X and Y
        type(conic_type), intent(out) :: conic              !! coefficients not yet set
        type(error_type), allocatable, intent(out) :: error !! `cause%overflow`, `%underflow`
        character(*), parameter :: name(11) = ['field X1', 'field Y1', 'field S1', 'field X2', &
            'field Y2', 'field X3', 'field Y3', 'field S3', 'field XI', 'field YI', 'shift   ']
        type(hex_type) :: word(11)
        integer :: i

        word = from_decimal([card%x1, card%y1, card%s1, card%x2, card%y2, card%x3, card%y3, &
            card%s3, card%xi, card%yi, shift])
        do i = 1, size(word)
            call interrupt(word(i)%trap, 'in the '//trim(name(i)), error)
            if (allocated(error)) return
        end do
        conic%given%s1 = word(3)
        conic%given%s3 = word(8)
        conic%xi = word(9)
        conic%yi = word(10)
        conic%shift = word(11)
        conic%given%x1 = word(1) + conic%shift
        conic%given%y1 = word(2) + conic%shift
        conic%given%x2 = word(4) + conic%shift
        conic%given%y2 = word(5) + conic%shift
        conic%given%x3 = word(6) + conic%shift
        conic%given%y3 = word(7) + conic%shift
    end subroutine read_conic

    !> Finds the coefficients.
    pure subroutine solve_conic(conic, error)
        type(conic_type), intent(inout) :: conic            !! conditions; solved on return
        type(error_type), allocatable, intent(out) :: error !! `cause%singular`, `%overflow`, ...
        type(hex_type) :: w(5, 6)
        logical :: solved

        w = array_of(conic%given)
        call interrupt(first_trap(reshape(w, [30])), 'in the array', error)
        if (allocated(error)) return
        call solve_array(w, solved)
        call interrupt(first_trap(reshape(w, [30])), 'in the solution of the array', error)
        if (allocated(error)) return
        conic%coefficient = w(:, 6)
        if (.not. solved) call fail(error, cause%singular, 'this array has no unique solution: '// &
            'the three points and two slopes do not fix one conic, or not with this shift')
    end subroutine solve_conic

    !> The first trap of some words, 0 where there is none.
    pure integer function first_trap(word) result(trap)
        type(hex_type), intent(in) :: word(:) !! any words
        integer :: i
        trap = 0
        do i = 1, size(word)
            trap = word(i)%trap
            if (trap /= 0) return
        end do
    end function first_trap

    !> A new page with the inputs, shift removed, and the coefficients.
    subroutine print_heading(conic, printer, out)
        type(conic_type), intent(in) :: conic       !! conditions and coefficients
        type(printer_type), intent(in) :: printer   !! how lines leave
        type(output_type), intent(inout) :: out     !! where to
        type(hex_type) :: input(8)
        character(82) :: line
        integer :: i

        associate (c => conic%given, shift => conic%shift)
            input = [c%x1 - shift, c%y1 - shift, c%s1, c%x2 - shift, c%y2 - shift, &
                c%x3 - shift, c%y3 - shift, c%s3]
        end associate
        line = '1'
        do i = 1, 8
            call put_fixed(input(i), 5, line(10*i - 7:10*i + 2))
        end do
        call printer%print(line, out)
        line = ''
        do i = 1, 5
            call put_fixed(conic%coefficient(i), 8, line(11*i - 4:11*i + 6))
        end do
        call printer%print(line, out)
    end subroutine print_heading

    !> The left side of the equation at the three points, which must be -1.
    subroutine print_checks(conic, printer, out, hold, error)
        type(conic_type), intent(in) :: conic               !! conditions and coefficients
        type(printer_type), intent(in) :: printer           !! how lines leave
        type(output_type), intent(inout) :: out             !! where to
        logical, intent(out) :: hold                        !! each prints as -1.00000
        type(error_type), allocatable, intent(out) :: error !! `cause%overflow`, `%underflow`
        type(hex_type) :: left(3)
        character(17) :: line
        integer :: i

        associate (c => conic%given)
            left = left_side(conic%coefficient, [c%x1, c%x2, c%x3], [c%y1, c%y2, c%y3])
        end associate
        hold = .true.
        call interrupt(first_trap(left), 'in the check of the coefficients', error)
        if (allocated(error)) return
        line = ''
        do i = 1, 3
            call put_fixed(left(i), 5, line(7:17))
            hold = hold .and. adjustl(line) == '-1.00000'
            call printer%print(line, out)
        end do
    end subroutine print_checks

    !> `A x**2 + B x y + C y**2 + D x + E y`, summed from the left.
    pure function left_side(coefficient, x, y) result(left)
        type(hex_type), intent(in) :: coefficient(5) !! A to E
        type(hex_type), intent(in) :: x(3)           !! points, shifted
        type(hex_type), intent(in) :: y(3)           !! points, shifted
        type(hex_type) :: left(3)
        associate (a => coefficient(1), b => coefficient(2), c => coefficient(3), &
            d => coefficient(4), e => coefficient(5))
            left = a*(x*x) + (b*x)*y + c*(y*y) + d*x + e*y
        end associate
    end function left_side

    !> The table of Y over X.
    pure type(table_type) function x_table(conic) result(table)
        type(conic_type), intent(in) :: conic !! solved
        associate (k => conic%coefficient)
            table = table_type('X', conic%given%x1, conic%given%x3, conic%xi, &
                k(1), k(2), k(3), k(4), k(5), conic%shift)
        end associate
    end function x_table

    !> The table of X over Y: A and C, D and E change places.
    pure type(table_type) function y_table(conic) result(table)
        type(conic_type), intent(in) :: conic !! solved
        associate (k => conic%coefficient)
            table = table_type('Y', conic%given%y1, conic%given%y3, conic%yi, &
                k(3), k(2), k(1), k(5), k(4), conic%shift)
        end associate
    end function y_table

    !> Prints a table, or the program's message where the increment is zero.
    subroutine print_stepped(table, printer, out, error)
        type(table_type), intent(in) :: table               !! the table
        type(printer_type), intent(in) :: printer           !! how lines leave
        type(output_type), intent(inout) :: out             !! where to
        type(error_type), allocatable, intent(out) :: error !! `cause%increment`, others

        if (is_zero(table%step)) then
            call printer%print('       INVALID INCREMENT OF X OR Y', out)
            call fail(error, cause%increment, table%axis//'I is zero: punch an increment')
        else
            call print_table(table, printer, out, error)
        end if
    end subroutine print_stepped

end module period_program
