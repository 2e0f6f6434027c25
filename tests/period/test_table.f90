!> Tables of conics whose ordinates are plain numbers: their roots fit 6 hexadecimal digits.
program test_table
    use base_decimal, only: decimal_type
    use base_error, only: cause, error_type
    use base_kinds, only: i64
    use base_output, only: output_type
    use period_arithmetic, only: operator(+), operator(/)
    use period_convert, only: from_decimal
    use period_printer, only: printer_type
    use period_table, only: print_table, table_type
    use period_word, only: hex_type, whole
    use support_tap, only: tap_type
    implicit none (type, external)

    character, parameter :: lf = new_line('a')
    type(tap_type) :: tap

    call check_roots()
    call check_line()
    call check_no_ordinate()
    call check_end()
    call tap%finish()

contains

    !> A table without shift: coefficients are whole numbers over a divisor.
    type(table_type) function table_of(range, coefficient, divisor) result(table)
        integer, intent(in) :: range(3), coefficient(5), divisor
        type(hex_type) :: k(5)
        k = whole(coefficient)/whole(divisor)
        table = table_type('X', whole(range(1)), whole(range(2)), whole(range(3)), &
            k(1), k(2), k(3), k(4), k(5), whole(0))
    end function table_of

    !> Prints a table; the cause of its error, 0 for none.
    subroutine run(table, page, why)
        type(table_type), intent(in) :: table
        character(:), allocatable, intent(out) :: page
        integer, intent(out) :: why
        type(output_type) :: out
        type(error_type), allocatable :: error
        call print_table(table, printer_type(), out, error)
        page = out%text()
        why = 0
        if (allocated(error)) why = error%cause
    end subroutine run

    !> x**2 + y**2 = 16 divided by -16, exact in hexadecimal: at 0 the roots are 4 and -4, at 4 both
    !> are 0; the root with plus over a negative coefficient is the lower one.
    subroutine check_roots()
        character(:), allocatable :: page
        integer :: why
        call run(table_of([-4, 8, 4], [-1, 0, -1, 0, 0], 16), page, why)
        call tap%same(page, &
            '          0.000    -4.000     4.000'//lf// &
            '          4.000     0.000     0.000'//lf, &
                'a circle: both roots, on the axis and at its end')
        call tap%ok(why == 0, 'a circle has no error')
    end subroutine check_roots

    !> No square of v: 2 u - v = -1 has the one root v = 2 u + 1, and 0 in the second column.
    subroutine check_line()
        character(:), allocatable :: page
        integer :: why
        call run(table_of([0, 3, 1], [0, 0, 0, 2, -1], 1), page, why)
        call tap%same(page, &
            '          1.000     3.000     0.000'//lf// &
            '          2.000     5.000     0.000'//lf, 'a line: the linear root, zero beside it')
        call tap%ok(why == 0, 'a line has no error')
    end subroutine check_line

    !> u v - v = -1: no ordinate at u = 1, where the machine divides by zero.
    subroutine check_no_ordinate()
        character(:), allocatable :: page
        integer :: why
        call run(table_of([-1, 3, 1], [0, 1, 0, 0, -1], 1), page, why)
        call tap%same(page, '          0.000     1.000     0.000'//lf, &
            'rows before the one without an ordinate are printed')
        call tap%ok(why == cause%divide, 'a row without an ordinate is a division by zero')
    end subroutine check_no_ordinate

    !> Steps of .1 are cut to a word, so that the tenth falls short of 1 and is printed.
    subroutine check_end()
        character(:), allocatable :: page
        integer :: why
        type(table_type) :: table
        table = table_of([0, 1, 1], [0, 0, 0, 2, -1], 1)
        table%step = from_decimal(decimal_type(1_i64, -1))
        call run(table, page, why)
        call tap%ok(index(page, '          1.000     3.000     0.000'//lf) > 0 &
            .and. len(page) == 10*36, 'a step that is cut falls short of X3 and prints it')
        table = table_of([3, 0, -1], [0, 0, 0, 2, -1], 1)
        call run(table, page, why)
        call tap%same(page, &
            '          2.000     5.000     0.000'//lf// &
            '          1.000     3.000     0.000'//lf, 'a negative step counts down')
    end subroutine check_end

end program test_table
