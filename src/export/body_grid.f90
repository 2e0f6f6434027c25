!> What stands around the curves of a lines plan: the straight lines of stations, butt lines and
!> waterlines with their ordinates, centre lines, and the title block.
module export_body_grid
    use base_kinds, only: dp
    use cut_outline, only: cut_type
    use cut_plane, only: cut_kind
    use export_body_drawing, only: drawing_type, mark_of, word_side
    use export_body_sheet, only: sheet_type
    implicit none (type, external)
    private

    public :: draw_grid, draw_block

    !> Dots from the edge of a view to the words beside it, and from line to line of the title
    !> block.
    real(dp), parameter :: beside = 9.0_dp, line_height = 19.0_dp
    !> The styles that the title block explains, and what they are.
    character(*), parameter :: styles(4) = [character(9) :: 'line', 'section', 'buttock', &
        'waterline']
    character(*), parameter :: meanings(4) = [character(12) :: 'control line', 'section', &
        'butt line', 'waterline']

contains

    !> Draws the straight lines of the planes of the cuts in the views where they are straight, with
    !> their ordinates beside them, and the centre lines.
    pure subroutine draw_grid(sheet, cuts, drawing)
        type(sheet_type), intent(in) :: sheet           !! where the views stand
        type(cut_type), intent(in) :: cuts(:)           !! with their planes
        type(drawing_type), intent(inout) :: drawing    !! gets them
        real(dp) :: left, right
        integer :: i

        left = sheet%body_centre + sheet%body_low
        right = sheet%body_centre + sheet%high(2)
        call straight('centre', [sheet%low(1), sheet%plan_centre], &
            [sheet%high(1), sheet%plan_centre], drawing)
        call straight('centre', [sheet%body_centre, sheet%low(3)], &
            [sheet%body_centre, sheet%high(3)], drawing)
        call note('CL', [sheet%low(1) - beside*sheet%dot, sheet%plan_centre], word_side%left, &
            drawing)
        call note('CL', [sheet%body_centre, sheet%high(3) + beside*sheet%dot], word_side%middle, &
            drawing)
        call note('STA', [sheet%low(1) - beside*sheet%dot, between_views(sheet)], word_side%left, &
            drawing)
        do i = 1, size(cuts)
            associate (at => cuts(i)%plane%through)
                select case (cuts(i)%plane%kind)
                case (cut_kind%station)
                    call station_grid(sheet, at(1), drawing)
                case (cut_kind%buttock)
                    call straight('grid', [sheet%low(1), sheet%plan_centre + at(2)], &
                        [sheet%high(1), sheet%plan_centre + at(2)], drawing)
                    call straight('grid', [sheet%body_centre + at(2), sheet%low(3)], &
                        [sheet%body_centre + at(2), sheet%high(3)], drawing)
                    call note('BL '//mark_of(at(2)), [sheet%low(1) - beside*sheet%dot, &
                        sheet%plan_centre + at(2)], word_side%left, drawing)
                    call note(mark_of(at(2)), [sheet%body_centre + at(2), &
                        sheet%high(3) + beside*sheet%dot], word_side%middle, drawing)
                case (cut_kind%waterline)
                    call straight('grid', [sheet%low(1), at(3)], [sheet%high(1), at(3)], drawing)
                    call straight('grid', [left, at(3)], [right, at(3)], drawing)
                    call note('WL '//mark_of(at(3)), [sheet%low(1) - beside*sheet%dot, at(3)], &
                        word_side%left, drawing)
                    call note(mark_of(at(3)), [right + beside*sheet%dot, at(3)], &
                        word_side%right, drawing)
                end select
            end associate
        end do
    end subroutine draw_grid

    !> Draws the straight lines of a station, with its name between profile and plan.
    pure subroutine station_grid(sheet, sta, drawing)
        type(sheet_type), intent(in) :: sheet           !! where the views stand
        real(dp), intent(in) :: sta                     !! deck units
        type(drawing_type), intent(inout) :: drawing    !! gets them

        call straight('grid', [sta, sheet%low(3)], [sta, sheet%high(3)], drawing)
        call straight('grid', [sta, sheet%plan_centre + sheet%low(2)], &
            [sta, sheet%plan_centre + sheet%high(2)], drawing)
        call note(mark_of(sta), [sta, sheet%high(3) + beside*sheet%dot], word_side%middle, drawing)
        call note(mark_of(sta), [sta, sheet%plan_centre + sheet%low(2) - beside*sheet%dot], &
            word_side%middle, drawing)
        call note(mark_of(sta), [sta, between_views(sheet)], word_side%middle, drawing)
    end subroutine station_grid

    !> The height half-way between profile and plan, deck units.
    pure real(dp) function between_views(sheet) result(y)
        type(sheet_type), intent(in) :: sheet !! where the views stand
        y = 0.5_dp*(sheet%low(3) + sheet%plan_centre + sheet%high(2))
    end function between_views

    !> Draws the title block: what it is, the scale, and which line is what.
    pure subroutine draw_block(sheet, heading, unit, drawing)
        type(sheet_type), intent(in) :: sheet           !! where it stands
        character(*), intent(in) :: heading             !! title of the deck
        character(*), intent(in) :: unit                !! of the deck
        type(drawing_type), intent(inout) :: drawing    !! gets it
        real(dp) :: at(2), dot
        integer :: i

        dot = sheet%dot
        at = sheet%block - [0.0_dp, line_height*dot]
        call drawing%write_words(heading, at, word_side%right, 2)
        at(2) = at(2) - 1.4_dp*line_height*dot
        call drawing%write_words('Lines plan, all views to one scale', at, word_side%right, 1)
        at(2) = at(2) - line_height*dot
        call drawing%write_words('Stations, butt lines and waterlines in '//unit, at, &
            word_side%right, 1)
        at(2) = at(2) - 1.4_dp*line_height*dot
        do i = 1, size(styles)
            if (.not. has_style(drawing, styles(i))) cycle
            call straight(styles(i), at, at + [34.0_dp*dot, 0.0_dp], drawing)
            call drawing%write_words(trim(meanings(i)), at + [42.0_dp*dot, 0.0_dp], &
                word_side%right, 0)
            at(2) = at(2) - line_height*dot
        end do
    end subroutine draw_block

    !> True where a drawing has lines of a style.
    pure logical function has_style(drawing, style)
        type(drawing_type), intent(in) :: drawing   !! the drawing
        character(*), intent(in) :: style           !! the style
        has_style = .false.
        if (drawing%layers > 0) has_style = any(drawing%layer(:drawing%layers)%style == style)
    end function has_style

    !> Draws a straight line.
    pure subroutine straight(style, from, to, drawing)
        character(*), intent(in) :: style               !! of the line
        real(dp), intent(in) :: from(2)                 !! one end
        real(dp), intent(in) :: to(2)                   !! other end
        type(drawing_type), intent(inout) :: drawing    !! gets it
        call drawing%draw(trim(style), reshape([from, to], [2, 2]))
    end subroutine straight

    !> Puts small words where they hide no others, else nowhere.
    pure subroutine note(text, at, side, drawing)
        character(*), intent(in) :: text                !! the words
        real(dp), intent(in) :: at(2)                   !! their place
        integer, intent(in) :: side                     !! one of `word_side%...`
        type(drawing_type), intent(inout) :: drawing    !! gets them
        call drawing%write_where_free(text, reshape(at, [2, 1]), side)
    end subroutine note

end module export_body_grid
