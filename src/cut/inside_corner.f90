!> The inside of the skin at a corner of an outline, a chine: the point that is the thickness inside
!> of both sections that meet there.
module cut_inside_corner
    use base_constants, only: degrees
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_tolerances, only: tangency_tolerance
    use body_body, only: body_type
    use body_offset, only: foot_at, foot_type, settle_inside
    use cut_outline, only: cut_point_type
    use cut_plane, only: in_view, plane_type
    use geom_space, only: across
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: is_corner, find_corner, image_of

    !> Newton steps at most, and what is a step of rounding, in thicknesses: feet are no better.
    integer, parameter :: most_steps = 30
    real(dp), parameter :: rounding = 1.0e-9_dp
    !> Sine of the angle below which two tangents are taken for parallel.
    real(dp), parameter :: parallel = 1.0e-6_dp

contains

    !> True for two points of an outline, one behind the other, that are the end of one section and
    !> the start of the next, where the skin breaks outwards.
    pure logical function is_corner(points, plane, ahead)
        type(cut_point_type), intent(in) :: points(2)   !! of the outside
        type(plane_type), intent(in) :: plane           !! of the cut
        real(dp), intent(in) :: ahead(3)                !! about which way the outline comes there
        real(dp) :: way(3)

        is_corner = .false.
        if (points(1)%section == points(2)%section .or. any(points%section == 0)) return
        if (.not. all(is_equal(points(1)%at, points(2)%at))) return
        if (.not. all(points%has_normal)) return
        way = across(points(1)%normal, plane%normal)
        way = sign(1.0_dp, dot_product(way, ahead))*way
        is_corner = dot_product(points(2)%normal, way) > &
            sin(tangency_tolerance/degrees)*norm2(way)
    end function is_corner

    !> A point of the outside on BL 0 as one of the mirror image; of no section where there is none.
    pure type(cut_point_type) function image_of(body, point) result(image)
        type(body_type), intent(in) :: body             !! finished, both halves
        type(cut_point_type), intent(in) :: point       !! of a section of the first half
        integer :: section

        section = point%section + size(body%sections)/2
        image = point
        image%normal(2) = -point%normal(2)
        image%section = 0
        if (abs(point%at(2)) > 0.0_dp .or. section > size(body%sections)) return
        associate (a => body%sections(point%section), b => body%sections(section))
            if (a%name == b%name .and. (a%is_port .neqv. b%is_port)) image%section = section
        end associate
    end function image_of

    !> The feet of the point of the plane that is the thickness inside of both sections.
    pure subroutine find_corner(body, plane, thickness, points, feet, is_found)
        type(body_type), intent(in) :: body             !! finished, both halves
        type(plane_type), intent(in) :: plane           !! of the cut
        real(dp), intent(in) :: thickness               !! of the skin, deck units
        type(cut_point_type), intent(in) :: points(2)   !! a corner
        type(foot_type), intent(out) :: feet(2)         !! one on each section
        logical, intent(out) :: is_found                !! there is such a point
        real(dp) :: way(3), inside(3, 2), n(3)
        integer :: i, k

        n = plane%normal/norm2(plane%normal)
        way = -in_plane(points(1)%normal) - in_plane(points(2)%normal)
        do i = 1, most_steps
            is_found = norm2(way) > 0.0_dp
            if (.not. is_found) return
            way = way/norm2(way)
            do k = 1, 2
                call foot_at(body, points(k)%section, points(k)%at, points(k)%normal, feet(k), &
                    is_found)
                if (is_found) call settle_inside(body, thickness, way, points(k)%at, feet(k), &
                    is_found)
                if (.not. is_found) return
                inside(:, k) = feet(k)%at - thickness*feet(k)%normal
            end do
            if (norm2(inside(:, 2) - inside(:, 1)) <= rounding*thickness) return
            way = crossing(inside, feet, plane) - points(1)%at
        end do
        is_found = .false.
    contains
        !> The part of a normal that lies in the plane, of unit length.
        pure function in_plane(normal) result(part)
            real(dp), intent(in) :: normal(3)   !! of the skin
            real(dp) :: part(3)
            part = normal - dot_product(normal, n)*n
            part = part/max(norm2(part), tiny(1.0_dp))
        end function in_plane
    end subroutine find_corner

    !> Where the tangents of two insides in a plane cross; the middle between their points where
    !> they are parallel.
    pure function crossing(inside, feet, plane) result(at)
        real(dp), intent(in) :: inside(3, 2)    !! a point of each
        type(foot_type), intent(in) :: feet(2)  !! their feet
        type(plane_type), intent(in) :: plane   !! of the cut
        real(dp) :: at(3), way(3, 2), turn
        integer :: k

        do k = 1, 2
            way(:, k) = across(feet(k)%normal, plane%normal)
        end do
        turn = cross(in_view(plane, way(:, 1)), in_view(plane, way(:, 2)))
        at = 0.5_dp*(inside(:, 1) + inside(:, 2))
        if (abs(turn) < parallel*norm2(way(:, 1))*norm2(way(:, 2))) return
        at = inside(:, 1) + way(:, 1)* &
            (cross(in_view(plane, inside(:, 2) - inside(:, 1)), in_view(plane, way(:, 2)))/turn)
    end function crossing

end module cut_inside_corner
