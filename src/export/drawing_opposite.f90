!> The inside of the skin opposite to a smooth stretch of an outline, as a path in the plane of the
!> cut: from each point of the outside straight in, across the outline, as far as the skin goes.
module export_drawing_opposite
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use body_body, only: body_type, smooth_stops
    use body_offset, only: foot_at, foot_type, is_on_section, settle_inside, way_inside
    use cut_plane, only: in_space, in_view, plane_type, true_shape
    use export_drawing_outside, only: outside_type
    use export_drawing_path, only: path_type
    use geom_space, only: across
    implicit none (type, external)
    private

    public :: opposite_type, new_opposite, patch_opposite, is_patch_opposite, is_own_patch, nowhere

    !> The inside opposite to a part of a path. `patch` and `until` say of which section the foot is
    !> (see `patch_opposite`) up to which parameter of the outside.
    type, extends(path_type) :: opposite_type
        type(outside_type) :: outside           !! the path
        type(body_type), allocatable :: body    !! finished, both halves
        type(plane_type) :: plane               !! of the cut
        real(dp) :: thickness = 0.0_dp          !! of the skin, deck units
        real(dp) :: from = 0.0_dp               !! parameter of the outside where it begins
        real(dp) :: to = 1.0_dp                 !! where it ends
        integer, allocatable :: patch(:)        !! in order
        real(dp), allocatable :: until(:)       !! as many
    contains
        procedure :: at => inside_at
        procedure :: way => inside_way
    end type opposite_type

    !> The patch where there is no inside.
    integer, parameter :: nowhere = 0
    !> More patches than a section has.
    integer, parameter :: most_stretches = 10000
    !> Sine of the angle between plane and skin below which the skin is not passed through.
    real(dp), parameter :: grazing = 1.0e-6_dp
    !> How far the inside may be, in thicknesses of a flat skin.
    real(dp), parameter :: furthest = 8.0_dp

contains

    !> The inside opposite to all of a path; its patches are to be found.
    pure subroutine new_opposite(whole, plane, thickness, outside, inside)
        type(body_type), intent(in) :: whole        !! finished, both halves
        type(plane_type), intent(in) :: plane       !! of the cut
        real(dp), intent(in) :: thickness           !! of the skin, deck units
        type(outside_type), intent(in) :: outside   !! a path of it
        type(opposite_type), intent(out) :: inside  !! without patches
        inside%outside = outside
        inside%body = whole
        inside%plane = plane
        inside%thickness = thickness
        allocate (inside%patch(0), inside%until(0))
    end subroutine new_opposite

    !> On which patch of the skin the foot of the inside is, opposite to a parameter of the outside:
    !> `most_stretches` times its section and the number of the stretch between joints of lines.
    !> `nowhere` where there is no inside.
    pure integer function patch_opposite(inside, s) result(patch)
        type(opposite_type), intent(in) :: inside   !! any
        real(dp), intent(in) :: s                   !! parameter of the outside
        type(foot_type) :: foot
        logical :: is_found

        patch = nowhere
        if (is_nose(inside, s)) then
            patch = most_stretches*inside%outside%section
            return
        end if
        call find_foot(inside, inside%outside%section, s, foot, is_found)
        if (is_found) is_found = is_on_section(inside%body, foot)
        if (.not. is_found) call search_foot(inside, s, foot, is_found)
        if (is_found) patch = patch_of(inside%body, foot)
    end function patch_opposite

    !> The patch of a foot.
    pure integer function patch_of(body, foot) result(patch)
        type(body_type), intent(in) :: body     !! finished, both halves
        type(foot_type), intent(in) :: foot     !! on one of its sections
        patch = most_stretches*foot%section &
            + count(smooth_stops(body, body%sections(foot%section)) <= foot%at(1))
    end function patch_of

    !> True where the foot, opposite to a parameter of the outside, can be on a patch.
    pure logical function is_patch_opposite(inside, s, patch) result(is_there)
        type(opposite_type), intent(in) :: inside   !! any
        real(dp), intent(in) :: s                   !! parameter of the outside
        integer, intent(in) :: patch                !! one that was found, or `nowhere`
        type(foot_type) :: foot

        if (patch == nowhere .or. is_nose(inside, s)) then
            is_there = patch_opposite(inside, s) == patch
            return
        end if
        call find_foot(inside, patch/most_stretches, s, foot, is_there)
        if (is_there) then
            is_there = is_on_section(inside%body, foot)
        else
            call search_foot(inside, s, foot, is_there)
        end if
        if (is_there) is_there = patch_of(inside%body, foot) == patch
    end function is_patch_opposite

    !> Which patches are on the section of the outside itself.
    pure function is_own_patch(inside) result(is_own)
        type(opposite_type), intent(in) :: inside   !! with patches
        logical :: is_own(size(inside%patch))
        is_own = inside%patch/most_stretches == inside%outside%section
    end function is_own_patch

    !> Where the way inside begins, and which way it goes.
    pure subroutine look_from(inside, s, from, inward)
        type(opposite_type), intent(in) :: inside   !! any
        real(dp), intent(in) :: s                   !! parameter of the outside
        real(dp), intent(out) :: from(3)            !! STA, BL, WL
        real(dp), intent(out) :: inward(3)          !! unit vector; zero where there is none
        real(dp) :: at(3), way(3)

        at = inside%outside%at(s)
        way = inside%outside%way(s)
        from = in_space(inside%plane, at(:2))
        inward = inside%outside%side*(way(2)*inside%plane%u - way(1)*inside%plane%v)
        if (norm2(inward) > 0.0_dp) inward = inward/norm2(inward)
    end subroutine look_from

    !> The foot of the inside on the conics of a section.
    pure subroutine find_foot(inside, section, s, foot, is_found)
        type(opposite_type), intent(in) :: inside   !! any
        integer, intent(in) :: section              !! of the whole body
        real(dp), intent(in) :: s                   !! parameter of the outside
        type(foot_type), intent(out) :: foot        !! where it is found
        logical, intent(out) :: is_found            !! there is one
        real(dp) :: from(3), inward(3)

        call look_from(inside, s, from, inward)
        call first_foot(inside, section, from, inward, foot, is_found)
        if (is_found) call settle_inside(inside%body, inside%thickness, inward, from, foot, &
            is_found)
        if (is_found) is_found = is_near(inside, from, inward, foot)
    end subroutine find_foot

    !> The foot on a section from where the way inside begins; none where that way grazes the skin.
    pure subroutine first_foot(inside, section, from, inward, foot, is_found)
        type(opposite_type), intent(in) :: inside   !! any
        integer, intent(in) :: section              !! of the whole body
        real(dp), intent(in) :: from(3)             !! where the way inside begins
        real(dp), intent(in) :: inward(3)           !! unit vector, or zero
        type(foot_type), intent(out) :: foot        !! where it is found
        logical, intent(out) :: is_found            !! there is one

        is_found = any(.not. is_zero(inward))
        if (.not. is_found) return
        call foot_at(inside%body, section, from, -inward, foot, is_found)
        if (is_found) is_found = -dot_product(foot%normal, inward) > grazing
    end subroutine first_foot

    !> True for an inside that is ahead, and no further than a skin bent a little can be.
    pure logical function is_near(inside, from, inward, foot)
        type(opposite_type), intent(in) :: inside   !! any
        real(dp), intent(in) :: from(3)             !! where the way inside begins
        real(dp), intent(in) :: inward(3)           !! unit vector
        type(foot_type), intent(in) :: foot         !! where it was found
        real(dp) :: ahead, slope
        ahead = dot_product(foot%at - inside%thickness*foot%normal - from, inward)
        slope = -dot_product(foot%normal, inward)
        is_near = slope > grazing .and. ahead > 0.0_dp .and. &
            ahead*slope <= furthest*inside%thickness
    end function is_near

    !> The foot of the inside, in small steps of the thickness and on any section: near the end of
    !> a section a long step leaves it.
    pure subroutine search_foot(inside, s, foot, is_found)
        type(opposite_type), intent(in) :: inside   !! any
        real(dp), intent(in) :: s                   !! parameter of the outside
        type(foot_type), intent(out) :: foot        !! where it is found
        logical, intent(out) :: is_found            !! there is one
        real(dp) :: from(3), inward(3)

        call look_from(inside, s, from, inward)
        call first_foot(inside, inside%outside%section, from, inward, foot, is_found)
        if (is_found) call way_inside(inside%body, inside%thickness, inward, foot, is_found)
    end subroutine search_foot

    !> True where a path begins or ends in a blunt nose, whose normal, along STA, is in the plane.
    pure logical function is_nose(inside, s)
        type(opposite_type), intent(in) :: inside   !! any
        real(dp), intent(in) :: s                   !! parameter of the outside
        real(dp) :: way(3)

        is_nose = .false.
        if (inside%outside%is_arc .or. .not. is_zero(inside%plane%normal(1))) return
        if (s > 0.0_dp .and. s < 1.0_dp) return
        way = inside%outside%way(s)
        is_nose = is_zero(dot_product(way(:2), [inside%plane%u(1), inside%plane%v(1)])) &
            .and. any(.not. is_zero(way)) .and. .not. is_smooth_at(inside, s)
    end function is_nose

    !> True where the skin has a smooth surface.
    pure logical function is_smooth_at(inside, s) result(is_smooth)
        type(opposite_type), intent(in) :: inside   !! any
        real(dp), intent(in) :: s                   !! parameter of the outside
        type(foot_type) :: foot
        real(dp) :: from(3), inward(3)

        call look_from(inside, s, from, inward)
        call foot_at(inside%body, inside%outside%section, from, -inward, foot, is_smooth)
    end function is_smooth_at

    !> The section on whose conics the foot is, opposite to a parameter of the outside; where there
    !> is no inside, the section of the outside.
    pure integer function section_of(inside, s) result(section)
        type(opposite_type), intent(in) :: inside   !! with patches
        real(dp), intent(in) :: s                   !! parameter of the outside
        integer :: i

        section = inside%outside%section
        do i = 1, size(inside%patch)
            section = inside%outside%section
            if (inside%patch(i) /= nowhere) section = inside%patch(i)/most_stretches
            if (s <= inside%until(i)) return
        end do
    end function section_of

    !> The parameter of the outside.
    pure real(dp) function outer(inside, t) result(s)
        class(opposite_type), intent(in) :: inside  !! any
        real(dp), intent(in) :: t                   !! 0 to 1
        s = inside%from + (inside%to - inside%from)*t
        if (t >= 1.0_dp) s = inside%to
    end function outer

    !> The foot of the inside on its patch, or else on any section.
    pure subroutine foot_opposite(inside, s, foot, is_found)
        type(opposite_type), intent(in) :: inside   !! with patches
        real(dp), intent(in) :: s                   !! parameter of the outside
        type(foot_type), intent(out) :: foot        !! where it is found
        logical, intent(out) :: is_found            !! there is one
        call find_foot(inside, section_of(inside, s), s, foot, is_found)
        if (.not. is_found) call search_foot(inside, s, foot, is_found)
    end subroutine foot_opposite

    !> The point of the inside. Where there is no foot, as in a blunt nose, it is the thickness off.
    pure function inside_at(f, t) result(point)
        class(opposite_type), intent(in) :: f   !! with patches
        real(dp), intent(in) :: t               !! 0 to 1
        real(dp) :: point(3), from(3), inward(3), s
        type(foot_type) :: foot
        logical :: is_found

        s = outer(f, t)
        call foot_opposite(f, s, foot, is_found)
        if (is_found) then
            point(:2) = true_shape(f%plane, foot%at - f%thickness*foot%normal)
        else
            call look_from(f, s, from, inward)
            point(:2) = true_shape(f%plane, from + f%thickness*inward)
        end if
        point(3) = 0.0_dp
    end function inside_at

    !> The direction of the inside: across the normal of the skin at the foot, along the outside.
    pure function inside_way(f, t) result(way)
        class(opposite_type), intent(in) :: f   !! with patches
        real(dp), intent(in) :: t               !! 0 to 1
        real(dp) :: way(3), s
        type(foot_type) :: foot
        logical :: is_found

        s = outer(f, t)
        call foot_opposite(f, s, foot, is_found)
        way = f%outside%way(s)
        if (.not. is_found) return
        foot%at = [in_view(f%plane, across(foot%normal, f%plane%normal)), 0.0_dp]
        way = sign(1.0_dp, dot_product(foot%at, way))*foot%at
    end function inside_way

end module export_drawing_opposite
