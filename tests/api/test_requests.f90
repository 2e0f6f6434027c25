!> From cut cards to cuts: stations stepped in decimals, limits in order, rules of points.
program test_requests
    use api_requests, only: requests_of
    use base_fault, only: fault_list_type
    use base_kinds, only: dp, i64
    use cut_plane, only: cut_kind
    use cut_request, only: cut_rule, request_type
    use deck_job, only: job_type
    use support_job_deck, only: body_text, job_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(request_type), allocatable :: requests(:)
    type(fault_list_type) :: faults

    call ask('STATION,0.,.5,.1')
    call tap%ok(stations_are([0.0_dp, 0.1_dp, 0.2_dp, 0.3_dp, 0.4_dp, 0.5_dp]), &
        'steps of .1 are the doubles nearest to the decimals')
    call ask('STATION,0.,1.,.3')
    call tap%ok(stations_are([0.0_dp, 0.3_dp, 0.6_dp, 0.9_dp, 1.0_dp]), &
        'the end is cut where no step meets it')
    call ask('STATION,1.,0.,-.5')
    call tap%ok(stations_are([1.0_dp, 0.5_dp, 0.0_dp]), 'steps may go forward')
    call ask('STATION,20.')
    call tap%ok(stations_are([20.0_dp]), 'one value is one station')
    call ask('STATION,LIST,3.,1.,2.')
    call tap%ok(stations_are([3.0_dp, 1.0_dp, 2.0_dp]), 'a list keeps its order')
    call tap%ok(requests(1)%rule == cut_rule%number .and. requests(1)%number == 25, &
        'a station has 25 points unless said')
    call ask('BUTTOCK,4.5,20.,0.,-5.')
    call tap%ok(size(requests) == 1, 'a buttock is one cut')
    if (size(requests) == 1) then
        call tap%ok(requests(1)%plane%kind == cut_kind%buttock, 'of its kind')
        call tap%near(requests(1)%plane%through(2), 4.5_dp, 0.0_dp, 'at its BL')
        call tap%ok(requests(1)%limit(1)%has_from .and. requests(1)%limit(1)%from < 1.0_dp .and. &
            requests(1)%limit(1)%to > 19.0_dp, 'a range is put in order')
        call tap%near(requests(1)%grid%ordinate(1_i64), 15.0_dp, 0.0_dp, 'and stepped as asked')
    end if
    call ask('OBLIQUE,20.,-16.,30.,-6.,2.5')
    call tap%ok(size(requests) == 1, 'an oblique frame is one cut')
    call ask('PLANE,1.,2.,3.,1.,1.,1.')
    if (size(requests) == 1) call tap%near(dot_product(requests(1)%plane%normal, &
        requests(1)%plane%through), 6.0_dp, 1.0e-15_dp, 'a plane has its point and normal')
    call tap%finish()

contains

    !> Asks for the cuts of one card behind a body.
    subroutine ask(card)
        character(*), intent(in) :: card !! a cut card, free-field
        type(job_type) :: job
        call job_of(body_text//card//'|END', job, faults)
        call requests_of(job%body(1)%cut(1), requests, faults)
    end subroutine ask

    !> True where the cuts are these stations, exactly.
    logical function stations_are(expected)
        real(dp), intent(in) :: expected(:) !! deck units, in order
        integer :: i
        stations_are = size(requests) == size(expected)
        if (.not. stations_are) return
        do i = 1, size(expected)
            stations_are = stations_are .and. requests(i)%plane%kind == cut_kind%station .and. &
                requests(i)%plane%through(1) == expected(i)
        end do
    end function stations_are

end program test_requests
