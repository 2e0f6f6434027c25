!> Sides between lines and stations, on a cylinder.
program test_whole_sides
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_panel_side, only: side_type
    use body_whole_sides, only: whole_sides
    use deck_job, only: job_type
    use support_pipe, only: pipe_body
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(job_type) :: job
    type(body_type) :: body
    type(fault_list_type) :: faults
    type(side_type) :: side(4)
    type(error_type), allocatable :: error

    call pipe_body('PATCH,P,10,UCL,30,MHB|PATCH,Q,10,UCL,30,SHO', job, body, faults)
    call whole_sides(job%body(1)%patch(1), body, 1.0e-3_dp, side, error)
    call tap%ok(.not. allocated(error), 'sides between a section''s own lines')
    call tap%near(norm2(side(1)%at(0.0_dp) - [10.0_dp, 10.0_dp, 0.0_dp]), 0.0_dp, 0.0_dp, &
        'the arc is turned as it is run through')
    call tap%near(norm2(side(2)%at(1.0_dp) - [30.0_dp, 0.0_dp, 10.0_dp]), 0.0_dp, 0.0_dp, &
        'a line ends at the station')
    call tap%ok(side(1)%is_arc .and. .not. side(2)%is_arc, 'arcs and lines')
    call whole_sides(job%body(1)%patch(2), body, 1.0e-3_dp, side, error)
    call tap%ok(allocated(error), 'between other lines no section goes')
    if (allocated(error)) call tap%has(error%message, &
        'no section goes from line SHO to UCL at station 10.', 'which is told')
    call tap%finish()
end program test_whole_sides
