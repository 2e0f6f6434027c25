!> What lies beside a side of a patch and gives it its tangent planes: the skin of a section, an
!> earlier panel, or the patch's own mirror image beyond BL 0.
module body_beside
    use base_constants, only: degrees
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_text, only: compact, to_text
    use base_tolerances, only: tangency_tolerance
    use body_body, only: body_type
    use body_panel_side, only: place_on, side_type
    use body_section, only: section_arc
    use body_skin, only: skin_at, skin_type
    use deck_job, only: name_length
    use geom_arc, only: arc_type
    use geom_arc_point, only: point
    use geom_bspline_surface, only: bspline_surface_type, surface_jet
    use geom_place, only: place_at
    use geom_space, only: across, angle_between
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: beside_type, edge_type, find_skin, find_edge, is_in_mirror, normal_beside

    !> What may lie beside a side.
    type, public :: neighbour_list
        integer :: none = 0     !! nothing is asked
        integer :: skin = 1     !! a section
        integer :: panel = 2    !! an edge of a panel
        integer :: mirror = 3   !! the image in BL 0
    end type neighbour_list

    !> By name: `case (neighbour%skin)`.
    type(neighbour_list), parameter, public :: neighbour = neighbour_list()

    !> An edge of a panel, in the order of the sides of a patch, as the other side runs along it.
    type :: edge_type
        type(bspline_surface_type) :: surface   !! of the panel
        real(dp) :: outward = 1.0_dp            !! dS/du x dS/dv points outward (1) or inward (-1)
        integer :: number = 1                   !! which of its edges
        logical :: is_against = .false.         !! run through from its last corner to its first
    end type edge_type

    !> What lies beside a side.
    type :: beside_type
        integer :: kind = 0                     !! one of `neighbour%...`
        character(name_length) :: name = ''     !! of section or panel
        type(body_type), allocatable :: body    !! of the section
        integer :: section = 0                  !! in the body's list
        type(edge_type) :: edge                 !! of the panel
    end type beside_type

    !> Points of a side, less one, at which it is looked what it lies on.
    integer, parameter :: looks = 8
    !> Steps that make a place steady, and the step of a difference.
    integer, parameter :: steps = 4
    real(dp), parameter :: small_step = 1.0e-6_dp

contains

    !> The outward unit normal beside a point of a side; zero where there is none.
    pure function normal_beside(beside, at, way, t) result(normal)
        type(beside_type), intent(in) :: beside !! not none
        real(dp), intent(in) :: at(3)           !! the point, deck units
        real(dp), intent(in) :: way(3)          !! along the side there
        real(dp), intent(in) :: t               !! where on the side, 0 to 1
        real(dp) :: normal(3)
        type(skin_type) :: skin

        select case (beside%kind)
        case (neighbour%skin)
            skin = skin_by(beside%body, beside%section, at)
            normal = merge(skin%normal, 0.0_dp, skin%has_normal)
        case (neighbour%panel)
            normal = edge_normal(beside%edge, t)
        case default
            normal = [-way(3), 0.0_dp, way(1)]
            if (.not. all(is_zero(normal))) normal = normal/norm2(normal)
        end select
    end function normal_beside

    !> The skin of a section where a point lies on it: at its station, at the nearest place of the
    !> arc.
    pure type(skin_type) function skin_by(body, number, at) result(skin)
        type(body_type), intent(in) :: body     !! finished
        integer, intent(in) :: number           !! of the section
        real(dp), intent(in) :: at(3)           !! deck units
        type(error_type), allocatable :: error
        type(arc_type) :: arc
        real(dp) :: sta, t

        associate (section => body%sections(number))
            sta = min(max(at(1), section%from), section%to)
            call section_arc(body%lines, section, sta, arc, error)
            t = 0.5_dp
            if (.not. allocated(error)) t = place_near(arc, at(2:))
            skin = skin_at(body%lines, section, sta, place_at(t))
        end associate
    end function skin_by

    !> The parameter of an arc where a point beside it is nearest. It begins where the shares of the
    !> ends are, s0 : s2 = sqrt(b0) : sqrt(b2) with the barycentric coordinates of the point in the
    !> triangle of the arc, which are exact on the arc but not steady near its ends; steps along the
    !> tangent make it so.
    pure real(dp) function place_near(arc, at) result(t)
        type(arc_type), intent(in) :: arc       !! any
        real(dp), intent(in) :: at(2)           !! BL, WL, deck units
        real(dp) :: chord(2), share(2), way(2), ends(2)
        integer :: i

        chord = arc%finish - arc%start
        if (arc%is_line) then
            t = dot_product(at - arc%start, chord)/dot_product(chord, chord)
            t = min(max(t, 0.0_dp), 1.0_dp)
            return
        end if
        share = [cross(at - arc%finish, arc%finish_tangent)/cross(-chord, arc%finish_tangent), &
            cross(at - arc%start, arc%start_tangent)/cross(chord, arc%start_tangent)]
        share = sqrt(max(share, 0.0_dp))
        t = 0.5_dp
        if (sum(share) > 0.0_dp) t = share(2)/sum(share)
        do i = 1, steps
            ends = [max(t - small_step, 0.0_dp), min(t + small_step, 1.0_dp)]
            way = (point(arc, place_at(ends(2))) - point(arc, place_at(ends(1)))) &
                /(ends(2) - ends(1))
            t = t + dot_product(at - point(arc, place_at(t)), way)/dot_product(way, way)
            t = min(max(t, 0.0_dp), 1.0_dp)
        end do
    end function place_near

    !> The normal of a panel at an edge.
    pure function edge_normal(edge, t) result(normal)
        type(edge_type), intent(in) :: edge !! of the panel
        real(dp), intent(in) :: t           !! 0 to 1, as the other side runs
        real(dp) :: normal(3), uv(2), at(3), u(3), v(3)

        uv = edge_place(edge, t)
        call surface_jet(edge%surface, uv(1), uv(2), at, u, v)
        normal = across(u, v)
        if (.not. all(is_zero(normal))) normal = edge%outward*normal/norm2(normal)
    end function edge_normal

    !> The parameters of a place on an edge.
    pure function edge_place(edge, t) result(uv)
        type(edge_type), intent(in) :: edge !! of a panel
        real(dp), intent(in) :: t           !! 0 to 1, as the other side runs
        real(dp) :: uv(2)
        uv = place_on(edge%number, merge(1.0_dp - t, t, edge%is_against))
    end function edge_place

    !> Finds the section on whose skin a side lies, within a gap; of several that of the first. None
    !> where there is none.
    !>
    !> Fails with `cause%joint_gap` where the side lies on several whose skins meet at an angle.
    pure subroutine find_skin(body, side, gap, beside, error)
        type(body_type), intent(in) :: body                 !! finished
        type(side_type), intent(in) :: side                 !! no point
        real(dp), intent(in) :: gap                         !! deck units
        type(beside_type), intent(out) :: beside            !! its neighbour
        type(error_type), allocatable, intent(out) :: error !! see above
        type(skin_type) :: skin, other
        real(dp) :: angle
        integer :: i, k

        do i = 1, size(body%sections)
            if (largest_miss(body, i, side) > gap) cycle
            if (beside%kind == neighbour%none) then
                beside%kind = neighbour%skin
                beside%name = body%sections(i)%name
                beside%section = i
                cycle
            end if
            do k = 0, looks
                skin = skin_by(body, beside%section, side%at(real(k, dp)/real(looks, dp)))
                other = skin_by(body, i, side%at(real(k, dp)/real(looks, dp)))
                if (.not. (skin%has_normal .and. other%has_normal)) cycle
                angle = degrees*angle_between(skin%normal, other%normal)
                if (angle <= tangency_tolerance) cycle
                call fail(error, cause%joint_gap, 'lies on sections '//trim(beside%name)// &
                    ' and '//trim(body%sections(i)%name)//', which meet at an angle there, '// &
                    compact(angle)//' degrees at station '//compact(skin%at(1))// &
                    '; nothing is tangent to both')
                return
            end do
        end do
        if (beside%kind == neighbour%skin) allocate (beside%body, source=body)
    end subroutine find_skin

    !> How far a side is from the skin of a section at most; huge where the section is not beside
    !> all of it.
    pure real(dp) function largest_miss(body, number, side) result(miss)
        type(body_type), intent(in) :: body     !! finished
        integer, intent(in) :: number           !! of the section
        type(side_type), intent(in) :: side     !! no point
        type(skin_type) :: skin
        real(dp) :: at(3)
        integer :: k

        miss = 0.0_dp
        do k = 0, looks
            at = side%at(real(k, dp)/real(looks, dp))
            skin = skin_by(body, number, at)
            miss = max(miss, norm2(skin%at - at))
        end do
    end function largest_miss

    !> Finds whether a side runs along an edge of a panel, from corner to corner.
    pure subroutine find_edge(surface, outward, side, gap, beside)
        type(bspline_surface_type), intent(in) :: surface   !! of the panel
        real(dp), intent(in) :: outward                     !! which way it faces: 1 or -1
        type(side_type), intent(in) :: side                 !! no point
        real(dp), intent(in) :: gap                         !! deck units
        type(beside_type), intent(inout) :: beside          !! that edge, where there is one
        type(edge_type) :: edge
        integer :: number, way

        edge%surface = surface
        edge%outward = outward
        do number = 1, 4
            do way = 1, 2
                edge%number = number
                edge%is_against = way == 2
                if (.not. runs_along(edge)) cycle
                beside%kind = neighbour%panel
                beside%edge = edge
                return
            end do
        end do
    contains
        !> True where the side is at the edge all along.
        pure logical function runs_along(edge)
            type(edge_type), intent(in) :: edge !! of the panel
            real(dp) :: t, uv(2), at(3), u(3), v(3)
            integer :: k
            runs_along = .false.
            do k = 0, looks
                t = real(k, dp)/real(looks, dp)
                uv = edge_place(edge, t)
                call surface_jet(edge%surface, uv(1), uv(2), at, u, v)
                if (norm2(at - side%at(t)) > gap) return
            end do
            runs_along = .true.
        end function runs_along
    end subroutine find_edge

    !> True for a side in BL 0.
    pure logical function is_in_mirror(side, gap)
        type(side_type), intent(in) :: side     !! no point
        real(dp), intent(in) :: gap             !! deck units
        real(dp) :: at(3)
        integer :: k
        is_in_mirror = .true.
        do k = 0, looks
            at = side%at(real(k, dp)/real(looks, dp))
            is_in_mirror = is_in_mirror .and. abs(at(2)) <= gap
        end do
    end function is_in_mirror

end module body_beside
