!> From the cut cards of a job to the cuts asked of a body: where deck and cut layers meet. A
!> stepped STATION card asks for one cut a station.
module api_requests
    use base_decimal, only: decimal_type, grid_type, new_grid, to_real
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp, i64
    use cut_plane, only: buttock_plane, oblique_plane, plane_through, plane_type, station_plane, &
        waterline_plane
    use cut_request, only: limit_type, request_type
    use deck_body_card, only: blame
    use deck_job, only: cut, cut_real, cut_type, range_type, rule
    implicit none (type, external)
    private

    public :: requests_of

contains

    !> The cuts that a card asks for. None where the card can't be met, which is a fault on it.
    subroutine requests_of(card, requests, faults)
        type(cut_type), intent(in) :: card                          !! a cut card of a job
        type(request_type), allocatable, intent(out) :: requests(:) !! in the order of the card
        type(fault_list_type), intent(inout) :: faults              !! what is wrong is added
        type(request_type) :: request
        type(error_type), allocatable :: error
        real(dp), allocatable :: stations(:)
        integer :: i

        call common_part(card, request, error)
        if (allocated(error)) then
            allocate (requests(0))
            call blame(card%card, 2, error%message, faults)
            return
        end if
        select case (card%kind)
        case (cut%station)
            call stations_of(card, stations, faults)
            allocate (requests(size(stations)), source=request)
            do i = 1, size(stations)
                requests(i)%plane = station_plane(stations(i))
            end do
            return
        case (cut%buttock)
            request%plane = buttock_plane(cut_real(card, 1))
        case (cut%waterline)
            request%plane = waterline_plane(cut_real(card, 1))
        case (cut%oblique)
            call oblique_plane(cut_real(card, [1, 2]), cut_real(card, [3, 4]), request%plane, error)
        case (cut%plane)
            call plane_through(cut_real(card, [1, 2, 3]), cut_real(card, [4, 5, 6]), &
                request%plane, error)
        end select
        if (allocated(error)) then
            allocate (requests(0))
            call blame(card%card, 2, error%message, faults)
        else
            allocate (requests(1), source=request)
        end if
    end subroutine requests_of

    !> What does not depend on the kind of cut: limits, spread of points, flange, skin.
    subroutine common_part(card, request, error)
        type(cut_type), intent(in) :: card                  !! a cut card
        type(request_type), intent(out) :: request          !! all but the plane
        type(error_type), allocatable, intent(out) :: error !! the step can't be worked
        integer :: i

        request%name = card%name
        do i = 1, size(request%limit)
            request%limit(i) = limit_of(card%limit(i))
        end do
        request%rule = card%points%kind
        request%axis = card%points%axis
        request%number = card%points%number
        request%step = to_real(card%points%step)
        request%is_flange_forward = card%is_flange_forward
        request%skin = to_real(card%skin)
        request%arcs = to_real(card%arcs)
        if (card%points%kind == rule%step) then
            call new_grid(card%points%start, card%points%step, request%grid, error)
        end if
    end subroutine common_part

    !> A range of a card with its ends in order.
    pure type(limit_type) function limit_of(range) result(limit)
        type(range_type), intent(in) :: range !! FROM may be above TO
        real(dp) :: from, to

        from = to_real(range%from)
        to = to_real(range%to)
        limit = limit_type(range%has_from, range%has_to, from, to)
        if (range%has_from .and. range%has_to .and. from > to) then
            limit = limit_type(.true., .true., to, from)
        end if
    end function limit_of

    !> The stations of a STATION card: its list, or its steps with both ends. The reader of the deck
    !> has seen to their number.
    subroutine stations_of(card, stations, faults)
        type(cut_type), intent(in) :: card                  !! a STATION card
        real(dp), allocatable, intent(out) :: stations(:)   !! deck units, in the card's order
        type(fault_list_type), intent(inout) :: faults      !! what is wrong is added
        type(grid_type) :: grid
        type(error_type), allocatable :: error
        integer(i64) :: k, last

        allocate (stations(0))
        if (.not. card%is_stepped) then
            stations = to_real(card%value)
            return
        end if
        call new_grid(card%value(1), card%value(3), grid, error)
        if (allocated(error)) then
            call blame(card%card, 4, error%message, faults)
            return
        end if
        last = nint(grid%steps_to(cut_real(card, 2)), i64)
        do while ((cut_real(card, 2) - grid%ordinate(last))*cut_real(card, 3) <= 0.0_dp)
            last = last - 1
        end do
        stations = [(grid%ordinate(k), k = 0, last), cut_real(card, 2)]
    end subroutine stations_of

end module api_requests
