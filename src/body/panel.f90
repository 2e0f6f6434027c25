!> A panel: the surface of a PATCH or a DUCT card.
!>
!> A patch is a Coons patch between parts of control lines and arcs of sections. The sides are
!> splines of degree 5 within `panel_tolerance` of the curves; the surface is the patch between
!> these, exactly. Along sides that are to be tangent to what lies beside them it has the slopes of
!> `body_ribbon`; how far its normals are from those is measured. A duct is made by `body_duct`.
module body_panel
    use base_constants, only: degrees
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact, to_text
    use base_tolerances, only: agreement_ulps, panel_tolerance, tangency_tolerance, ulp
    use body_beside, only: beside_type, neighbour, normal_beside
    use body_panel_side, only: place_on, side_type, side_spline
    use body_ribbon, only: add_ribbon
    use deck_job, only: name_length, twist
    use geom_bspline, only: bspline_type
    use geom_bspline_surface, only: bspline_surface_type, mirrored_surface, surface_jet, &
        surface_point
    use geom_coons, only: check_corners
    use geom_coons_blend, only: blend
    use geom_coons_spline, only: coons_surface, new_spline_frame, settle_twists, spline_frame_type
    use geom_space, only: across, angle_between
    implicit none (type, external)
    private

    public :: panel_type, joint_type, plan_type, new_panel, mirrored_panel
    public :: panel_noise, panel_reach

    !> What a panel is to be.
    type :: plan_type
        character(name_length) :: name = ''     !! of its card
        type(side_type) :: side(4)              !! its sides, each running on from the one before
        type(beside_type) :: beside(4)          !! what it is to be tangent to
        integer :: twists = 1                   !! one of `twist%...`
        real(dp) :: gap = 0.0_dp                !! by which sides may miss, deck units
    end type plan_type

    !> How a panel meets what lies beside a side.
    type :: joint_type
        character(name_length) :: name = ''     !! section or panel; or MIRROR; blank: not looked at
        real(dp) :: angle = 0.0_dp              !! largest between the normals, degrees
        real(dp) :: worst(3) = 0.0_dp           !! where, deck units
        logical :: is_inward = .false.          !! the panel faces the other way
    end type joint_type

    !> A panel, in deck units.
    type :: panel_type
        character(name_length) :: name = ''     !! of its card
        type(bspline_surface_type) :: surface   !! over 0 to 1; side 1 is v = 0, side 2 is u = 1
        real(dp) :: outward = 1.0_dp            !! dS/du x dS/dv points outward (1) or inward (-1)
        integer :: point = 0                    !! which side is a point; 0: none
        logical :: is_round = .false.           !! of a duct: where u ends it goes on smoothly where
                                                !! u begins
        logical :: has_image = .true.           !! in a symmetric body it has a mirror image
        real(dp) :: error = 0.0_dp              !! largest distance of an edge from its side
        real(dp) :: worst(3) = 0.0_dp           !! where
        type(joint_type) :: joint(4)            !! along sides that are TANGENT
    end type panel_type

    !> Points of an edge at which its distance from the side is measured.
    integer, parameter :: edge_points = 200
    !> Where tangents span less than this of the square on the longer one there is no normal.
    real(dp), parameter :: no_area = 1.0e-9_dp

contains

    !> The panel of a plan.
    !>
    !> Fails with `cause%joint_gap` where sides do not meet, or where the panel can't be tangent to
    !> what lies beside it; with `cause%no_convergence` where a side can't be made a spline: it has
    !> a corner.
    pure subroutine new_panel(plan, panel, error)
        type(plan_type), intent(in) :: plan                 !! what it is to be
        type(panel_type), intent(out) :: panel              !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(spline_frame_type) :: frame
        type(bspline_type) :: spline(4)
        real(dp) :: tolerance
        integer :: i

        tolerance = panel_tolerance*size_of(plan%side)
        panel%name = plan%name
        do i = 1, 4
            if (plan%side(i)%is_point) panel%point = i
            call side_spline(plan%side(i), is_turned=i > 2, tolerance=tolerance, &
                spline=spline(i), error=error)
            if (.not. allocated(error)) cycle
            error%message = 'side '//to_text(i)//': '//error%message
            return
        end do
        frame = new_spline_frame(spline, plan%twists == twist%adini)
        call check_corners(frame, plan%gap, error)
        if (allocated(error)) return
        do i = 1, 4
            if (plan%beside(i)%kind == neighbour%none) cycle
            call add_ribbon(i, plan%beside(i), frame, error)
            if (allocated(error)) return
        end do
        call settle_twists(frame)
        call coons_surface(frame, merge(blend%linear, blend%slopes, plan%twists == twist%linear), &
            panel%surface, error)
        if (allocated(error)) return
        if (.not. maxval(abs(panel%surface%pole)) < huge(1.0_dp)) then
            call fail(error, cause%no_convergence, 'the surface is not finite')
            return
        end if
        do i = 1, 4
            call measure_edge(plan%side(i), i, panel)
            if (plan%beside(i)%kind /= neighbour%none) &
                call measure_joint(plan%beside(i), i, panel, error)
            if (allocated(error)) return
        end do
    end subroutine new_panel

    !> Measures how far a panel is from tangent to what lies beside a side. Fails with
    !> `cause%joint_gap` where that is more than `tangency_tolerance`.
    pure subroutine measure_joint(beside, number, panel, error)
        type(beside_type), intent(in) :: beside             !! what lies beside
        integer, intent(in) :: number                       !! the side
        type(panel_type), intent(inout) :: panel            !! gets the joint
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: uv(2), at(3), u(3), v(3), own(3), other(3), angle
        integer :: i

        associate (joint => panel%joint(number))
            joint%name = beside%name
            do i = 0, edge_points
                uv = place_on(number, real(i, dp)/real(edge_points, dp))
                call surface_jet(panel%surface, uv(1), uv(2), at, u, v)
                own = across(u, v)
                if (.not. norm2(own) > no_area*max(dot_product(u, u), dot_product(v, v))) cycle
                own = own/norm2(own)
                other = normal_beside(beside, at, merge(u, v, mod(number, 2) == 1), &
                    real(i, dp)/real(edge_points, dp))
                if (beside%kind /= neighbour%mirror .and. 2*i == edge_points) &
                    joint%is_inward = dot_product(own, other) < 0.0_dp
                angle = degrees*min(angle_between(own, other), angle_between(own, -other))
                if (angle < joint%angle) cycle
                joint%angle = angle
                joint%worst = at
            end do
            if (joint%angle <= tangency_tolerance) return
            call fail(error, cause%joint_gap, 'TANGENT'//to_text(number)//': the normals of '// &
                'the patch and of '//trim(joint%name)//' differ by up to '//compact(joint%angle)// &
                ' degrees along side '//to_text(number)//', at station '// &
                compact(joint%worst(1))//'; '//compact(tangency_tolerance)//' is allowed: the '// &
                'skins beside two sides bend too differently in their corner')
        end associate
    end subroutine measure_joint

    !> A size of what sides stand around: the largest distance of a corner from the first.
    pure real(dp) function size_of(side)
        type(side_type), intent(in) :: side(4) !! its sides
        integer :: i

        size_of = tiny(1.0_dp)
        do i = 1, 4
            size_of = max(size_of, norm2(side(i)%at(1.0_dp) - side(1)%at(0.0_dp)))
        end do
    end function size_of

    !> Measures how far an edge of a panel is from its side.
    pure subroutine measure_edge(side, number, panel)
        type(side_type), intent(in) :: side         !! the side
        integer, intent(in) :: number               !! which: 1 to 4
        type(panel_type), intent(inout) :: panel    !! gets its error, if larger
        real(dp) :: t, uv(2), at(3), off
        integer :: i

        do i = 0, edge_points
            t = real(i, dp)/real(edge_points, dp)
            uv = place_on(number, t)
            at = surface_point(panel%surface, uv(1), uv(2))
            off = norm2(at - side%at(t))
            if (off <= panel%error) cycle
            panel%error = off
            panel%worst = at
        end do
    end subroutine measure_edge

    !> What of a height over a plane is but rounding, deck units.
    pure real(dp) function panel_noise(panel)
        type(panel_type), intent(in) :: panel !! any
        panel_noise = agreement_ulps*ulp*maxval(abs(panel%surface%pole))
    end function panel_noise

    !> How far apart, deck units, two points may be that are one on the sides of a panel: an edge is
    !> not on its side but near to it.
    pure real(dp) function panel_reach(panel)
        type(panel_type), intent(in) :: panel !! any
        panel_reach = max(panel_noise(panel), panel%error)
    end function panel_reach

    !> The mirror image of a panel in BL 0.
    pure type(panel_type) function mirrored_panel(panel) result(other)
        type(panel_type), intent(in) :: panel !! any
        other = panel
        other%surface = mirrored_surface(panel%surface)
        other%outward = -panel%outward
        other%worst(2) = 0.0_dp - panel%worst(2)
        other%joint%worst(2) = 0.0_dp - panel%joint%worst(2)
    end function mirrored_panel

end module body_panel
