!> Several integrals at once: exact ones, rough ones, and such as do not exist.
program test_integral_set
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_integral_set, only: estimate_type, integrate_set
    use support_families, only: pole_type, powers_type, rough_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(estimate_type) :: estimate
    type(error_type), allocatable :: error
    real(dp) :: expected(3), worst
    integer :: i

    call integrate_set(powers_type(number=16), 0.0_dp, 2.0_dp, 1.0e-3_dp, estimate, error)
    worst = maxval([(abs(estimate%value(i + 1)*real(i + 1, dp)/2.0_dp**(i + 1) - 1.0_dp), i=0, 15)])
    call tap%ok(.not. allocated(error), 'powers have integrals')
    call tap%near(worst, 0.0_dp, 1.0e-14_dp, 'those of powers up to the 15th are exact at once')

    expected = [0.0_dp, 2.0_dp/3.0_dp*((4.0_dp/3.0_dp)**1.5_dp + (2.0_dp/3.0_dp)**1.5_dp), &
        0.4_dp*atan(5.0_dp)]
    call integrate_set(rough_type(number=3), -1.0_dp, 1.0_dp, 1.0e-11_dp, estimate, error)
    call tap%ok(.not. allocated(error), 'a root and a sine have integrals')
    call tap%near(maxval(abs(estimate%value - expected)), 0.0_dp, 1.0e-11_dp, 'to their tolerance')
    call tap%ok(all(abs(estimate%value - expected) <= estimate%error), 'the estimates hold')
    call tap%ok(all(estimate%error <= 1.0e-11_dp*estimate%magnitude), 'and are as asked')
    call tap%near(estimate%magnitude(1), 2.0_dp*(1.0_dp - cos(1.0_dp)), 1.0e-3_dp, &
        'an odd function cancels, its magnitude does not')
    call integrate_set(rough_type(number=3), 1.0_dp, -1.0_dp, 1.0e-11_dp, estimate, error)
    call tap%near(maxval(abs(estimate%value + expected)), 0.0_dp, 1.0e-11_dp, 'backwards: negative')
    call integrate_set(rough_type(number=3), 0.5_dp, 0.5_dp, 1.0e-11_dp, estimate, error)
    call tap%ok(all(abs(estimate%value) <= 0.0_dp), 'nothing from a place to itself')

    call integrate_set(pole_type(number=1), 0.0_dp, 1.0_dp, 1.0e-11_dp, estimate, error)
    call tap%ok(allocated(error), '1/t from 0 has no integral')
    if (allocated(error)) call tap%ok(error%cause == cause%no_convergence, 'and that is the cause')
    call integrate_set(pole_type(number=1), 0.5_dp, 2.0_dp, 1.0e-11_dp, estimate, error)
    call tap%ok(allocated(error), 'where a value does not exist, nor does the integral')
    if (allocated(error)) call tap%same(error%message, 'beyond 1', &
        'and its own words are passed on')
    call tap%finish()

end program test_integral_set
