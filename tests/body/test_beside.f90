!> What lies beside sides on a cylinder, and its normals.
program test_beside
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_beside, only: beside_type, find_edge, find_skin, is_in_mirror, neighbour, normal_beside
    use body_body, only: body_type
    use body_panel, only: panel_type
    use body_panel_side, only: line_side, side_type
    use deck_job, only: job_type
    use support_pipe, only: pipe_body
    use support_saddle, only: saddle, saddle_sides
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(job_type) :: job
    type(body_type) :: body
    type(fault_list_type) :: faults
    type(beside_type) :: beside
    type(error_type), allocatable :: error
    type(side_type) :: side, sides(4)
    type(panel_type) :: panel
    real(dp) :: normal(3), off
    integer :: i

    call pipe_body('STATION,1', job, body, faults)
    side = line_side(body%lines(3), 5.0_dp, 35.0_dp)
    call find_skin(body, side, 1.0e-3_dp, beside, error)
    call tap%ok(beside%kind == neighbour%skin .and. beside%name == 'TOP', &
        'a line of shoulder points lies on the skin')
    normal = normal_beside(beside, side%at(0.2_dp), [1.0_dp, 0.0_dp, 0.0_dp], 0.2_dp)
    call tap%near(norm2(normal - [0.0_dp, 0.6_dp, 0.8_dp]), 0.0_dp, 1.0e-15_dp, &
        'and has its normal')
    ! A point near the skin has the normal of the place of its shares.
    normal = normal_beside(beside, [9.0_dp, 8.0_dp, 6.0_dp], [1.0_dp, 0.0_dp, 0.0_dp], 0.0_dp)
    call tap%near(norm2(normal - [0.0_dp, 0.8_dp, 0.6_dp]), 0.0_dp, 1.0e-14_dp, &
        'as any other point')
    side = line_side(body%lines(2), 5.0_dp, 35.0_dp)
    call find_skin(body, side, 1.0e-3_dp, beside, error)
    normal = normal_beside(beside, side%at(0.5_dp), [1.0_dp, 0.0_dp, 0.0_dp], 0.5_dp)
    call tap%near(norm2(normal - [0.0_dp, 1.0_dp, 0.0_dp]), 0.0_dp, 1.0e-15_dp, &
        'where the section ends too')
    body%lines(3)%plan = body%lines(2)%plan
    side = line_side(body%lines(3), 5.0_dp, 35.0_dp)
    call pipe_body('STATION,1', job, body, faults)
    call find_skin(body, side, 1.0e-3_dp, beside, error)
    call tap%ok(beside%kind == neighbour%none, 'a line beside the skin has none')
    call tap%ok(.not. is_in_mirror(side, 1.0e-3_dp), 'and is not in BL 0')
    call tap%ok(is_in_mirror(line_side(body%lines(1), 0.0_dp, 40.0_dp), 1.0e-3_dp), &
        'as a line without a plan is')
    beside%kind = neighbour%mirror
    normal = normal_beside(beside, [0.0_dp, 0.0_dp, 0.0_dp], [3.0_dp, 0.0_dp, 4.0_dp], 0.0_dp)
    call tap%near(norm2(normal - [-0.8_dp, 0.0_dp, 0.6_dp]), 0.0_dp, 1.0e-15_dp, &
        'the image has a normal in BL 0')
    panel = saddle()
    sides = saddle_sides()
    off = 0.0_dp
    do i = 1, 4
        beside = beside_type()
        call find_edge(panel%surface, panel%outward, sides(i), 1.0e-6_dp, beside)
        call tap%ok(beside%kind == neighbour%panel .and. beside%edge%number == i .and. &
            .not. beside%edge%is_against, 'a side is found on a panel')
        associate (at => sides(i)%at(0.3_dp))
            normal = [-0.04_dp*at(2), -0.04_dp*at(1), 1.0_dp]
            off = max(off, norm2(normal/norm2(normal) - normal_beside(beside, at, &
                [1.0_dp, 0.0_dp, 0.0_dp], 0.3_dp)))
        end associate
    end do
    call tap%near(off, 0.0_dp, 1.0e-14_dp, 'with the normals of the saddle')
    call tap%finish()
end program test_beside
