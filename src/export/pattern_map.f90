!> The page map: all tiles of a sheet with the parts on them, small. Tiles that are left out are
!> crossed.
module export_pattern_map
    use base_kinds, only: dp
    use export_pattern_page, only: item_type, label_type, page_type, side
    use export_pattern_part, only: bezier_points
    use export_pattern_style, only: style
    use export_pattern_tiling, only: cell_of, tile_name, tiling_type
    implicit none (type, external)
    private

    public :: draw_map, blank_tiles

    !> Straight pieces that stand for a Bezier arc.
    integer, parameter :: pieces = 24
    !> Points of the map nearer to each other are one, in.
    real(dp), parameter :: finest = 0.015_dp
    !> The tallest name of a tile, and what part of its cell a name takes.
    real(dp), parameter :: tallest_name = 0.2_dp, name_part = 0.3_dp

contains

    !> Draws the map in the middle of a box. Tile [0, 0] marks none: then all have names, and those
    !> that are left out are crossed.
    pure subroutine draw_map(page, sheet, tiling, box, tile)
        type(page_type), intent(inout) :: page      !! gets it
        type(page_type), intent(in) :: sheet        !! what is drawn
        type(tiling_type), intent(in) :: tiling     !! its tiles
        real(dp), intent(in) :: box(4)              !! left, bottom, right, top, in
        integer, intent(in) :: tile(2)              !! column and row of the one to mark
        real(dp) :: scale, corner(2), whole(2)
        integer :: i, k

        whole = tiling%cell*real(shape(tiling%has_tile), dp)
        scale = minval((box(3:) - box(:2))/whole)
        corner = box(:2) + 0.5_dp*(box(3:) - box(:2) - scale*whole) - scale*tiling%corner
        if (all(tile > 0)) then
            call page%draw(style%map_this, &
                frame(scale, corner, cell_of(tiling, tile(1), tile(2))), .true.)
            call draw_net(page, frame(scale, corner, [tiling%corner, tiling%corner + whole]), &
                shape(tiling%has_tile))
        else
            do k = 1, size(tiling%has_tile, 2)
                do i = 1, size(tiling%has_tile, 1)
                    call draw_cell(page, frame(scale, corner, cell_of(tiling, i, k)), &
                        tiling%has_tile(i, k))
                    call draw_name(page, frame(scale, corner, cell_of(tiling, i, k)), &
                        tile_name(i, k))
                end do
            end do
        end if
        do i = 1, sheet%count
            if (sheet%items(i)%style == style%outline) &
                call draw_small(page, sheet%items(i), scale, corner)
        end do
    end subroutine draw_map

    !> Draws all cells by the lines between them.
    pure subroutine draw_net(page, corners, cells)
        type(page_type), intent(inout) :: page      !! gets them
        real(dp), intent(in) :: corners(2, 4)       !! of all cells, in
        integer, intent(in) :: cells(2)             !! columns and rows
        real(dp) :: part
        integer :: i

        do i = 0, cells(1)
            part = real(i, dp)/real(cells(1), dp)
            call page%draw(style%map, between(corners(:, [1, 4]), corners(:, [2, 3]), part))
        end do
        do i = 0, cells(2)
            part = real(i, dp)/real(cells(2), dp)
            call page%draw(style%map, between(corners(:, [1, 2]), corners(:, [4, 3]), part))
        end do
    end subroutine draw_net

    !> A line between two others.
    pure function between(first, second, part) result(line)
        real(dp), intent(in) :: first(2, 2)     !! ends, in
        real(dp), intent(in) :: second(2, 2)    !! ends, in
        real(dp), intent(in) :: part            !! 0: the first, 1: the second
        real(dp) :: line(2, 2)
        line = (1.0_dp - part)*first + part*second
    end function between

    !> Draws the cell of a tile; crossed where it is left out.
    pure subroutine draw_cell(page, corners, has_tile)
        type(page_type), intent(inout) :: page      !! gets it
        real(dp), intent(in) :: corners(2, 4)       !! in
        logical, intent(in) :: has_tile             !! it is printed

        if (has_tile) then
            call page%draw(style%map, corners, .true.)
        else
            call page%draw(style%map_none, corners, .true.)
            call page%draw(style%map_none, corners(:, 1:3:2))
            call page%draw(style%map_none, corners(:, 2:4:2))
        end if
    end subroutine draw_cell

    !> The corners of a box of the sheet on the map, counter-clockwise.
    pure function frame(scale, corner, box) result(corners)
        real(dp), intent(in) :: scale       !! of the map
        real(dp), intent(in) :: corner(2)   !! of the map, in
        real(dp), intent(in) :: box(4)      !! left, bottom, right, top, in
        real(dp) :: corners(2, 4)

        corners(1, :) = corner(1) + scale*[box(1), box(3), box(3), box(1)]
        corners(2, :) = corner(2) + scale*[box(2), box(2), box(4), box(4)]
    end function frame

    !> Draws an outline, small, without the points that nobody could part.
    pure subroutine draw_small(page, item, scale, corner)
        type(page_type), intent(inout) :: page  !! gets it
        type(item_type), intent(in) :: item     !! curves
        real(dp), intent(in) :: scale           !! of the map
        real(dp), intent(in) :: corner(2)       !! of the map, in
        real(dp) :: points(2, pieces*(size(item%at, 2) - 1)/3 + 1)
        integer :: i, kept

        do i = 1, (size(item%at, 2) - 1)/3
            points(:, pieces*(i - 1) + 1:pieces*i + 1) = spread(corner, 2, pieces + 1) + &
                scale*bezier_points(item%at(:, 3*i - 2:3*i + 1), pieces)
        end do
        kept = 1
        do i = 2, size(points, 2)
            if (i < size(points, 2) .and. norm2(points(:, i) - points(:, kept)) < finest) cycle
            kept = kept + 1
            points(:, kept) = points(:, i)
        end do
        call page%draw(style%map_part, points(:, :kept), item%is_closed)
    end subroutine draw_small

    !> Writes the name of a tile at the top of its cell.
    pure subroutine draw_name(page, corners, name)
        type(page_type), intent(inout) :: page      !! gets it
        real(dp), intent(in) :: corners(2, 4)       !! of the cell, in
        character(*), intent(in) :: name            !! of the tile
        type(label_type) :: label

        label%text = name
        label%height = min(tallest_name, name_part*(corners(2, 4) - corners(2, 1)))
        label%side = side%right
        call page%write(style%sheet_words, corners(:, 4) + label%height*[0.25_dp, -0.95_dp], label)
    end subroutine draw_name

    !> The names of the tiles that are left out; empty where there are none.
    pure function blank_tiles(tiling) result(names)
        type(tiling_type), intent(in) :: tiling !! the tiles
        character(:), allocatable :: names
        integer :: i, k

        names = ''
        do k = 1, size(tiling%has_tile, 2)
            do i = 1, size(tiling%has_tile, 1)
                if (tiling%has_tile(i, k)) cycle
                if (names /= '') names = names//' '
                names = names//tile_name(i, k)
            end do
        end do
    end function blank_tiles

end module export_pattern_map
