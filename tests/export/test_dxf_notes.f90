!> Tests of the words on a drawing.
program test_dxf_notes
    use base_error, only: error_type
    use base_kinds, only: dp
    use export_drawing, only: contour_type, drawing_type, mark_type, shape_type
    use export_dxf_notes, only: add_bevels, add_notes
    use export_dxf_page, only: add_references, page_type
    use export_settings, only: settings_type
    use export_units, only: find_unit, unit_type
    use support_sketch, only: add_shape, new_drawing, new_shape, segment
    use support_tap, only: tap_type
    implicit none (type, external)
    type(tap_type) :: tap

    call check_notes()
    call check_bevels()
    call tap%finish()

contains

    subroutine check_notes()
        type(page_type) :: page
        type(drawing_type) :: drawing
        type(settings_type) :: settings
        type(shape_type) :: shape
        integer :: i

        drawing = new_drawing(1.0e-3_dp)
        drawing%units = 'MM'
        shape = new_shape('FLOOR', 20.0_dp)
        shape%quantity = 2
        call add_shape(drawing, shape)
        settings%tolerance = 0.025_dp
        call noted(drawing, settings, page)
        call tap%ok(has_note(page, 'SKETCH'), 'the title')
        call tap%ok(has_note(page, 'DECK sketch.crd'), 'the deck')
        call tap%ok(has_note(page, 'ALL DIMENSIONS IN MM'), 'the unit, in words')
        call tap%ok(has_note(page, 'WITHIN 0.025 MM OF THE EXACT SHAPE'), 'the tolerance')
        call tap%ok(has_note(page, 'LAYER FLOOR_2: STATION FLOOR, 2 PIECES'), &
            'what is on which layer, and how many pieces')
        call tap%ok(.not. has_note(page, 'HALVES: THE OTHER HALF IS THE MIRROR IMAGE IN BL 0'), &
            'no word of halves where there are none')
        call tap%ok(all([(page%words(i)%at(2) < page%low(2), i=1, size(page%words))]), &
            'all stand below the shapes')
        call tap%ok(all([(page%words(i)%at(2) < page%words(i - 1)%at(2) - page%height, &
            i=2, size(page%words))]), 'none over another')
        drawing%title = ''
        drawing%cuts%is_half = .true.
        settings%is_half = .true.
        settings%is_in_space = .true.
        call noted(drawing, settings, page)
        call tap%ok(has_note(page, 'HALVES: THE OTHER HALF IS THE MIRROR IMAGE IN BL 0'), &
            'halves are said to be halves')
        call tap%ok(has_note(page, 'IN SPACE: X IS STA, Y IS BL, Z IS WL'), 'what the axes are')
        call tap%ok(page%words(1)%text == 'DECK sketch.crd', 'no line for no title')
    end subroutine check_notes

    subroutine noted(drawing, settings, page)
        type(drawing_type), intent(in) :: drawing       !! what is drawn
        type(settings_type), intent(in) :: settings     !! how
        type(page_type), intent(out) :: page            !! with its notes
        type(unit_type) :: unit
        type(error_type), allocatable :: error
        call find_unit(drawing%units, unit, error)
        page%high = [24.0_dp, 24.0_dp]
        call add_references(page, 'BL', 'WL')
        call add_notes(page, drawing, unit, settings, ['FLOOR_2'])
    end subroutine noted

    logical function has_note(page, text) result(has)
        type(page_type), intent(in) :: page     !! with notes
        character(*), intent(in) :: text        !! of one of them
        integer :: i
        has = any([(page%words(i)%text == text, i=1, size(page%words))])
    end function has_note

    subroutine check_bevels()
        type(page_type) :: page
        type(contour_type) :: contour
        page%high = [24.0_dp, 24.0_dp]
        call add_references(page, 'BL', 'WL')
        contour = segment([0.0_dp, 0.0_dp, 0.0_dp], [0.0_dp, 0.0_dp, 9.0_dp])
        deallocate (contour%marks)
        call add_bevels(page, contour)
        call tap%ok(size(page%ticks) == 0, 'a contour without marks')
        contour%marks = [mark_type([0.0_dp, 3.0_dp], [1.0_dp, 0.0_dp], 3.46_dp), &
            mark_type([0.0_dp, 6.0_dp], [1.0_dp, 0.0_dp], -2.0_dp), &
            mark_type([0.0_dp, 9.0_dp], [0.0_dp, 1.0_dp], 0.04_dp)]
        call add_bevels(page, contour)
        call tap%ok(size(page%ticks) == 3 .and. size(page%words) == 3, 'a tick for each bevel')
        call tap%same(page%words(1)%text, '+3.5', 'an open bevel, degrees')
        call tap%same(page%words(2)%text, '-2.0', 'a closed one')
        call tap%same(page%words(3)%text, '0.0', 'none has no sign')
        call tap%ok(all(abs(page%ticks(1)%from - [0.0_dp, 3.0_dp]) <= 0.0_dp) .and. &
            page%ticks(1)%to(1) > 0.0_dp .and. page%words(1)%at(1) > page%ticks(1)%to(1), &
            'the tick leads from the contour outward to the figures')
    end subroutine check_bevels

end program test_dxf_notes
