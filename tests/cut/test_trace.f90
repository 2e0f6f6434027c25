!> What planes take from a cylinder and from an ellipsoid of revolution, as curves: also where they
!> turn back in STA.
program test_trace
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_trace, only: trace_type
    use cut_plane, only: buttock_plane, plane_through, plane_type, station_plane, waterline_plane
    use cut_request, only: request_type
    use cut_trace, only: traces_of
    use base_error, only: error_type
    use deck_job, only: job_type
    use support_pipe, only: pipe_body
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(job_type) :: job
    type(body_type) :: body
    type(fault_list_type) :: faults
    type(request_type) :: request
    type(error_type), allocatable :: error

    call pipe_body('STATION,1', job, body, faults)
    request%plane = waterline_plane(6.0_dp)
    call prove('a waterline', [0.0_dp, 8.0_dp, 6.0_dp], [40.0_dp, 8.0_dp, 6.0_dp])
    request%limit(1)%has_from = .true.
    request%limit(1)%from = 15.0_dp
    call prove('a waterline within limits', [15.0_dp, 8.0_dp, 6.0_dp], [40.0_dp, 8.0_dp, 6.0_dp])
    request%limit(1)%has_from = .false.
    request%plane = station_plane(12.0_dp)
    call prove('a station', [12.0_dp, 0.0_dp, 10.0_dp], [12.0_dp, 10.0_dp, 0.0_dp])
    request%plane = buttock_plane(11.0_dp)
    call tap%ok(size(traces_of(body, request)) == 0, 'a buttock beside it is nothing')
    ! STA = 20 + (BL + WL)/2 on the quarter circle: 25 at its ends, 27.07 where it turns back.
    call plane_through([20.0_dp, 0.0_dp, 0.0_dp], [2.0_dp, -1.0_dp, -1.0_dp], request%plane, error)
    call prove('a plane whose cut turns back', [25.0_dp, 0.0_dp, 10.0_dp], &
        [25.0_dp, 10.0_dp, 0.0_dp])
    call tap%finish()

contains

    !> One curve on plane and cylinder, between two points in either order.
    subroutine prove(name, first, last)
        character(*), intent(in) :: name        !! of the checks
        real(dp), intent(in) :: first(3)        !! STA, BL, WL
        real(dp), intent(in) :: last(3)         !! STA, BL, WL
        type(trace_type), allocatable :: traces(:)
        real(dp) :: at(3), ends(3, 2), off, step, before(3), longest
        integer :: i

        allocate (traces(0))
        traces = traces_of(body, request)
        call tap%ok(size(traces) == 1, name//' is one curve')
        if (size(traces) /= 1) return
        ends(:, 1) = traces(1)%side%at(0.0_dp)
        ends(:, 2) = traces(1)%side%at(1.0_dp)
        if (norm2(ends(:, 1) - first) > norm2(ends(:, 2) - first)) ends = ends(:, 2:1:-1)
        call tap%near(max(norm2(ends(:, 1) - first), norm2(ends(:, 2) - last)), 0.0_dp, &
            1.0e-11_dp, name//': its ends')
        off = 0.0_dp
        longest = 0.0_dp
        before = traces(1)%side%at(0.0_dp)
        do i = 1, 400
            at = traces(1)%side%at(real(i, dp)/400.0_dp)
            off = max(off, abs(norm2(at(2:)) - 10.0_dp), abs(dot_product(request%plane%normal, &
                at - request%plane%through)))
            step = norm2(at - before)
            longest = max(longest, step)
            before = at
        end do
        call tap%near(off, 0.0_dp, 1.0e-8_dp, name//' is on plane and cylinder')
        call tap%ok(longest < 0.5_dp, name//' goes on without a jump')
    end subroutine prove

end program test_trace
