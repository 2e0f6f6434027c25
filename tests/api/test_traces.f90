!> Cuts that are sides of patches become curves; others do not.
program test_traces
    use api_traces, only: traces_of_sides
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_trace, only: trace_type
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

    call pipe_body('POINTS,NUMBER,5|BUTTOCK,1|BUTTOCK,2,,,,SPARE|WATERLN,6,,,,LOW|'// &
        'PATCH,P,10,UCL,20,LOW', job, body, faults)
    allocate (traces(0))
    traces = traces_of_sides(job%body(1), body)
    call tap%ok(size(traces) == 1, 'one cut is a side')
    if (size(traces) == 1) then
        call tap%ok(traces(1)%cut == 3, 'the third one')
        at = traces(1)%side%at(0.5_dp)
        call tap%near(norm2(at - [20.0_dp, 8.0_dp, 6.0_dp]), 0.0_dp, 1.0e-8_dp, 'its curve')
    end if
    call tap%finish()
end program test_traces
