!> Tests of the page map.
program test_pattern_map
    use base_kinds, only: dp
    use export_pattern_map, only: blank_tiles, draw_map
    use export_pattern_page, only: bounds_of, item_kind, page_type
    use export_pattern_style, only: style
    use export_pattern_tiling, only: tiling_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(tiling_type) :: tiling
    type(page_type) :: sheet, page, small
    real(dp) :: box(4)
    integer :: i

    tiling%cell = [10.0_dp, 5.0_dp]
    tiling%corner = [-1.0_dp, -2.0_dp]
    allocate (tiling%has_tile(2, 3))
    tiling%has_tile = .true.
    tiling%has_tile(2, 3) = .false.
    call sheet%draw_curves(style%outline, reshape([0.0_dp, 0.0_dp, 3.0_dp, 0.0_dp, 6.0_dp, 0.0_dp, &
        9.0_dp, 0.0_dp], [2, 4]), .false.)
    call sheet%draw(style%line, reshape([0.0_dp, 0.0_dp, 3.0_dp, 0.0_dp], [2, 2]))
    call draw_map(page, sheet, tiling, [1.0_dp, 1.0_dp, 5.0_dp, 7.0_dp], [0, 0])
    call tap%ok(count_of(page, style%map) == 5 .and. count_of(page, style%map_none) == 3, &
        'a tile that is left out is crossed')
    call tap%ok(count_of(page, style%sheet_words) == 6, 'all tiles have names')
    call tap%ok(count_of(page, style%map_part) == 1, 'outlines are drawn, nothing else')
    ! Twenty by fifteen in a room of four by six: a fifth; its corner is at (1, 2.5).
    box = bounds_of(page)
    call tap%ok(all(abs(box([1, 3]) - [1.0_dp, 5.0_dp]) < 1.0e-12_dp), 'the map fills its room')
    do i = 1, page%count
        if (page%items(i)%style == style%map_part) call tap%ok(norm2(page%items(i)%at(:, 1) - &
            [1.2_dp, 2.9_dp]) < 1.0e-12_dp, 'the part is where the tiles have it')
    end do
    call tap%same(blank_tiles(tiling), 'C2', 'what is left out is told')
    call draw_map(small, sheet, tiling, [0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp], [2, 1])
    call tap%ok(count_of(small, style%map_this) == 1 .and. &
        count_of(small, style%sheet_words) == 0, &
        'on a tile it is marked, and names are left out')
    call tap%ok(all(abs(small%items(1)%at(:, 3) - [1.0_dp, 0.875_dp]) < 1.0e-12_dp), &
        'the tile of the second column and the first row is at the upper right')
    call tap%ok(small%items(1)%kind == item_kind%lines .and. small%items(1)%is_closed, &
        'as a filled box')
    call tap%finish()

contains

    !> How many items of a page have a style.
    integer function count_of(page, kind) result(number)
        type(page_type), intent(in) :: page !! any
        integer, intent(in) :: kind         !! one of `style%...`
        number = count(page%items(:page%count)%style == kind)
    end function count_of

end program test_pattern_map
