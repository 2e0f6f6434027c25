!> Tests of what stands around a lines plan.
program test_body_grid
    use base_kinds, only: dp
    use cut_outline, only: cut_type
    use cut_plane, only: buttock_plane, station_plane, waterline_plane
    use export_body_drawing, only: drawing_type
    use export_body_grid, only: draw_block, draw_grid
    use export_body_sheet, only: new_sheet, sheet_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(drawing_type) :: drawing
    type(sheet_type) :: sheet
    type(cut_type) :: cuts(4)
    character(:), allocatable :: words
    integer :: i

    sheet = new_sheet([0.0_dp, 0.0_dp, -10.0_dp], [280.0_dp, 22.0_dp, 40.0_dp], .true.)
    drawing%dot = sheet%dot
    cuts(1)%plane = station_plane(70.0_dp)
    cuts(2)%plane = buttock_plane(14.0_dp)
    cuts(3)%plane = waterline_plane(12.5_dp)
    cuts(4)%plane = station_plane(70.1_dp)
    call draw_grid(sheet, cuts, drawing)
    call tap%same(drawing%layer(2)%style, 'grid        ', 'planes of cuts are a grid')
    call tap%ok(drawing%layer(2)%count == 8, 'each is a straight line in two views')
    words = ''
    do i = 1, drawing%count
        words = words//'|'//drawing%words(i)%text
    end do
    call tap%ok(index(words, '|BL 14|14') > 0 .and. index(words, '|WL 12.5|12.5') > 0, &
        'butt lines and waterlines are named')
    call tap%ok(index(words, '|70|70|70|') > 0, 'a station in three places')
    call tap%ok(index(words, '70.1') == 0, 'one too near to another keeps silent')
    i = drawing%count
    call drawing%draw('section', reshape([0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp], [2, 2]))
    call draw_block(sheet, 'TITLE', 'mm', drawing)
    call tap%same(drawing%words(i + 1)%text, 'TITLE', 'the title block has the title')
    call tap%ok(drawing%words(i + 3)%text == 'Stations, butt lines and waterlines in mm', &
        'the unit')
    call tap%ok(drawing%count == i + 4 .and. drawing%words(i + 4)%text == 'section', &
        'and explains the lines that are there, no others')
    call tap%finish()
end program test_body_grid
