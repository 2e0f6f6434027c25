!> Tests of the cuts of a lines plan: what is asked, round ones where that is little.
program test_plan_cuts
    use app_plan_cuts, only: closely, plan_cuts
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_outline, only: cut_type
    use cut_plane, only: buttock_plane, cut_kind, station_plane
    use cut_request, only: cut_rule, request_type
    use support_solids, only: ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(cut_type) :: asked(5)
    type(cut_type), allocatable :: cuts(:)
    type(request_type) :: request

    body = ellipsoid([50.0_dp, 30.0_dp, 20.0_dp])
    asked(1)%plane = station_plane(-7.0_dp)
    asked(2)%plane = station_plane(1.0_dp)
    asked(3)%plane = station_plane(1.0_dp)
    asked(4)%plane = station_plane(33.0_dp)
    asked(5)%plane = buttock_plane(9.0_dp)
    allocate (cuts, source=plan_cuts([body], asked))
    call tap%ok(all(abs(along(cut_kind%station) - [-7.0_dp, 1.0_dp, 33.0_dp]) <= 0.0_dp), &
        'three stations are enough, each once')
    call tap%ok(all(abs(along(cut_kind%buttock) - [9.0_dp, 5.0_dp, 15.0_dp, 20.0_dp, 25.0_dp]) &
        <= 1.0e-12_dp), 'one butt line is not: round ones join it, none too near')
    call tap%ok(all(abs(along(cut_kind%waterline) - [-10.0_dp, 0.0_dp, 10.0_dp]) <= 1.0e-12_dp), &
        'where none is asked all are round')
    deallocate (cuts)
    asked%plane = station_plane(80.0_dp)
    allocate (cuts, source=plan_cuts([body], asked))
    call tap%ok(.not. any(along(cut_kind%station) > 50.0_dp), 'a plane off the body gives no cut')
    request%number = 3
    request = closely(request, 200.0_dp)
    call tap%ok(request%rule == cut_rule%chord, 'points stand by the chord')
    call tap%near(request%step, 0.02_dp, 1.0e-15_dp, 'as near as a ten-thousandth of the body')
    call tap%finish()

contains

    !> Where the cuts of a kind are.
    function along(kind) result(ordinates)
        integer, intent(in) :: kind
        real(dp), allocatable :: ordinates(:)
        integer :: i
        allocate (ordinates(0))
        do i = 1, size(cuts)
            if (cuts(i)%plane%kind == kind) ordinates = [ordinates, cuts(i)%plane%through(kind)]
        end do
    end function along

end program test_plan_cuts
