!> Tests of pages.
program test_pattern_page
    use base_kinds, only: dp
    use export_pattern_page, only: bounds_of, drawing_order, is_straight, label_corners, &
        label_type, page_type, side
    use export_pattern_style, only: style
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(page_type) :: page, sheet
    type(label_type) :: label
    real(dp) :: corners(2, 4), box(4)
    integer :: i

    page%size = [4.0_dp, 2.0_dp]
    call page%open_group('STA_20', 'STATION 20')
    label%text = 'TA'
    label%height = 1.0_dp
    call page%write(style%words, [1.0_dp, 0.0_dp], label)
    call page%draw(style%outline, reshape([0.0_dp, 0.0_dp, 4.0_dp, 2.0_dp], [2, 2]))
    call page%close_group()
    call page%draw(style%bar, reshape([0.0_dp, 0.0_dp, 4.0_dp, 0.0_dp], [2, 2]), .true.)
    call tap%ok(page%count == 3 .and. all(page%items(:3)%group == [1, 1, 0]), &
        'items belong to the open part, or to the sheet')
    call tap%ok(all(drawing_order(page) == [2, 1, 3]), &
        'a part is drawn layer by layer, the sheet last')

    call sheet%open_group('A', 'A')
    call sheet%close_group()
    call sheet%place(page, [10.0_dp, 20.0_dp], .true.)
    call tap%ok(sheet%group_count == 2 .and. all(sheet%items(:3)%group == [2, 2, 0]), &
        'a page placed on another brings its parts')
    call tap%same(sheet%groups(2)%title, 'STATION 20', 'with their titles')
    call tap%ok(all(abs(sheet%items(2)%at - reshape([12.0_dp, 20.0_dp, 10.0_dp, 24.0_dp], [2, 2])) &
        < 1.0e-12_dp), 'turned left its lower left corner is the lower right one')
    call tap%ok(all(abs(sheet%items(1)%label%along - [0.0_dp, 1.0_dp]) < 1.0e-12_dp), &
        'and its words run upwards')

    ! T is 611 wide, A 667.
    corners = label_corners([1.0_dp, 5.0_dp], label)
    call tap%near(corners(1, 2) - corners(1, 1), 1.278_dp, 1.0e-12_dp, &
        'a label is as wide as its text')
    call tap%ok(corners(2, 1) < 5.0_dp .and. corners(2, 4) > 5.7_dp, &
        'and as high as capitals, with what hangs below')
    label%side = side%left
    corners = label_corners([1.0_dp, 5.0_dp], label)
    call tap%near(corners(1, 2), 1.0_dp, 1.0e-12_dp, 'on the left its end is at the point')
    label%side = side%middle
    label%along = [0.0_dp, 1.0_dp]
    corners = label_corners([1.0_dp, 5.0_dp], label)
    call tap%near(corners(2, 1) + corners(2, 2), 10.0_dp, 1.0e-12_dp, 'in the middle, upright')
    call tap%ok(corners(1, 3) < 1.0_dp, 'with its top to the left')

    do i = 1, 40
        call sheet%draw(style%line, reshape([real(i, dp), 0.0_dp, 7.0_dp, 30.0_dp], [2, 2]))
    end do
    box = bounds_of(sheet)
    call tap%ok(sheet%count == 43 .and. all(abs(box([1, 2, 4]) - [1.0_dp, 0.0_dp, 30.0_dp]) < &
        1.0e-12_dp) .and. abs(box(3) - 40.0_dp) < 1.0e-12_dp, 'lists grow, the box holds all')
    call tap%ok(is_straight(reshape([0.0_dp, 0.0_dp, 1.0_dp, 2.0_dp, 2.0_dp, 4.0_dp, 3.0_dp, &
        6.0_dp], [2, 4])), 'a straight Bezier arc is known')
    call tap%ok(.not. is_straight(reshape([0.0_dp, 0.0_dp, 1.0_dp, 2.001_dp, 2.0_dp, 4.0_dp, &
        3.0_dp, 6.0_dp], [2, 4])), 'a bent one is not straight')
    call tap%finish()
end program test_pattern_page
