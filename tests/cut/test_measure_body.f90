!> Volumes, centroids and wetted areas against closed forms.
program test_measure_body
    use base_constants, only: pi
    use base_kinds, only: dp
    use body_body, only: body_type, finish_body, mirrored_body
    use cut_measure_body, only: body_measure_type, measure_body, stops_of
    use support_solids, only: cone, cylinder, ellipsoid, paraboloid, solid, waist
    use support_tap, only: tap_type
    implicit none (type, external)

    integer, parameter :: qp = selected_real_kind(30)
    real(dp), parameter :: good = 1.0e-10_dp
    type(tap_type) :: tap
    type(body_type) :: body
    type(body_measure_type) :: measure
    real(dp), allocatable :: stops(:)
    real(dp) :: e

    body = ellipsoid([3.0_dp, 3.0_dp, 3.0_dp])
    call check('a sphere', 36.0_dp*pi, 36.0_dp*pi, [0.0_dp, 0.0_dp, 0.0_dp])
    body = ellipsoid([5.0_dp, 3.0_dp, 3.0_dp])
    e = 0.8_dp
    call check('a prolate spheroid', 4.0_dp*pi/3.0_dp*45.0_dp, &
        2.0_dp*pi*9.0_dp*(1.0_dp + 5.0_dp/(3.0_dp*e)*asin(e)), [0.0_dp, 0.0_dp, 0.0_dp])
    body = ellipsoid([3.0_dp, 5.0_dp, 5.0_dp])
    call check('an oblate spheroid', 4.0_dp*pi/3.0_dp*75.0_dp, &
        2.0_dp*pi*25.0_dp*(1.0_dp + (1.0_dp - e**2)/e*atanh(e)), [0.0_dp, 0.0_dp, 0.0_dp])
    body = ellipsoid([10.0_dp, 3.0_dp, 2.0_dp])
    call check('an ellipsoid of three axes', 80.0_dp*pi, ellipsoid_area(10.0_dp, 3.0_dp, 2.0_dp), &
        [0.0_dp, 0.0_dp, 0.0_dp])
    allocate (stops(0))
    stops = stops_of(body)
    call tap%ok(size(stops) == 3, 'an ellipsoid of two arcs has three stops')
    call tap%ok(all(abs(stops - [-10.0_dp, 0.0_dp, 10.0_dp]) <= 0.0_dp), 'in order')
    call check_curve()
    body = mirrored_body(body)
    call check('an ellipsoid by four quarters, not symmetric', 80.0_dp*pi, &
        ellipsoid_area(10.0_dp, 3.0_dp, 2.0_dp), [0.0_dp, 0.0_dp, 0.0_dp])
    body = paraboloid(2.0_dp, 9.0_dp)
    call check('a paraboloid', pi*2.0_dp*81.0_dp, &
        pi*6.0_dp/(6.0_dp*81.0_dp)*((36.0_dp + 4.0_dp*81.0_dp)**1.5_dp - 216.0_dp), &
        [6.0_dp, 0.0_dp, 0.0_dp])
    body = cone(3.0_dp, 4.0_dp, 0.0_dp)
    call check('a cone', 12.0_dp*pi, 15.0_dp*pi, [3.0_dp, 0.0_dp, 0.0_dp])
    body = cone(3.0_dp, 4.0_dp, -125.0_dp)
    call check('a cone far below the datum', 12.0_dp*pi, 15.0_dp*pi, [3.0_dp, 0.0_dp, -125.0_dp])
    body = cylinder(3.0_dp, 7.0_dp)
    call check('a cylinder, without its ends', 63.0_dp*pi, 42.0_dp*pi, [3.5_dp, 0.0_dp, 0.0_dp])
    body = waist()
    call check('a hyperboloid of one sheet', 2.0_dp*pi*(0.75_dp + 0.75_dp**3/3.0_dp), &
        2.0_dp*pi*(0.75_dp*sqrt(2.125_dp) + asinh(0.75_dp*sqrt(2.0_dp))/sqrt(2.0_dp)), &
        [0.0_dp, 0.0_dp, 0.0_dp])

    call check_fault()
    body = waist()
    body%is_closed = .false.
    call measure_body(body, [0.0_dp], measure)
    call tap%ok(.not. measure%has_volume .and. measure%has_wetted, &
        'a body that is not closed has no volume but a skin')
    call tap%same(measure%why, &
        'between stations -0.75 and 0.75 the section ends at BL 0 but the '// &
        'deck does not say CLOSE', 'and it is said why')
    body%is_closed = .true.
    body%sections = body%sections(1:1)
    call measure_body(body, [0.0_dp], measure)
    call tap%ok(.not. measure%has_volume, 'an open quarter has no volume')
    call tap%same(measure%why, &
        'between stations -0.75 and 0.75 the section is open at BL 1., WL 0.', &
        'and it is said where it is open')
    deallocate (body%sections)
    allocate (body%sections(0))
    call measure_body(body, [0.0_dp], measure)
    call tap%ok(.not. (measure%has_volume .or. measure%has_wetted), 'no section, no measures')
    call tap%same(measure%why, 'the body has no section', 'and it is said so')
    call tap%finish()

contains

    !> Checks the measures of the body.
    subroutine check(name, volume, wetted, centroid)
        character(*), intent(in) :: name
        real(dp), intent(in) :: volume, wetted, centroid(3)
        character(100) :: text
        call measure_body(body, [0.5_dp], measure)
        if (allocated(measure%why)) call tap%note(measure%why)
        call tap%ok(measure%has_volume .and. measure%has_wetted, 'has volume and skin: '//name)
        call tap%near(measure%volume/volume, 1.0_dp, good, 'volume of '//name)
        call tap%near(measure%wetted_area/wetted, 1.0_dp, good, 'wetted area of '//name)
        call tap%near(norm2(measure%centroid - centroid), 0.0_dp, good*10.0_dp, &
            'centroid of '//name)
        call tap%ok(abs(measure%volume - volume) <= measure%volume_error, &
            'the estimate of the volume holds: '//name)
        call tap%ok(abs(measure%wetted_area - wetted) <= measure%wetted_error, &
            'the estimate of the skin holds: '//name)
        call tap%ok(measure%volume_error < good*volume .and. measure%wetted_error < good*wetted, &
            'and is small')
        write (text, '(4es10.2)') measure%volume/volume - 1.0_dp, measure%volume_error/volume, &
            measure%wetted_area/wetted - 1.0_dp, measure%wetted_error/wetted
        call tap%note(trim(text))
    end subroutine check

    !> An ellipsoid whose upper shoulder line is that of a cylinder, BL 1.14, WL 1.52, up to station
    !> 7: from 6.5 on, where 2 sqrt(1 - x^2/100) < 1.52, its shoulders are above its top line.
    subroutine check_fault()
        type(body_type) :: tube
        body = ellipsoid([10.0_dp, 3.0_dp, 2.0_dp])
        tube = cylinder(1.9_dp, 7.0_dp)
        body%lines(2) = tube%lines(2)
        call finish_body(body)
        call measure_body(body, [0.0_dp], measure)
        call tap%ok(.not. (measure%has_volume .or. measure%has_wetted), &
            'where a section has no arc there is neither volume nor skin')
        call tap%has(measure%why, 'at station 6.', 'it is said where')
        call tap%has(measure%why, ': UPPER: the shoulder point (1.14, 1.52) lies on the other '// &
            'side of the tangent', 'in which section, and why')
    end subroutine check_fault

    !> The area curve of the ellipsoid 10, 3, 2.
    subroutine check_curve()
        integer :: i
        real(dp) :: worst
        call measure_body(body, [7.3_dp, -10.0_dp, 99.0_dp, 7.3_dp], measure)
        call tap%ok(size(measure%curve) == 22, 'a grid of 21 stations and one more, none twice')
        call tap%ok(all(measure%curve(2:)%sta > measure%curve(:21)%sta), 'the curve is in order')
        call tap%ok(all(measure%curve%has_area), 'every station has an area')
        worst = 0.0_dp
        do i = 1, 22
            associate (slice => measure%curve(i))
                worst = max(worst, abs(slice%area - 6.0_dp*pi*(1.0_dp - (0.1_dp*slice%sta)**2)))
            end associate
        end do
        call tap%near(worst, 0.0_dp, 1.0e-11_dp, 'the area curve of an ellipsoid is a parabola')
    end subroutine check_curve

    !> The surface of an ellipsoid, in real128 by its own parametrisation x = a cos f, y = b sin f
    !> cos v, z = c sin f sin v; both rules converge geometrically.
    real(dp) function ellipsoid_area(a, b, c)
        real(dp), intent(in) :: a, b, c
        integer, parameter :: n = 240
        real(qp), parameter :: half_turn = acos(-1.0_qp)
        real(qp) :: f, v, p, q, r, weight, sum_of
        integer :: i, k
        sum_of = 0.0_qp
        do i = 1, n
            f = half_turn*(real(i, qp) - 0.5_qp)/real(n, qp)
            weight = fejer(f, n)
            do k = 1, n
                v = 2.0_qp*half_turn*real(k, qp)/real(n, qp)
                p = real(b*c, qp)*cos(f)
                q = real(a*c, qp)*sin(f)*cos(v)
                r = real(a*b, qp)*sin(f)*sin(v)
                sum_of = sum_of + sqrt(p**2 + q**2 + r**2)*weight
            end do
        end do
        ellipsoid_area = real(sum_of*2.0_qp*half_turn/real(n, qp)**2, dp)
    end function ellipsoid_area

    !> Fejer's first rule for sin f df over a half turn, times n.
    real(qp) function fejer(f, n)
        real(qp), intent(in) :: f
        integer, intent(in) :: n
        integer :: j
        fejer = 1.0_qp
        do j = 1, n/2
            fejer = fejer - 2.0_qp*cos(2.0_qp*real(j, qp)*f)/(4.0_qp*real(j, qp)**2 - 1.0_qp)
        end do
        fejer = fejer*2.0_qp
    end function fejer

end program test_measure_body
