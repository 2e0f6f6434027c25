!> From the cut cards that are sides of patches to curves on the skin.
module api_traces
    use api_requests, only: requests_of
    use base_fault, only: fault_list_type
    use body_body, only: body_type
    use body_trace, only: trace_type
    use cut_request, only: request_type
    use cut_trace, only: traces_of
    use deck_job, only: asked_body_type => body_type
    implicit none (type, external)
    private

    public :: traces_of_sides

contains

    !> The curves of the cuts that are sides of patches. What is wrong with a cut is said where it
    !> is made.
    function traces_of_sides(asked, body) result(traces)
        type(asked_body_type), intent(in) :: asked  !! as the deck has it
        type(body_type), intent(in) :: body         !! as built
        type(trace_type), allocatable :: traces(:), more(:)
        type(request_type), allocatable :: requests(:)
        type(fault_list_type) :: known
        integer :: i, k

        allocate (traces(0), more(0))
        do i = 1, size(asked%cut)
            if (.not. any([(any(asked%patch(k)%side%cut == i), k = 1, size(asked%patch))])) cycle
            call requests_of(asked%cut(i), requests, known)
            if (size(requests) /= 1) cycle
            more = traces_of(body, requests(1))
            more%cut = i
            traces = [traces, more]
        end do
    end function traces_of_sides

end module api_traces
