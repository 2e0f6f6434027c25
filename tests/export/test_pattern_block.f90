!> Tests of the block of words of a part.
program test_pattern_block
    use base_error, only: error_type
    use base_kinds, only: dp
    use cut_plane, only: oblique_plane, plane_through, plane_type, station_plane, waterline_plane
    use export_drawing, only: drawing_type, shape_kind, shape_type
    use export_pattern_block, only: draw_block
    use export_pattern_page, only: item_kind
    use export_pattern_part, only: new_part, part_type
    use export_receipt, only: receipt_type
    use export_units, only: find_unit, unit_type
    use support_shapes, only: add_circle, new_drawing, new_shape
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(shape_type) :: shape
    type(plane_type) :: plane
    type(error_type), allocatable :: error
    character(:), allocatable :: words

    shape = new_shape('STA_20', 'STATION 20', station_plane(20.0_dp))
    shape%skin = 0.8_dp
    shape%quantity = 2
    shape%is_flange_forward = .true.
    call add_circle(shape, [0.0_dp, 0.0_dp], 90.0_dp, .false., 6)
    call add_circle(shape, [0.0_dp, 0.0_dp], 89.2_dp, .true., 0)
    words = block_of(shape, 'MM')
    call tap%ok(index(words, '|STATION 20|SHAPES OF CLOSED FORM|DECK test.crd ') == 1, &
        'names of the part, the title and the deck come first')
    call tap%has(words, 'ORDINATES IN MM', 'units')
    call tap%has(words, 'QUANTITY 2', 'quantity')
    call tap%has(words, 'SEEN FROM AFT     FLANGE FORWARD', 'sides')
    call tap%has(words, '|PLANE OF STA 20|', 'the plane')
    call tap%has(words, '|LINES BL EVERY 50 MM, WL EVERY 50 MM|', 'steps')
    call tap%has(words, '|OUTSIDE OF SKIN|INSIDE OF SKIN, 0.8 MM|', 'sides of the skin')
    call tap%has(words, '|BEVELS IN DEGREES, + OPEN, - CLOSED|', 'bevels')
    call tap%has(words, '|FULL SIZE. OUTLINE WITHIN 0.', 'the measured error')

    shape%contours = shape%contours(:1)
    deallocate (shape%contours(1)%marks)
    words = block_of(shape, 'INCHES')
    call tap%ok(index(words, 'INSIDE') == 0 .and. index(words, 'BEVEL') == 0, &
        'what is not there is not explained')
    shape%plane = waterline_plane(-12.0_dp)
    shape%is_flange_forward = .false.
    words = block_of(shape, 'INCHES')
    call tap%has(words, 'SEEN FROM ABOVE     FLANGE ABOVE|PLANE OF WL -12|', 'a waterline')
    ! Ten along STA in 48 of WL: atan(10/48).
    call oblique_plane([40.0_dp, -24.0_dp], [50.0_dp, 24.0_dp], plane, error)
    shape%plane = plane
    words = block_of(shape, 'INCHES')
    call tap%has(words, 'PLANE THROUGH STA 40 AT WL -24, LEANING 11.768 DEGREES AFT', &
        'an oblique plane leans aft')
    call oblique_plane([194.0_dp, -24.0_dp], [186.0_dp, 44.0_dp], plane, error)
    shape%plane = plane
    words = block_of(shape, 'INCHES')
    call tap%has(words, 'DEGREES FORWARD', 'or forward')
    call plane_through([104.0_dp, 0.0_dp, 0.0_dp], [1.0_dp, 0.1_dp, -0.2_dp], plane, error)
    shape%plane = plane
    words = block_of(shape, 'INCHES')
    call tap%has(words, 'PLANE THROUGH STA 104 BL 0 WL 0, NORMAL 1 0.1 -0.2', 'any plane')
    shape%kind = shape_kind%card
    words = block_of(shape, 'INCHES')
    call tap%ok(index(words, 'FLANGE') == 0 .and. index(words, 'PLANE') == 0 .and. &
        index(words, 'SKIN') == 0, 'a card of 1970 has neither plane nor flange nor skin')
    call tap%finish()

contains

    !> The words of a block, each between bars.
    function block_of(shape, name) result(words)
        type(shape_type), intent(in) :: shape   !! what is drawn
        character(*), intent(in) :: name        !! of the unit
        character(:), allocatable :: words
        type(part_type) :: part
        type(receipt_type) :: receipt
        type(drawing_type) :: drawing
        type(unit_type) :: unit
        integer :: i

        drawing = new_drawing([shape])
        call find_unit(name, unit, error)
        call new_part(shape, 1.0_dp/unit%inch, 1.0e-3_dp, part, receipt)
        call draw_block(drawing, shape, unit, part)
        words = '|'
        do i = 1, part%page%count
            if (part%page%items(i)%kind == item_kind%words) &
                words = words//part%page%items(i)%label%text//'|'
        end do
    end function block_of

end program test_pattern_block
