!> How a sheet is parted into tiles. Each tile owns a cell; its window shows half the overlap more
!> on each side. Cells have sides of whole quarters of an inch, so that the crosses at their corners
!> prove the scale too.
module export_pattern_tiling
    use base_kinds, only: dp
    use base_text, only: to_text
    use export_pattern_clip, only: anything_in
    use export_pattern_page, only: page_type
    use export_pattern_paper, only: paper_type
    implicit none (type, external)
    private

    public :: tiling_type, new_tiling, cell_of, window_of, tile_name, strip_height, letters_of

    !> The parting of a sheet.
    type :: tiling_type
        real(dp) :: paper(2) = 0.0_dp           !! width and height of a page as it is used, in
        real(dp) :: margin = 0.0_dp             !! around it, in
        real(dp) :: overlap = 0.0_dp            !! in
        real(dp) :: cell(2) = 0.0_dp            !! width and height, in
        real(dp) :: corner(2) = 0.0_dp          !! lower left one of all cells, on the sheet, in
        logical, allocatable :: has_tile(:, :)  !! by columns from the left and rows from the top
        logical :: is_one = .false.             !! all is on one page: it has no crosses
    end type tiling_type

    !> The strip below the window: bars, words, small map; in.
    real(dp), parameter :: strip_height = 1.0_dp
    !> How far a part is off the middle of the tiles, so that none is cut on its centre line; in.
    real(dp), parameter :: aside = 0.5_dp
    !> Sides of cells are multiples of this, in.
    real(dp), parameter :: quarter = 0.25_dp

contains

    !> Parts a sheet, upright or across: whichever takes fewer pages.
    pure subroutine new_tiling(sheet, paper, tiling)
        type(page_type), intent(in) :: sheet        !! what is drawn, from (0, 0) to its size
        type(paper_type), intent(in) :: paper       !! what it is printed on
        type(tiling_type), intent(out) :: tiling    !! the parting
        type(tiling_type) :: across

        call part_sheet(sheet, paper, paper%size, tiling)
        if (paper%is_upright) return
        call part_sheet(sheet, paper, [paper%size(2), paper%size(1)], across)
        if (count(across%has_tile) < count(tiling%has_tile)) tiling = across
    end subroutine new_tiling

    !> Parts a sheet into pages as they lie.
    pure subroutine part_sheet(sheet, paper, page_size, tiling)
        type(page_type), intent(in) :: sheet        !! what is drawn
        type(paper_type), intent(in) :: paper       !! what it is printed on
        real(dp), intent(in) :: page_size(2)        !! width and height of a page, in
        type(tiling_type), intent(out) :: tiling    !! the parting
        real(dp) :: room(2)
        integer :: tiles(2), i, k

        tiling%paper = page_size
        tiling%margin = paper%margin
        tiling%overlap = paper%overlap
        room = page_size - 2.0_dp*paper%margin - [0.0_dp, strip_height]
        tiling%is_one = all(sheet%size <= room)
        if (tiling%is_one) then
            tiling%cell = room
            tiling%overlap = 0.0_dp
            tiles = 1
        else
            tiling%cell = quarter*real(floor((room - paper%overlap)/quarter), dp)
            tiles = max(1, ceiling(sheet%size/tiling%cell))
        end if
        tiling%corner = 0.5_dp*(sheet%size - tiling%cell*real(tiles, dp))
        if (.not. tiling%is_one) tiling%corner = tiling%corner - min(aside, -tiling%corner)
        allocate (tiling%has_tile(tiles(1), tiles(2)))
        do k = 1, tiles(2)
            do i = 1, tiles(1)
                tiling%has_tile(i, k) = anything_in(sheet, cell_of(tiling, i, k))
            end do
        end do
    end subroutine part_sheet

    !> The cell of a tile on the sheet: left, bottom, right, top, in.
    pure function cell_of(tiling, column, row) result(box)
        type(tiling_type), intent(in) :: tiling     !! the parting
        integer, intent(in) :: column               !! from the left
        integer, intent(in) :: row                  !! from the top
        real(dp) :: box(4)

        box(1) = tiling%corner(1) + real(column - 1, dp)*tiling%cell(1)
        box(2) = tiling%corner(2) + real(size(tiling%has_tile, 2) - row, dp)*tiling%cell(2)
        box(3:) = box(:2) + tiling%cell
    end function cell_of

    !> What a tile shows of the sheet: left, bottom, right, top, in.
    pure function window_of(tiling, column, row) result(box)
        type(tiling_type), intent(in) :: tiling     !! the parting
        integer, intent(in) :: column               !! from the left
        integer, intent(in) :: row                  !! from the top
        real(dp) :: box(4), more
        more = 0.5_dp*tiling%overlap
        box = cell_of(tiling, column, row) + [-more, -more, more, more]
    end function window_of

    !> The name of a tile: a letter for its row, a number for its column.
    pure function tile_name(column, row) result(name)
        integer, intent(in) :: column               !! from the left
        integer, intent(in) :: row                  !! from the top
        character(:), allocatable :: name
        name = letters_of(row)//to_text(column)
    end function tile_name

    !> The letters of a number: A to Z, AA, AB and so on.
    pure function letters_of(number) result(letters)
        integer, intent(in) :: number !! from 1
        character(:), allocatable :: letters
        integer :: rest

        letters = ''
        rest = number
        do while (rest > 0)
            letters = achar(iachar('A') + mod(rest - 1, 26))//letters
            rest = (rest - 1)/26
        end do
    end function letters_of

end module export_pattern_tiling
