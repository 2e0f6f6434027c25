!> One cut in its true shape: outlines with their points, the skin's inside, the port half where it
!> is the image of the starboard half, the centre line, and what plane it is.
module export_body_cut
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_text, only: to_text
    use cut_outline, only: cut_type, outline_type
    use cut_plane, only: cut_kind, plane_type
    use export_body_curves, only: gather_outlines, mirror_in_plane, on_paper, outline_points
    use export_body_drawing, only: drawing_type, mark_of, word_side
    implicit none (type, external)
    private

    public :: cut_drawing, plane_words, kind_word

    !> Dots of the longer side of the box between the axes; from a point to its number.
    real(dp), parameter :: box = 660.0_dp, beside = 14.0_dp
    !> Room around the outlines, in parts of their span; least share of a side of the box.
    real(dp), parameter :: margin = 0.07_dp, slimmest = 0.3_dp

contains

    !> The picture of a cut; without layers where the plane misses the body.
    pure type(drawing_type) function cut_drawing(cut, shape, number, is_symmetric, heading, unit) &
        result(drawing)
        type(cut_type), intent(in) :: cut           !! the cut, with the points asked for
        type(cut_type), intent(in) :: shape         !! the same, points closer than the eye tells
        integer, intent(in) :: number               !! of the cut in its deck
        logical, intent(in) :: is_symmetric         !! the body is
        character(*), intent(in) :: heading         !! title of the deck
        character(*), intent(in) :: unit            !! name of its unit
        type(outline_type), allocatable :: outlines(:)
        real(dp) :: low(2), high(2)
        logical :: is_mirrored

        drawing%script = 'chart'
        drawing%heading = heading
        drawing%view = 'Cut '//to_text(number)//': '//plane_words(cut)
        call name_axes(cut%plane, unit, drawing)
        is_mirrored = is_symmetric .and. is_zero(cut%plane%normal(2))
        call gather_outlines(shape, outlines)
        call find_box(shape, outlines, is_mirrored, low, high)
        if (low(1) > high(1)) return
        call set_box(low, high, drawing)
        call draw_centre_line(cut%plane, drawing)
        if (is_mirrored) call draw_outlines(shape, shape%inside, 'mirror', .true., drawing)
        if (is_mirrored) call draw_outlines(shape, outlines, 'mirror', .true., drawing)
        call draw_outlines(shape, shape%inside, 'inside', .false., drawing)
        call draw_outlines(shape, outlines, 'outline', .false., drawing)
        call draw_points(cut, drawing)
    end function cut_drawing

    !> A cut in words: its kind, its plane, its name.
    pure function plane_words(cut) result(text)
        type(cut_type), intent(in) :: cut !! the cut
        character(:), allocatable :: text

        associate (plane => cut%plane)
            select case (plane%kind)
            case (cut_kind%station)
                text = 'station '//mark_of(plane%through(1))
            case (cut_kind%buttock)
                text = 'butt line '//mark_of(plane%through(2))
            case (cut_kind%waterline)
                text = 'waterline '//mark_of(plane%through(3))
            case default
                text = kind_word(plane%kind)//' through ('//triple(plane%through)//'), normal ('// &
                    triple(plane%normal/norm2(plane%normal))//')'
            end select
        end associate
        if (cut%name /= '') text = trim(cut%name)//', '//text
    end function plane_words

    !> A kind of cut in a word.
    pure function kind_word(kind) result(word)
        integer, intent(in) :: kind !! one of `cut_kind%...`
        character(:), allocatable :: word
        character(9), parameter :: words(5) = [character(9) :: 'station', 'buttock', 'waterline', &
            'oblique', 'plane']
        word = trim(words(kind))
    end function kind_word

    !> Three numbers to four decimals.
    pure function triple(values) result(text)
        real(dp), intent(in) :: values(3) !! finite numbers
        character(:), allocatable :: text
        real(dp), parameter :: decimals = 1.0e4_dp
        real(dp) :: rounded(3)
        rounded = anint(values*decimals)/decimals
        text = mark_of(rounded(1))//', '//mark_of(rounded(2))//', '//mark_of(rounded(3))
    end function triple

    !> Names the axes: by their coordinate where they are along one, else u and v; the note then
    !> says where these are.
    pure subroutine name_axes(plane, unit, drawing)
        type(plane_type), intent(in) :: plane           !! of the cut
        character(*), intent(in) :: unit                !! name of the unit
        type(drawing_type), intent(inout) :: drawing    !! gets the names

        drawing%note = ''
        drawing%x_axis = axis_name('u', plane%u, plane%origin)//', '//unit
        drawing%y_axis = axis_name('v', plane%v, plane%origin)//', '//unit
        if (plane%kind <= cut_kind%waterline) return
        drawing%note = 'u along ('//triple(plane%u)//'), v along ('//triple(plane%v)// &
            ') from STA, BL, WL '//triple(plane%origin)
    end subroutine name_axes

    !> The name of an axis.
    pure function axis_name(letter, direction, origin) result(name)
        character, intent(in) :: letter         !! u or v
        real(dp), intent(in) :: direction(3)    !! unit vector along STA, BL, WL
        real(dp), intent(in) :: origin(3)       !! where it is zero: STA, BL, WL, deck units
        character(:), allocatable :: name
        character(*), parameter :: names(3) = [character(14) :: 'station (STA)', 'butt line (BL)', &
            'waterline (WL)']
        integer :: i

        name = letter
        do i = 1, 3
            if (is_zero(direction(i) - 1.0_dp) .and. is_zero(origin(i))) name = trim(names(i))
        end do
    end function axis_name

    !> The corners of what is drawn.
    pure subroutine find_box(cut, outlines, is_mirrored, low, high)
        type(cut_type), intent(in) :: cut               !! the cut
        type(outline_type), intent(in) :: outlines(:)   !! all it has
        logical, intent(in) :: is_mirrored              !! the port half is drawn
        real(dp), intent(out) :: low(2)                 !! deck units; above `high`: nothing there
        real(dp), intent(out) :: high(2)                !! deck units
        real(dp), allocatable :: at(:, :), uv(:, :)
        integer :: i

        low = huge(1.0_dp)
        high = -huge(1.0_dp)
        do i = 1, size(outlines)
            if (size(outlines(i)%points) == 0) cycle
            at = outline_points(outlines(i))
            uv = on_paper(cut, at)
            low = min(low, minval(uv, dim=2))
            high = max(high, maxval(uv, dim=2))
            if (.not. is_mirrored) cycle
            uv = on_paper(cut, mirror_in_plane(at))
            low = min(low, minval(uv, dim=2))
            high = max(high, maxval(uv, dim=2))
        end do
    end subroutine find_box

    !> Sets the edges of the drawing around its corners.
    pure subroutine set_box(low, high, drawing)
        real(dp), intent(in) :: low(2)                  !! deck units
        real(dp), intent(in) :: high(2)                 !! deck units
        type(drawing_type), intent(inout) :: drawing    !! gets edges and scale
        real(dp) :: half(2), middle(2)

        middle = 0.5_dp*(low + high)
        half = 0.5_dp*(high - low) + margin*maxval(high - low)
        if (.not. maxval(half) > 0.0_dp) half = 0.5_dp
        half = max(half, slimmest*maxval(half))
        drawing%low = middle - half
        drawing%high = middle + half
        drawing%dot = 2.0_dp*maxval(half)/box
    end subroutine set_box

    !> Draws the line of BL 0 through the box, where the plane has one.
    pure subroutine draw_centre_line(plane, drawing)
        type(plane_type), intent(in) :: plane           !! of the cut
        type(drawing_type), intent(inout) :: drawing    !! with its edges
        real(dp) :: across(2), foot(2), along(2), near, far
        integer :: i

        across = [plane%u(2), plane%v(2)]
        if (all(is_zero(across))) return
        foot = 0.5_dp*(drawing%low + drawing%high)
        foot = foot - across*(plane%origin(2) + dot_product(across, foot))/sum(across**2)
        along = [-across(2), across(1)]
        near = -huge(1.0_dp)
        far = huge(1.0_dp)
        do i = 1, 2
            if (is_zero(along(i))) then
                if (foot(i) < drawing%low(i) .or. foot(i) > drawing%high(i)) return
            else
                near = max(near, min((drawing%low(i) - foot(i))/along(i), &
                    (drawing%high(i) - foot(i))/along(i)))
                far = min(far, max((drawing%low(i) - foot(i))/along(i), &
                    (drawing%high(i) - foot(i))/along(i)))
            end if
        end do
        if (near < far) call drawing%draw('centre', reshape([foot + near*along, foot + far*along], &
            [2, 2]))
    end subroutine draw_centre_line

    !> Draws outlines, or their images in BL 0.
    pure subroutine draw_outlines(cut, outlines, style, is_mirrored, drawing)
        type(cut_type), intent(in) :: cut               !! with its plane
        type(outline_type), intent(in) :: outlines(:)   !! outside or inside
        character(*), intent(in) :: style               !! of the lines
        logical, intent(in) :: is_mirrored              !! draw the images
        type(drawing_type), intent(inout) :: drawing    !! gets them
        real(dp), allocatable :: at(:, :)
        integer :: i

        do i = 1, size(outlines)
            if (size(outlines(i)%points) == 0) cycle
            at = outline_points(outlines(i))
            if (is_mirrored) at = mirror_in_plane(at)
            call drawing%draw(style, on_paper(cut, at))
        end do
    end subroutine draw_outlines

    !> Draws the points, and the numbers of the first and the last of each outline.
    pure subroutine draw_points(cut, drawing)
        type(cut_type), intent(in) :: cut               !! the cut
        type(drawing_type), intent(inout) :: drawing    !! gets them
        type(outline_type), allocatable :: outlines(:)
        integer :: i, k, number, count

        number = 0
        allocate (outlines(0))
        call gather_outlines(cut, outlines)
        do i = 1, size(outlines)
            count = size(outlines(i)%points)
            do k = 1, count
                number = number + 1
                associate (uv => outlines(i)%points(k)%uv)
                    call drawing%draw('point', reshape(uv, [2, 1]))
                    if (k > 1 .and. k < count) cycle
                    call drawing%write_where_free(to_text(number), &
                        places_around(uv, drawing%dot(1)), word_side%middle)
                end associate
            end do
        end do
    end subroutine draw_points

    !> Places around a point for its number.
    pure function places_around(uv, dot) result(places)
        real(dp), intent(in) :: uv(2)   !! the point
        real(dp), intent(in) :: dot     !! deck units a dot
        real(dp) :: places(2, 4)
        real(dp), parameter :: ways(2, 4) = reshape([1.0_dp, 1.0_dp, 1.0_dp, -1.0_dp, -1.0_dp, &
            1.0_dp, -1.0_dp, -1.0_dp], [2, 4])
        integer :: i
        do i = 1, 4
            places(:, i) = uv + beside*dot*ways(:, i)
        end do
    end function places_around

end module export_body_cut
