!> Splines against figures of scipy 1 (BSpline, written in by hand), against the circle, and against
!> their images.
program test_bspline
    use base_kinds, only: dp
    use geom_bspline, only: bspline_type, is_rational, mapped_spline, reversed_spline, &
        spline_breaks, &
        spline_from, spline_jet, spline_point, spline_to
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(bspline_type) :: cubic, quintic, circle, image
    real(dp) :: p(2), d(2), dd(2), q(1), dq(1), ddq(1), away(3), t, s3(3)
    integer :: i

    cubic = bspline_type(3, [0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 2.5_dp, 2.5_dp, 4.0_dp, &
        4.0_dp, &
        4.0_dp, 4.0_dp], reshape([1.0_dp, 2.0_dp, 3.0_dp, -1.0_dp, 4.0_dp, 5.0_dp, -2.0_dp, &
        0.5_dp, &
        6.0_dp, 7.0_dp, 8.0_dp, 8.0_dp, 9.0_dp, 1.0_dp], [2, 7]), [(1.0_dp, i=1, 7)])
    call tap%ok(spline_from(cubic) == 0.0_dp .and. spline_to(cubic) == 4.0_dp .and. &
        all(spline_breaks(cubic) == [0.0_dp, 1.0_dp, 2.5_dp, 4.0_dp]), &
        'where a spline begins and ends')
    call tap%ok(.not. is_rational(cubic), 'equal weights are no weights')
    call check_jet(0.3_dp, [2.38096_dp, 0.56684_dp, 3.2496_dp, -1.1916_dp, -8.736_dp, 19.656_dp])
    call check_jet(1.0_dp, [2.68_dp, 2.12_dp, -2.16_dp, 2.16_dp, -6.72_dp, -10.08_dp])
    call check_jet(2.5_dp, [2.0_dp, 3.75_dp, 8.0_dp, 6.5_dp, -16.0_dp/3.0_dp, -6.0_dp])
    call check_jet(3.7_dp, [8.272_dp, 4.286_dp, 2.88_dp, -8.06_dp, -3.2_dp, -18.26666666666667_dp])
    call tap%ok(all(spline_point(cubic, 0.0_dp) == [1.0_dp, 2.0_dp]) .and. &
        all(spline_point(cubic, 4.0_dp) == [9.0_dp, 1.0_dp]), 'its ends are poles, exactly')

    quintic = bspline_type(5, [0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 0.1_dp, 0.25_dp, &
        0.6_dp, &
        1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp], reshape([3.0_dp, 1.0_dp, 4.0_dp, 1.0_dp, &
        5.0_dp, 9.0_dp, 2.0_dp, 6.0_dp, 5.0_dp], [1, 9]), [(1.0_dp, i=1, 9)])
    call spline_jet(quintic, 0.25_dp, q, dq, ddq)
    call tap%near(q(1), 2.935590277777778_dp, 2.0e-15_dp, 'degree 5: point')
    call tap%near(dq(1), 8.790509259259261_dp, 3.0e-14_dp, 'first derivative')
    call tap%near(ddq(1), 109.4135802469136_dp, 1.0e-12_dp, 'second derivative')

    ! The half plane's stereographic circle: ((1 - t**2), 2 t)/(1 + t**2).
    circle = bspline_type(2, [0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 1.0_dp], reshape([1.0_dp, &
        0.0_dp, &
        1.0_dp, 1.0_dp, 0.0_dp, 1.0_dp], [2, 3]), [1.0_dp, 1.0_dp, 2.0_dp])
    call tap%ok(is_rational(circle), 'a quarter of a circle is rational')
    away = 0.0_dp
    do i = 0, 20
        t = real(i, dp)/20.0_dp
        call spline_jet(circle, t, p, d, dd)
        away(1) = max(away(1), norm2(p - [1 - t**2, 2*t]/(1 + t**2)), &
            norm2(p - spline_point(circle, t)))
        away(2) = max(away(2), norm2(d - [-4*t, 2*(1 - t**2)]/(1 + t**2)**2))
        away(3) = max(away(3), norm2(dd - [12*t**2 - 4, 4*t*(t**2 - 3)]/(1 + t**2)**3))
    end do
    call tap%near(away(1), 0.0_dp, 3.0e-16_dp, 'its points are on the circle')
    call tap%near(away(2), 0.0_dp, 2.0e-15_dp, 'its first derivative is in closed form')
    call tap%near(away(3), 0.0_dp, 1.0e-14_dp, 'its second too')

    image = reversed_spline(cubic)
    away = 0.0_dp
    do i = 0, 40
        t = real(i, dp)/10.0_dp
        away(1) = max(away(1), norm2(spline_point(image, t) - spline_point(cubic, 4.0_dp - t)))
    end do
    call tap%near(away(1), 0.0_dp, 1.0e-14_dp, 'backwards it is the same curve')
    call tap%ok(all(image%knot == [0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.5_dp, 1.5_dp, 3.0_dp, &
        4.0_dp, 4.0_dp, &
        4.0_dp, 4.0_dp]), 'its knots are mirrored')
    image = cubic
    image%knot = 0.1_dp + 0.3_dp*cubic%knot
    image = reversed_spline(image)
    call tap%ok(image%knot(1) == 0.1_dp .and. all(image%knot(8:) == 0.1_dp + 0.3_dp*4.0_dp), &
        'its ends keep their parameters where these are not whole')

    call mapped_spline(circle, reshape([0.0_dp, 3.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, -2.0_dp], [3, 2]), &
        [0.1_dp, 10.0_dp, 20.0_dp], image)
    away = 0.0_dp
    do i = 0, 20
        t = real(i, dp)/20.0_dp
        p = spline_point(circle, t)
        s3 = spline_point(image, t)
        away(1) = max(away(1), norm2(s3(2:) - [10.0_dp + 3.0_dp*p(1), 20.0_dp - 2.0_dp*p(2)]))
        away(2) = max(away(2), abs(s3(1) - 0.1_dp))
    end do
    call tap%near(away(1), 0.0_dp, 4.0e-15_dp, 'its image in space')
    call tap%ok(away(2) == 0.0_dp, 'is in its plane, exactly')
    call tap%finish()

contains

    !> Compares point and derivatives of the cubic with figures.
    subroutine check_jet(t, figures)
        real(dp), intent(in) :: t           !! parameter
        real(dp), intent(in) :: figures(6)  !! point, first, second derivative
        character(8) :: name

        write (name, '(f4.1)') t
        call spline_jet(cubic, t, p, d, dd)
        call tap%ok(all(abs([p, d, dd] - figures) <= 3.0e-14_dp), &
            'scipy''s figures at '//trim(name))
        call tap%ok(all(abs(spline_point(cubic, t) - figures(:2)) <= 2.0e-15_dp), 'and its point')
    end subroutine check_jet

end program test_bspline
