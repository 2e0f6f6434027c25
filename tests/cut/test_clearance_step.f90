!> Steps on a paraboloid p = (u, t, (u**2 + 2 t**2)/2), worked by hand.
program test_clearance_step
    use base_kinds, only: dp
    use cut_clearance_step, only: step_towards
    use cut_measure_sheet, only: spot_type
    use support_tap, only: tap_type
    implicit none (type, external)

    logical, parameter :: out(3) = .true., free(2) = .true.
    type(tap_type) :: tap
    type(spot_type) :: spot

    spot = spot_at(0.0_dp, 0.0_dp)
    call check(step_towards(spot, spot%at - [0.3_dp, 0.2_dp, -1.0_dp], out, free, free), &
        [0.15_dp, 0.2_dp/3.0_dp], 'from below: the way over 1 + distance times curvature')
    call check(step_towards(spot, spot%at - [0.3_dp, 0.2_dp, 0.25_dp], out, free, free), &
        [0.4_dp, 0.4_dp], 'from within: over 1 - distance times curvature')
    call check(step_towards(spot, spot%at - [0.3_dp, 0.0_dp, 2.0_dp], out, free, free), &
        [0.1_dp, 0.0_dp], 'beyond the centres of curvature: downwards all the same')
    call check(step_towards(spot, spot%at - [0.3_dp, 0.2_dp, -1.0_dp], out, free, &
        [.false., .true.]), [0.0_dp, 0.2_dp/3.0_dp], 'u is held at its upper bound')
    call check(step_towards(spot, spot%at - [-0.3_dp, 0.2_dp, -1.0_dp], out, free, &
        [.false., .true.]), [-0.15_dp, 0.2_dp/3.0_dp], 'but not where it leads away from it')
    call check(step_towards(spot, spot%at - [-0.3_dp, -0.2_dp, -1.0_dp], out, [.true., .false.], &
        free), [-0.15_dp, 0.0_dp], 't is held at its lower bound')
    call check(step_towards(spot, spot%at - [-0.3_dp, -0.2_dp, -1.0_dp], out, .not. free, &
        .not. free), [0.0_dp, 0.0_dp], 'nothing is free')
    spot = spot_at(0.5_dp, 0.0_dp)
    call check(step_towards(spot, [0.0_dp, 0.0_dp, 1.0_dp], [.false., .false., .true.], free, &
        free), [-0.4_dp, 0.0_dp], 'above a level face: .5/(.5**2 + 1)')
    call tap%finish()

contains

    !> A point of the paraboloid.
    type(spot_type) function spot_at(u, t) result(spot)
        real(dp), intent(in) :: u, t
        spot%at = [u, t, 0.5_dp*u**2 + t**2]
        spot%u = [1.0_dp, 0.0_dp, u]
        spot%t = [0.0_dp, 1.0_dp, 2.0_dp*t]
        spot%uu = [0.0_dp, 0.0_dp, 1.0_dp]
        spot%tt = [0.0_dp, 0.0_dp, 2.0_dp]
    end function spot_at

    !> Checks a step.
    subroutine check(step, expected, name)
        real(dp), intent(in) :: step(2), expected(2)
        character(*), intent(in) :: name
        call tap%near(maxval(abs(step - expected)), 0.0_dp, 1.0e-14_dp, name)
    end subroutine check

end program test_clearance_step
