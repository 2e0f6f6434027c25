!> `make book`: every figure that SAE 700202 prints of the nose, beside what LOFT makes of the same
!> cards, in System/360 arithmetic and from the arc; then the inlet of seed 002. Ends with status 1
!> where a figure in System/360 arithmetic is not the printed one.
!>
!>     as scanned    the characters of the damaged scan
!>     as restored   the figure as it was printed
!>     s360          the program of 1970 in System/360 arithmetic
!>     ieee          the arc in doubles, rounded once
!>     off           ieee less restored, in units of the last printed figure
program book
    use, intrinsic :: iso_fortran_env, only: output_unit
    use base_kinds, only: dp
    use base_text, only: right, to_text
    use body_body, only: body_type
    use base_digits, only: fixed
    use support_book, only: characters_wrong, figure_type, read_coefficients, read_figures, &
        text_file
    use support_book_card, only: book_card_type, exact_figure, is_of_contour, printed_figure, &
        run_cards, value_of
    use support_book_inlet, only: inlet_count, inlet_lines
    use support_book_nose, only: is_of_nose, nose_of_deck, off_nose, point_of
    implicit none (type, external)

    !> What the closing lines count.
    type :: count_type
        integer :: figures = 0              !! figures compared
        integer :: same = 0                 !! of them the same in System/360 arithmetic
        integer :: scan_wrong(0:2) = 0      !! scans with none, one, more characters wrong
        real(dp) :: punched(2) = 0.0_dp     !! largest error on contour and far side, inches
        real(dp) :: meant(2) = 0.0_dp       !! the same against curves that end vertical
    end type count_type

    !> What the paper says of its figures: .0015 in, .0381 mm.
    real(dp), parameter :: claim = 0.0015_dp
    real(dp), parameter :: millimetres = 25.4_dp
    integer, parameter :: ordinate_decimals = 3, coefficient_decimals = 8

    type(book_card_type), allocatable :: cards(:)
    type(count_type) :: ordinates, coefficients

    cards = run_cards(text_file('cards/sae700202.crd'))
    call say('The figures of SAE 700202 (1970), appendix B, and the same from its cards.')
    call say('Off: ieee less restored, in units of the last printed figure.')
    call compare(read_coefficients('golden/book/inputs.csv'), coefficient_decimals, coefficients)
    call compare(read_figures('golden/book/tables.csv'), ordinate_decimals, ordinates)
    call say('')
    call close_count()
    call compare_nose(read_figures('golden/book/tables.csv'))
    call show_inlet()
    if (ordinates%same < ordinates%figures .or. coefficients%same < coefficients%figures) &
        stop 1, quiet=.true.

contains

    !> Compares figures, table by table.
    subroutine compare(figures, decimals, counted)
        type(figure_type), intent(in) :: figures(:)
        integer, intent(in) :: decimals
        type(count_type), intent(inout) :: counted
        integer :: i

        do i = 1, size(figures)
            if (begins_table(figures, i)) call head_table(figures(i))
            call compare_figure(figures(i), card_named(figures(i)%line), decimals, counted)
        end do
    end subroutine compare

    !> True where a figure begins a table: the one before it is of another.
    pure logical function begins_table(figures, i)
        type(figure_type), intent(in) :: figures(:)
        integer, intent(in) :: i
        begins_table = i == 1
        if (begins_table) return
        associate (a => figures(i - 1), b => figures(i))
            begins_table = a%line /= b%line .or. a%axis /= b%axis .or. a%column /= b%column
        end associate
    end function begins_table

    !> Prints the head of a table.
    subroutine head_table(figure)
        type(figure_type), intent(in) :: figure
        character(:), allocatable :: words

        words = 'coefficients'
        if (figure%axis /= '') then
            words = merge('Y at steps of X', 'X at steps of Y', figure%axis == 'X')//', '// &
                merge('first ', 'second', figure%column == 'root1')
            words = trim(words)//' root'
            words = words//': '//trim(merge('the contour ', 'the far side', &
                is_of_contour(card_named(figure%line), figure)))
        end if
        call say('')
        call say('Table '//figure%table//', '//trim(figure%line)//', '//words)
        call say(right(merge('at', '  ', figure%axis /= ''), 9)//right('as scanned', 15)// &
            right('as restored', 15)//right('s360', 15)//right('ieee', 15)//right('off', 7))
    end subroutine head_table

    !> Prints a figure in all its readings and counts how they agree.
    subroutine compare_figure(figure, card, decimals, counted)
        type(figure_type), intent(in) :: figure
        type(book_card_type), intent(in) :: card
        integer, intent(in) :: decimals
        type(count_type), intent(inout) :: counted
        character(15) :: period, ieee
        integer :: off, wrong, side
        real(dp) :: exact

        exact = exact_figure(card, card%meant, figure)
        period = with_zero(printed_figure(card, figure))
        ieee = fixed(exact, 15, decimals)
        off = nint((value_of(ieee) - value_of(figure%restored))*10.0_dp**decimals)
        call say(right(figure%along, 9)//right(figure%scanned, 15)//right(figure%restored, 15)// &
            right(period, 15)//ieee//right(to_text(off), 7)//mark(period, figure))

        counted%figures = counted%figures + 1
        if (period == figure%restored) counted%same = counted%same + 1
        wrong = min(2, characters_wrong(figure%scanned, trim(figure%restored)))
        counted%scan_wrong(wrong) = counted%scan_wrong(wrong) + 1
        if (figure%axis == '') return
        side = merge(1, 2, is_of_contour(card, figure))
        counted%meant(side) = max(counted%meant(side), abs(value_of(period) - exact))
        exact = exact_figure(card, card%punched, figure)
        counted%punched(side) = max(counted%punched(side), abs(value_of(period) - exact))
    end subroutine compare_figure

    !> A star beside a figure in System/360 arithmetic that is not the printed one.
    pure function mark(period, figure)
        character(*), intent(in) :: period
        type(figure_type), intent(in) :: figure
        character(:), allocatable :: mark
        mark = ''
        if (period /= figure%restored) mark = ' *'
    end function mark

    !> Prints what came of it.
    subroutine close_count()
        integer :: wrong(0:2)

        wrong = ordinates%scan_wrong
        call say('In System/360 arithmetic '//of(ordinates)//' ordinates and '//of(coefficients)// &
            ' coefficients')
        call say('come out as printed.')
        call say('Of the ordinates '//to_text(wrong(0))//' agree as scanned, '// &
            to_text(wrong(1))//' differ in one character, '//to_text(wrong(2))//' in more.')
        call say('')
        call say('Largest error of the 1970 listing'//right('in', 21)//right('mm', 10))
        call say_length('against its cards as punched, on the contour', ordinates%punched(1))
        call say_length('    over all', maxval(ordinates%punched))
        call say_length('    as the paper claims', claim)
        call say_length('against sections that end vertical, contour', ordinates%meant(1))
        call say_length('    over all', maxval(ordinates%meant))
        call say('The sections end in a slope of 999.999 for a vertical one. The program of 1970')
        call say('took it as it stands, the arc is vertical: so the differences in table 4.')
    end subroutine close_count

    !> `84 of 84`.
    pure function of(counted) result(text)
        type(count_type), intent(in) :: counted
        character(:), allocatable :: text
        text = to_text(counted%same)//' of '//to_text(counted%figures)
    end function of

    !> Prints how far the points of table 4 are from the nose as LOFT makes it of the control lines
    !> of table 1, without a figure copied from one card to the next.
    subroutine compare_nose(figures)
        type(figure_type), intent(in) :: figures(:) !! tables 2 and 4
        type(body_type) :: nose
        character(61) :: row
        real(dp) :: distance, worst
        integer :: i

        call nose_of_deck(nose)
        call say('')
        call say('Table 4 and the nose of cards/nose.crd, which is made of table 1 alone')
        call say(right('STA', 9)//right('BL', 15)//right('WL', 15)//right('normal to skin, in', 22))
        worst = 0.0_dp
        do i = 1, size(figures)
            if (.not. is_of_nose(figures(i))) cycle
            associate (at => point_of(figures(i)))
                call off_nose(nose, at, distance)
                row = fixed(at(1), 9, 0)
                row(10:) = fixed(at(2), 15, 3)
                row(25:) = fixed(at(3), 15, 3)
                row(40:) = fixed(distance, 22, 5)
                call say(row)
            end associate
            worst = max(worst, abs(distance))
        end do
        row = fixed(worst, 9, 5)
        call say('Largest distance of a printed point from that nose:'//row(:9)//' in')
    end subroutine compare_nose

    !> Prints the inlet of seed 002, which LOFT does not reproduce.
    subroutine show_inlet()
        character(80) :: lines(inlet_count)
        integer :: i
        lines = inlet_lines()
        do i = 1, size(lines)
            call say(lines(i))
        end do
    end subroutine show_inlet

    !> Prints a length in inches and in millimetres.
    subroutine say_length(words, inches)
        character(*), intent(in) :: words
        real(dp), intent(in) :: inches
        character(45) :: name
        name = words
        call say(name//fixed(inches, 9, 5)//fixed(inches*millimetres, 10, 4))
    end subroutine say_length

    !> The card of a name.
    function card_named(name) result(card)
        character(*), intent(in) :: name
        type(book_card_type) :: card
        integer :: i
        do i = 1, size(cards)
            card = cards(i)
            if (card%name == name) return
        end do
        error stop 'the deck has no card for a figure of the book'
    end function card_named

    !> A figure with the zero before its point, as the book has it.
    pure function with_zero(text) result(figure)
        character(*), intent(in) :: text
        character(15) :: figure
        figure = text
        if (text(1:1) == '.') figure = '0'//text
        if (text(1:2) == '-.') figure = '-0'//text(2:)
    end function with_zero

    !> Prints a line without the blanks at its end.
    subroutine say(text)
        character(*), intent(in) :: text
        write (output_unit, '(a)') trim(text)
    end subroutine say

end program book
