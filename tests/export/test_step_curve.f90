!> Points, directions and curves of STEP files: their text, worked by hand.
program test_step_curve
    use base_kinds, only: dp
    use export_step_curve, only: add_curve, add_direction, add_edge_curve, add_placement, &
        add_point, curve_word, knot_words
    use export_step_text, only: step_file_type
    use geom_bspline, only: bspline_type
    use support_step_records, only: record_named, record_type, records_of, refers_back
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_points()
    call check_placement()
    call check_splines()
    call check_edges()
    call tap%same(knot_words([0.0_dp, 0.0_dp, 0.5_dp, 0.75_dp, 0.75_dp, 1.0_dp, 1.0_dp]), &
        '(2,1,2,2),(0.,0.5,0.75,1.)', 'knots: how often each stands, and the different ones')
    call tap%finish()

contains

    subroutine check_points()
        type(step_file_type) :: file
        integer :: number
        call add_point(file, [1.0_dp, -2.5_dp, 0.0_dp], number)
        call add_direction(file, [0.0_dp, 0.6_dp, 0.8_dp], number)
        call tap%same(file%text(), '#1=CARTESIAN_POINT('''',(1.,-2.5,0.));'//new_line('a')// &
            '#2=DIRECTION('''',(0.,0.6,0.8));'//new_line('a'), 'a point and a direction')
    end subroutine check_points

    subroutine check_placement()
        type(step_file_type) :: file
        type(record_type), allocatable :: records(:)
        integer :: number
        call add_placement(file, [5.0_dp, 0.0_dp, 1.0_dp], [-1.0_dp, 0.0_dp, 0.0_dp], number)
        call add_placement(file, [0.0_dp, 0.0_dp, 0.0_dp], [0.6_dp, 0.8_dp, 0.0_dp], number)
        records = records_of(file%text())
        call tap%same(record_named(records, 4), 'AXIS2_PLACEMENT_3D('''',#1,#2,#3)', 'a place')
        call tap%same(record_named(records, 2), 'DIRECTION('''',(-1.,0.,0.))', 'its z')
        call tap%same(record_named(records, 3), 'DIRECTION('''',(0.,1.,0.))', &
            'its x, across z')
        call tap%same(record_named(records, 7), 'DIRECTION('''',(0.,0.,1.))', &
            'the axis z is farthest from is x')
    end subroutine check_placement

    subroutine check_splines()
        type(step_file_type) :: file
        type(record_type), allocatable :: records(:)
        type(bspline_type) :: arc, cubic
        integer :: number

        arc = quarter()
        call add_curve(file, arc, 'STA-0', number)
        cubic = bspline_type(3, [0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 2.0_dp, 2.0_dp, 2.0_dp, &
            2.0_dp], reshape([0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, &
            0.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp], [3, 5]), &
            [2.0_dp, 2.0_dp, 2.0_dp, 2.0_dp, 2.0_dp])
        call add_curve(file, cubic, 'It''s', number)
        records = records_of(file%text())
        call tap%ok(refers_back(records) .and. number == 10, 'instances in order')
        call tap%same(record_named(records, 4), '(BOUNDED_CURVE()B_SPLINE_CURVE(2,(#1,#2,#3),'// &
            '.UNSPECIFIED.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((3,3),(0.,1.),.UNSPECIFIED.)'// &
            'CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((1.,0.5,1.))'// &
            'REPRESENTATION_ITEM(''STA-0''))', 'a rational spline is many entities at once')
        call tap%same(record_named(records, 2), 'CARTESIAN_POINT('''',(0.,1.,-1.))', &
            'its second pole')
        call tap%same(record_named(records, 10), 'B_SPLINE_CURVE_WITH_KNOTS(''It''''s'',3,'// &
            '(#5,#6,#7,#8,#9),.UNSPECIFIED.,.T.,.F.,(4,1,4),(0.,1.,2.),.UNSPECIFIED.)', &
            'equal weights make a plain one; this one is closed')
        call tap%same(curve_word(arc), 'RATIONAL_B_SPLINE_CURVE', 'the word for a rational one')
        call tap%same(curve_word(cubic), 'B_SPLINE_CURVE_WITH_KNOTS', 'and for a plain one')
    end subroutine check_splines

    subroutine check_edges()
        type(step_file_type) :: file
        type(record_type), allocatable :: records(:)
        type(bspline_type) :: chord
        integer :: number

        chord = bspline_type(1, [0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp], reshape([1.0_dp, 0.0_dp, &
            0.0_dp, 1.0_dp, 3.0_dp, 4.0_dp], [3, 2]), [1.0_dp, 0.25_dp])
        call add_edge_curve(file, chord, number)
        call add_edge_curve(file, quarter(), number)
        records = records_of(file%text())
        call tap%same(record_named(records, 4), 'LINE('''',#1,#3)', 'a straight edge is a line')
        call tap%same(record_named(records, 1), 'CARTESIAN_POINT('''',(1.,0.,0.))', &
            'from its first pole')
        call tap%same(record_named(records, 2), 'DIRECTION('''',(0.,0.6,0.8))', 'to its last')
        call tap%same(record_named(records, 3), 'VECTOR('''',#2,5.)', 'and as long')
        call tap%ok(index(record_named(records, number), 'RATIONAL_B_SPLINE_CURVE') > 0, &
            'a bent edge is a spline')
    end subroutine check_edges

    !> An arc with three poles.
    pure type(bspline_type) function quarter() result(arc)
        arc = bspline_type(2, [0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 1.0_dp], &
            reshape([0.0_dp, 0.0_dp, -1.0_dp, 0.0_dp, 1.0_dp, -1.0_dp, 0.0_dp, 1.0_dp, 0.0_dp], &
            [3, 3]), [1.0_dp, 0.5_dp, 1.0_dp])
    end function quarter

end program test_step_curve
