!> The cut of the inside of the skin: of every point of an outline that of the inside which is
!> opposite to it, across the outline in the plane of the cut.
module cut_inside
    use base_exact, only: is_equal, is_zero
    use base_kinds, only: dp, i64
    use base_text, only: compact, counted
    use body_body, only: body_type
    use body_offset, only: foot_at, foot_type, parallel_curvature, steepest_curvature, way_inside
    use body_skin, only: skin_at, skin_type
    use cut_inside_corner, only: find_corner, image_of, is_corner
    use cut_note, only: add_note
    use cut_outline, only: cut_point_type, cut_type, note_type, outline_type
    use cut_plane, only: cut_kind, height_over, in_view, true_shape
    use cut_point, only: give_bevel, left_of
    use geom_arc_point, only: slope_along
    use geom_place, only: is_finish, is_start, place_type
    use geom_space, only: across
    use geom_zeros, only: function_type, zeros_of
    implicit none (type, external)
    private

    public :: inside_outlines

    !> Sine of the angle between plane and skin below which the skin is not passed through.
    real(dp), parameter :: grazing = 1.0e-6_dp

    !> What is lost of an outline, for its note.
    type :: loss_type
        integer(i64) :: sharp = 0           !! points where t reaches a radius of curvature
        real(dp) :: radius = huge(1.0_dp)   !! the least such radius, deck units
        real(dp) :: at(3) = 0.0_dp          !! where: STA, BL, WL
        integer(i64) :: beyond = 0          !! points opposite to which the skin has no inside
    end type loss_type

    !> An edge of a section and the inside opposite to it, over STA.
    type, extends(function_type) :: rim_type
        type(body_type) :: body         !! finished, both halves
        type(cut_type) :: cut           !! plane and thickness
        integer :: section = 0          !! which of its sections
        type(place_type) :: place       !! its start or its finish
    contains
        procedure :: at => rim_at
    end type rim_type

    !> How far along STA the end of the inside is looked for, in thicknesses.
    real(dp), parameter :: reach = 8.0_dp

contains

    !> The inside of outlines. Where a point of it does not exist it is left out, and a note says
    !> why; an outline that loses points is no longer closed.
    pure subroutine inside_outlines(body, cut)
        type(body_type), intent(in) :: body     !! finished, both halves
        type(cut_type), intent(inout) :: cut    !! has outlines and thickness; gets inside and notes
        type(loss_type) :: loss
        integer :: i

        deallocate (cut%inside)
        allocate (cut%inside(size(cut%outlines)))
        do i = 1, size(cut%outlines)
            loss = loss_type()
            call inside_of(body, cut, cut%outlines(i), cut%inside(i), loss)
            call tell(cut%skin, loss, cut%notes)
        end do
    end subroutine inside_outlines

    !> The inside of one outline.
    pure subroutine inside_of(body, cut, outline, inside, loss)
        type(body_type), intent(in) :: body             !! finished, both halves
        type(cut_type), intent(in) :: cut               !! plane, flange, thickness
        type(outline_type), intent(in) :: outline       !! of the outside
        type(outline_type), intent(out) :: inside       !! see above
        type(loss_type), intent(inout) :: loss          !! what is left out
        logical, allocatable :: is_found(:)
        integer :: i

        allocate (inside%pieces(0), is_found(size(outline%points)))
        inside%points = outline%points
        is_found = .false.
        do i = 1, size(is_found)
            if (.not. is_found(i)) call take_corner(body, cut, outline, i, inside, is_found)
            if (is_found(i)) cycle
            call pass_through(body, cut, ahead_at(outline, i), inside%points(i), is_found(i), loss)
        end do
        if (.not. all(is_found)) inside%points = pack(inside%points, is_found)
        inside%is_closed = outline%is_closed .and. size(inside%points) == size(outline%points)
    end subroutine inside_of

    !> Takes a corner of the outside, and the point behind it, to the inside: two sections that
    !> meet, or one that meets its mirror image in an end of the outline.
    pure subroutine take_corner(body, cut, outline, i, inside, is_found)
        type(body_type), intent(in) :: body             !! finished, both halves
        type(cut_type), intent(in) :: cut               !! plane, flange, thickness
        type(outline_type), intent(in) :: outline       !! of the outside
        integer, intent(in) :: i                        !! which of its points
        type(outline_type), intent(inout) :: inside     !! gets the points
        logical, intent(inout) :: is_found(:)           !! set where there is a corner
        type(cut_point_type) :: pair(2)
        type(foot_type) :: feet(2)
        integer :: last, before, k
        logical :: is_there

        last = min(i + 1, size(is_found))
        before = max(i - 1, 1)
        pair = [outline%points(i), outline%points(last)]
        if (i == 1) before = last
        if (i == 1 .or. i == size(is_found)) then
            if (outline%is_closed .or. abs(cut%plane%normal(2)) > 0.0_dp) return
            pair(2) = image_of(body, pair(1))
            last = i
        end if
        if (.not. is_corner(pair, cut%plane, pair(1)%at - outline%points(before)%at)) return
        call find_corner(body, cut%plane, cut%skin, pair, feet, is_there)
        if (.not. is_there) return
        do k = i, last
            call describe(cut, ahead_at(outline, k), feet(k - i + 1), inside%points(k))
            if (last == i) inside%points(k)%at(2) = 0.0_dp
            if (last == i) inside%points(k)%uv = true_shape(cut%plane, inside%points(k)%at)
            is_found(k) = .true.
        end do
    end subroutine take_corner

    !> About which way an outline goes at one of its points, in its view.
    pure function ahead_at(outline, i) result(ahead)
        type(outline_type), intent(in) :: outline   !! of two points or more
        integer, intent(in) :: i                    !! which of its points
        real(dp) :: ahead(2)
        integer :: before, after

        before = max(1, i - 1)
        after = min(size(outline%points), i + 1)
        if (all(is_equal(outline%points(i)%at, outline%points(after)%at))) &
            after = min(size(outline%points), after + 1)
        if (all(is_equal(outline%points(i)%at, outline%points(before)%at))) &
            before = max(1, before - 1)
        ahead = outline%points(after)%uv - outline%points(before)%uv
    end function ahead_at

    !> Takes a point of the outside to the inside.
    pure subroutine pass_through(body, cut, ahead, point, is_found, loss)
        type(body_type), intent(in) :: body             !! finished, both halves
        type(cut_type), intent(in) :: cut               !! plane, flange, thickness
        real(dp), intent(in) :: ahead(2)                !! about which way the outline goes
        type(cut_point_type), intent(inout) :: point    !! of the outside; then of the inside
        logical, intent(out) :: is_found                !! it has a point opposite
        type(loss_type), intent(inout) :: loss          !! gets what is left out
        type(foot_type) :: foot
        real(dp) :: n(3), way(3)

        n = cut%plane%normal/norm2(cut%plane%normal)
        way = dot_product(point%normal, n)*n - point%normal
        is_found = point%has_normal .and. norm2(way) > grazing
        if (is_found) then
            way = way/norm2(way)
            call foot_at(body, point%section, point%at, point%normal, foot, is_found)
            if (.not. is_found) then
                call step_in(cut, n, point, is_found)
                if (is_found) return
            else
                call way_inside(body, cut%skin, way, foot, is_found)
                if (is_found) call describe(cut, ahead, foot, point)
            end if
        end if
        if (is_found .or. .not. point%has_normal) return
        call end_on_edge(body, cut, ahead, point, is_found)
        if (.not. is_found) call lose(cut%skin, foot, point, loss)
    end subroutine pass_through

    !> Where the skin ends at an edge of its section, its inside ends opposite to another point of
    !> that edge: the nearest whose inside is in the plane.
    pure subroutine end_on_edge(body, cut, ahead, point, is_found)
        type(body_type), intent(in) :: body             !! finished, both halves
        type(cut_type), intent(in) :: cut               !! plane, flange, thickness
        real(dp), intent(in) :: ahead(2)                !! about which way the outline goes
        type(cut_point_type), intent(inout) :: point    !! of the outside; then of the inside
        logical, intent(out) :: is_found                !! there is such a point
        type(rim_type) :: rim
        type(skin_type) :: skin
        type(foot_type) :: foot
        real(dp), allocatable :: sta(:)
        real(dp) :: near

        is_found = is_start(point%place) .or. is_finish(point%place)
        if (.not. is_found) return
        rim = rim_type(body, cut, point%section, point%place)
        allocate (sta(0))
        near = point%at(1)
        associate (section => body%sections(point%section))
            sta = zeros_of(rim, max(section%from, near - reach*cut%skin), &
                min(section%to, near + reach*cut%skin), 0.0_dp)
        end associate
        is_found = size(sta) > 0
        if (.not. is_found) return
        near = sta(minloc(abs(sta - near), dim=1))
        skin = skin_at(body%lines, body%sections(point%section), near, point%place)
        call foot_at(body, point%section, skin%at, skin%normal, foot, is_found)
        if (is_found) is_found = cut%skin*steepest_curvature(foot) < 1.0_dp
        if (is_found) call describe(cut, ahead, foot, point)
    end subroutine end_on_edge

    !> The height over the plane of the inside opposite to an edge, at a station.
    pure real(dp) function rim_at(f, x) result(height)
        class(rim_type), intent(in) :: f    !! edge and plane
        real(dp), intent(in) :: x           !! station, deck units
        type(skin_type) :: skin

        skin = skin_at(f%body%lines, f%body%sections(f%section), x, f%place)
        height = height_over(f%cut%plane, skin%at - f%cut%skin*skin%normal)
    end function rim_at

    !> Where the skin is not smooth but has a normal in the plane, as at a round nose on its axis.
    pure subroutine step_in(cut, n, point, is_found)
        type(cut_type), intent(in) :: cut               !! plane and thickness
        real(dp), intent(in) :: n(3)                    !! unit normal of the plane
        type(cut_point_type), intent(inout) :: point    !! of the outside; then of the inside
        logical, intent(out) :: is_found                !! the normal is in the plane

        is_found = is_zero(dot_product(point%normal, n))
        if (.not. is_found) return
        point%at = point%at - cut%skin*point%normal
        point%uv = true_shape(cut%plane, point%at)
        point%has_curvature = .false.
        point%curvature = 0.0_dp
    end subroutine step_in

    !> Says all that is said of a point of the inside.
    pure subroutine describe(cut, ahead, foot, point)
        type(cut_type), intent(in) :: cut               !! plane, flange, thickness
        real(dp), intent(in) :: ahead(2)                !! about which way the outline goes
        type(foot_type), intent(in) :: foot             !! Q
        type(cut_point_type), intent(inout) :: point    !! gets it
        real(dp) :: way(3), left(3)

        point%at = foot%at - cut%skin*foot%normal
        if (cut%plane%kind == cut_kind%station) point%at(1) = cut%plane%through(1)
        if (cut%plane%kind == cut_kind%buttock) point%at(2) = cut%plane%through(2)
        if (cut%plane%kind == cut_kind%waterline) point%at(3) = cut%plane%through(3)
        point%uv = true_shape(cut%plane, point%at)
        point%section = foot%section
        call give_bevel(foot%normal, cut%plane, cut%is_flange_forward, point)
        way = across(foot%normal, cut%plane%normal)
        point%has_slope = any(.not. is_zero(way))
        point%has_curvature = point%has_slope
        if (.not. point%has_slope) return
        way = way/norm2(way)
        if (dot_product(in_view(cut%plane, way), ahead) < 0.0_dp) way = -way
        point%slope = slope_along(in_view(cut%plane, way))
        left = left_of(cut%plane, way)
        point%curvature = -parallel_curvature(foot, cut%skin, way)/dot_product(foot%normal, left)
    end subroutine describe

    !> Counts a point of the outside that has none opposite.
    pure subroutine lose(thickness, foot, point, loss)
        real(dp), intent(in) :: thickness           !! deck units
        type(foot_type), intent(in) :: foot         !! at the point, where its section is known
        type(cut_point_type), intent(in) :: point   !! the point
        type(loss_type), intent(inout) :: loss      !! counts it
        real(dp) :: steepest

        steepest = 0.0_dp
        if (foot%section > 0) steepest = steepest_curvature(foot)
        if (thickness*steepest >= 1.0_dp) then
            loss%sharp = loss%sharp + 1
            if (1.0_dp/steepest < loss%radius) loss%at = point%at
            loss%radius = min(loss%radius, 1.0_dp/steepest)
        else
            if (loss%beyond == 0 .and. loss%sharp == 0) loss%at = point%at
            loss%beyond = loss%beyond + 1
        end if
    end subroutine lose

    !> Notes what is left out.
    pure subroutine tell(thickness, loss, notes)
        real(dp), intent(in) :: thickness                           !! deck units
        type(loss_type), intent(in) :: loss                         !! what is left out
        type(note_type), allocatable, intent(inout) :: notes(:)     !! gets it
        character(:), allocatable :: place

        place = ' at station '//compact(loss%at(1))//', BL '//compact(loss%at(2))//', WL '// &
            compact(loss%at(3))
        if (loss%sharp > 0) then
            call add_note(notes, .false., 'the skin of '//compact(thickness)//' is thicker '// &
                'than the radius of curvature '//compact(loss%radius)//place// &
                '; no inside opposite '//counted(loss%sharp, 'point')//' of the outline')
        end if
        if (loss%beyond > 0) then
            call add_note(notes, .false., 'no inside of the skin opposite '// &
                counted(loss%beyond, 'point')//' of the outline, the first'//place// &
                ': a section or its smooth surface ends there; where it can go on, let its '// &
                'lines go on')
        end if
    end subroutine tell

end module cut_inside
