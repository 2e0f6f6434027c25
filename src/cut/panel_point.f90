!> A point of a cut on a panel: normal, slope, curvature and bevel from the derivatives of the
!> surface.
!>
!> The tangent is across both normals. The curvature of a plane section is that of the normal
!> section over the sine of the angle between plane and panel (Meusnier).
module cut_panel_point
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_tolerances, only: straight_curvature
    use body_panel, only: panel_type
    use cut_outline, only: cut_point_type
    use cut_panel_walk, only: walk_type, uv_at
    use cut_plane, only: cut_kind, in_view, true_shape
    use cut_point, only: give_bevel, left_of
    use geom_arc_point, only: slope_along
    use geom_coons, only: patch_jet_type
    use geom_space, only: across
    use geom_surface_jet, only: second_jet
    implicit none (type, external)
    private

    public :: point_on_panel, panel_normal

    !> Below this sine of the angle between plane and panel the plane touches the panel.
    real(dp), parameter :: touching = 1.0e-9_dp
    !> A tangent shorter than this, relative to the other, is none: the side there is a point.
    real(dp), parameter :: no_way = 1.0e-9_dp

contains

    !> The point of a place of a track; `way` is about where the track goes there.
    pure type(cut_point_type) function point_on_panel(walk, s, way, is_forward) result(point)
        type(walk_type), intent(in) :: walk     !! panel, plane and track
        real(dp), intent(in) :: s               !! place on the track
        real(dp), intent(in) :: way(3)          !! towards the points that follow, any length
        logical, intent(in) :: is_forward       !! the flange is on the forward side
        type(patch_jet_type) :: jet
        real(dp) :: uv(2), normal(3), tangent(3)
        logical :: is_regular

        uv = uv_at(walk, s)
        jet = second_jet(walk%panel%surface, uv(1), uv(2))
        point%at = jet%at
        associate (plane => walk%plane)
            if (plane%kind == cut_kind%station) point%at(1) = plane%through(1)
            if (plane%kind == cut_kind%buttock) point%at(2) = plane%through(2)
            if (plane%kind == cut_kind%waterline) point%at(3) = plane%through(3)
            point%uv = true_shape(plane, point%at)
            call panel_normal(walk%panel, jet, normal, is_regular)
            if (all(is_zero(normal))) return
            call give_bevel(normal, plane, is_forward, point)
            tangent = across(normal, plane%normal/norm2(plane%normal))
            if (norm2(tangent) <= touching) return
            tangent = tangent/norm2(tangent)
            if (dot_product(tangent, way) < 0.0_dp) tangent = -tangent
            point%has_slope = .true.
            point%slope = slope_along(in_view(plane, tangent))
            if (.not. is_regular) return
            point%has_curvature = .true.
            point%curvature = normal_curvature(jet, normal, tangent) &
                /dot_product(normal, left_of(plane, tangent))
            if (abs(point%curvature)*max(norm2(jet%u), norm2(jet%v)) <= straight_curvature) &
                point%curvature = 0.0_dp
        end associate
    end function point_on_panel

    !> The outward unit normal of a panel; zero where there is none. Where a side is a point it is
    !> the one that the panel has next to it, and the panel is not regular there.
    pure subroutine panel_normal(panel, jet, normal, is_regular)
        type(panel_type), intent(in) :: panel       !! any
        type(patch_jet_type), intent(in) :: jet     !! of its surface
        real(dp), intent(out) :: normal(3)          !! see above
        logical, intent(out) :: is_regular          !! both tangents are there
        real(dp) :: u(3), v(3)

        u = jet%u
        v = jet%v
        is_regular = norm2(u) > no_way*norm2(v) .and. norm2(v) > no_way*norm2(u)
        if (.not. is_regular) then
            select case (panel%point)
            case (1)
                u = jet%uv
            case (2)
                v = -jet%uv
            case (3)
                u = -jet%uv
            case (4)
                v = jet%uv
            end select
        end if
        normal = across(u, v)
        if (norm2(normal) <= no_way*norm2(u)*norm2(v)) then
            normal = 0.0_dp
            is_regular = .false.
        else
            normal = panel%outward*normal/norm2(normal)
        end if
    end subroutine panel_normal

    !> The curvature of the normal section along a tangent, positive where it bends to the normal.
    pure real(dp) function normal_curvature(jet, normal, tangent) result(curvature)
        type(patch_jet_type), intent(in) :: jet !! of a regular surface
        real(dp), intent(in) :: normal(3)       !! its unit normal, either way
        real(dp), intent(in) :: tangent(3)      !! unit tangent
        real(dp) :: e, f, g, a, b, u, v, det

        e = dot_product(jet%u, jet%u)
        f = dot_product(jet%u, jet%v)
        g = dot_product(jet%v, jet%v)
        u = dot_product(jet%u, tangent)
        v = dot_product(jet%v, tangent)
        det = e*g - f**2
        a = (g*u - f*v)/det
        b = (e*v - f*u)/det
        curvature = a**2*dot_product(jet%uu, normal) + 2.0_dp*a*b*dot_product(jet%uv, normal) &
            + b**2*dot_product(jet%vv, normal)
    end function normal_curvature

end module cut_panel_point
