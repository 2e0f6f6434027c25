!> The lines plan of a deck as a loft draws it: profile, half-breadth plan below it, body plan
!> beside it, on one sheet to one scale. Sections forward of the greatest stand on the starboard
!> side of the body plan, those aft of it to port, the greatest on both; where none are aft, or the
!> body has no symmetry, all stand as they are.
module export_body_lines
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_line, only: line_type
    use cut_outline, only: cut_type, outline_type
    use cut_plane, only: cut_kind
    use export_body_curves, only: body_range, chain_strokes, gather_outlines, mirror_in_plane, &
        outline_points, swept_area
    use export_body_drawing, only: drawing_type, mark_of, stroke_type
    use export_body_grid, only: draw_block, draw_grid
    use export_body_named, only: draw_named
    use export_body_sheet, only: in_body_plan, in_plan, in_profile, new_sheet, sheet_type
    implicit none (type, external)
    private

    public :: lines_plan, find_corners

contains

    !> The lines plan of some bodies and their cuts. Buttocks, waterlines and stations should have
    !> points as close as the eye can tell; other cuts are not drawn.
    pure type(drawing_type) function lines_plan(bodies, cuts, heading, unit) result(drawing)
        type(body_type), intent(in) :: bodies(:)    !! finished, of one symmetry
        type(cut_type), intent(in) :: cuts(:)       !! of any of these bodies
        character(*), intent(in) :: heading         !! title of the deck
        character(*), intent(in) :: unit            !! name of its unit
        type(sheet_type) :: sheet
        real(dp) :: low(3), high(3), greatest
        logical :: is_symmetric, is_split
        integer :: i

        is_symmetric = .true.
        if (size(bodies) > 0) is_symmetric = bodies(1)%is_symmetric
        call find_corners(bodies, cuts, low, high)
        greatest = greatest_station(cuts)
        is_split = is_symmetric .and. any(cuts%plane%kind == cut_kind%station .and. &
            cuts%plane%through(1) > greatest)
        sheet = new_sheet(low, high, is_split)
        drawing%name = 'lines'
        drawing%script = 'sheet'
        drawing%heading = heading
        drawing%note = ''
        drawing%view = 'Lines plan'
        drawing%x_axis = ''
        drawing%y_axis = ''
        drawing%low = sheet%paper_low
        drawing%high = sheet%paper_high
        drawing%dot = sheet%dot
        call draw_grid(sheet, cuts, drawing)
        call draw_cuts(sheet, cuts, greatest, is_split, drawing)
        do i = 1, size(bodies)
            call draw_lines(sheet, bodies(i), body_range(bodies(i:i)), drawing)
        end do
        call draw_block(sheet, heading, unit, drawing)
    end function lines_plan

    !> The corners of the room that lines and cuts take.
    pure subroutine find_corners(bodies, cuts, low, high)
        type(body_type), intent(in) :: bodies(:)    !! finished
        type(cut_type), intent(in) :: cuts(:)       !! of these bodies
        real(dp), intent(out) :: low(3)             !! least STA, BL and WL, deck units
        real(dp), intent(out) :: high(3)            !! greatest, deck units
        type(outline_type), allocatable :: outlines(:)
        real(dp), allocatable :: at(:, :)
        real(dp) :: range(2)
        integer :: i, k

        range = body_range(bodies)
        low = [range(1), 0.0_dp, huge(1.0_dp)]
        high = [range(2), 0.0_dp, -huge(1.0_dp)]
        do i = 1, size(bodies)
            do k = 1, size(bodies(i)%lines)
                associate (line => bodies(i)%lines(k))
                    if (line%has_side) call widen(chain_strokes(line%side, range), [1, 3], &
                        low, high)
                    if (line%has_plan) call widen(chain_strokes(line%plan, range), [1, 2], &
                        low, high)
                end associate
            end do
        end do
        do i = 1, size(cuts)
            call gather_outlines(cuts(i), outlines)
            do k = 1, size(outlines)
                at = outline_points(outlines(k))
                low = min(low, minval(at, dim=2))
                high = max(high, maxval(at, dim=2))
            end do
        end do
    end subroutine find_corners

    !> Widens the corners of a room to hold strokes of a view.
    pure subroutine widen(strokes, axes, low, high)
        type(stroke_type), intent(in) :: strokes(:) !! in two dimensions
        integer, intent(in) :: axes(2)              !! which of STA, BL, WL they are
        real(dp), intent(inout) :: low(3)           !! least STA, BL and WL, deck units
        real(dp), intent(inout) :: high(3)          !! greatest, deck units
        integer :: i
        do i = 1, size(strokes)
            low(axes) = min(low(axes), minval(strokes(i)%at, dim=2))
            high(axes) = max(high(axes), maxval(strokes(i)%at, dim=2))
        end do
    end subroutine widen

    !> Draws each cut in the view where it is curved.
    pure subroutine draw_cuts(sheet, cuts, greatest, is_split, drawing)
        type(sheet_type), intent(in) :: sheet           !! where the views stand
        type(cut_type), intent(in) :: cuts(:)           !! of the bodies
        real(dp), intent(in) :: greatest                !! station of the greatest section
        logical, intent(in) :: is_split                 !! sections aft of it go to port
        type(drawing_type), intent(inout) :: drawing    !! gets them
        type(outline_type), allocatable :: outlines(:)
        real(dp), allocatable :: at(:, :)
        integer :: i, k

        do i = 1, size(cuts)
            call gather_outlines(cuts(i), outlines)
            do k = 1, size(outlines)
                at = outline_points(outlines(k))
                select case (cuts(i)%plane%kind)
                case (cut_kind%station)
                    associate (sta => cuts(i)%plane%through(1))
                        if (sta <= greatest .or. .not. is_split) call draw_named('section', &
                            in_body_plan(sheet, at), mark_of(sta), drawing)
                        if (sta >= greatest .and. is_split) call draw_named('section', &
                            in_body_plan(sheet, mirror_in_plane(at)), mark_of(sta), drawing)
                    end associate
                case (cut_kind%buttock)
                    call draw_named('buttock', in_profile(at), &
                        'BL '//mark_of(cuts(i)%plane%through(2)), drawing)
                case (cut_kind%waterline)
                    call draw_named('waterline', in_plan(sheet, at), &
                        'WL '//mark_of(cuts(i)%plane%through(3)), drawing)
                end select
            end do
        end do
    end subroutine draw_cuts

    !> The station of the greatest section; the foremost of these.
    pure real(dp) function greatest_station(cuts) result(sta)
        type(cut_type), intent(in) :: cuts(:) !! of which stations count
        real(dp) :: area, greatest
        integer :: i

        sta = huge(1.0_dp)
        greatest = -1.0_dp
        do i = 1, size(cuts)
            if (cuts(i)%plane%kind /= cut_kind%station) cycle
            area = abs(swept_area(cuts(i)))
            if (area < greatest .or. (.not. area > greatest .and. &
                cuts(i)%plane%through(1) > sta)) cycle
            greatest = area
            sta = cuts(i)%plane%through(1)
        end do
    end function greatest_station

    !> Draws the control lines of a body in profile and plan.
    pure subroutine draw_lines(sheet, body, range, drawing)
        type(sheet_type), intent(in) :: sheet           !! where the views stand
        type(body_type), intent(in) :: body             !! finished
        real(dp), intent(in) :: range(2)                !! its stations, deck units
        type(drawing_type), intent(inout) :: drawing    !! gets them
        type(stroke_type), allocatable :: strokes(:)
        integer :: i, k

        do i = 1, size(body%lines)
            associate (line => body%lines(i))
                if (line%has_side) then
                    strokes = chain_strokes(line%side, range)
                    do k = 1, size(strokes)
                        call draw_named('line', strokes(k)%at, name_of(line, k, size(strokes)), &
                            drawing)
                    end do
                end if
                if (line%has_plan) then
                    strokes = chain_strokes(line%plan, range)
                    do k = 1, size(strokes)
                        strokes(k)%at(2, :) = strokes(k)%at(2, :) + sheet%plan_centre
                        call draw_named('line', strokes(k)%at, name_of(line, k, size(strokes)), &
                            drawing)
                    end do
                end if
            end associate
        end do
    end subroutine draw_lines

    !> The name of a line on the middle one of its arcs, nothing on the others.
    pure function name_of(line, arc, arcs) result(name)
        type(line_type), intent(in) :: line !! a control line
        integer, intent(in) :: arc          !! which of its arcs
        integer, intent(in) :: arcs         !! how many there are
        character(:), allocatable :: name
        name = ''
        if (arc == (arcs + 1)/2) name = trim(line%name)
    end function name_of

end module export_body_lines
