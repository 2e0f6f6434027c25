!> Goals of measures: which of them are aims.
program test_sweep
    use deck_sweep, only: goal, has_aim, wanted_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call tap%ok(has_aim(wanted_type(goal=goal%least)), 'MIN is an aim')
    call tap%ok(has_aim(wanted_type(goal=goal%most)), 'MAX is an aim')
    call tap%ok(has_aim(wanted_type(goal=goal%near)), 'NEAR is an aim')
    call tap%ok(.not. has_aim(wanted_type(goal=goal%show)), 'SHOW is none')
    call tap%ok(.not. has_aim(wanted_type(goal=goal%range)), 'a limit is none')
    call tap%finish()

end program test_sweep
