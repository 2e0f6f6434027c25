!> Points, lines and splines of IGES files: their records, worked by hand.
program test_iges_curve
    use base_kinds, only: dp
    use export_iges_curve, only: add_line, add_point, add_spline, no_normal
    use export_iges_file, only: entry_type, iges_file_type
    use geom_bspline, only: bspline_type
    use support_iges_deck, only: deck_of, deck_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(iges_file_type) :: file
    type(deck_type) :: deck
    type(bspline_type) :: quarter, loop
    integer :: at

    quarter = bspline_type(2, [0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 1.0_dp], &
        reshape([20.0_dp, 0.0_dp, -1.0_dp, 20.0_dp, 1.0_dp, -1.0_dp, 20.0_dp, 1.0_dp, 0.0_dp], &
        [3, 3]), [1.0_dp, 0.5_dp, 1.0_dp])
    loop = bspline_type(3, [0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 2.0_dp, 2.0_dp, 2.0_dp, &
        2.0_dp], reshape([0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, &
        0.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp], [3, 5]), &
        [2.0_dp, 2.0_dp, 2.0_dp, 2.0_dp, 2.0_dp])
    call add_point(file, entry_type(), [1.0_dp, -2.5_dp, 0.0_dp], 0, at)
    call add_line(file, entry_type(), reshape([0.0_dp, 0.0_dp, 1.0_dp, 2.0_dp, 3.0_dp, 4.0_dp], &
        [3, 2]), 7, at)
    call add_spline(file, entry_type(), quarter, [1.0_dp, 0.0_dp, 0.0_dp], 9, at)
    call add_spline(file, entry_type(), loop, no_normal, 0, at)
    deck = deck_of(file%directory%text()//file%parameters%text())
    call tap%ok(at == 7, 'pointers go on')
    call tap%same(deck%record(1), '116,1.,-2.5,0.,0;', 'a point, without a symbol')
    call tap%same(deck%record(3), '110,0.,0.,1.,2.,3.,4.,0,1,7;', 'a line with a name')
    call tap%same(deck%record(5), '126,2,2,1,0,0,0,'// & ! index, degree; planar, open, rational
        '0.,0.,0.,1.,1.,1.,1.,0.5,1.,'// &               ! knots, weights
        '20.,0.,-1.,20.,1.,-1.,20.,1.,0.,'// &           ! poles
        '0.,1.,1.,0.,0.,0,1,9;', 'a rational spline')    ! from, to, normal, name
    call tap%same(deck%record(7), '126,4,3,0,1,1,0,0.,0.,0.,0.,1.,2.,2.,2.,2.,'// &
        '2.,2.,2.,2.,2.,0.,0.,0.,1.,0.,0.,1.,1.,0.,0.,1.,0.,0.,0.,0.,0.,2.,0.,0.,0.;', &
        'a polynomial one in space that closes; all its knots, to the last')
    call tap%finish()
end program test_iges_curve
