!> Tests of the parting of a sheet into tiles.
program test_pattern_tiling
    use base_kinds, only: dp
    use export_pattern_page, only: page_type
    use export_pattern_paper, only: paper_kind, paper_type
    use export_pattern_style, only: style
    use export_pattern_tiling, only: cell_of, letters_of, new_tiling, strip_height, tile_name, &
        tiling_type, window_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(paper_type), parameter :: letter = paper_type(paper_kind%sheets, [8.5_dp, 11.0_dp], &
        0.4_dp, 0.5_dp)
    type(tiling_type) :: tiling
    real(dp) :: box(4), window(4)

    call new_tiling(framed([30.0_dp, 40.0_dp]), letter, tiling)
    call tap%ok(all(modulo(4.0_dp*tiling%cell, 1.0_dp) < 1.0e-12_dp), &
        'cells have sides of whole quarters of an inch')
    call tap%ok(all(tiling%cell + tiling%overlap <= tiling%paper - 0.8_dp - [0.0_dp, &
        strip_height]), 'and fit on the paper with their overlap, margins and strip')
    box = cell_of(tiling, 1, size(tiling%has_tile, 2))
    call tap%ok(all(box(:2) <= 0.0_dp), 'the lower left cell begins outside of the sheet')
    box = cell_of(tiling, size(tiling%has_tile, 1), 1)
    call tap%ok(box(3) >= 30.0_dp .and. box(4) >= 40.0_dp, 'the upper right one ends outside')
    window = window_of(tiling, 2, 2)
    box = cell_of(tiling, 2, 2)
    call tap%ok(all(abs(window - box - [-0.25_dp, -0.25_dp, 0.25_dp, 0.25_dp]) < 1.0e-12_dp), &
        'a window shows half the overlap more on each side')
    box = cell_of(tiling, 1, 2)
    call tap%near(box(3), window(1) + 0.25_dp, 1.0e-12_dp, 'cells meet')
    call tap%ok(.not. tiling%has_tile(3, 3) .and. tiling%has_tile(1, 1), &
        'a tile with nothing on it is left out')

    call new_tiling(framed([70.0_dp, 6.0_dp]), letter, tiling)
    call tap%ok(tiling%paper(1) > tiling%paper(2), 'what is low and long is printed across')
    call new_tiling(framed([5.0_dp, 60.0_dp]), letter, tiling)
    call tap%ok(tiling%paper(1) < tiling%paper(2), 'what is high and narrow upright')
    call new_tiling(framed([7.6_dp, 8.5_dp]), letter, tiling)
    call tap%ok(tiling%is_one .and. size(tiling%has_tile) == 1, 'what fits is on one page')
    call new_tiling(framed([7.6_dp, 9.7_dp]), letter, tiling)
    call tap%ok(.not. tiling%is_one, 'what does not is tiled')

    call tap%same(tile_name(1, 1)//tile_name(12, 3), 'A1C12', 'rows have letters, columns numbers')
    call tap%same(letters_of(26)//' '//letters_of(27)//' '//letters_of(703), 'Z AA AAA', &
        'letters go on as long as they must')
    call tap%finish()

contains

    !> A sheet with a frame around it.
    pure type(page_type) function framed(size) result(sheet)
        real(dp), intent(in) :: size(2) !! in
        sheet%size = size
        call sheet%draw(style%outline, reshape([0.0_dp, 0.0_dp, size(1), 0.0_dp, size, 0.0_dp, &
            size(2)], [2, 4]), .true.)
    end function framed

end program test_pattern_tiling
