!> Offset tables of bodies whose sections are circles: heights and half-breadths by Pythagoras.
program test_offsets
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_build, only: build_body
    use body_ledger, only: joint_type
    use cut_offsets, only: half_breadths, heights, offset_table_type
    use deck_job, only: job_type
    use support_job_deck, only: job_of
    use support_tap, only: tap_type
    implicit none (type, external)

    !> A cylinder of radius 5 from STA 0 to 20: two quarters, shoulders at (3, -4) and (3, 4)
    character(*), parameter :: cylinder = &
        'LINE,LCL,SIDE|STRAIGHT,0.,-5.,20.,-5.|LINE,UCL,SIDE|STRAIGHT,0.,5.,20.,5.|'// &
        'LINE,MHB,SIDE|STRAIGHT,0.,0.,20.,0.|LINE,MHB,PLAN|STRAIGHT,0.,5.,20.,5.|'// &
        'LINE,LSH,SIDE|STRAIGHT,0.,-4.,20.,-4.|LINE,LSH,PLAN|STRAIGHT,0.,3.,20.,3.|'// &
        'LINE,USH,SIDE|STRAIGHT,0.,4.,20.,4.|LINE,USH,PLAN|STRAIGHT,0.,3.,20.,3.|'// &
        'SECTION,LOWER,LCL,LSH,MHB,0.,999.999|SECTION,UPPER,MHB,USH,UCL,999.999,0.|'// &
        'STATION,10.|END'
    type(tap_type) :: tap
    type(job_type) :: job
    type(fault_list_type) :: faults
    type(body_type) :: body
    type(joint_type), allocatable :: joints(:)
    type(offset_table_type) :: table

    call job_of(cylinder, job, faults)
    call build_body(job, 1, body, joints, faults)
    call tap%ok(faults%count == 0, 'the cylinder is built')

    table = heights(body, [4.0_dp, 6.0_dp], [-1.0_dp, 0.0_dp, 10.0_dp])
    call tap%ok(size(table%rows) == 2, 'BL 4 is met below and above, BL 6 nowhere')
    if (size(table%rows) == 2) then
        call tap%near(table%rows(1)%figure(3), -3.0_dp, 1.0e-15_dp, 'below at WL -3')
        call tap%near(table%rows(2)%figure(3), 3.0_dp, 1.0e-15_dp, 'above at WL 3')
        call tap%ok(all(table%rows(1)%is_met .eqv. [.false., .true., .true.]), &
            'not before the body begins')
    end if
    table = half_breadths(body, [-3.0_dp, 0.0_dp], [10.0_dp])
    call tap%ok(size(table%rows) == 3, 'WL -3 is met once, WL 0 by both sections at their joint')
    if (size(table%rows) == 3) then
        call tap%near(table%rows(1)%figure(1), 4.0_dp, 1.0e-15_dp, 'at BL 4')
        call tap%near(table%rows(2)%figure(1), 5.0_dp, 0.0_dp, 'at BL 5')
    end if
    table = heights(body, [5.0_dp], [10.0_dp])
    call tap%ok(size(table%rows) == 2, 'the widest butt line touches each section once')
    call tap%finish()

end program test_offsets
