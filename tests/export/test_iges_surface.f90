!> Surfaces of IGES files: the order of their numbers, their ranges, their other side.
program test_iges_surface
    use base_kinds, only: dp
    use export_iges_file, only: entry_type, iges_file_type
    use export_iges_surface, only: add_surface, turned_outward
    use geom_bspline_surface, only: bspline_surface_type, surface_jet, surface_point
    use support_iges_deck, only: deck_of, deck_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(iges_file_type) :: file
    type(deck_type) :: deck
    type(bspline_surface_type) :: surface, other
    real(dp) :: at(3), du(3), dv(3), there(3), du_there(3), dv_there(3), off
    integer :: pointer, i

    surface = bspline_surface_type([1, 2], [0.0_dp, 0.0_dp, 80.0_dp, 80.0_dp], [0.0_dp, 0.0_dp, &
        0.0_dp, 1.0_dp, 1.0_dp, 1.0_dp], reshape([(real(i, dp), i=1, 18)], [3, 2, 3]), &
        reshape([1.0_dp, 1.0_dp, 0.5_dp, 0.75_dp, 1.0_dp, 1.0_dp], [2, 3]))
    call add_surface(file, entry_type(), surface, 3, pointer)
    surface%weight = 1.0_dp
    surface%pole(:, :, 3) = surface%pole(:, :, 1)
    call add_surface(file, entry_type(), surface, 0, pointer)
    deck = deck_of(file%directory%text()//file%parameters%text())
    call tap%same(deck%record(1), '128,1,2,1,2,0,0,0,0,0,'// & ! open, rational, not periodic
        '0.,0.,80.,80.,0.,0.,0.,1.,1.,1.,'// &
        '1.,1.,0.5,0.75,1.,1.,'// &                            ! weights, u first
        '1.,2.,3.,4.,5.,6.,7.,8.,9.,10.,11.,12.,13.,14.,15.,16.,17.,18.,'// &
        '0.,80.,0.,1.,0,1,3;', 'a rational surface, with its ranges and its name')
    call tap%ok(index(deck%record(3), '128,1,2,1,2,0,1,1,0,0,') == 1, &
        'a polynomial one that closes along v')

    surface%v_knot = 0.1_dp + 0.3_dp*surface%v_knot
    surface%pole(:, :, 2) = surface%pole(:, :, 2) + 5.0_dp
    surface%pole(1, 1, 3) = -7.0_dp
    other = turned_outward(surface)
    off = 0.0_dp
    do i = 0, 10
        call surface_jet(surface, 8.0_dp*real(i, dp), 0.1_dp + 0.02_dp*real(i, dp), at, du, dv)
        call surface_jet(other, 8.0_dp*real(i, dp), 0.4_dp - 0.02_dp*real(i, dp), there, du_there, &
            dv_there)
        off = max(off, norm2(at - there), norm2(du - du_there), norm2(dv + dv_there))
    end do
    call tap%near(off, 0.0_dp, 1.0e-12_dp, 'the other side is the same surface with v turned')
    call tap%ok(all(surface_point(other, 0.0_dp, other%v_knot(1)) == surface%pole(:, 1, 3)) .and. &
        other%v_knot(1) == surface%v_knot(1) .and. other%v_knot(6) == surface%v_knot(6), &
        'its ends are the same to the last bit')
    call tap%finish()
end program test_iges_surface
