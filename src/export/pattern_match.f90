!> The marks by which tiles are joined: crosses at the corners of each cell, a line to cut along
!> where another tile follows, and on that line a circle with a letter on either side. One tile is
!> cut and laid on the other: circles and crosses are whole where both lie right.
module export_pattern_match
    use base_kinds, only: dp
    use export_pattern_clip, only: anything_in
    use export_pattern_letters, only: text_width
    use export_pattern_page, only: label_type, page_type, side
    use export_pattern_style, only: style
    use export_pattern_tiling, only: cell_of, letters_of, tiling_type, window_of
    implicit none (type, external)
    private

    public :: match_type, find_matches, draw_matches, draw_crosses

    !> A mark, on the sheet.
    type :: match_type
        integer :: tiles(2, 2) = 0              !! column and row of the tiles that it joins
        real(dp) :: at(2) = 0.0_dp              !! its middle on the edge, in
        real(dp) :: radius = 0.0_dp             !! in
        logical :: is_upright = .false.         !! the edge is
        character(:), allocatable :: letters    !! on both sides of the edge
    end type match_type

    !> The largest radius, in, and that for an overlap.
    real(dp), parameter :: largest_radius = 0.22_dp, radius_part = 0.42_dp
    !> Handles of a quarter of a circle as a Bezier arc, in parts of its radius.
    real(dp), parameter :: handle = 0.5522847498307936_dp
    !> Where along an edge a mark is tried, in parts of it.
    real(dp), parameter :: places(7) = [0.5_dp, 0.35_dp, 0.65_dp, 0.25_dp, 0.75_dp, 0.15_dp, &
        0.85_dp]
    !> Half the length of a cross, in parts of the overlap.
    real(dp), parameter :: cross_part = 0.4_dp

contains

    !> The marks of a sheet, one for each edge between two tiles; where a part is not in their way,
    !> if there is such a place.
    pure subroutine find_matches(sheet, tiling, matches)
        type(page_type), intent(in) :: sheet                        !! what is drawn
        type(tiling_type), intent(in) :: tiling                     !! its tiles
        type(match_type), allocatable, intent(out) :: matches(:)    !! the marks
        integer :: i, k, count

        allocate (matches(2*size(tiling%has_tile)))
        count = 0
        do k = 1, size(tiling%has_tile, 2)
            do i = 1, size(tiling%has_tile, 1)
                if (.not. tiling%has_tile(i, k)) cycle
                if (has_tile(tiling, i + 1, k)) then
                    count = count + 1
                    matches(count)%is_upright = .true.
                    matches(count)%tiles = reshape([i, k, i + 1, k], [2, 2])
                end if
                if (has_tile(tiling, i, k + 1)) then
                    count = count + 1
                    matches(count)%tiles = reshape([i, k, i, k + 1], [2, 2])
                end if
            end do
        end do
        matches = matches(:count)
        do i = 1, count
            matches(i)%letters = letters_of(i)
            matches(i)%radius = min(largest_radius, radius_part*tiling%overlap)
            call place_match(sheet, cell_of(tiling, matches(i)%tiles(1, 1), &
                matches(i)%tiles(2, 1)), matches(i))
        end do
    end subroutine find_matches

    !> True for a tile that is there and is printed.
    pure logical function has_tile(tiling, column, row) result(has)
        type(tiling_type), intent(in) :: tiling     !! the tiles
        integer, intent(in) :: column               !! from the left, any number
        integer, intent(in) :: row                  !! from the top, any number

        has = .false.
        if (column > size(tiling%has_tile, 1) .or. row > size(tiling%has_tile, 2)) return
        has = tiling%has_tile(column, row)
    end function has_tile

    !> Finds the place of a mark on the right or lower edge of a cell: the first that is free, or
    !> the middle.
    pure subroutine place_match(sheet, cell, match)
        type(page_type), intent(in) :: sheet        !! what is drawn
        real(dp), intent(in) :: cell(4)             !! left, bottom, right, top, in
        type(match_type), intent(inout) :: match    !! gets it
        integer :: i

        do i = 1, size(places)
            match%at = edge_point(cell, places(i), match%is_upright)
            if (.not. anything_in(sheet, [match%at - match%radius, match%at + match%radius])) &
                return
        end do
        match%at = edge_point(cell, places(1), match%is_upright)
    end subroutine place_match

    !> A point of the right or the lower edge of a cell.
    pure function edge_point(cell, part, is_upright) result(at)
        real(dp), intent(in) :: cell(4)         !! left, bottom, right, top, in
        real(dp), intent(in) :: part            !! of the edge, from its left or lower end
        logical, intent(in) :: is_upright       !! the right edge
        real(dp) :: at(2)

        at = [cell(3), cell(2) + part*(cell(4) - cell(2))]
        if (.not. is_upright) at = [cell(1) + part*(cell(3) - cell(1)), cell(2)]
    end function edge_point

    !> Draws the marks of a tile, and the lines on which they stand.
    pure subroutine draw_matches(page, tiling, matches, tile, shift)
        type(page_type), intent(inout) :: page      !! gets them
        type(tiling_type), intent(in) :: tiling     !! its tiles
        type(match_type), intent(in) :: matches(:)  !! of the sheet
        integer, intent(in) :: tile(2)              !! column and row
        real(dp), intent(in) :: shift(2)            !! from the sheet to the page, in
        real(dp) :: window(4), line(2, 2)
        integer :: i

        window = window_of(tiling, tile(1), tile(2))
        do i = 1, size(matches)
            associate (match => matches(i))
                if (any(match%tiles(:, 1) /= tile) .and. any(match%tiles(:, 2) /= tile)) cycle
                if (match%is_upright) then
                    line = reshape([match%at(1), window(2), match%at(1), window(4)], [2, 2])
                else
                    line = reshape([window(1), match%at(2), window(3), match%at(2)], [2, 2])
                end if
                call page%draw(style%cut, line + spread(shift, 2, 2))
                call draw_match(page, match, match%at + shift)
            end associate
        end do
    end subroutine draw_matches

    !> Draws a mark.
    pure subroutine draw_match(page, match, at)
        type(page_type), intent(inout) :: page      !! gets it
        type(match_type), intent(in) :: match       !! the mark
        real(dp), intent(in) :: at(2)               !! its middle, in
        type(label_type) :: label
        real(dp) :: aside(2)

        call page%draw_curves(style%cross, match%radius*circle() + spread(at, 2, 13), .true.)
        aside = merge([0.5_dp, 0.0_dp], [0.0_dp, 0.5_dp], match%is_upright)*match%radius
        label%text = match%letters
        label%height = 0.8_dp*match%radius/max(1.0_dp, text_width(match%letters, 1.0_dp, .false.))
        label%side = side%middle
        call page%write(style%sheet_words, at - aside - [0.0_dp, 0.36_dp*label%height], label)
        call page%write(style%sheet_words, at + aside - [0.0_dp, 0.36_dp*label%height], label)
    end subroutine draw_match

    !> A circle of radius 1 around (0, 0) as four Bezier arcs, within 3e-4 of it.
    pure function circle() result(control)
        real(dp) :: control(2, 13), quarter(2, 3)
        integer :: i

        control(:, 1) = [1.0_dp, 0.0_dp]
        quarter = reshape([1.0_dp, handle, handle, 1.0_dp, 0.0_dp, 1.0_dp], [2, 3])
        do i = 0, 3
            control(:, 3*i + 2:3*i + 4) = quarter
            quarter = reshape([-quarter(2, 1), quarter(1, 1), -quarter(2, 2), quarter(1, 2), &
                -quarter(2, 3), quarter(1, 3)], [2, 3])
        end do
    end function circle

    !> Draws crosses at the corners of a tile's cell.
    pure subroutine draw_crosses(page, tiling, tile, shift)
        type(page_type), intent(inout) :: page      !! gets them
        type(tiling_type), intent(in) :: tiling     !! its tiles
        integer, intent(in) :: tile(2)              !! column and row
        real(dp), intent(in) :: shift(2)            !! from the sheet to the page, in
        real(dp) :: cell(4), at(2), reach
        integer :: i

        cell = cell_of(tiling, tile(1), tile(2))
        reach = cross_part*tiling%overlap
        do i = 1, 4
            at = [cell(merge(1, 3, i <= 2)), cell(merge(2, 4, mod(i, 2) == 1))] + shift
            call page%draw(style%cross, spread(at, 2, 2) + &
                reshape([-reach, 0.0_dp, reach, 0.0_dp], [2, 2]))
            call page%draw(style%cross, spread(at, 2, 2) + &
                reshape([0.0_dp, -reach, 0.0_dp, reach], [2, 2]))
        end do
    end subroutine draw_crosses

end module export_pattern_match
