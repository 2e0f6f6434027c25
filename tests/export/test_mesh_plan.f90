!> Tests of where rows and columns are.
program test_mesh_plan
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use export_mesh_density, only: density_type, find_density
    use export_mesh_plan, only: new_plan, plan_type, station_plan
    use support_bodies, only: ellipsoid
    use support_cylinders, only: cylinders
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(density_type) :: density
    type(plan_type) :: plan, finer
    type(error_type), allocatable :: error
    integer :: i

    body = ellipsoid([50.0_dp, 50.0_dp, 50.0_dp], 50.0_dp, 0.0_dp)
    call find_density(body, density, error)
    call new_plan(density, 0.1_dp, 90.0_dp, .true., plan, error)
    ! pi sqrt(50/8/.05) is 35.1: a chord of h radians is 50 h**2/8 off, .05 is half of what is
    ! asked.
    call tap%ok(size(plan%runs(1)%u) == 37, 'a sphere has 36 steps along')
    call tap%ok(size(plan%columns(1)%share) == 19, 'and 18 in a quarter around')
    call tap%near(plan%columns(2)%share(7), 1.0_dp/3.0_dp, 1.0e-12_dp, 'in equal shares')
    call tap%near(plan%runs(1)%sta(1) + plan%runs(1)%sta(37), 100.0_dp, 0.0_dp, &
        'from end to end exactly')
    call tap%near(plan%runs(1)%sta(19), 50.0_dp, 1.0e-12_dp, 'the middle row is in the middle')
    call tap%near(plan%runs(1)%sta(2), 100.0_dp*sin(acos(-1.0_dp)/72.0_dp)**2, 1.0e-9_dp, &
        'rows are close together at a blunt end')
    call new_plan(density, 0.025_dp, 90.0_dp, .true., finer, error)
    call tap%ok(size(finer%runs(1)%u) == 72, 'a quarter of the tolerance is twice the steps')
    call new_plan(density, 10.0_dp, 5.0_dp, .true., finer, error)
    call tap%ok(size(finer%columns(1)%share) == 19 .and. size(finer%runs(1)%u) == 37, &
        'an angle of 5 degrees is 36 and 18 steps')
    call new_plan(density, 1000.0_dp, 180.0_dp, .true., finer, error)
    call tap%ok(size(finer%columns(1)%share) == 3 .and. size(finer%runs(1)%u) == 3, &
        'there are never fewer than two')
    call new_plan(density, 1.0e-6_dp, 90.0_dp, .true., finer, error)
    call tap%ok(allocated(error), 'too many triangles are refused')
    call tap%ok(error%cause == cause%too_many, 'as such')
    call tap%has(error%message, 'no more than 4000000;', 'with the limit')

    call station_plan(density, 0.1_dp, 90.0_dp, [80.0_dp, 20.0_dp, 50.0_dp, 20.0_dp, 100.0_dp, &
        -3.0_dp, 120.0_dp], plan)
    call tap%ok(size(plan%runs(1)%sta) == 5, 'stations that are given, each once, and the ends')
    call tap%near(maxval(abs(plan%runs(1)%sta - [0.0_dp, 20.0_dp, 50.0_dp, 80.0_dp, 100.0_dp])), &
        0.0_dp, 0.0_dp, 'in order')
    call tap%near(maxval(abs(100.0_dp*sin(acos(0.0_dp)*plan%runs(1)%u)**2 - plan%runs(1)%sta)), &
        0.0_dp, 1.0e-13_dp, 'their parameters are found')
    call tap%ok(size(plan%columns(1)%share) == 19, 'columns are as for the tolerance')

    body = cylinders([50.0_dp, 50.0_dp], [30.0_dp, 30.0_dp], 0.0_dp)
    call find_density(body, density, error)
    call new_plan(density, 0.1_dp, 90.0_dp, .true., plan, error)
    call tap%ok(all([(size(plan%runs(i)%u), i=1, 2)] == 3), 'a cylinder has no more rows than two')
    call tap%ok(size(plan%columns(1)%share) > size(plan%columns(3)%share), &
        'a larger section has more columns')
    call tap%near(plan%runs(2)%sta(1), plan%runs(1)%sta(3), 0.0_dp, 'runs are end to end')
    call tap%finish()
end program test_mesh_plan
