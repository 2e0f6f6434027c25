!> The pages of a sheet that is tiled: a page map, then a page for each tile on which anything is
!> drawn, row by row from the top.
module export_pattern_tiles
    use base_kinds, only: dp
    use base_text, only: to_text
    use export_pattern_bars, only: draw_bars
    use export_pattern_clip, only: add_within
    use export_pattern_letters, only: shortened, text_width
    use export_pattern_map, only: blank_tiles, draw_map
    use export_pattern_match, only: draw_crosses, draw_matches, find_matches, match_type
    use export_pattern_number, only: inches, short
    use export_pattern_page, only: label_type, page_type
    use export_pattern_style, only: style
    use export_pattern_tiling, only: new_tiling, strip_height, tile_name, tiling_type, window_of
    use export_pattern_paper, only: paper_type
    implicit none (type, external)
    private

    public :: tile_sheet

    !> Room for the small map and for the words beside it, heights of type: in.
    real(dp), parameter :: map_width = 1.0_dp, words_width = 2.3_dp, gap = 0.12_dp, &
        height = 0.1_dp, name_height = 0.3_dp, title_height = 0.25_dp, line_height = 0.155_dp
    !> A page map: its height on a roll, lines above it, their type, and from line to line: in.
    real(dp), parameter :: roll_map = 12.0_dp, head_height = 1.9_dp, &
        body_height = 0.12_dp, body_line = 0.19_dp

contains

    !> Makes the pages of a sheet.
    pure subroutine tile_sheet(sheet, paper, heading, pages)
        type(page_type), intent(in) :: sheet                    !! what is drawn
        type(paper_type), intent(in) :: paper                   !! what it is printed on
        character(*), intent(in) :: heading                     !! of the deck, any bytes
        type(page_type), allocatable, intent(out) :: pages(:)   !! the pages
        type(tiling_type) :: tiling
        type(match_type), allocatable :: matches(:)
        integer :: i, k, count

        call new_tiling(sheet, paper, tiling)
        if (tiling%is_one) then
            allocate (pages(1))
            call draw_tile(sheet, tiling, [1, 1], pages(1))
            call draw_strip(pages(1), sheet, tiling, [1, 1], heading)
            pages(1)%name = sheet%name
            pages(1)%label = sheet%label
            return
        end if
        call find_matches(sheet, tiling, matches)
        allocate (pages(1 + count_tiles(tiling)))
        call draw_overview(pages(1), sheet, tiling, paper%is_upright, heading)
        count = 1
        do k = 1, size(tiling%has_tile, 2)
            do i = 1, size(tiling%has_tile, 1)
                if (.not. tiling%has_tile(i, k)) cycle
                count = count + 1
                call draw_tile(sheet, tiling, [i, k], pages(count))
                call draw_matches(pages(count), tiling, matches, [i, k], &
                    shift_of(tiling, [i, k]))
                call draw_crosses(pages(count), tiling, [i, k], shift_of(tiling, [i, k]))
                call draw_strip(pages(count), sheet, tiling, [i, k], heading)
            end do
        end do
    end subroutine tile_sheet

    !> How many tiles are printed.
    pure integer function count_tiles(tiling) result(tiles)
        type(tiling_type), intent(in) :: tiling !! the tiles
        tiles = count(tiling%has_tile)
    end function count_tiles

    !> From the sheet to the page of a tile, in.
    pure function shift_of(tiling, tile) result(shift)
        type(tiling_type), intent(in) :: tiling     !! the tiles
        integer, intent(in) :: tile(2)              !! column and row
        real(dp) :: shift(2), window(4), room(2), corner(2)

        window = window_of(tiling, tile(1), tile(2))
        room = tiling%paper - 2.0_dp*tiling%margin - [0.0_dp, strip_height]
        corner = tiling%margin + [0.0_dp, strip_height] + 0.5_dp*(room - window(3:) + window(:2))
        shift = corner - window(:2)
    end function shift_of

    !> Draws what a tile shows of the sheet.
    pure subroutine draw_tile(sheet, tiling, tile, page)
        type(page_type), intent(in) :: sheet        !! what is drawn
        type(tiling_type), intent(in) :: tiling     !! its tiles
        integer, intent(in) :: tile(2)              !! column and row
        type(page_type), intent(out) :: page        !! the page
        real(dp) :: window(4), shift(2)
        integer :: i

        page%name = sheet%name//'-'//tile_name(tile(1), tile(2))
        page%label = sheet%label//' '//tile_name(tile(1), tile(2))
        page%size = tiling%paper
        page%is_clipped = .not. tiling%is_one
        window = window_of(tiling, tile(1), tile(2))
        shift = shift_of(tiling, tile)
        page%window = window + [shift, shift]
        page%groups = sheet%groups
        page%group_count = sheet%group_count
        do i = 1, sheet%count
            call add_within(page, sheet%items(i), window, shift)
        end do
    end subroutine draw_tile

    !> Draws the strip below a tile: small map, words, check bars.
    pure subroutine draw_strip(page, sheet, tiling, tile, heading)
        type(page_type), intent(inout) :: page      !! gets it
        type(page_type), intent(in) :: sheet        !! what is drawn
        type(tiling_type), intent(in) :: tiling     !! its tiles
        integer, intent(in) :: tile(2)              !! column and row
        character(*), intent(in) :: heading         !! of the deck
        real(dp) :: at(2)
        integer :: number

        at = [tiling%margin, tiling%margin]
        if (.not. tiling%is_one) then
            call draw_map(page, sheet, tiling, [at, at + [map_width, strip_height - gap]], tile)
            at(1) = at(1) + map_width + gap
        end if
        at(2) = at(2) + strip_height - gap - name_height
        if (tiling%is_one) then
            call write_words(page, sheet%label, title_height, at, words_width)
        else
            call write_words(page, tile_name(tile(1), tile(2)), name_height, at, words_width)
        end if
        at(2) = at(2) - 0.1_dp
        call write_line(page, heading, at)
        if (.not. tiling%is_one) then
            number = count(tiling%has_tile(:, :tile(2) - 1)) + &
                count(tiling%has_tile(:tile(1), tile(2)))
            call write_line(page, sheet%label//', TILE '//to_text(number)//' OF '// &
                to_text(count_tiles(tiling)), at)
            call write_line(page, 'CROSSES '//inches(tiling%cell(1))//' BY '// &
                inches(tiling%cell(2))//' in APART', at)
        end if
        call write_line(page, 'PRINT AT 100 %, NOT FITTED', at)
        at = [at(1) + words_width, tiling%margin + gap]
        call draw_bars(page, at, tiling%paper(1) - tiling%margin - at(1))
    end subroutine draw_strip

    !> Writes a small line of the strip, and goes to the next.
    pure subroutine write_line(page, words, at)
        type(page_type), intent(inout) :: page      !! gets it
        character(*), intent(in) :: words           !! any bytes
        real(dp), intent(inout) :: at(2)            !! base line of that above; then its own, in

        at(2) = at(2) - line_height
        call write_words(page, words, height, at, words_width)
    end subroutine write_line

    !> Writes words of the sheet.
    pure subroutine write_words(page, words, type_height, at, width)
        type(page_type), intent(inout) :: page      !! gets them
        character(*), intent(in) :: words           !! any bytes
        real(dp), intent(in) :: type_height         !! in
        real(dp), intent(in) :: at(2)               !! start of the base line, in
        real(dp), intent(in) :: width               !! of the room, in
        type(label_type) :: label

        label%text = shortened(words, type_height, width)
        label%height = type_height
        label%is_bold = type_height > 0.2_dp
        call page%write(style%sheet_words, at, label)
    end subroutine write_words

    !> Draws the page map, with what to do.
    pure subroutine draw_overview(page, sheet, tiling, is_roll, heading)
        type(page_type), intent(inout) :: page      !! gets it
        type(page_type), intent(in) :: sheet        !! what is drawn
        type(tiling_type), intent(in) :: tiling     !! its tiles
        logical, intent(in) :: is_roll              !! paper is as long as it must be
        character(*), intent(in) :: heading         !! of the deck
        character(:), allocatable :: blanks
        real(dp) :: at(2), box(4)

        page%name = sheet%name//'-map'
        page%label = sheet%label//' PAGE MAP'
        page%size = tiling%paper
        if (is_roll) page%size(2) = min(page%size(2), roll_map)
        at = [tiling%margin, page%size(2) - tiling%margin - title_height]
        call write_words(page, page%label, title_height, at, page%size(1) - 2.0_dp*at(1))
        at(2) = at(2) - 0.05_dp
        call write_body(page, heading, at)
        call write_body(page, to_text(count_tiles(tiling))//' TILES, '//inches(sheet%size(1))// &
            ' BY '//inches(sheet%size(2))//' in IN ALL', at)
        blanks = 'LEFT OUT, NOTHING ON THEM: '//blank_tiles(tiling)
        if (text_width(blanks, body_height, .false.) > page%size(1) - 2.0_dp*tiling%margin) &
            blanks = 'CROSSED TILES ARE LEFT OUT, NOTHING ON THEM'
        if (.not. all(tiling%has_tile)) call write_body(page, blanks, at)
        call write_body(page, '1  PRINT AT 100 %, NOT FITTED TO THE PAGE. MEASURE BOTH BARS OF '// &
            'EACH PAGE.', at)
        call write_body(page, '2  ON ONE OF TWO NEIGHBOURS CUT ALONG THE DOTTED LINE.', at)
        call write_body(page, '3  LAY IT ON THE OTHER, SAME LETTER ON SAME LETTER, UNTIL '// &
            'CIRCLES AND CROSSES ARE WHOLE. TAPE.', at)
        call write_body(page, '4  MEASURE FROM CROSS TO CROSS: '//short(tiling%cell(1), 3)// &
            ' in ACROSS, '//short(tiling%cell(2), 3)//' in UP.', at)
        box = [[0.0_dp, 0.0_dp] + tiling%margin, page%size - tiling%margin]
        call draw_bars(page, box(:2), box(3) - box(1))
        call draw_map(page, sheet, tiling, box + [0.0_dp, strip_height, 0.0_dp, -head_height], &
            [0, 0])
    end subroutine draw_overview

    !> Writes a line of the page map, and goes to the next.
    pure subroutine write_body(page, words, at)
        type(page_type), intent(inout) :: page      !! gets it
        character(*), intent(in) :: words           !! any bytes
        real(dp), intent(inout) :: at(2)            !! base line of that above; then its own, in

        at(2) = at(2) - body_line
        call write_words(page, words, body_height, at, page%size(1) - 2.0_dp*at(1))
    end subroutine write_body

end module export_pattern_tiles
