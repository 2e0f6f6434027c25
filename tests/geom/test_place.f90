!> Places on an arc.
program test_place
    use base_kinds, only: dp
    use geom_place, only: at_finish, at_shoulder, at_start, is_before, is_finish, is_start, &
        mirrored, &
        place_at, place_type
    use geom_twofold, only: twofold
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(place_type) :: near

    near = place_type(twofold(1.0_dp), twofold(1.0e-300_dp))
    call tap%ok(is_start(at_start) .and. .not. is_finish(at_start), 'the start is the start')
    call tap%ok(is_finish(at_finish) .and. .not. is_start(at_finish), 'the finish is the finish')
    call tap%ok(.not. is_start(at_shoulder) .and. .not. is_finish(at_shoulder), &
        'the shoulder is neither')
    call tap%ok(is_start(place_at(0.0_dp)) .and. is_finish(place_at(1.0_dp)), &
        'parameters 0 and 1 are the ends')
    call tap%ok(.not. is_start(near) .and. is_before(at_start, near), &
        'a place can be very near the start')
    call tap%ok(is_before(near, place_at(1.0e-10_dp)), 'and still nearer than another')
    call tap%ok(is_before(at_start, at_shoulder) .and. is_before(at_shoulder, at_finish), &
        'the shoulder is between the ends')
    call tap%ok(.not. is_before(place_at(0.5_dp), at_shoulder) .and. &
        .not. is_before(at_shoulder, place_at(0.5_dp)), 'parameter .5 is the shoulder')
    call tap%ok(is_finish(mirrored(at_start)), 'the start is the finish of the way back')
    call tap%finish()
end program test_place
