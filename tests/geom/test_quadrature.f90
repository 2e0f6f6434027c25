!> Integrals in closed form, easy and hard.
program test_quadrature
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_quadrature, only: integrate
    use support_integrands, only: example_type, exponential, peak, power_22, reciprocal, root
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(error_type), allocatable :: error
    real(dp) :: value

    call check(power_22, 0.0_dp, 1.0_dp, 1.0_dp/23.0_dp, &
        'x**22, which the rule of 15 points has exactly')
    call check(exponential, 0.0_dp, 1.0_dp, exp(1.0_dp) - 1.0_dp, 'exp x')
    call check(peak, -1.0_dp, 1.0_dp, 2.0e4_dp*atan(1.0e4_dp), 'a peak a ten-thousandth wide')
    call check(root, 0.0_dp, 1.0_dp, 2.0_dp/3.0_dp, 'the square root, steep at its end')
    call check(exponential, 1.0_dp, 0.0_dp, 1.0_dp - exp(1.0_dp), 'backwards, with the other sign')
    call check(exponential, 0.5_dp, 0.5_dp, 0.0_dp, 'over nothing')
    call integrate(example_type(reciprocal), 0.0_dp, 1.0_dp, 1.0e-11_dp, value, error)
    call tap%ok(allocated(error), 'an integral that does not exist is refused')
    call tap%ok(error%cause == cause%no_convergence, '... for not converging')
    call tap%ok(index(error%message, 'uncertain by') > 0, '... and says how uncertain it is')
    call tap%finish()

contains

    !> Checks an integral.
    subroutine check(which, from, to, expected, name)
        integer, intent(in) :: which
        real(dp), intent(in) :: from, to, expected
        character(*), intent(in) :: name
        call integrate(example_type(which), from, to, 1.0e-11_dp, value, error)
        if (allocated(error)) call tap%note(error%message)
        call tap%ok(.not. allocated(error), 'converges: '//name)
        call tap%near(value, expected, 1.0e-12_dp*abs(expected), name)
    end subroutine check

end program test_quadrature
