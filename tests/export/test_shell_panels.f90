!> Tests of faces before they are sewn: loops, keys, names, mirror images.
program test_shell_panels
    use base_kinds, only: dp
    use export_shell_panels, only: key_type, mirrored_panel, operator(==), panel_type, station_words
    use support_skins, only: deck_body, take_panels
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(panel_type), allocatable :: panels(:)
    type(panel_type) :: port
    real(dp), allocatable :: corners(:, :)
    integer :: i

    call take_panels(deck_body('ellipsoid'), panels, corners)
    call tap%ok(size(panels) == 4, 'two sections in two stretches are four panels')
    call tap%same(panels(1)%face%name, 'UPPER STA 20 TO 120', 'named by section and stations')
    call tap%same(panels(4)%face%section, 'LOWER', 'they know their section')
    call tap%ok(panels(1)%face%is_outward .and. .not. panels(2)%face%is_outward, &
        'from the top to the side out is along dS/du x dS/dv, from the bottom against it')
    associate (upper => panels(1)%bonds, lower => panels(2)%bonds)
        call tap%ok(upper(3)%key == lower(3)%key, 'they meet on the side line')
        call tap%ok(upper(3)%is_forward .neqv. lower(3)%is_forward, 'in opposite ways')
        call tap%ok(.not. upper(1)%key == lower(1)%key, 'not on the centre lines')
        call tap%ok(all([upper(1)%is_forward, upper(2)%is_forward] .eqv. .true.) .and. &
            .not. upper(3)%is_forward, 'the upper one leads aft at the top, forward at the side')
        call tap%ok(all(upper%end == [0, 2, 0, 1]) .and. all(lower%end == [0, 1, 0, 2]), &
            'start line, end, finish line, end')
        call tap%ok(.not. allocated(upper(4)%curve%pole) .and. allocated(upper(2)%curve%pole), &
            'the nose is a point, the greatest section a curve')
        call tap%ok(upper(2)%key == panels(3)%bonds(4)%key, 'which both stretches have')
    end associate

    port = mirrored_panel(panels(1))
    call tap%same(port%face%name, 'UPPER P STA 20 TO 120', 'the port one has a P')
    call tap%ok(port%face%is_port .and. .not. port%face%is_outward, 'and is turned')
    call tap%ok(port%bonds(1)%key == panels(1)%bonds(1)%key .and. &
        .not. port%bonds(1)%is_forward, 'it meets the other in BL 0')
    call tap%ok(.not. any([(port%bonds(i)%key == panels(1)%bonds(6 - i)%key, i=3, 4)]), &
        'its other sides are its own')
    call tap%ok(all(port%bonds(3)%curve%pole(2, :) == -panels(1)%bonds(3)%curve%pole(2, :)), &
        'mirror images of the starboard ones')
    call tap%ok(.not. key_type(1, 2) == key_type(1, 2, side=1), 'sides of a rib differ')
    call tap%same(station_words(14.0_dp), '14', 'a whole station has no point')
    call tap%same(station_words(-7.25_dp), '-7.25', 'others have')
    call tap%finish()
end program test_shell_panels
