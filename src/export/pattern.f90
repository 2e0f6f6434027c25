!> Full-size patterns of the cuts of a drawing, on pages that the writers of SVG and PDF render.
!>
!> Reference lines are at round ordinates of the drawing's unit, which is that of the settings too;
!> pages are in inches.
module export_pattern
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: counted
    use export_drawing, only: drawing_type, shape_type
    use export_drawing_whole, only: whole
    use export_pattern_block, only: draw_block
    use export_pattern_marks, only: draw_bevels, draw_lines, draw_name, line_type, name_lines
    use export_pattern_page, only: largest_page, page_type
    use export_pattern_paper, only: find_paper, paper_kind, paper_type
    use export_pattern_part, only: new_part, part_type
    use export_pattern_sheets, only: fitted_page, framed_part, make_sheets
    use export_pattern_tiles, only: tile_sheet
    use export_pattern_tiling, only: strip_height
    use export_receipt, only: receipt_type
    use export_settings, only: settings_type
    use export_units, only: find_unit, unit_type
    implicit none (type, external)
    private

    public :: lay_out

    !> The tolerance where none is asked for, in.
    real(dp), parameter :: usual_tolerance = 1.0e-3_dp

contains

    !> Lays out the cuts of a drawing. Fails with `cause%usage` where there is no cut to draw, or
    !> where the unit or the paper can't be.
    pure subroutine lay_out(drawing, settings, pages, receipt, error)
        type(drawing_type), intent(in) :: drawing               !! in any unit
        type(settings_type), intent(in) :: settings             !! what is asked for
        type(page_type), allocatable, intent(out) :: pages(:)   !! in order
        type(receipt_type), intent(inout) :: receipt            !! gets an entity for each contour
        type(error_type), allocatable, intent(out) :: error     !! see above
        type(unit_type) :: unit
        type(paper_type) :: paper
        type(page_type), allocatable :: parts(:), sheets(:)

        call find_unit(drawing%units, unit, error)
        if (allocated(error)) return
        call find_paper(settings, 1.0_dp/unit%inch, paper, error)
        if (allocated(error)) return
        call draw_parts(drawing, settings, unit, parts, receipt)
        if (size(parts) == 0) then
            call fail(error, cause%usage, 'there is no cut to make a pattern of; it takes a '// &
                'STATION, BUTTOCK, WATERLN, OBLIQUE or PLANE card that cuts the body')
            return
        end if
        call make_sheets(parts, settings%is_each, paper, sheets)
        call make_pages(sheets, paper, heading_of(drawing), pages)
    end subroutine lay_out

    !> Draws the parts; cuts that have no outline have none, and the receipt says so.
    pure subroutine draw_parts(drawing, settings, unit, parts, receipt)
        type(drawing_type), intent(in) :: drawing               !! what is drawn
        type(settings_type), intent(in) :: settings             !! what is asked for
        type(unit_type), intent(in) :: unit                     !! of both
        type(page_type), allocatable, intent(out) :: parts(:)   !! with corners at (0, 0)
        type(receipt_type), intent(inout) :: receipt            !! gets the contours
        type(shape_type) :: shape
        type(part_type) :: part
        type(line_type), allocatable :: lines(:)
        real(dp) :: tolerance
        integer :: i, count

        tolerance = settings%tolerance
        if (.not. tolerance > 0.0_dp) tolerance = usual_tolerance*unit%inch
        allocate (parts(size(drawing%cuts)))
        count = 0
        do i = 1, size(drawing%cuts)
            shape = drawing%cuts(i)
            if (shape%is_half .and. .not. settings%is_half) shape = whole(drawing%cuts(i))
            call new_part(shape, 1.0_dp/unit%inch, tolerance, part, receipt)
            if (size(part%traces) == 0) then
                call receipt%say('NO PATTERN OF '//shape%title//': IT HAS NO OUTLINE')
                cycle
            end if
            call draw_lines(shape, part, lines)
            call draw_bevels(shape, part)
            call name_lines(lines, part)
            call draw_name(shape%title, part)
            call draw_block(drawing, shape, unit, part)
            count = count + 1
            parts(count) = framed_part(part%page, shape%name, shape%title)
        end do
        parts = parts(:count)
    end subroutine draw_parts

    !> Makes the pages of sheets.
    pure subroutine make_pages(sheets, paper, heading, pages)
        type(page_type), intent(in) :: sheets(:)                !! from `make_sheets`
        type(paper_type), intent(in) :: paper                   !! what they are printed on
        character(*), intent(in) :: heading                     !! of the deck
        type(page_type), allocatable, intent(out) :: pages(:)   !! in order
        type(page_type), allocatable :: more(:), grown(:)
        integer :: i, count

        allocate (pages(size(sheets)))
        count = 0
        do i = 1, size(sheets)
            call print_sheet(sheets(i), paper, heading, more)
            if (count + size(more) > size(pages)) then
                allocate (grown(2*(count + size(more))))
                grown(:count) = pages(:count)
                call move_alloc(grown, pages)
            end if
            pages(count + 1:count + size(more)) = more
            count = count + size(more)
        end do
        pages = pages(:count)
    end subroutine make_pages

    !> Makes the pages of a sheet: tiles, or one that fits.
    pure subroutine print_sheet(sheet, paper, heading, pages)
        type(page_type), intent(in) :: sheet                    !! from `make_sheets`
        type(paper_type), intent(in) :: paper                   !! what it is printed on
        character(*), intent(in) :: heading                     !! of the deck
        type(page_type), allocatable, intent(out) :: pages(:)   !! in order
        integer :: i

        if (paper%kind == paper_kind%sheets) then
            call tile_sheet(sheet, paper, heading, pages)
        else if (paper%kind == paper_kind%roll .and. &
            sheet%size(1) > paper%size(1) - 2.0_dp*paper%margin) then
            call tile_sheet(sheet, strips_for(sheet, paper), heading, pages)
        else
            allocate (pages(1))
            pages(1) = fitted_page(sheet, paper, heading)
        end if
        do i = 1, size(pages)
            pages(i)%title = heading
        end do
    end subroutine print_sheet

    !> A roll cut in lengths for a sheet that is wider: as long as the sheet, or as a page may be.
    pure type(paper_type) function strips_for(sheet, roll) result(strips)
        type(page_type), intent(in) :: sheet        !! wider than the roll
        type(paper_type), intent(in) :: roll        !! what it is printed on

        strips = roll
        strips%size(2) = min(largest_page, strip_height + 2.0_dp*roll%margin + &
            real(ceiling(sheet%size(2) + roll%overlap), dp))
    end function strips_for

    !> What each page says of the deck.
    pure function heading_of(drawing) result(heading)
        type(drawing_type), intent(in) :: drawing !! the drawing
        character(:), allocatable :: heading
        heading = drawing%deck
        if (drawing%title /= '') heading = drawing%title//', '//heading
    end function heading_of

end module export_pattern
