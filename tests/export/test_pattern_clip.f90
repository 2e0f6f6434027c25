!> Tests of what lies in a box.
program test_pattern_clip
    use base_kinds, only: dp
    use cut_plane, only: station_plane
    use export_drawing, only: shape_type
    use export_pattern_clip, only: add_within, anything_in, touches
    use export_pattern_page, only: label_type, page_type
    use export_pattern_part, only: new_part, part_type
    use export_pattern_style, only: style
    use export_receipt, only: receipt_type
    use support_shapes, only: add_circle, new_shape
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(page_type) :: page, tile
    type(label_type) :: label
    type(shape_type) :: shape
    type(part_type) :: part
    type(receipt_type) :: receipt
    integer :: before

    call page%draw(style%line, reshape([0.0_dp, 0.0_dp, 10.0_dp, 10.0_dp], [2, 2]))
    call tap%ok(touches(page%items(1), [4.0_dp, 4.0_dp, 5.0_dp, 5.0_dp]), 'a line goes through')
    call tap%ok(.not. touches(page%items(1), [6.0_dp, 4.0_dp, 7.0_dp, 5.0_dp]), 'or past')
    label%text = 'STATION'
    label%height = 5.0_dp
    call page%write(style%words, [0.0_dp, 20.0_dp], label)
    call tap%ok(touches(page%items(2), [4.0_dp, 21.0_dp, 5.0_dp, 22.0_dp]), &
        'a box within words is touched by them')
    call tap%ok(.not. anything_in(page, [4.0_dp, 12.0_dp, 5.0_dp, 15.0_dp]), 'nothing in between')
    call page%draw(style%map, reshape([30.0_dp, 0.0_dp, 40.0_dp, 0.0_dp, 40.0_dp, 9.0_dp], &
        [2, 3]), .true.)
    call tap%ok(touches(page%items(3), [34.5_dp, 4.0_dp, 35.5_dp, 5.0_dp]), &
        'the line back to the start counts')

    shape = new_shape('STA_20', 'STATION 20', station_plane(20.0_dp))
    call add_circle(shape, [0.0_dp, 0.0_dp], 10.0_dp, .false., 0)
    call add_circle(shape, [0.0_dp, 0.0_dp], 9.5_dp, .true., 0)
    call new_part(shape, 1.0_dp, 1.0e-5_dp, part, receipt)
    call tap%ok(.not. anything_in(part%page, [-5.0_dp, -5.0_dp, 5.0_dp, 5.0_dp]), &
        'inside of a circle is nothing')
    call add_within(tile, part%page%items(1), [6.0_dp, 6.0_dp, 9.0_dp, 9.0_dp], [1.0_dp, 2.0_dp])
    call tap%ok(tile%count == 1 .and. .not. tile%items(1)%is_closed .and. &
        size(tile%items(1)%at, 2) < size(part%page%items(1)%at, 2)/2, &
        'of a circle the arcs near the box are kept, open')
    call tap%ok(all(tile%items(1)%at > 0.0_dp), 'those on its side')
    call tap%near(minval(abs(norm2(tile%items(1)%at - spread([1.0_dp, 2.0_dp], 2, &
        size(tile%items(1)%at, 2)), dim=1) - 10.0_dp)), 0.0_dp, 1.0e-9_dp, 'moved')
    call add_within(tile, part%page%items(2), [6.0_dp, 6.0_dp, 9.0_dp, 9.0_dp], [0.0_dp, 0.0_dp])
    call tap%ok(tile%items(2)%is_closed, 'a dashed one stays whole, so that its dashes meet')
    call add_within(tile, part%page%items(1), [-20.0_dp, -20.0_dp, 20.0_dp, 20.0_dp], &
        [0.0_dp, 0.0_dp])
    call tap%ok(tile%count == 3 .and. tile%items(3)%is_closed, 'all of it in the box stays closed')
    call add_within(tile, part%page%items(1), [-11.0_dp, -1.0_dp, 11.0_dp, 1.0_dp], &
        [0.0_dp, 0.0_dp])
    call tap%ok(tile%count >= 5, 'two sides in a box are two pieces')
    before = tile%count
    call add_within(tile, part%page%items(1), [-5.0_dp, -5.0_dp, 5.0_dp, 5.0_dp], [0.0_dp, 0.0_dp])
    call tap%ok(tile%count == before, 'what is not there adds nothing')
    call tap%finish()
end program test_pattern_clip
