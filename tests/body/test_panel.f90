!> Panels: a saddle between straight sides, its image, sides that do not meet.
program test_panel
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use body_panel, only: mirrored_panel, new_panel, panel_type, plan_type
    use body_panel_side, only: arc_side, side_type
    use deck_job, only: twist
    use geom_arc, only: line_between
    use geom_bspline_surface, only: surface_point
    use support_saddle, only: saddle, saddle_sides
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(panel_type) :: panel, other
    type(side_type) :: side(4)
    type(error_type), allocatable :: error
    real(dp) :: off, point(3)
    integer :: i, kind

    do kind = twist%adini, twist%linear
        call new_panel(plan_type('SADDLE', saddle_sides(), twists=kind, gap=1.0e-9_dp), panel, &
            error)
        call tap%ok(.not. allocated(error), 'a panel between four sides')
        off = 0.0_dp
        do i = 0, 10
            point = surface_point(panel%surface, real(i, dp)/10.0_dp, &
                real(mod(3*i, 11), dp)/10.0_dp)
            off = max(off, abs(point(3) - 0.04_dp*point(1)*point(2)))
        end do
        if (kind == twist%none) then
            call tap%ok(off > 1.0e-2_dp, 'without twists it is no saddle')
        else
            call tap%near(off, 0.0_dp, 1.0e-14_dp, 'with twists it is the saddle')
        end if
        call tap%near(panel%error, 0.0_dp, 1.0e-14_dp, 'its edges are its sides')
    end do
    other = mirrored_panel(saddle())
    point = surface_point(other%surface, 1.0_dp, 1.0_dp)
    call tap%near(maxval(abs(point - [10.0_dp, -10.0_dp, 4.0_dp])), 0.0_dp, 1.0e-14_dp, 'its image')
    call tap%ok(other%outward < 0.0_dp, 'whose outside is the other one')
    side = saddle_sides()
    side(2) = arc_side(line_between([0.0_dp, 0.0_dp], [10.0_dp, 4.5_dp]), 10.0_dp)
    call new_panel(plan_type('GAP', side, twists=twist%adini, gap=1.0e-3_dp), panel, error)
    call tap%ok(allocated(error), 'sides that do not meet are an error')
    if (allocated(error)) then
        call tap%ok(error%cause == cause%joint_gap, 'a gap')
        call tap%has(error%message, 'sides 2 and 3 do not meet in corner 3: the gap is 0.5', &
            'which is told with its corner')
    end if
    call tap%finish()
end program test_panel
