!> What is marked on a part: bevels along its outline, reference lines with their names, the centre
!> line with its symbol, and the part's name.
module export_pattern_marks
    use base_kinds, only: dp
    use export_drawing, only: mark_type, shape_type
    use export_pattern_grid, only: chords_of, families_of, family_type, name_of
    use export_pattern_number, only: bevel_text
    use export_pattern_page, only: label_corners, label_type, side
    use export_pattern_part, only: is_inside_outline, part_type
    use export_pattern_style, only: style
    implicit none (type, external)
    private

    public :: line_type, draw_lines, draw_bevels, name_lines, draw_name

    !> Lengths on paper, in: of a bevel's tick, inwards; from its end to the degrees; from a line to
    !> its name; from the outline to the name; how far a line goes beyond the outline, and the
    !> centre line; from one place tried to the next.
    real(dp), parameter :: tick = 0.2_dp, gap = 0.05_dp, above = 0.05_dp, inset = 0.3_dp, &
        beyond = 0.15_dp, centre_beyond = 0.6_dp, stride = 0.3_dp
    !> Heights of type, in.
    real(dp), parameter :: small = 0.11_dp, symbol = 0.24_dp, heading = 0.22_dp
    !> Of capitals, in parts of the height of the type; half of it is above the middle.
    real(dp), parameter :: capital = 0.718_dp
    !> How far degrees may stand beside their tick, in heights of type.
    real(dp), parameter :: asides(3) = [0.0_dp, 0.8_dp, -0.8_dp]
    !> Places tried for a name on each side of the middle of a line.
    integer, parameter :: most_places = 40

    !> Lines of a part.
    type :: line_type
        character(:), allocatable :: name       !! `WL 5`
        real(dp) :: along(2) = 0.0_dp           !! unit vector
        real(dp) :: foot(2) = 0.0_dp            !! its point 0, in
        real(dp), allocatable :: chords(:, :)   !! from and to by columns, in
    end type line_type

contains

    !> Draws the bevels of a shape: a tick inwards and the degrees, positive where the flange is
    !> open.
    pure subroutine draw_bevels(shape, part)
        type(shape_type), intent(in) :: shape   !! has the marks
        type(part_type), intent(inout) :: part  !! gets them
        integer :: i, k

        do i = 1, size(shape%contours)
            if (.not. allocated(shape%contours(i)%marks)) cycle
            do k = 1, size(shape%contours(i)%marks)
                call draw_bevel(shape%contours(i)%marks(k), part)
            end do
        end do
    end subroutine draw_bevels

    !> Draws a bevel; without figures where they have no room.
    pure subroutine draw_bevel(mark, part)
        type(mark_type), intent(in) :: mark     !! the bevel
        type(part_type), intent(inout) :: part  !! gets it
        type(label_type) :: label
        real(dp) :: at(2), line(2, 2), down(2)
        integer :: i, k

        label%text = bevel_text(mark%bevel)//char(194)//char(176)
        label%height = small
        label%along = -mark%outward
        label%side = side%right
        if (label%along(1) < 0.0_dp) then
            label%along = -label%along
            label%side = side%left
        end if
        down = [label%along(2), -label%along(1)]
        line(:, 1) = part%inch*mark%uv
        line(:, 2) = line(:, 1) - tick*mark%outward
        call part%page%draw(style%bevel, line)
        call part%room%take_line(line)
        do i = 0, 1
            do k = 1, size(asides)
                at = line(:, 2) - (gap + 0.5_dp*stride*real(i, dp))*mark%outward + &
                    (0.5_dp*capital + asides(k))*small*down
                if (.not. part%room%is_free(at, label)) cycle
                call put_words(style%bevel_words, at, label, part)
                return
            end do
        end do
    end subroutine draw_bevel

    !> Draws the reference lines.
    pure subroutine draw_lines(shape, part, lines)
        type(shape_type), intent(in) :: shape                   !! its plane
        type(part_type), intent(inout) :: part                  !! gets them
        type(line_type), allocatable, intent(out) :: lines(:)   !! what was drawn
        type(family_type) :: families(2)
        integer :: i, k, count

        families = families_of(shape%plane, shape%kind, part)
        allocate (lines(sum(families%last - families%first + 1)))
        count = 0
        do k = 1, 2
            do i = families(k)%first, families(k)%last
                count = count + 1
                associate (line => lines(count))
                    line%name = name_of(families(k), i)
                    call chords_of(part, families(k), i, line%along, line%foot, line%chords)
                    if (i == 0 .and. families(k)%axis == 2) then
                        line%name = ''
                        if (part%fold > 0) line%name = 'FOLD ON CENTRE LINE'
                        call draw_centre(line, part)
                    else
                        call draw_chords(line, part)
                    end if
                end associate
            end do
        end do
    end subroutine draw_lines

    !> Writes the names of lines where they hide nothing.
    pure subroutine name_lines(lines, part)
        type(line_type), intent(in) :: lines(:)     !! from `draw_lines`
        type(part_type), intent(inout) :: part      !! gets them
        integer :: i

        do i = 1, size(lines)
            if (lines(i)%name /= '') call write_names(lines(i), part)
        end do
    end subroutine name_lines

    !> Draws a line on each stretch, a little beyond the outline.
    pure subroutine draw_chords(line, part)
        type(line_type), intent(in) :: line     !! the line
        type(part_type), intent(inout) :: part  !! gets it
        real(dp) :: ends(2, 2)
        integer :: i

        do i = 1, size(line%chords, 2)
            ends(:, 1) = line%foot + (line%chords(1, i) - beyond)*line%along
            ends(:, 2) = line%foot + (line%chords(2, i) + beyond)*line%along
            call part%page%draw(style%line, ends)
            call part%room%take_line(ends)
        end do
    end subroutine draw_chords

    !> Draws the centre line across all of the part, with its symbol, a C and an L in one.
    pure subroutine draw_centre(line, part)
        type(line_type), intent(inout) :: line  !! the line; gets what is drawn as its chord
        type(part_type), intent(inout) :: part  !! gets it
        type(label_type) :: letter
        real(dp) :: ends(2, 2), at(2), reach(2)

        reach = [dot_product(line%along, part%box(:2) - line%foot), &
            dot_product(line%along, part%box(3:) - line%foot)]
        line%chords = reshape([minval(reach), maxval(reach)], [2, 1])
        ends(:, 1) = line%foot + (line%chords(1, 1) - centre_beyond)*line%along
        ends(:, 2) = line%foot + (line%chords(2, 1) + centre_beyond)*line%along
        call part%page%draw(merge(style%fold, style%centre, part%fold > 0), ends)
        call part%room%take_line(ends)
        letter%height = symbol
        letter%side = side%middle
        letter%text = 'C'
        at = ends(:, 2) + 0.55_dp*symbol*line%along - [0.0_dp, 0.3_dp*symbol]
        call put_words(style%words, at, letter, part)
        letter%text = 'L'
        at = at + symbol*[0.16_dp, -0.26_dp]
        call put_words(style%words, at, letter, part)
    end subroutine draw_centre

    !> Writes the name of a line at both ends of each stretch, inside of the outline; where there is
    !> no room, beyond its end.
    pure subroutine write_names(line, part)
        type(line_type), intent(in) :: line     !! the line
        type(part_type), intent(inout) :: part  !! gets them
        type(label_type) :: label
        real(dp) :: length
        logical :: is_written
        integer :: i

        label%text = line%name
        label%height = small
        label%along = line%along
        do i = 1, size(line%chords, 2)
            length = line%chords(2, i) - line%chords(1, i)
            label%side = side%right
            call write_near(line, line%chords(1, i), 0.5_dp*length, label, part, is_written)
            label%side = side%left
            if (is_written .and. length < 4.0_dp) cycle
            call write_near(line, line%chords(2, i), -0.5_dp*length, label, part, is_written)
        end do
    end subroutine write_names

    !> Writes a name on a line near an end, nearer than half-way to the other; else beyond it.
    pure subroutine write_near(line, end, half, label, part, is_written)
        type(line_type), intent(in) :: line         !! the line
        real(dp), intent(in) :: end                 !! where along it the end is, in
        real(dp), intent(in) :: half                !! half-way to the other end, in
        type(label_type), intent(in) :: label       !! the name, on its side of the place
        type(part_type), intent(inout) :: part      !! gets it
        logical, intent(out) :: is_written          !! it has a place
        type(label_type) :: moved
        real(dp) :: at(2), from, up(2)
        integer :: i

        up = [-line%along(2), line%along(1)]
        is_written = .true.
        moved = label
        do i = 0, most_places
            from = inset + stride*real(i, dp)
            if (from > abs(half)) exit
            at = line%foot + (end + sign(from, half))*line%along + above*up
            if (.not. part%room%is_free(at, moved)) cycle
            call put_words(style%line_words, at, moved, part)
            return
        end do
        moved%side = side%left - label%side
        at = line%foot + (end - sign(beyond + gap, half))*line%along - 0.5_dp*capital*small*up
        is_written = part%room%is_free(at, moved)
        if (.not. is_written) return
        call put_words(style%line_words, at, moved, part)
    end subroutine write_near

    !> Writes words of a part; their room is taken then.
    pure subroutine put_words(kind, at, label, part)
        integer, intent(in) :: kind             !! one of `style%...`
        real(dp), intent(in) :: at(2)           !! where they stand, in
        type(label_type), intent(in) :: label   !! what
        type(part_type), intent(inout) :: part  !! gets them
        call part%page%write(kind, at, label)
        call part%room%take_label(at, label)
    end subroutine put_words

    !> Writes a part's name on it, so that it is still there when the paper is cut; nowhere where it
    !> has no room.
    pure subroutine draw_name(words, part)
        character(*), intent(in) :: words       !! the name
        type(part_type), intent(inout) :: part  !! gets it
        type(label_type) :: label
        real(dp) :: at(2), corners(2, 4)
        integer :: i, j, k
        integer, parameter :: tries = 9
        real(dp), parameter :: order(tries) = [0.5_dp, 0.45_dp, 0.55_dp, 0.4_dp, 0.6_dp, 0.3_dp, &
            0.7_dp, 0.2_dp, 0.8_dp]

        if (.not. part%is_region) return
        label%text = words
        label%side = side%middle
        do k = 1, 2
            label%height = heading/real(k, dp)
            do i = 1, tries
                do j = 1, tries
                    at = part%box(:2) + [order(j), order(i)]*(part%box(3:) - part%box(:2))
                    corners = label_corners(at, label)
                    if (.not. is_inside_outline(part, corners(:, 1))) cycle
                    if (.not. part%room%is_free(at, label)) cycle
                    call put_words(style%words, at, label, part)
                    return
                end do
            end do
        end do
    end subroutine draw_name

end module export_pattern_marks
