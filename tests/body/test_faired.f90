!> Faired lines beside their points: a straight line but for points without weight.
program test_faired
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_build, only: build_body
    use body_faired, only: faired_type, faired_views
    use body_ledger, only: joint_type
    use deck_job, only: job_type, view
    use support_job_deck, only: job_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(job_type) :: job
    type(fault_list_type) :: faults
    type(body_type) :: body
    type(joint_type), allocatable :: joints(:)
    type(faired_type), allocatable :: list(:)

    call job_of('LINE,A,SIDE,FAIR,2.|0,0|1,9.,0|2,4.|3,6.|LINE,B,SIDE,FAIR|0,0|LINE,C,SIDE,A|'// &
        'LINE,A,ANGLE,FAIR|0,0|5,45.|LINE,D,SIDE,SPLINE|0,0|1,1', job, faults)
    call build_body(job, 1, body, joints, faults)
    allocate (list(0))
    list = faired_views(job%body(1), body%lines)
    call tap%ok(size(list) == 2, 'what was faired itself, and could be, is listed')
    call tap%ok(all(list%line == 'A') .and. all(list%view == [view%side, view%angle]), &
        'by lines and views')
    associate (point => list(1)%point)
        call tap%near(maxval(abs(point%faired - [0.0_dp, 2.0_dp, 4.0_dp, 6.0_dp])), 0.0_dp, &
            1.0e-14_dp, 'the line at the stations of the points')
        call tap%ok(all(point%sta == [0.0_dp, 1.0_dp, 2.0_dp, 3.0_dp]) .and. &
            all(point%measured == [0.0_dp, 9.0_dp, 4.0_dp, 6.0_dp]), 'the points as measured')
        call tap%ok(all(point%weight == [2.0_dp, 0.0_dp, 2.0_dp, 2.0_dp]), 'their weights')
        call tap%ok(all(point%is_held .eqv. [.true., .false., .false., .true.]), 'the ends')
        call tap%ok(all(point%is_on), 'the line is at all of them')
    end associate
    call tap%ok(size(joints) == 0, 'nothing of it is in the ledger')
    call tap%finish()

end program test_faired
