!> The block of words below a part: what it is, how many, which side is seen, what the lines mean,
!> how exact they are.
module export_pattern_block
    use base_constants, only: degrees
    use base_kinds, only: dp
    use base_text, only: to_text
    use cut_plane, only: cut_kind, flange_normal, plane_type
    use export_drawing, only: drawing_type, shape_kind, shape_type
    use export_pattern_grid, only: axis_name, families_of, family_type
    use export_pattern_number, only: ordinate, short
    use export_pattern_page, only: bounds_of, label_type
    use export_pattern_part, only: part_type
    use export_pattern_style, only: style
    use export_units, only: unit_type
    implicit none (type, external)
    private

    public :: draw_block

    !> Heights of type, and of a line of it in parts of the type; length of a line shown, and the
    !> gap behind it: in.
    real(dp), parameter :: title_height = 0.28_dp, heading_height = 0.17_dp, height = 0.12_dp, &
        line_height = 1.45_dp, sample = 0.6_dp, gap = 0.12_dp
    !> From the outline to the block, and from whatever else is drawn, in.
    real(dp), parameter :: below = 0.75_dp, clear = 0.15_dp
    !> Decimals of an error, in inches or millimetres: two figures more than can be measured.
    integer, parameter :: error_decimals = 6

contains

    !> Draws the block, below everything that the part has.
    pure subroutine draw_block(drawing, shape, unit, part)
        type(drawing_type), intent(in) :: drawing   !! deck, title, tolerance
        type(shape_type), intent(in) :: shape       !! as drawn, whole or half
        type(unit_type), intent(in) :: unit         !! of the drawing
        type(part_type), intent(inout) :: part      !! gets it
        real(dp) :: at(2), drawn(4)

        drawn = bounds_of(part%page)
        at = [part%box(1), min(part%box(2) - below, drawn(2) - clear)]
        call write_line(shape%title, title_height, .true., at, part)
        if (drawing%title /= '') call write_line(drawing%title, heading_height, .false., at, part)
        call write_line('DECK '//drawing%deck//'     ORDINATES IN '//trim(unit%name)// &
            '     QUANTITY '//to_text(shape%quantity), height, .false., at, part)
        call write_line('SEEN FROM '//seen_from(shape%plane)//flange_words(shape), height, &
            .false., at, part)
        if (shape%kind /= shape_kind%card) &
            call write_line(plane_words(shape%plane), height, .false., at, part)
        call write_line(step_words(shape, unit, part), height, .false., at, part)
        call write_legend(shape, unit, at, part)
        if (part%fold > 0) call write_line('HALF: THE OTHER SIDE OF THE CENTRE LINE IS ITS '// &
            'MIRROR IMAGE', height, .false., at, part)
        if (has_bevels(shape)) &
            call write_line('BEVELS IN DEGREES, + OPEN, - CLOSED', height, .false., at, part)
        call write_line('FULL SIZE. OUTLINE WITHIN '// &
            short(part%error/part%inch, error_decimals)//' '//trim(unit%short)// &
            ' OF THE LOFT, MEASURED', height, .false., at, part)
    end subroutine draw_block

    !> Writes a line and goes to the next one.
    pure subroutine write_line(words, type_height, is_bold, at, part)
        character(*), intent(in) :: words       !! any bytes
        real(dp), intent(in) :: type_height     !! in
        logical, intent(in) :: is_bold          !! heavy
        real(dp), intent(inout) :: at(2)        !! top of the line; then of the next
        type(part_type), intent(inout) :: part  !! gets it
        type(label_type) :: label

        label%text = words
        label%height = type_height
        label%is_bold = is_bold
        call part%page%write(style%words, at - [0.0_dp, type_height], label)
        at(2) = at(2) - line_height*type_height
    end subroutine write_line

    !> Shows the lines of the outside and the inside of the skin, and says which is which.
    pure subroutine write_legend(shape, unit, at, part)
        type(shape_type), intent(in) :: shape   !! has the thickness
        type(unit_type), intent(in) :: unit     !! of it
        real(dp), intent(inout) :: at(2)        !! top of the line; then of the next
        type(part_type), intent(inout) :: part  !! gets it

        call draw_sample(style%like_outline, at, part)
        if (shape%kind == shape_kind%card) then
            call write_beside('CURVE OF THE CARD', at, part)
        else
            call write_beside('OUTSIDE OF SKIN', at, part)
        end if
        if (.not. any(part%traces%is_inside)) return
        call draw_sample(style%like_inside, at, part)
        call write_beside('INSIDE OF SKIN, '//ordinate(shape%skin)//' '//trim(unit%short), at, part)
    end subroutine write_legend

    !> Draws a short line as tall as the words behind it.
    pure subroutine draw_sample(kind, at, part)
        integer, intent(in) :: kind             !! one of `style%...`
        real(dp), intent(in) :: at(2)           !! top of the line of words
        type(part_type), intent(inout) :: part  !! gets it
        real(dp) :: start(2)
        start = at - [0.0_dp, 0.64_dp*height]
        call part%page%draw(kind, reshape([start, start + [sample, 0.0_dp]], [2, 2]))
    end subroutine draw_sample

    !> Writes words behind a line that is shown.
    pure subroutine write_beside(words, at, part)
        character(*), intent(in) :: words       !! what it means
        real(dp), intent(inout) :: at(2)        !! top of the line; then of the next
        type(part_type), intent(inout) :: part  !! gets them

        at(1) = at(1) + sample + gap
        call write_line(words, height, .false., at, part)
        at(1) = at(1) - sample - gap
    end subroutine write_beside

    !> Where the eye is: u goes to the right, v up.
    pure function seen_from(plane) result(words)
        type(plane_type), intent(in) :: plane !! of the shape
        character(:), allocatable :: words
        words = side_of([plane%u(2)*plane%v(3) - plane%u(3)*plane%v(2), &
            plane%u(3)*plane%v(1) - plane%u(1)*plane%v(3), &
            plane%u(1)*plane%v(2) - plane%u(2)*plane%v(1)])
    end function seen_from

    !> The side that a direction points to most.
    pure function side_of(direction) result(words)
        real(dp), intent(in) :: direction(3) !! along STA, BL, WL
        character(:), allocatable :: words
        integer :: axis
        character(9), parameter :: sides(2, 3) = reshape([character(9) :: 'AFT', 'FORWARD', &
            'STARBOARD', 'PORT', 'ABOVE', 'BELOW'], [2, 3])
        axis = maxloc(abs(direction), dim=1)
        words = trim(sides(merge(1, 2, direction(axis) > 0.0_dp), axis))
    end function side_of

    !> On which side the flange is; nothing for what has none.
    pure function flange_words(shape) result(words)
        type(shape_type), intent(in) :: shape !! any
        character(:), allocatable :: words
        words = ''
        if (shape%kind == shape_kind%card .or. shape%kind == shape_kind%line) return
        words = '     FLANGE '//side_of(flange_normal(shape%plane, shape%is_flange_forward))
    end function flange_words

    !> Where the plane is.
    pure function plane_words(plane) result(words)
        type(plane_type), intent(in) :: plane !! of the shape
        character(:), allocatable :: words

        associate (at => plane%origin, n => plane%normal)
            select case (plane%kind)
            case (cut_kind%station)
                words = 'PLANE OF STA '//ordinate(at(1))
            case (cut_kind%buttock)
                words = 'PLANE OF BL '//ordinate(at(2))
            case (cut_kind%waterline)
                words = 'PLANE OF WL '//ordinate(at(3))
            case (cut_kind%oblique)
                words = 'PLANE THROUGH STA '//ordinate(at(1))//' AT WL '//ordinate(at(3))// &
                    ', LEANING '//short(degrees*abs(atan2(plane%v(1), plane%v(3))), 3)// &
                    ' DEGREES '//trim(merge('AFT    ', 'FORWARD', plane%v(1) > 0.0_dp))
            case default
                words = 'PLANE THROUGH STA '//ordinate(at(1))//' BL '//ordinate(at(2))//' WL '// &
                    ordinate(at(3))//', NORMAL '//ordinate(n(1))//' '//ordinate(n(2))//' '// &
                    ordinate(n(3))
            end select
        end associate
    end function plane_words

    !> How far the reference lines are apart.
    pure function step_words(shape, unit, part) result(words)
        type(shape_type), intent(in) :: shape   !! its plane
        type(unit_type), intent(in) :: unit     !! of the steps
        type(part_type), intent(in) :: part     !! with its outlines
        character(:), allocatable :: words
        type(family_type) :: families(2)
        integer :: k

        families = families_of(shape%plane, shape%kind, part)
        words = 'LINES'
        do k = 1, 2
            if (k == 2) words = words//','
            words = words//' '//axis_name(families(k))//' EVERY '//ordinate(families(k)%step)// &
                ' '//trim(unit%short)
        end do
    end function step_words

    !> True where bevels are marked.
    pure logical function has_bevels(shape) result(has)
        type(shape_type), intent(in) :: shape !! any
        integer :: i
        has = .false.
        do i = 1, size(shape%contours)
            if (allocated(shape%contours(i)%marks)) has = has .or. &
                size(shape%contours(i)%marks) > 0
        end do
    end function has_bevels

end module export_pattern_block
