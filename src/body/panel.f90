!> A panel: the surface of a PATCH or a DUCT card.
!>
!> A patch is a Coons patch between parts of control lines and arcs of sections. The sides are
!> splines of degree 5 within `panel_tolerance` of the curves; the surface is the patch between
!> these, exactly. A duct is made by `body_duct`.
module body_panel
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: to_text
    use base_tolerances, only: panel_tolerance
    use body_panel_side, only: side_type, side_spline
    use deck_job, only: name_length, twist
    use geom_bspline, only: bspline_type
    use geom_bspline_surface, only: bspline_surface_type, mirrored_surface, surface_point
    use geom_coons, only: check_corners
    use geom_coons_blend, only: blend
    use geom_coons_spline, only: coons_surface, new_spline_frame, spline_frame_type
    implicit none (type, external)
    private

    public :: panel_type, new_panel, mirrored_panel

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
    end type panel_type

    !> Points of an edge at which its distance from the side is measured.
    integer, parameter :: edge_points = 200

contains

    !> The panel between four sides, given in the order of the card, each running on from the end of
    !> the one before.
    !>
    !> Fails with `cause%joint_gap` where sides do not meet within `gap`, with
    !> `cause%no_convergence` where a side can't be made a spline: it has a corner.
    pure subroutine new_panel(name, side, twists, gap, panel, error)
        character(*), intent(in) :: name                    !! of the card
        type(side_type), intent(in) :: side(4)              !! its sides
        integer, intent(in) :: twists                       !! one of `twist%...`
        real(dp), intent(in) :: gap                         !! by which sides may miss, deck units
        type(panel_type), intent(out) :: panel              !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(spline_frame_type) :: frame
        type(bspline_type) :: spline(4)
        real(dp) :: tolerance
        integer :: i

        tolerance = panel_tolerance*size_of(side)
        panel%name = name
        do i = 1, 4
            if (side(i)%is_point) panel%point = i
            call side_spline(side(i), is_turned=i > 2, tolerance=tolerance, spline=spline(i), &
                error=error)
            if (.not. allocated(error)) cycle
            error%message = 'side '//to_text(i)//': '//error%message
            return
        end do
        frame = new_spline_frame(spline, twists == twist%adini)
        call check_corners(frame, gap, error)
        if (allocated(error)) return
        call coons_surface(frame, merge(blend%linear, blend%slopes, twists == twist%linear), &
            panel%surface, error)
        if (allocated(error)) return
        do i = 1, 4
            call measure_edge(side(i), i, panel)
        end do
        if (maxval(abs(panel%surface%pole)) < huge(1.0_dp)) return
        call fail(error, cause%no_convergence, 'the surface is not finite')
    end subroutine new_panel

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
        real(dp) :: t, at(3), off
        integer :: i

        do i = 0, edge_points
            t = real(i, dp)/real(edge_points, dp)
            select case (number)
            case (1)
                at = surface_point(panel%surface, t, 0.0_dp)
            case (2)
                at = surface_point(panel%surface, 1.0_dp, t)
            case (3)
                at = surface_point(panel%surface, 1.0_dp - t, 1.0_dp)
            case default
                at = surface_point(panel%surface, 0.0_dp, 1.0_dp - t)
            end select
            off = norm2(at - side%at(t))
            if (off <= panel%error) cycle
            panel%error = off
            panel%worst = at
        end do
    end subroutine measure_edge

    !> The mirror image of a panel in BL 0.
    pure type(panel_type) function mirrored_panel(panel) result(other)
        type(panel_type), intent(in) :: panel !! any
        other = panel
        other%surface = mirrored_surface(panel%surface)
        other%outward = -panel%outward
        other%worst(2) = 0.0_dp - panel%worst(2)
    end function mirrored_panel

end module body_panel
