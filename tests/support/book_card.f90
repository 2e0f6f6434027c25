!> The cards of the book, run both ways: the page of 1970 in System/360 arithmetic, its figures
!> found by their columns, and the arc, for which every figure is worked out exactly.
module support_book_card
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp, i64
    use base_output, only: output_type
    use body_card_arc, only: arc_of_card
    use body_card_facts, only: card_facts_type, facts_of_card
    use body_card_tables, only: card_table_type, tables_of_card
    use deck_conic_card, only: conic_card_type
    use deck_conic_deck, only: conic_deck_type, found
    use deck_layout, only: conic
    use deck_source, only: source_type
    use geom_arc, only: arc_through, arc_type, end_type
    use geom_conic, only: conic_of, conic_type, roots_at
    use geom_shifted, only: shifted_type
    use period_card, only: period_card_type
    use period_printer, only: printer_type
    use period_program, only: default_shift, run_card
    use support_book, only: figure_type
    implicit none (type, external)
    private

    public :: book_card_type, run_cards, is_of_contour, exact_figure, printed_figure, value_of

    !> The curve of a card, worked out exactly.
    type :: curve_type
        type(conic_type) :: conic                       !! its equation
        type(card_table_type), allocatable :: table(:)  !! its tables, the contour alone
    end type curve_type

    !> A card of the book and all that was made of it.
    type :: book_card_type
        character(:), allocatable :: name   !! the comment right before it
        character(:), allocatable :: page   !! what the program of 1970 printed
        type(shifted_type) :: shifted       !! coefficients of the five equations in doubles
        type(curve_type) :: meant           !! LOFT's curve: a slope of 999.999 is vertical
        type(curve_type) :: punched         !! the curve with 999.999 as the slope it is
    end type book_card_type

    !> Where the figures stand in a row of the page: stepped ordinate, both roots.
    integer, parameter :: along_columns(2) = [7, 15], &
        root_columns(2, 2) = reshape([17, 25, 27, 35], [2, 2])
    !> A stepped ordinate is the one of a figure within this, inches.
    real(dp), parameter :: step_noise = 1.0e-9_dp
    character, parameter :: line_feed = new_line('a'), form_feed = achar(12)

contains

    !> Runs all cards of a deck. A card at fault stops the comparison: the book has none.
    function run_cards(deck_text) result(cards)
        character(*), intent(in) :: deck_text !! a 1970 deck
        type(book_card_type), allocatable :: cards(:)
        type(source_type) :: source
        type(conic_deck_type) :: deck
        type(conic_card_type) :: card
        type(fault_list_type) :: faults
        type(error_type), allocatable :: error
        integer :: outcome

        call source%from_text(deck_text)
        allocate (cards(0))
        do
            call deck%next(source, card, outcome, faults, error)
            if (outcome == found%finished) exit
            cards = [cards, run_of(card, faults)]
        end do
        if (faults%has_errors(0)) error stop 'a card of the book is at fault'
    end function run_cards

    !> Runs one card both ways.
    function run_of(card, faults) result(run)
        type(conic_card_type), intent(in) :: card       !! a sound card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(book_card_type) :: run
        type(arc_type) :: arc
        type(card_facts_type) :: facts
        type(output_type) :: out
        type(error_type), allocatable :: error
        logical :: has_arc

        run%name = card%label
        call arc_of_card(card, arc, has_arc, faults)
        facts = facts_of_card(card, arc, default_shift)
        run%shifted = facts%shifted
        call draw(card, arc, run%meant, faults)
        call arc_through( &
            end_type(card%real([conic%x1, conic%y1]), [1.0_dp, card%real(conic%s1)]), &
            card%real([conic%x2, conic%y2]), &
            end_type(card%real([conic%x3, conic%y3]), [1.0_dp, card%real(conic%s3)]), arc, error)
        if (allocated(error)) error stop 'a card of the book has no arc'
        call draw(card, arc, run%punched, faults)
        call run_card(period_card(card), default_shift, printer_type(), out, error)
        if (allocated(error)) error stop 'the program of 1970 stops on a card of the book'
        run%page = out%text()
    end function run_of

    !> Equation and tables of an arc.
    subroutine draw(card, arc, curve, faults)
        type(conic_card_type), intent(in) :: card       !! the card that asks for the tables
        type(arc_type), intent(in) :: arc               !! the arc
        type(curve_type), intent(out) :: curve          !! its equation and tables
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        curve%conic = conic_of(arc)
        call tables_of_card(card, arc, curve%table, faults)
    end subroutine draw

    !> A card as the 1970 program takes it.
    pure type(period_card_type) function period_card(card)
        type(conic_card_type), intent(in) :: card !! a readable card
        associate (v => card%value)
            period_card = period_card_type(v(conic%x1), v(conic%y1), v(conic%s1), v(conic%x2), &
                v(conic%y2), v(conic%x3), v(conic%y3), v(conic%s3), v(conic%xi), v(conic%yi), &
                card%ityp)
        end associate
    end function period_card

    !> A figure as the page of 1970 has it, blank where it is not there: an ordinate by the columns
    !> of its row, a coefficient by its columns of the second line.
    pure function printed_figure(card, figure) result(text)
        type(book_card_type), intent(in) :: card    !! the card it is of
        type(figure_type), intent(in) :: figure     !! which
        character(11) :: text
        character(:), allocatable :: page
        integer :: field(2), i

        page = page_of(card, figure%axis)
        text = ''
        if (figure%axis == '') then
            i = index('ABCDE', figure%along(1:1))
            text = adjustl(cut(line_of(page, 2), [11*i - 5, 11*i + 5]))
            return
        end if
        field = root_columns(:, merge(1, 2, figure%column == 'root1'))
        do i = 3, count_lines(page)
            if (adjustl(cut(line_of(page, i), along_columns)) /= figure%along) cycle
            text = adjustl(cut(line_of(page, i), field))
            return
        end do
    end function printed_figure

    !> What stands between two form feeds: the page with the Y table is the last, every other
    !> figure is on the first.
    pure function page_of(card, axis) result(page)
        type(book_card_type), intent(in) :: card !! the card
        character, intent(in) :: axis            !! which was stepped
        character(:), allocatable :: page
        integer(i64) :: first, last
        first = index(card%page, form_feed, kind=i64) + 1
        last = index(card%page, form_feed, back=.true., kind=i64)
        page = card%page(last + 1:)
        if (axis /= 'Y' .and. last > first) page = card%page(first:last - 1)
    end function page_of

    !> A line of a page, with blanks enough to take columns from.
    pure function line_of(page, number) result(line)
        character(*), intent(in) :: page !! lines, each with its line feed
        integer, intent(in) :: number    !! which, from 1
        character(82) :: line
        integer :: i, first
        first = 1
        do i = 2, number
            first = first + index(page(first:)//line_feed, line_feed)
        end do
        line = ''
        if (first <= len(page)) line = page(first:first + index(page(first:), line_feed) - 2)
    end function line_of

    !> Columns of a line.
    pure function cut(line, field) result(text)
        character(*), intent(in) :: line !! the line
        integer, intent(in) :: field(2)  !! first and last column
        character(11) :: text
        text = line(field(1):field(2))
    end function cut

    !> Line feeds of a page.
    pure integer function count_lines(page)
        character(*), intent(in) :: page !! the page
        integer :: i
        count_lines = count([(page(i:i) == line_feed, i=1, len(page))])
    end function count_lines

    !> The value of a figure, not rounded: on the contour from the arc's own table, beyond it the
    !> other root of the arc's conic; a coefficient from the five equations in doubles.
    real(dp) function exact_figure(card, curve, figure) result(value)
        type(book_card_type), intent(in) :: card    !! the card it is of
        type(curve_type), intent(in) :: curve       !! which of its curves
        type(figure_type), intent(in) :: figure     !! which
        real(dp) :: roots(2)

        if (figure%axis == '') then
            value = card%shifted%coefficient(index('ABCDE', figure%along(1:1)))
            return
        end if
        value = contour_at(curve, figure)
        if (is_of_contour(card, figure)) return
        roots = roots_at(curve%conic, figure%place())
        value = roots(maxloc(abs(roots - value), dim=1))
    end function exact_figure

    !> True where a figure is of the contour: of the two roots on the page the nearer to the arc.
    logical function is_of_contour(card, figure)
        type(book_card_type), intent(in) :: card    !! the card it is of
        type(figure_type), intent(in) :: figure     !! an ordinate
        type(figure_type) :: other
        real(dp) :: contour

        other = figure
        other%column = merge('root2', 'root1', figure%column == 'root1')
        contour = contour_at(card%meant, figure)
        is_of_contour = abs(value_of(printed_figure(card, figure)) - contour) &
            <= abs(value_of(printed_figure(card, other)) - contour)
    end function is_of_contour

    !> The ordinate of a contour at a stepped one.
    real(dp) function contour_at(curve, figure) result(value)
        type(curve_type), intent(in) :: curve       !! the curve
        type(figure_type), intent(in) :: figure     !! an ordinate
        real(dp) :: stepped
        integer :: i, nearest

        do i = 1, size(curve%table)
            if (curve%table(i)%axis /= index('XY', figure%axis)) cycle
            associate (row => curve%table(i)%row)
                if (figure%axis == 'X') then
                    nearest = minloc(abs(row%x - figure%place()), dim=1)
                    stepped = row(nearest)%x
                    value = row(nearest)%y
                else
                    nearest = minloc(abs(row%y - figure%place()), dim=1)
                    stepped = row(nearest)%y
                    value = row(nearest)%x
                end if
            end associate
            if (abs(stepped - figure%place()) < step_noise) return
        end do
        error stop 'the arc has no table row for a figure of the book'
    end function contour_at

    !> A printed figure as a number; a huge one where none is printed.
    real(dp) function value_of(text)
        character(*), intent(in) :: text !! the figure, or blank
        value_of = huge(1.0_dp)
        if (text /= '') read (text, *) value_of
    end function value_of

end module support_book_card
