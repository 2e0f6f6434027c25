!> Tests of fair parts of arcs: closed forms of circle, parabola and hyperbola.
program test_mesh_share
    use base_constants, only: pi
    use base_kinds, only: dp
    use export_mesh_share, only: pace_at, parameter_at
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    real(dp), parameter :: s(5) = [0.0_dp, 0.2_dp, 0.5_dp, 0.85_dp, 1.0_dp]
    real(dp), parameter :: weights(5) = [-0.5_dp, 0.3_dp, 0.999_dp, 1.0_dp, 5.0_dp]
    real(dp) :: worst, half, t, p(2), step
    integer :: i, k

    worst = 0.0_dp
    do k = 1, 17
        half = real(k, dp)*pi/18.0_dp
        do i = 1, size(s)
            t = parameter_at(s(i), cos(half))
            p = on_circle(t, half)
            worst = max(worst, abs(atan2(p(2), p(1)) - (2.0_dp*s(i) - 1.0_dp)*half))
        end do
    end do
    call tap%near(worst, 0.0_dp, 2.0e-14_dp, 'a circle is divided into equal turns')
    call tap%near(maxval(abs(parameter_at(s, 1.0_dp) - s)), 0.0_dp, 0.0_dp, &
        'a parabola into equal parts of its parameter')
    worst = 0.0_dp
    do i = 1, size(s)
        t = parameter_at(s(i), cosh(2.0_dp))
        worst = max(worst, abs(on_hyperbola(t, 2.0_dp) - (2.0_dp*s(i) - 1.0_dp)*2.0_dp))
    end do
    call tap%near(worst, 0.0_dp, 2.0e-14_dp, 'a hyperbola into equal steps of its angle')
    call tap%ok(all(abs(parameter_at(0.0_dp, [-0.9_dp, 0.0_dp, 0.5_dp, 1.0_dp, 40.0_dp])) <= &
        0.0_dp), 'a share of 0 is the start')
    call tap%ok(all(abs(parameter_at(1.0_dp, [-0.9_dp, 0.0_dp, 0.5_dp, 1.0_dp, 40.0_dp]) &
        - 1.0_dp) <= 0.0_dp), 'a share of 1 is the finish')
    call tap%near(maxval(abs(parameter_at(s, 1.0_dp + 1.0e-11_dp) - s)) &
        + maxval(abs(parameter_at(s, 1.0_dp - 1.0e-11_dp) - s)), 0.0_dp, 1.0e-10_dp, &
        'beside a parabola it is nearly one')
    worst = 0.0_dp
    step = 1.0e-6_dp
    do k = 1, 5
        do i = 2, 4
            t = (parameter_at(s(i) + step, weights(k)) - parameter_at(s(i) - step, weights(k))) &
                /(2.0_dp*step)
            worst = max(worst, abs(pace_at(s(i), weights(k)) - t))
        end do
    end do
    call tap%near(worst, 0.0_dp, 1.0e-9_dp, 'the pace is the derivative')
    call tap%finish()

contains

    !> A point of the circle of radius 1 from -half to half, as a rational quadratic.
    function on_circle(t, half) result(p)
        real(dp), intent(in) :: t, half
        real(dp) :: p(2), b(3)
        b = [(1.0_dp - t)**2, 2.0_dp*t*(1.0_dp - t)*cos(half), t**2]
        p = [b(1)*cos(half) + 2.0_dp*t*(1.0_dp - t) + b(3)*cos(half), (b(3) - b(1))*sin(half)] &
            /sum(b)
    end function on_circle

    !> The angle of a point of the hyperbola x = cosh, y = sinh from -half to half.
    real(dp) function on_hyperbola(t, half) result(angle)
        real(dp), intent(in) :: t, half
        real(dp) :: b(3)
        b = [(1.0_dp - t)**2, 2.0_dp*t*(1.0_dp - t)*cosh(half), t**2]
        angle = asinh((b(3) - b(1))*sinh(half)/sum(b))
    end function on_hyperbola

end program test_mesh_share
