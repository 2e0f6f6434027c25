!> Points at given lengths: along a parabola in closed form, where the speed is zero at the ends,
!> and round a corner.
program test_spacing
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_spacing, only: new_scale, parameters_at, scale_type
    use support_speeds, only: speed_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(scale_type) :: scale
    type(error_type), allocatable :: error
    real(dp) :: length(101), t(101)
    real(dp), parameter :: pi = acos(-1.0_dp)
    integer :: i

    call new_scale(speed_type(kind=1), [0.0_dp, 2.0_dp], 1.0e-13_dp, scale, error)
    call tap%near(scale%length, arc_of(2.0_dp), 1.0e-13_dp, 'the length of a parabola')
    length = [(scale%length*real(i, dp)/100.0_dp, i=0, 100)]
    call parameters_at(scale, length, t)
    call tap%near(maxval(abs(arc_of(t) - length)), 0.0_dp, 1.0e-12_dp, 'in equal parts')
    call tap%ok(t(1) >= 0.0_dp .and. t(101) <= 2.0_dp, 'none beyond an end')
    call new_scale(speed_type(kind=2), [0.0_dp, 1.0_dp], 1.0e-9_dp, scale, error)
    length = [(scale%length*real(i, dp)/100.0_dp, i=0, 100)]
    call parameters_at(scale, length, t)
    call tap%near(maxval(abs(0.5_dp*(1.0_dp - cos(pi*t)) - length)), 0.0_dp, 1.0e-8_dp, &
        'from rest to rest')
    call new_scale(speed_type(kind=3), [0.0_dp, 1.0_dp], 1.0e-6_dp, scale, error)
    call tap%ok(.not. allocated(error), 'a corner that is not told of')
    call tap%near(scale%length, 0.3_dp + 1.4_dp, 1.0e-5_dp, 'costs little')
    call new_scale(speed_type(kind=3), [0.0_dp, 0.3_dp, 1.0_dp], 1.0e-12_dp, scale, error)
    call tap%ok(size(scale%panels) == 2, 'one that is, nothing')
    call tap%finish()

contains

    !> The length of y = x**2 from 0 on.
    elemental real(dp) function arc_of(x)
        real(dp), intent(in) :: x
        arc_of = 0.5_dp*x*sqrt(1.0_dp + 4.0_dp*x**2) + 0.25_dp*asinh(2.0_dp*x)
    end function arc_of

end program test_spacing
