!> Tables of arcs on pages: rows as they should stand, worked by hand.
program test_arc_listing
    use base_constants, only: pi
    use base_kinds, only: dp
    use base_output, only: output_type
    use cut_outline, only: cut_type
    use cut_plane, only: buttock_plane, plane_type, station_plane, waterline_plane
    use geom_circular, only: circular_between
    use report_arc_listing, only: arc_table_type, print_arcs
    use report_ordinate, only: new_form, ordinate_form_type
    use report_page, only: page_type
    use support_tap, only: tap_type
    implicit none (type, external)
    character, parameter :: nl = new_line('a')
    type(tap_type) :: tap

    call check_table()
    call check_units()
    call check_wide()
    call tap%finish()

contains

    !> A quarter circle to the left, another to the right that ends it, a straight piece.
    pure type(arc_table_type) function example() result(table)
        allocate (table%arcs(3))
        table%arcs(1)%arc = circular_between([0.0_dp, 0.0_dp], 0.0_dp, [2.0_dp, 2.0_dp])
        table%arcs(1)%is_primary = .false.
        table%arcs(1)%deviation = 1.234e-3_dp
        table%arcs(1)%worst = [1.5_dp, 0.25_dp]
        table%arcs(2)%arc = circular_between([2.0_dp, 2.0_dp], 0.5_dp*pi, [5.0_dp, 5.0_dp])
        table%arcs(2)%deviation = 4.567e-3_dp
        table%arcs(2)%worst = [3.5_dp, 4.25_dp]
        table%arcs(3)%arc = circular_between([5.0_dp, 5.0_dp], 0.0_dp, [9.0_dp, 5.0_dp])
    end function example

    !> The text of tables of a cut.
    function text_of(plane, tables, form, columns) result(text)
        type(plane_type), intent(in) :: plane           !! of the cut
        type(arc_table_type), intent(in) :: tables(:)   !! of it
        type(ordinate_form_type), intent(in) :: form    !! of ordinates
        integer, intent(in) :: columns                  !! of the page
        character(:), allocatable :: text
        type(page_type) :: page
        type(output_type) :: out
        type(cut_type) :: cut

        cut%plane = plane
        cut%arcs = 0.005_dp
        call page%set_size(columns, 60)
        call page%set_heading('TITLE', 'deck.crd', 'INCHES')
        call print_arcs(page, 7, cut, tables, form, out)
        text = out%text()
    end function text_of

    subroutine check_table()
        type(arc_table_type) :: tables(2)
        type(ordinate_form_type) :: form
        character(:), allocatable :: text

        tables = example()
        tables(2)%is_inside = .true.
        tables(2)%is_closed = .true.
        tables(2)%arcs%is_primary = .true.
        form = new_form('INCHES', 'INCHES', 3)
        text = text_of(buttock_plane(5.0_dp), tables, form, 80)
        call tap%has(text, nl//'ARCS OF CUT 7, WITHIN 0.005; U IS STA, V IS WL'//nl// &
            'OUTLINE 1, OPEN: 3 ARCS, 4 POINTS, 1 OF THEM SECONDARY (S)'//nl, 'what they are')
        call tap%has(text, nl// &
            '  NO     START U   START V  CENTRE U  CENTRE V     RADIUS     TURN DEVIATION'//nl// &
            '   1       0.000     0.000     0.000     2.000      2.000   90.000   1.2E-03'//nl// &
            '   2 S     2.000     2.000     5.000     2.000     -3.000  -90.000   4.6E-03'//nl// &
            '   3       5.000     5.000                           LINE                 0.'//nl// &
            ' END       9.000     5.000'//nl// &
            'LARGEST DEVIATION 4.6E-03, OF ARC 2 AT U 3.500  V 4.250'//nl, 'the rows')
        call tap%has(text, nl//'INSIDE OF SKIN, OUTLINE 1, CLOSED: 3 ARCS, 3 POINTS'//nl, &
            'of the inside, closed: as many points as arcs')
        call tap%ok(index(text, 'ARCS OF CUT') == index(text, 'ARCS OF CUT', .true.), &
            'the cut is named once')
        call tap%same(text_of(buttock_plane(5.0_dp), tables(:0), form, 80), '', &
            'without arcs nothing is printed')
        text = text_of(station_plane(5.0_dp), tables, form, 80)
        call tap%has(text, '; U IS BL, V IS WL'//nl, 'axes of a station')
        text = text_of(waterline_plane(5.0_dp), tables, form, 80)
        call tap%has(text, '; U IS STA, V IS BL'//nl, 'and of a waterline')
    end subroutine check_table

    subroutine check_units()
        character(:), allocatable :: text
        text = text_of(station_plane(1.0_dp), [example()], new_form('INCHES', 'MM', 1), 80)
        call tap%has(text, 'WITHIN 0.127;', 'the tolerance in the unit of the listing')
        call tap%has(text, nl// &
            '   2 S      50.8      50.8     127.0      50.8      -76.2  -90.000   1.2E-01'//nl, &
            'lengths and deviations too')
    end subroutine check_units

    !> More decimals than a line has room for.
    subroutine check_wide()
        character(:), allocatable :: text
        text = text_of(station_plane(1.0_dp), [example()], new_form('INCHES', 'INCHES', 6), 80)
        call tap%has(text, nl// &
            '   2 S     2.000000     2.000000     5.000000     2.000000'//nl// &
            '     -3.000000  -90.000   4.6E-03'//nl, 'a row takes two lines')
        text = text_of(station_plane(1.0_dp), [example()], new_form('INCHES', 'INCHES', 6), 132)
        call tap%has(text, nl//'   2 S     2.000000     2.000000     5.000000     2.000000'// &
            '     -3.000000  -90.000   4.6E-03'//nl, 'or one on a wide page')
    end subroutine check_wide

end program test_arc_listing
