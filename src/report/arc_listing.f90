!> The circular arcs of a cut as a shop sets them out: where each begins, its centre, its radius,
!> how far it turns, how far it is from the exact shape.
!>
!>     ARCS OF CUT 3, WITHIN 0.005; U IS STA, V IS WL
!>     OUTLINE 1, OPEN: 28 ARCS, 29 POINTS, 14 OF THEM SECONDARY (S)
!>        NO    START U    START V   CENTRE U   CENTRE V      RADIUS     TURN DEVIATION
!>         1     -6.000     -5.400     23.731    -31.183     -39.353    4.162   3.1E-03
!>       S 2     -5.033      0.844 ...
!>       END      6.000      5.400
!>     LARGEST DEVIATION 3.7E-03, OF ARC 12 AT U 1.203  V -3.041
!>
!> A secondary point is one that the curve does not give its tangent to: two arcs meet there.
module report_arc_listing
    use base_constants, only: pi
    use base_digits, only: fixed, scientific
    use base_kinds, only: dp, i64
    use base_output, only: output_type
    use base_text, only: columns, compact, counted, right, to_text, upper
    use cut_outline, only: cut_type
    use geom_arc_chain, only: chain_arc_type
    use report_ordinate, only: ordinate_form_type, ordinate_text, ordinate_words
    use report_page, only: page_type, widest_page
    implicit none (type, external)
    private

    public :: arc_table_type, print_arcs

    !> The arcs of one contour of a cut.
    type :: arc_table_type
        logical :: is_closed = .false.                  !! the last ends where the first begins
        logical :: is_inside = .false.                  !! of the inside of the skin
        type(chain_arc_type), allocatable :: arcs(:)    !! in order, one at least; in u and v
    end type arc_table_type

    !> Columns of the number of an arc and its mark, of the mark, of an ordinate and of a radius
    !> beside their decimals, of a turn and of a deviation.
    integer, parameter :: number_width = 6, mark_width = 2, ordinate_width = 7, radius_width = 8, &
        turn_width = 9, deviation_width = 10
    !> Decimals of turns, figures of deviations.
    integer, parameter :: turn_decimals = 3, deviation_figures = 2
    !> Lines of a table that stay together.
    integer, parameter :: block_lines = 8

contains

    !> Prints the arcs of a cut; nothing where none are asked.
    subroutine print_arcs(page, number, cut, tables, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        integer, intent(in) :: number                   !! which cut of the deck, from 1
        type(cut_type), intent(in) :: cut               !! the cut
        type(arc_table_type), intent(in) :: tables(:)   !! one a contour
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals of ordinates
        type(output_type), intent(inout) :: out         !! where it goes
        integer :: i, outlines(2)

        if (size(tables) == 0) return
        outlines = 0
        do i = 1, size(tables)
            associate (table => tables(i), of => merge(2, 1, tables(i)%is_inside))
                outlines(of) = outlines(of) + 1
                call page%keep(out, block_lines)
                if (i == 1) call page%line(out, 'ARCS OF CUT '//to_text(number)//', WITHIN '// &
                    compact(form%factor*cut%arcs)//axes_of(cut))
                call page%line(out, head_of(table, outlines(of)))
                call print_rows(page, table, form, out)
                call print_largest(page, table, form, out)
            end associate
        end do
        call page%blank(out)
        call page%blank(out)
    end subroutine print_arcs

    !> What U and V of a cut are, where they are ordinates.
    pure function axes_of(cut) result(text)
        type(cut_type), intent(in) :: cut !! any
        character(19), parameter :: words(5) = [character(19) :: '; U IS BL, V IS WL', &
            '; U IS STA, V IS WL', '; U IS STA, V IS BL', '; U AND V AS ABOVE', &
            '; U AND V AS ABOVE']
        character(len_trim(words(cut%plane%kind), i64)) :: text
        text = words(cut%plane%kind)
    end function axes_of

    !> The line above a table.
    pure function head_of(table, number) result(text)
        type(arc_table_type), intent(in) :: table   !! the arcs
        integer, intent(in) :: number               !! which outline, or inside
        character(widest_page) :: text
        integer(i64) :: arcs, points

        arcs = size(table%arcs, kind=i64)
        points = arcs + merge(0_i64, 1_i64, table%is_closed)
        text = trim(merge('INSIDE OF SKIN, OUTLINE ', 'OUTLINE                 ', &
            table%is_inside))//' '//to_text(number)//', '// &
            trim(merge('CLOSED', 'OPEN  ', table%is_closed))//': '//upper(counted(arcs, 'arc'))// &
            ', '//upper(counted(points, 'point'))
        if (any(.not. table%arcs%is_primary)) text = trim(text)//', '// &
            to_text(count(.not. table%arcs%is_primary))//' OF THEM SECONDARY (S)'
    end function head_of

    !> Prints the rows of a table under their heads.
    subroutine print_rows(page, table, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(arc_table_type), intent(in) :: table       !! the arcs
        type(ordinate_form_type), intent(in) :: form    !! of ordinates
        type(output_type), intent(inout) :: out         !! where they go
        character(widest_page) :: lines(2)
        integer :: i, count, first

        first = number_width + 4*columns_of(form)
        count = merge(2, 1, first + radius_width + max(3, form%decimals) + turn_width + &
            deviation_width > page%width())
        lines = head_row(form)
        if (count == 1) lines(1) = columns(lines(1), 1, first)//lines(2)
        call page%set_columns(out, lines(:count))
        do i = 1, size(table%arcs)
            lines = row(table, i, form)
            if (count == 1) lines(1) = columns(lines(1), 1, first)//lines(2)
            call page%keep(out, count)
            call page%line(out, lines(1))
            if (count == 2) call page%line(out, lines(2))
        end do
        if (.not. table%is_closed) then
            associate (last => table%arcs(size(table%arcs))%arc)
                call page%line(out, right('END', number_width - mark_width)//'  '// &
                    place_text(last%finish, form))
            end associate
        end if
        call page%end_columns()
    end subroutine print_rows

    !> The heads of the columns: of what leads to the centre, and of what follows.
    pure function head_row(form) result(text)
        type(ordinate_form_type), intent(in) :: form    !! of ordinates
        character(len=widest_page) :: text(2)
        integer :: width

        width = columns_of(form)
        text(1) = right('NO', number_width - mark_width)//'  '//right('START U', width)// &
            right('START V', width)//right('CENTRE U', width)//right('CENTRE V', width)
        text(2) = right('RADIUS', radius_width + max(3, form%decimals))// &
            right('TURN', turn_width)//right('DEVIATION', deviation_width)
    end function head_row

    !> The row of an arc. A straight one has no centre, and LINE for a radius.
    pure function row(table, number, form) result(text)
        type(arc_table_type), intent(in) :: table       !! the arcs
        integer, intent(in) :: number                   !! which
        type(ordinate_form_type), intent(in) :: form    !! of ordinates
        character(len=widest_page) :: text(2)
        integer :: width

        width = radius_width + max(3, form%decimals)
        associate (arc => table%arcs(number)%arc)
            text(1) = right(to_text(number), number_width - mark_width)//merge(' S', '  ', &
                starts_at_secondary(table, number))//place_text(arc%start, form)
            if (arc%is_line) then
                text(2) = right('LINE', width)//right('', turn_width)
            else
                text(1) = trim(text(1))//place_text(arc%centre, form)
                text(2) = fixed(form%factor*arc%radius, width, form%decimals)// &
                    fixed(180.0_dp/pi*arc%turn, turn_width, turn_decimals)
            end if
        end associate
        text(2) = columns(text(2), 1, width + turn_width)// &
            right(deviation_text(table%arcs(number), form), deviation_width)
    end function row

    !> True where an arc begins at a secondary point.
    pure logical function starts_at_secondary(table, number) result(starts)
        type(arc_table_type), intent(in) :: table   !! the arcs
        integer, intent(in) :: number               !! which
        starts = .false.
        if (number > 1) starts = .not. table%arcs(number - 1)%is_primary
    end function starts_at_secondary

    !> Prints where the largest deviation is.
    subroutine print_largest(page, table, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(arc_table_type), intent(in) :: table       !! the arcs
        type(ordinate_form_type), intent(in) :: form    !! of ordinates
        type(output_type), intent(inout) :: out         !! where it goes
        integer :: worst

        worst = maxloc(table%arcs%deviation, 1)
        associate (arc => table%arcs(worst))
            call page%line(out, 'LARGEST DEVIATION '//trim(deviation_text(arc, form))// &
                ', OF ARC '//to_text(worst)//' AT U '//ordinate_words(form, arc%worst(1))// &
                '  V '//ordinate_words(form, arc%worst(2)))
        end associate
    end subroutine print_largest

    !> A deviation in few figures, blanks behind them.
    pure function deviation_text(arc, form) result(text)
        type(chain_arc_type), intent(in) :: arc         !! any
        type(ordinate_form_type), intent(in) :: form    !! unit
        character(deviation_width) :: text
        text = '0.'
        if (arc%deviation > 0.0_dp) text = adjustl(scientific(form%factor*arc%deviation, &
            deviation_width, deviation_figures))
    end function deviation_text

    !> A point in its columns.
    pure function place_text(at, form) result(text)
        real(dp), intent(in) :: at(2)                   !! u and v, deck units
        type(ordinate_form_type), intent(in) :: form    !! of ordinates
        character(widest_page) :: text
        text = ordinate_text(form, at(1), columns_of(form))// &
            ordinate_text(form, at(2), columns_of(form))
    end function place_text

    !> Columns of an ordinate.
    pure integer function columns_of(form)
        type(ordinate_form_type), intent(in) :: form !! its decimals
        columns_of = ordinate_width + max(3, form%decimals)
    end function columns_of

end module report_arc_listing
