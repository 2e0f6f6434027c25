!> Ribbons: slopes across a side of a frame that lie in the tangent planes of a cylinder.
program test_ribbon
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_beside, only: beside_type, neighbour
    use body_body, only: body_type
    use body_panel_side, only: arc_side, line_side, side_spline, side_type
    use body_ribbon, only: add_ribbon
    use body_section, only: section_arc
    use deck_job, only: job_type
    use geom_arc, only: arc_type, reversed
    use geom_bspline, only: bspline_type, spline_jet
    use geom_coons_spline, only: new_spline_frame, settle_twists, spline_frame_type
    use support_pipe, only: pipe_body
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(job_type) :: job
    type(body_type) :: body
    type(fault_list_type) :: faults
    type(spline_frame_type) :: frame
    type(beside_type) :: beside
    type(error_type), allocatable :: error
    real(dp) :: at(3), slope(3), twist(3), point(3), first(3), second(3), off
    integer :: i

    call pipe_body('STATION,1', job, body, faults)
    frame = new_spline_frame(splines(body), .true.)
    beside%kind = neighbour%skin
    beside%section = 1
    beside%body = body
    call add_ribbon(1, beside, frame, error)
    call tap%ok(.not. allocated(error), 'an arc of the skin gets a ribbon')
    off = 0.0_dp
    do i = 0, 50
        call spline_jet(frame%side(1), real(i, dp)/50.0_dp, point, first, second)
        call spline_jet(frame%ribbon(1), real(i, dp)/50.0_dp, slope, at, second)
        off = max(off, abs(dot_product(slope, [0.0_dp, point(2:)]))/(10.0_dp*norm2(slope)))
    end do
    call tap%near(off, 0.0_dp, 1.0e-8_dp, 'in the tangent planes of the cylinder')
    call spline_jet(frame%ribbon(1), 0.0_dp, slope, twist, second)
    call tap%near(norm2(slope - frame%slope_v(:, 0, 0)), 0.0_dp, 1.0e-14_dp, &
        'from the slope of the next side on')
    call settle_twists(frame)
    call tap%near(norm2(frame%twist(:, 0, 0) - twist), 0.0_dp, 1.0e-14_dp, 'which gives its twist')
    frame%slope_v(3, 0, 0) = frame%slope_v(3, 0, 0) + 1.0_dp
    call add_ribbon(1, beside, frame, error)
    call tap%ok(allocated(error), 'a side that leaves the skin is an error')
    if (allocated(error)) call tap%has(error%message, 'TANGENT1: side 4 begins at an angle of', &
        'which names it')
    call tap%finish()

contains

    !> The sides between stations 10 and 20, from the top to the side of the cylinder.
    function splines(body) result(spline)
        type(body_type), intent(in) :: body !! the cylinder
        type(bspline_type) :: spline(4)
        type(side_type) :: side(4)
        type(arc_type) :: arc
        integer :: i
        call section_arc(body%lines, body%sections(1), 10.0_dp, arc, error)
        side(1) = arc_side(arc, 10.0_dp)
        side(2) = line_side(body%lines(2), 10.0_dp, 20.0_dp)
        side(3) = arc_side(reversed(arc), 20.0_dp)
        side(4) = line_side(body%lines(1), 20.0_dp, 10.0_dp)
        do i = 1, 4
            call side_spline(side(i), i > 2, 1.0e-9_dp, spline(i), error)
        end do
    end function splines

end program test_ribbon
