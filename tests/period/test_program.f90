!> What the 1970 program does with cards that go wrong, and with carriage control. Its figures are
!> proved against the book in `test_book`.
program test_program
    use base_constants, only: largest_table
    use base_error, only: cause, error_type
    use base_output, only: output_type
    use period_printer, only: printer_type
    use period_program, only: default_shift, run_card
    use support_punched, only: card_of, decimal
    use support_tap, only: tap_type
    implicit none (type, external)

    character, parameter :: lf = new_line('a'), ff = achar(12)
    !> The first card of the book less its increments.
    character(*), parameter :: first_line = &
        '-30.0   -10.0   .114    0.0     -7.1    50.0    -4.0    .0523   '
    type(tap_type) :: tap

    call check_asa()
    call check_messages()
    call check_increments()
    call check_length()
    call check_traps()
    call tap%finish()

contains

    !> With `asa` the control column stays and there is no form feed.
    subroutine check_asa()
        type(output_type) :: out
        type(error_type), allocatable :: error
        character(:), allocatable :: page
        call run_card(card_of(first_line//'5.0'), default_shift, printer_type(asa=.true.), out, &
            error)
        page = out%text()
        call tap%same(page(:12), '1  -30.00000', 'the control column starts a page with 1')
        call tap%ok(index(page, ff) == 0, 'the control column replaces form feeds')
        call tap%ok(index(page, lf//'         -25.000    -5.099    -9.443'//lf) > 0, &
            'rows have a blank control column')
        call tap%ok(index(page, ' '//lf) == 0, 'no line ends in blanks')
    end subroutine check_asa

    !> Singular array and invalid increment.
    subroutine check_messages()
        character(*), parameter :: circle = &
            '0.      0.      0.      4.      4.      8.      0.      1.      1.'
        character(:), allocatable :: page
        integer :: why

        call outcome(circle, '0.', page, why)
        call tap%same(page, 'THIS ARRAY HAS NO UNIQUE SOLUTION'//lf//lf, &
            'a conic through the origin of the shifted axes has no solution and no page')
        call tap%ok(why == cause%singular, 'and that is an error')
        call outcome(first_line//'0.    1.     1', '100.', page, why)
        call tap%same(page(index(page, '-1.00000'//lf, back=.true.):), &
            '-1.00000'//lf//'      INVALID INCREMENT OF X OR Y'//lf, &
            'a zero XI ends the card, its Y table too')
        call tap%ok(why == cause%increment, 'a zero XI is an error')
        call outcome(first_line//'40.   0.     1', '100.', page, why)
        call tap%ok(index(page, '      INVALID INCREMENT OF X OR Y'//lf) > 0 &
            .and. lines(page) == 5 + 1 + 3, &
            'a zero YI prints the message on the Y page')
        call tap%ok(why == cause%increment, 'a zero YI is an error')
    end subroutine check_messages

    !> Increments that overshoot, point the wrong way, or count down.
    subroutine check_increments()
        character(*), parameter :: backward = &
            '50.0    -4.0    .0523   0.0     -7.1    -30.0   -10.0   .114    -5.0'
        character(:), allocatable :: page
        integer :: why

        call outcome(first_line//'80.', '100.', page, why)
        call tap%ok(lines(page) == 5 + 1 .and. index(page, '         50.000') > 0 .and. why == 0, &
            'one row is printed at X3 where the first step reaches it')
        call outcome(first_line//'-5.', '100.', page, why)
        call tap%ok(lines(page) == 5 + 1 .and. index(page, '        -35.000') > 0 .and. why == 0, &
            'an increment of the wrong sign prints one row')
        call outcome(backward, '100.', page, why)
        call tap%ok(lines(page) == 5 + 15 .and. index(page, '        -25.000') > 0 .and. why == 0, &
            'a negative increment counts down to X3')
        call outcome(first_line//'5.0', '1000.', page, why)
        call tap%ok(lines(page) == 5 + 15 .and. why == 0, &
            'another shift gives the same number of rows')
        call tap%ok(index(page, '  -30.00000 -10.00000') > 0, 'another shift is taken off again')
        call outcome(first_line//'5.0', '30.', page, why)
        call tap%ok(lines(page) == 5 + 15 .and. why == cause%checks_off, &
            'a shift that takes a point to X = 0 spoils the checks, and the page stands')
    end subroutine check_increments

    !> Tables that are too long, or would never end.
    subroutine check_length()
        character(*), parameter :: line = &
            '0.      -10.0   .114    10.0    -7.1    100.    -4.0    .0523   '
        character(:), allocatable :: page
        integer :: why

        call outcome(line//'.001', '100.', page, why)
        call tap%ok(lines(page) >= 5 + 99999 .and. lines(page) <= 5 + largest_table &
            .and. why == 0, 'a table of 99999 rows is printed')
        call outcome(line//'.00099', '100.', page, why)
        call tap%ok(lines(page) == 5 .and. why == cause%too_many, 'one of 101010 rows is refused')
        call outcome(line//'1.E-50', '100.', page, why)
        call tap%ok(lines(page) == 5 .and. why == cause%too_many, &
            'a step that is lost in X is refused')
        call outcome(line//'.002', '1.E14', page, why)
        call tap%ok(lines(page) == 5 .and. why == cause%too_many, &
            'a step below the last digit of X is refused')
        ! 16**11: below it the last digit is worth .00024, from it on .0039.
        call outcome('-1.0'//line(5:40)//'1.  '//line(45:)//'.001', '17592186044416.', page, why)
        call tap%ok(lines(page) > 1000 .and. lines(page) < 1100 .and. why == cause%too_many, &
            'a step that is lost on the way to X3 ends the table')
    end subroutine check_length

    !> Where the machine would have interrupted.
    subroutine check_traps()
        character(*), parameter :: rest = &
            '-10.0   .114    0.0     -7.1    50.0    -4.0    .0523   5.'
        character(:), allocatable :: page
        integer :: why

        call outcome('1.E76   '//rest, '100.', page, why)
        call tap%ok(page == '' .and. why == cause%overflow, &
            'a number that no word holds is an overflow')
        call outcome('1.E-79  '//rest, '100.', page, why)
        call tap%ok(page == '' .and. why == cause%underflow, &
            'a number too small for a word is an underflow')
        call outcome('1.E40   '//rest, '100.', page, why)
        call tap%ok(page == '' .and. why == cause%overflow, &
            'a square that overflows stops the card')
        call outcome('1.E-70  '//rest, '0.', page, why)
        call tap%ok(page == '' .and. why == cause%underflow, &
            'a square that underflows stops the card')
        call outcome('-30.0   '//rest(:len(rest) - 2)//'1.E39', '100.', page, why)
        call tap%ok(lines(page) == 5 .and. why == cause%overflow, &
            'a row that overflows is not printed')
    end subroutine check_traps

    !> What a card prints with a shift, and the cause of its error, 0 for none.
    subroutine outcome(image, shift, page, why)
        character(*), intent(in) :: image, shift
        character(:), allocatable, intent(out) :: page
        integer, intent(out) :: why
        type(output_type) :: out
        type(error_type), allocatable :: error
        call run_card(card_of(image), decimal(shift), printer_type(), out, error)
        page = out%text()
        why = 0
        if (.not. allocated(error)) return
        why = error%cause
        call tap%note(error%message)
    end subroutine outcome

    !> Line feeds of a text.
    integer function lines(text)
        character(*), intent(in) :: text
        integer :: i
        lines = 0
        do i = 1, len(text)
            if (text(i:i) == lf) lines = lines + 1
        end do
    end function lines

end program test_program
