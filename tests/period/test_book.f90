!> The page of the book: the eleven cards of SAE 700202, appendix B, run as in 1970, every ordinate
!> of tables 2 and 4 digit for digit, the coefficients, and the page as its formats set it.
program test_book
    use base_decimal, only: decimal_type
    use base_error, only: error_type
    use base_kinds, only: i64
    use base_output, only: output_type
    use period_printer, only: printer_type
    use period_program, only: default_shift, run_card
    use support_punched, only: card_of, decimal
    use support_tap, only: tap_type
    implicit none (type, external)

    character, parameter :: lf = new_line('a'), ff = achar(12)
    integer, parameter :: cards = 11

    !> A card of the book, its name and what it printed.
    type :: run_type
        character(20) :: name = ''
        character(80) :: card = ''
        character(:), allocatable :: page
    end type run_type

    type(tap_type) :: tap
    type(run_type) :: run(cards)

    call run_the_book(run)
    call check_ordinates(run)
    call check_inputs(run)
    call check_first_page(run(1)%page)
    call check_section_page(run(7)%page, run(8)%page)
    call tap%finish()

contains

    !> Runs the deck of the book card by card, each to a text of its own.
    subroutine run_the_book(run)
        type(run_type), intent(out) :: run(cards)
        character(132) :: line, name
        integer :: unit, status, n

        n = 0
        name = ''
        open (newunit=unit, file='cards/sae700202.crd', action='read', status='old')
        do
            read (unit, '(a)', iostat=status) line
            if (status /= 0) exit
            if (line(1:2) == '* ') name = line(3:)
            if (scan(line(1:1), '*TU') > 0) cycle
            if (line(1:7) == '999.999') exit
            n = n + 1
            if (n > cards) exit
            run(n)%name = name(:20)
            run(n)%card = line(:80)
            run(n)%page = page_of(line(:80))
        end do
        close (unit)
        call tap%ok(n == cards, 'the deck of the book has eleven cards before its end card')
    end subroutine run_the_book

    !> What a card prints with the usual shift on paper; a failure is shown.
    function page_of(image) result(page)
        character(*), intent(in) :: image
        character(:), allocatable :: page
        type(output_type) :: out
        type(error_type), allocatable :: error
        call run_card(card_of(image), default_shift, printer_type(), out, error)
        page = out%text()
        if (allocated(error)) call tap%ok(.false., 'no error: '//error%message)
    end function page_of

    !> Every figure of tables 2 and 4: `table,line,axis,along,column,scanned,restored`.
    subroutine check_ordinates(run)
        type(run_type), intent(in) :: run(cards)
        character(132) :: line
        character(24) :: field(7)
        integer :: unit, status, figures

        figures = 0
        open (newunit=unit, file='golden/book/tables.csv', action='read', status='old')
        read (unit, '(a)', iostat=status) line
        do
            read (unit, '(a)', iostat=status) line
            if (status /= 0) exit
            call split(line, field)
            figures = figures + 1
            call tap%same(trim(figure(run, field(2), field(3), field(4), field(5))), &
                trim(field(7)), 'table '//trim(field(1))//', '//trim(field(2))//', '// &
                trim(field(5))//' at '//trim(field(3))//' = '//trim(field(4)))
        end do
        close (unit)
        call tap%ok(figures == 84, 'the book has 84 ordinates')
    end subroutine check_ordinates

    !> The figure printed for a line at an ordinate.
    function figure(run, name, axis, along, column) result(text)
        type(run_type), intent(in) :: run(cards)
        character(*), intent(in) :: name, axis, along, column
        character(9) :: text
        character(:), allocatable :: page, row
        integer :: i, first, last

        text = 'missing'
        do i = 1, cards
            if (run(i)%name /= name) cycle
            page = run(i)%page
            first = index(page, ff, back=.true.)
            if (axis == 'X' .and. first > 1) page = page(:first - 1)
            if (axis == 'Y' .and. first > 1) page = page(first:)
            if (axis == 'Y' .and. first == 1) return
            do while (len(page) > 0)
                last = index(page, lf)
                row = page(:last - 1)
                page = page(last + 1:)
                if (len(row) /= 35) cycle
                if (adjustl(row(7:15)) /= along) cycle
                if (column == 'root1') text = adjustl(row(17:25))
                if (column == 'root2') text = adjustl(row(27:35))
                return
            end do
        end do
    end function figure

    !> Tables 1 and 3 are what is punched; the first line's coefficients are what is printed.
    subroutine check_inputs(run)
        type(run_type), intent(in) :: run(cards)
        character(*), parameter :: names = 'X1 Y1 S1 X2 Y2 X3 Y3 S3 XI YI', letters = 'ABCDE'
        integer, parameter :: first(11) = [1, 9, 17, 25, 33, 41, 49, 57, 65, 71, 77]
        character(132) :: line
        character(24) :: field(7)
        character(:), allocatable :: second
        character(80) :: card
        integer :: unit, status, i, k

        second = run(1)%page(index(run(1)%page, lf) + 1:)
        open (newunit=unit, file='golden/book/inputs.csv', action='read', status='old')
        read (unit, '(a)', iostat=status) line
        do
            read (unit, '(a)', iostat=status) line
            if (status /= 0) exit
            call split(line, field)
            if (field(1) == '2' .and. field(3) == 'check') then
                call tap%same(second(index(second, lf) + 1:index(second, lf) + 16), &
                    repeat(' ', 8)//trim(field(5)), 'the printed check value')
            else if (field(1) == '2') then
                k = index(letters, trim(field(3)))
                call tap%same(trim(adjustl(second(11*k - 5:11*k + 5))), trim(field(5)), &
                    'the printed coefficient '//trim(field(3)))
            else
                k = (index(names, trim(field(3))) + 2)/3
                do i = 1, cards
                    if (run(i)%name == field(2)) exit
                end do
                card = run(i)%card
                call tap%ok(same_number(card(first(k):first(k + 1) - 1), field(5)), &
                    'punched '//trim(field(2))//' '//trim(field(3)))
            end if
        end do
        close (unit)
    end subroutine check_inputs

    !> True where two texts are the same decimal.
    logical function same_number(a, b)
        character(*), intent(in) :: a, b
        type(decimal_type) :: p, q
        p = decimal(a)
        q = decimal(b)
        same_number = p%digits*10_i64**(int(p%power, i64) + 6_i64) &
            == q%digits*10_i64**(int(q%power, i64) + 6_i64)
    end function same_number

    !> Fields between commas.
    subroutine split(line, field)
        character(*), intent(in) :: line
        character(*), intent(out) :: field(:)
        integer :: i, first, comma
        first = 1
        field = ''
        do i = 1, size(field)
            comma = index(line(first:), ',')
            if (comma == 0) comma = len(line) - first + 2
            field(i) = line(first:first + comma - 2)
            first = first + comma
            if (first > len(line)) exit
        end do
    end subroutine split

    !> The top of the first page, character for character as the formats set it.
    subroutine check_first_page(page)
        character(*), intent(in) :: page
        call tap%same(page(:index(page, '        -20.000') - 1), ff// &
            '  -30.00000 -10.00000   0.11400   0.0      -7.10000'// &
            '  50.00000  -4.00000   0.05230'//lf// &
            '      0.00000088'//'-0.00002608'//' 0.00013696'//' 0.00229387'//'-0.02344400'//lf// &
            repeat('        -1.00000'//lf, 3)// &
            '        -25.000    -5.099    -9.443'//lf, &
                'the first page of table 2 begins as the formats say')
        call tap%ok(lines(page) == 5 + 15, 'the first page has 15 rows, X1 and X3 not among them')
    end subroutine check_first_page

    !> A card without a Y table has one page, one with a Y table two, the second without checks.
    subroutine check_section_page(floor_page, station_page)
        character(*), intent(in) :: floor_page, station_page
        character(:), allocatable :: second
        call tap%ok(index(floor_page, ff, back=.true.) == 1, 'without ITYP there is one page')
        second = station_page(index(station_page, ff, back=.true.):)
        call tap%ok(index(second, '999.99900') > 0 .and. &
            index(second, lf//'        -1.00000') == 0, &
            'the Y page repeats inputs and coefficients, not the checks')
        call tap%ok(lines(second) == 2 + 3, 'the Y table of station 10 has three rows')
        call tap%same(second(2:82), station_page(2:82), 'both pages have the same inputs')
    end subroutine check_section_page

    !> Line feeds of a text.
    integer function lines(text)
        character(*), intent(in) :: text
        integer :: i
        lines = 0
        do i = 1, len(text)
            if (text(i:i) == lf) lines = lines + 1
        end do
    end function lines

end program test_book
