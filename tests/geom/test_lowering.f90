!> Degree reduction: figures worked out in 2026 from constrained least squares, exact reductions,
!> what is kept at the ends, that nothing nearer is there, and B-splines for curves of high degree.
program test_lowering
    use base_kinds, only: dp
    use geom_bezier, only: bernstein, bezier_point, bezier_raised, bezier_jet
    use geom_bspline, only: bspline_type, spline_jet, spline_point
    use geom_lowering, only: bezier_lowered, bezier_unraised, lower_spline, lowered_apart
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    !> The curve of the figures.
    real(dp), parameter :: curve(2, 6) = reshape([0.0_dp, 0.0_dp, 1.0_dp, 3.0_dp, 3.0_dp, 4.0_dp, &
        5.0_dp, 3.0_dp, 6.0_dp, -1.0_dp, 8.0_dp, 0.0_dp], [2, 6])
    real(dp), parameter :: plain(2) = 0.0_dp
    type(tap_type) :: tap

    call check_figures()
    call check_exact()
    call check_nearest()
    call check_spline()
    call tap%finish()

contains

    !> From degree 5.
    subroutine check_figures()
        real(dp) :: four(2, 5), three(2, 4), rest(2)

        call bezier_lowered(curve, [1, 1], plain, four, rest)
        call tap%near(maxval(abs(four - reshape([0.0_dp, 0.0_dp, 1.1875_dp, 3.5416666666667_dp, &
            4.4166666666667_dp, 5.0_dp, 5.5625_dp, -1.0416666666667_dp, 8.0_dp, 0.0_dp], &
            [2, 5]))), 0.0_dp, 1.0e-12_dp, 'degree 4 with its ends')
        call tap%near(norm2(rest - [0.005201564866_dp, 0.017338549554_dp]), 0.0_dp, 1.0e-11_dp, &
            'what is left of it')
        call bezier_lowered(curve, [1, 1], plain, three, rest)
        call tap%near(maxval(abs(three - reshape([0.0_dp, 0.0_dp, 2.1190476190_dp, &
            6.1507936508_dp, 5.2857142857_dp, 0.0396825397_dp, 8.0_dp, 0.0_dp], [2, 4]))), 0.0_dp, &
            1.0e-10_dp, 'degree 3 with its ends')
        call tap%near(norm2(rest - [0.056708304394_dp, 0.151579557534_dp]), 0.0_dp, 1.0e-11_dp, &
            'what is left of it')
        call bezier_lowered(curve, [1, 1], [1.0_dp, 2.0_dp], three, rest)
        call tap%near(maxval(abs(three(:, 2:3) - reshape([2.2575757576_dp, 6.5151515152_dp, &
            5.2121212121_dp, -0.1515151515_dp], [2, 2]))), 0.0_dp, 1.0e-10_dp, &
            'the same weighted by (1 - t) t**2')
        call bezier_lowered(curve, [2, 2], plain, four, rest)
        call tap%near(maxval(abs(four(:, 2:4) - reshape([1.25_dp, 3.75_dp, 4.4166666666667_dp, &
            5.0_dp, 5.5_dp, -1.25_dp], [2, 3]))), 0.0_dp, 1.0e-12_dp, 'degree 4 with its tangents')
        call tap%near(norm2(rest - [0.018018749254_dp, 0.060062497513_dp]), 0.0_dp, 1.0e-11_dp, &
            'what is left of it')
        call bezier_lowered(curve, [0, 0], plain, four, rest)
        call tap%near(norm2(four(:, 1) - [0.0119047619_dp, 0.0396825397_dp]), 0.0_dp, 1.0e-10_dp, &
            'degree 4 with nothing kept')
        call tap%near(norm2(rest - [0.003589420769_dp, 0.011964735896_dp]), 0.0_dp, 1.0e-11_dp, &
            'is nearest')
    end subroutine check_figures

    !> A raised curve goes back.
    subroutine check_exact()
        real(dp) :: pole(2, 10), lower(2, 6), rest(2), worst
        integer :: keep

        pole(:, :6) = curve
        pole(:, :7) = bezier_raised(curve)
        pole(:, :8) = bezier_raised(pole(:, :7))
        pole(:, :9) = bezier_raised(pole(:, :8))
        pole = bezier_raised(pole(:, :9))
        worst = 0.0_dp
        do keep = 0, 3
            call bezier_lowered(pole, [keep, keep], plain, lower, rest)
            worst = max(worst, maxval(abs(lower - curve)), maxval(abs(rest)))
        end do
        call tap%near(worst, 0.0_dp, 1.0e-11_dp, 'raised from 5 to 9 and lowered: the same')
        call tap%near(maxval(abs(bezier_unraised(bezier_raised(curve)) - curve)), 0.0_dp, &
            1.0e-14_dp, 'raised and unraised by one: the same')
        call tap%near(maxval(abs(bezier_unraised(bezier_raised(curve(:, :5))) - curve(:, :5))), &
            0.0_dp, 1.0e-14_dp, 'also from degree 5')
        call tap%near(lowered_apart(pole, curve), 0.0_dp, 1.0e-14_dp, 'they are not apart')
    end subroutine check_exact

    !> The difference is at right angles to all that may be changed, and the ends are kept.
    subroutine check_nearest()
        type(random_type) :: random
        real(dp) :: pole(2, 8), lower(2, 6), rest(2), sum(2), square(2), t, w, worst(3), far
        real(dp), dimension(2) :: at(2), first, second, at2, first2, second2
        integer :: i, j, k

        worst = 0.0_dp
        do i = 1, 20
            do k = 1, 8
                pole(:, k) = [random%between(-1.0_dp, 1.0_dp), random%between(-1.0_dp, 1.0_dp)]
            end do
            call bezier_lowered(pole, [2, 1], [1.0_dp, 0.0_dp], lower, rest)
            call bezier_jet(pole, 0.0_dp, at, first, second)
            call bezier_jet(lower, 0.0_dp, at2, first2, second2)
            worst(1) = max(worst(1), norm2(at - at2), norm2(first - first2), &
                norm2(lower(:, 6) - pole(:, 8)))
            square = 0.0_dp
            far = 0.0_dp
            do j = 2, 4
                sum = 0.0_dp
                do k = 1, 999
                    t = 0.001_dp*real(k, dp)
                    w = merge(4.0_dp, 2.0_dp, mod(k, 2) == 1)/3000.0_dp*(1.0_dp - t)
                    at = bezier_point(pole, t) - bezier_point(lower, t)
                    sum = sum + w*at*bernstein(5, j, t)
                    if (j == 2) square = square + w*at**2
                    far = max(far, norm2(at))
                end do
                worst(2) = max(worst(2), maxval(abs(sum)))
            end do
            worst(3) = max(worst(3), maxval(abs(sqrt(square) - rest)))
            if (far > lowered_apart(pole, lower)) worst = 9.0_dp
        end do
        call tap%near(worst(1), 0.0_dp, 1.0e-13_dp, 'what is to be kept at the ends is kept')
        call tap%near(worst(2), 0.0_dp, 1.0e-9_dp, 'no change of an inner pole comes nearer')
        call tap%near(worst(3), 0.0_dp, 1.0e-9_dp, 'what is left is told, and bounded by the poles')
    end subroutine check_nearest

    !> Degree 25 in pieces of degree 5.
    subroutine check_spline()
        type(random_type) :: random
        type(bspline_type) :: spline, lower
        real(dp) :: apart, far, jump, at(2), first(2), second(2), first2(2), t
        integer :: i, k, count

        spline%degree = 25
        allocate (spline%pole(2, 26), spline%weight(26), spline%knot(52))
        spline%weight = 1.0_dp
        spline%knot(:26) = 0.0_dp
        spline%knot(27:) = 1.0_dp
        do k = 1, 26
            spline%pole(:, k) = [4.0_dp*real(k, dp), random%between(0.0_dp, 20.0_dp)]
        end do
        call lower_spline(spline, 5, 1.0e-3_dp, lower, apart)
        count = (size(lower%weight) - 2)/4
        call tap%ok(lower%degree == 5 .and. size(lower%knot) == size(lower%weight) + 6, &
            'degree 25 becomes degree 5')
        call tap%ok(count > 1 .and. count <= 64, 'in some pieces')
        call tap%ok(apart <= 1.0e-3_dp, 'within the tolerance')
        far = 0.0_dp
        do i = 0, 2000
            t = real(i, dp)/2000.0_dp
            far = max(far, norm2(spline_point(lower, t) - bezier_point(spline%pole, t)))
        end do
        call tap%ok(far <= apart .and. far > 0.01_dp*apart, 'as is measured between them')
        jump = 0.0_dp
        do i = 1, count - 1
            t = real(i, dp)/real(count, dp)
            call bezier_jet(spline%pole, t, at, first, second)
            call spline_jet(lower, t, at, first2, second)
            jump = max(jump, norm2(first - first2))
        end do
        call tap%near(jump, 0.0_dp, 1.0e-9_dp, 'joints have the tangents of the curve')
        call lower_spline(spline, 5, 0.0_dp, lower, apart)
        call tap%ok(lower%degree == 25 .and. apart <= 0.0_dp, &
            'where no number of pieces does it stays')
    end subroutine check_spline

end program test_lowering
