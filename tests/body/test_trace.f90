!> Arcs of sections at a station as curves.
program test_trace
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_trace, only: arcs_at, trace_type
    use deck_job, only: job_type
    use support_pipe, only: pipe_body
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(job_type) :: job
    type(body_type) :: body
    type(fault_list_type) :: faults
    type(trace_type), allocatable :: traces(:)
    real(dp) :: at(3)

    call pipe_body('STATION,1', job, body, faults)
    allocate (traces(0))
    traces = arcs_at(body, 7.0_dp)
    call tap%ok(size(traces) == 1, 'a section has an arc')
    if (size(traces) == 1) then
        at = traces(1)%side%at(0.3_dp)
        call tap%near(at(1), 7.0_dp, 0.0_dp, 'at its station')
        call tap%near(norm2(at(2:)), 10.0_dp, 4.0e-15_dp, 'on the cylinder')
        call tap%ok(traces(1)%section == 1 .and. traces(1)%cut == 0, 'whose it is')
    end if
    traces = arcs_at(body, 41.0_dp)
    call tap%ok(size(traces) == 0, 'beyond the section there is none')
    call tap%finish()
end program test_trace
