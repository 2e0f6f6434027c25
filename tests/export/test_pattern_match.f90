!> Tests of the marks that join tiles.
program test_pattern_match
    use base_kinds, only: dp
    use export_pattern_match, only: draw_crosses, draw_matches, find_matches, match_type
    use export_pattern_page, only: item_kind, page_type
    use export_pattern_part, only: bezier_points
    use export_pattern_style, only: style
    use export_pattern_tiling, only: tiling_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(tiling_type) :: tiling
    type(page_type) :: sheet, page
    type(match_type), allocatable :: matches(:)
    character(:), allocatable :: letters
    real(dp) :: points(2, 11), largest
    integer :: i

    tiling%cell = [10.0_dp, 5.0_dp]
    tiling%overlap = 0.5_dp
    allocate (tiling%has_tile(2, 3))
    tiling%has_tile = .true.
    tiling%has_tile(2, 3) = .false.
    call sheet%draw(style%outline, reshape([0.0_dp, 12.5_dp, 20.0_dp, 12.5_dp], [2, 2]))
    call find_matches(sheet, tiling, matches)
    ! Upright edges A1-A2, B1-B2; level ones A1-B1, A2-B2, B1-C1.
    call tap%ok(size(matches) == 5 .and. count(matches%is_upright) == 2, &
        'one mark for each edge between two tiles, none where a tile is left out')
    letters = ''
    do i = 1, size(matches)
        letters = letters//matches(i)%letters
    end do
    call tap%same(letters, 'ABCDE', 'each with a letter of its own')
    call tap%ok(abs(matches(1)%at(1) - 10.0_dp) < 1.0e-12_dp .and. &
        abs(matches(1)%at(2) - 11.75_dp) < 1.0e-12_dp, &
        'it stands in the middle of the edge, or where no part is')
    call tap%ok(all(abs(matches(2)%at - [5.0_dp, 10.0_dp]) < 1.0e-12_dp), 'on the line of the cut')

    call draw_matches(page, tiling, matches, [1, 2], [100.0_dp, 0.0_dp])
    call tap%ok(count_of(style%cut) == 3, 'the tile B1 has three neighbours')
    call tap%ok(count_of(style%sheet_words) == 6, 'letters stand on both sides of the cut')
    largest = 0.0_dp
    do i = 1, page%count
        if (page%items(i)%kind /= item_kind%curves) cycle
        points = bezier_points(page%items(i)%at(:, 4:7), 10)
        points = points - spread(0.5_dp*(page%items(i)%at(:, 1) + page%items(i)%at(:, 7)), 2, 11)
        largest = max(largest, maxval(abs(norm2(points, dim=1) - 0.21_dp)))
    end do
    call tap%ok(largest < 1.0e-4_dp, 'circles are round, and within the overlap')
    call draw_crosses(page, tiling, [1, 2], [100.0_dp, 0.0_dp])
    call tap%ok(page%count == 3*4 + 8, 'a tile has four crosses')
    associate (first => page%items(13)%at, last => page%items(19)%at)
        call tap%ok(all(abs(abs(sum(last - first, dim=2)/2.0_dp) - tiling%cell) < 1.0e-12_dp), &
            'as far apart as the cell is wide and high')
    end associate
    call tap%finish()

contains

    !> How many items of the page have a style.
    integer function count_of(kind) result(number)
        integer, intent(in) :: kind !! one of `style%...`
        number = count(page%items(:page%count)%style == kind)
    end function count_of

end program test_pattern_match
