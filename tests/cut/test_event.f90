!> What happens to cuts of an ellipsoid of semi-axes 5, 2, 1 on the way along STA.
program test_event
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_event, only: event_type, events_between, happening
    use cut_plane, only: buttock_plane, waterline_plane
    use support_bodies, only: ellipsoid
    use support_cutting, only: plane_of
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: ends(2) = [-5.0_dp, 5.0_dp]
    type(tap_type) :: tap
    type(body_type) :: body
    type(event_type), allocatable :: events(:)
    logical :: lies(2)

    body = ellipsoid([5.0_dp, 2.0_dp, 1.0_dp], 0.0_dp, 0.0_dp)
    call events_between(body, 1, buttock_plane(1.6_dp), ends, events, lies)
    call tap%ok(.not. any(lies), 'no edge lies in a buttock to starboard')
    call tap%ok(size(events) == 4, 'which the greatest breadth passes twice')
    call tap%near(maxval(abs(events%sta - [-5.0_dp, -3.0_dp, 3.0_dp, 5.0_dp])), 0.0_dp, &
        1.0e-15_dp, &
        'at stations -3 and 3')
    call tap%ok(all(events%kind == [happening%nothing, happening%finish, happening%finish, &
        happening%nothing]), 'with the finish line of the lower section')
    call events_between(body, 1, buttock_plane(0.0_dp), ends, events, lies)
    call tap%ok(all(lies .eqv. [.true., .false.]), 'the keel lies in the plane of symmetry')
    call events_between(body, 2, waterline_plane(0.6_dp), ends, events, lies)
    call tap%near(maxval(abs(events(2:3)%sta - [-4.0_dp, 4.0_dp])), 0.0_dp, 1.0e-15_dp, &
        'the crown passes a waterline at -4 and 4')
    call events_between(body, 2, plane_of([0.0_dp, 1.2_dp, 0.8_dp], [0.0_dp, 0.3_dp, 0.8_dp]), &
        ends, events, lies)
    call tap%ok(any(events%kind == happening%turn), 'a plane that touches turns there')
    call events_between(body, 2, plane_of([3.0_dp, 0.95_dp, 0.6_dp], [0.0_dp, 0.3_dp, 0.8_dp]), &
        ends, events, lies)
    call tap%ok(count(events%kind == happening%turn) == 2, &
        'one that cuts off an island turns twice')
    call tap%finish()
end program test_event
