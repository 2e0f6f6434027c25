!> The words on a drawing in DXF: what it shows, in which unit, how exactly, which cut is on which
!> layer; and the bevels along the contours.
module export_dxf_notes
    use base_constants, only: version
    use base_kinds, only: dp, i64
    use base_text, only: compact, counted, upper
    use export_drawing, only: contour_type, drawing_type
    use export_dxf_page, only: add_words, page_type, stroke_type, words_side, words_type
    use export_pattern_number, only: bevel_text
    use export_settings, only: settings_type
    use export_units, only: unit_type
    implicit none (type, external)
    private

    public :: add_notes, add_bevels

    !> In heights of letters: from the shapes to the first note, from note to note, the length of a
    !> bevel's tick and from its foot to its figures.
    real(dp), parameter :: below = 8.0_dp, line_height = 2.0_dp, tick = 1.0_dp, beyond = 2.0_dp
    !> Notes at most besides those of the cuts.
    integer, parameter :: most_notes = 7

contains

    !> Adds the notes, line by line below the shapes.
    pure subroutine add_notes(page, drawing, unit, settings, layers)
        type(page_type), intent(inout) :: page      !! with its corners and reference lines
        type(drawing_type), intent(in) :: drawing   !! what is drawn
        type(unit_type), intent(in) :: unit         !! of it
        type(settings_type), intent(in) :: settings !! as asked for
        character(*), intent(in) :: layers(:)       !! of the cuts
        type(words_type), allocatable :: notes(:)
        real(dp) :: down
        integer :: i, count

        allocate (notes(most_notes + size(drawing%cuts)))
        count = 0
        if (drawing%title /= '') call put_note(drawing%title, notes, count)
        call put_note('DECK '//drawing%deck, notes, count)
        call put_note('ALL DIMENSIONS IN '//trim(unit%name), notes, count)
        call put_note('WITHIN '//compact(settings%tolerance)//' '//trim(unit%short)// &
            ' OF THE EXACT SHAPE', notes, count)
        if (settings%is_in_space) then
            call put_note('IN SPACE: X IS STA, Y IS BL, Z IS WL', notes, count)
        else
            call put_note('TRUE SHAPES AT A COMMON ORIGIN, EACH CUT ON ITS OWN LAYER', notes, count)
        end if
        if (settings%is_half .and. any(drawing%cuts%is_half)) &
            call put_note('HALVES: THE OTHER HALF IS THE MIRROR IMAGE IN BL 0', notes, count)
        do i = 1, size(drawing%cuts)
            associate (cut => drawing%cuts(i))
                call put_note('LAYER '//trim(layers(i))//': '//cut%title//', '// &
                    upper(counted(int(cut%quantity, i64), 'piece')), notes, count)
            end associate
        end do
        call put_note('LOFT '//version, notes, count)
        page%words = notes(:count)
        do i = 1, count
            down = (below + line_height*real(i - 1, dp))*page%height
            page%words(i)%at = page%low - [0.0_dp, down]
        end do
    end subroutine add_notes

    !> Puts a note behind others; where it stands is not said yet.
    pure subroutine put_note(text, notes, count)
        character(*), intent(in) :: text                !! any bytes
        type(words_type), intent(inout) :: notes(:)     !! have room for it
        integer, intent(inout) :: count                 !! how many there are
        count = count + 1
        notes(count)%side = words_side%left
        notes(count)%text = text
    end subroutine put_note

    !> Adds the bevels along a contour: a tick across it and the degrees beside it.
    pure subroutine add_bevels(page, contour)
        type(page_type), intent(inout) :: page      !! gets them, its notes are there
        type(contour_type), intent(in) :: contour   !! in the plane of the page
        integer :: i

        if (.not. allocated(contour%marks)) return
        do i = 1, size(contour%marks)
            associate (mark => contour%marks(i))
                page%ticks = [page%ticks, stroke_type(mark%uv, &
                    mark%uv + tick*page%height*mark%outward)]
                call add_words(page%words, mark%uv + beyond*page%height*mark%outward, &
                    words_side%middle, bevel_text(mark%bevel))
            end associate
        end do
    end subroutine add_bevels

end module export_dxf_notes
