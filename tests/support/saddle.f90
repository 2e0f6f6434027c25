!> A panel that is a saddle, WL = .04 STA BL over 0 to 10: blended by straight lines between four
!> straight sides, it is that surface, whose cuts are known.
module support_saddle
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_line, only: line_type
    use body_panel, only: new_panel, panel_type, plan_type
    use body_panel_side, only: arc_side, line_side, side_type
    use deck_job, only: twist
    use geom_arc, only: line_between
    use support_bodies, only: constant_view, control_line, straight_view
    implicit none (type, external)
    private

    public :: saddle, saddle_sides

contains

    !> The sides: BL 0, station 10, BL 10, station 0.
    function saddle_sides() result(side)
        type(side_type) :: side(4)
        type(line_type) :: low, high
        low = control_line('LOW', constant_view(0.0_dp), constant_view(0.0_dp))
        high = control_line('HIGH', straight_view([0.0_dp, 0.0_dp], [10.0_dp, 4.0_dp]), &
            constant_view(10.0_dp))
        side(1) = line_side(low, 0.0_dp, 10.0_dp)
        side(2) = arc_side(line_between([0.0_dp, 0.0_dp], [10.0_dp, 4.0_dp]), 10.0_dp)
        side(3) = line_side(high, 10.0_dp, 0.0_dp)
        side(4) = arc_side(line_between([10.0_dp, 0.0_dp], [0.0_dp, 0.0_dp]), 0.0_dp)
    end function saddle_sides

    !> The panel.
    function saddle() result(panel)
        type(panel_type) :: panel
        type(error_type), allocatable :: error
        call new_panel(plan_type('SADDLE', saddle_sides(), twists=twist%linear, gap=1.0e-9_dp), &
            panel, error)
        if (allocated(error)) error stop 'the saddle can''t be built'
    end function saddle

end module support_saddle
