!> Tests of tiled sheets. Every point of an outline is on a page, where the page says it is: the
!> crosses of a tile tell where it lies on the sheet, and the circle is known there.
program test_pattern_tiles
    use base_kinds, only: dp
    use cut_plane, only: station_plane
    use export_drawing, only: shape_type
    use export_pattern_page, only: item_kind, page_type
    use export_pattern_paper, only: paper_kind, paper_type
    use export_pattern_part, only: bezier_points, new_part, part_type
    use export_pattern_sheets, only: framed_part
    use export_pattern_style, only: style
    use export_pattern_tiles, only: tile_sheet
    use export_receipt, only: receipt_type
    use support_shapes, only: add_circle, new_shape
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(page_type), allocatable :: pages(:)
    type(page_type) :: sheet

    sheet = circle(12.0_dp)
    call tile_sheet(sheet, paper_type(paper_kind%sheets, [8.5_dp, 11.0_dp], 0.4_dp, 0.5_dp), &
        'A DECK', pages)
    call tap%same(pages(1)%label, 'STATION 20 PAGE MAP', 'the page map comes first')
    call tap%same(pages(1)%name, 'STA_20-map', 'with a name for a file')
    call tap%same(pages(2)%label, 'STATION 20 A1', 'then the tiles')
    call tap%ok(all([pages(1)%size(1), pages(1)%size(2)] > 0.0_dp) .and. &
        .not. pages(1)%is_clipped .and. all(pages(2:)%is_clipped), 'tiles are clipped')
    call cover(pages(2:))
    call tap%ok(has_words(pages(1), '1  PRINT AT 100 %') .and. has_words(pages(1), 'LEFT OUT'), &
        'the map says what to do, and what is left out')
    call tap%ok(has_words(pages(2), 'TILE 1 OF '), 'tiles are counted')
    call tap%ok(bars_of(pages) == size(pages), 'each page has both check bars')

    sheet = circle(3.0_dp)
    call tile_sheet(sheet, paper_type(paper_kind%sheets, [8.5_dp, 11.0_dp], 0.4_dp, 0.5_dp), &
        'A DECK', pages)
    call tap%ok(size(pages) == 1, 'what fits on a page is one page')
    call tap%same(pages(1)%label, 'STATION 20', 'named for the part')
    call tap%ok(bars_of(pages) == 1 .and. .not. pages(1)%is_clipped, 'with bars, and whole')
    call tap%finish()

contains

    !> A sheet with a circle in its middle.
    type(page_type) function circle(radius) result(sheet)
        real(dp), intent(in) :: radius !! in
        type(shape_type) :: shape
        type(part_type) :: part
        type(receipt_type) :: receipt

        shape = new_shape('STA_20', 'STATION 20', station_plane(20.0_dp))
        call add_circle(shape, [1.0_dp, 2.0_dp], radius, .false., 0)
        call new_part(shape, 1.0_dp, 1.0e-5_dp, part, receipt)
        sheet = framed_part(part%page, shape%name, shape%title)
    end function circle

    !> Follows the arcs on all tiles: angles of the circle that are met within the window.
    subroutine cover(tiles)
        type(page_type), intent(in) :: tiles(:) !! without the map
        logical :: is_met(3600)
        integer, parameter :: steps = 500
        real(dp) :: points(2, steps + 1), centre(2), angle, worst
        integer :: i, k, j, e, known

        is_met = .false.
        worst = 0.0_dp
        known = 0
        do i = 1, size(tiles)
            do k = 1, tiles(i)%count
                associate (item => tiles(i)%items(k), window => tiles(i)%window)
                    if (item%kind /= item_kind%curves .or. item%group == 0) cycle
                    do e = 4, size(item%at, 2), 3
                        points = bezier_points(item%at(:, e - 3:e), steps)
                        centre = centre_of(points)
                        known = known + 1
                        do j = 1, steps + 1
                            if (any(points(:, j) < window(:2))) cycle
                            if (any(points(:, j) > window(3:))) cycle
                            angle = atan2(points(2, j) - centre(2), points(1, j) - centre(1))
                            is_met(1 + modulo(floor(angle*1800.0_dp/acos(-1.0_dp)), 3600)) = .true.
                        end do
                        worst = max(worst, norm2(centre - expected_centre(tiles(i))))
                    end do
                end associate
            end do
        end do
        call tap%ok(all(is_met), 'every point of an outline is on a tile, within its window')
        call tap%ok(known > 0 .and. worst < 5.0e-3_dp, &
            'where the crosses say: they tell where the middle of the circle is')
    end subroutine cover

    !> The centre of a circle of 12 in through the ends and the middle of an arc.
    function centre_of(points) result(centre)
        real(dp), intent(in) :: points(:, :) !! of the arc
        real(dp) :: centre(2), chord(2), sagitta(2)
        integer :: last

        last = size(points, 2)
        chord = 0.5_dp*(points(:, 1) + points(:, last))
        sagitta = points(:, (last + 1)/2) - chord
        centre = points(:, (last + 1)/2) - 12.0_dp*sagitta/norm2(sagitta)
    end function centre_of

    !> Where the middle of the sheet is by the crosses of a tile and by its name.
    function expected_centre(tile) result(centre)
        type(page_type), intent(in) :: tile !! named `STATION 20 B2`
        real(dp) :: centre(2), corner(2), cell(2), at(2, 4)
        integer :: i, count, row, column, rows
        character(:), allocatable :: name

        count = 0
        do i = 1, tile%count
            associate (item => tile%items(i))
                if (item%style /= style%cross .or. item%kind /= item_kind%lines) cycle
                if (abs(item%at(2, 1) - item%at(2, 2)) > 1.0e-12_dp) cycle
                count = count + 1
                at(:, count) = 0.5_dp*(item%at(:, 1) + item%at(:, 2))
            end associate
        end do
        corner = minval(at, dim=2)
        cell = maxval(at, dim=2) - corner
        name = tile%label(index(tile%label, ' ', back=.true.) + 1:)
        row = iachar(name(1:1)) - iachar('A') + 1
        column = iachar(name(2:2)) - iachar('0')
        rows = ceiling(24.0_dp/cell(2))
        ! The parts stand half an inch off the middle of all cells, if there is so much room.
        associate (columns => ceiling(24.0_dp/cell(1)))
            centre = corner + 0.5_dp*cell*real([columns, rows], dp) - &
                cell*real([column - 1, rows - row], dp) + min(0.5_dp, &
                0.5_dp*(cell*real([columns, rows], dp) - 24.0_dp))
        end associate
    end function expected_centre

    !> True where words that begin so are on a page.
    logical function has_words(page, words) result(has)
        type(page_type), intent(in) :: page     !! any
        character(*), intent(in) :: words       !! begin of a label
        integer :: i
        has = .false.
        do i = 1, page%count
            if (page%items(i)%kind == item_kind%words) &
                has = has .or. index(page%items(i)%label%text, words) > 0
        end do
    end function has_words

    !> Pages with both bars.
    integer function bars_of(pages) result(number)
        type(page_type), intent(in) :: pages(:) !! any
        integer :: i
        number = 0
        do i = 1, size(pages)
            if (has_words(pages(i), '.000 in') .and. has_words(pages(i), '.00 cm')) &
                number = number + 1
        end do
    end function bars_of

end program test_pattern_tiles
