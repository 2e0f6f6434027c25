!> C-Bezier curves: figures worked out from the formulas of the module's head with 50 digits,
!> 128-bit reals for small angles, arcs of circles, parts.
program test_cyclic
    use, intrinsic :: iso_fortran_env, only: real128
    use base_constants, only: pi
    use base_kinds, only: dp
    use geom_bezier, only: bezier_point
    use geom_cyclic, only: cyclic_jet, cyclic_part, cyclic_point, middle_ratio, start_ratio
    use geom_vector, only: cross
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    integer, parameter :: qp = real128
    real(dp), parameter :: unit(4, 4) = reshape([1.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, &
        0.0_dp, 1.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, &
        0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp], [4, 4])
    real(dp), parameter :: polygon(2, 4) = reshape([0.0_dp, 0.0_dp, 1.0_dp, 2.0_dp, 3.0_dp, &
        3.0_dp, 4.0_dp, 0.0_dp], [2, 4])
    type(tap_type) :: tap

    call check_figures(tap)
    call check_small(tap)
    call check_circle(tap)
    call check_parts(tap)
    call tap%finish()

contains

    !> alpha = 1.5, t = .6.
    subroutine check_figures(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp) :: z(4), first(4), second(4), point(2), d1(2), d2(2)

        call cyclic_jet(unit, 1.5_dp, 0.4_dp, z, first, second)
        call tap%near(maxval(abs(z - [0.232182938005_dp, 0.417151646318_dp, 0.280302880653_dp, &
            0.070362535024_dp])), 0.0_dp, 1.0e-12_dp, 'the four functions')
        call tap%near(maxval(abs(first/1.5_dp - [-0.753007475830_dp, -0.214397242210_dp, &
            0.619817369787_dp, 0.347587348253_dp])), 0.0_dp, 1.0e-12_dp, 'their derivatives')
        call cyclic_jet(polygon, 1.5_dp, 0.4_dp, point, d1, d2)
        call tap%near(norm2(point - [1.539510428373_dp, 1.675211934594_dp]), 0.0_dp, 1.0e-12_dp, &
            'a point')
        call tap%near(cross(d1, d2)/norm2(d1)**3, -0.502171222372_dp, 1.0e-12_dp, 'its curvature')
        call tap%near(middle_ratio(pi), 1.0_dp, 1.0e-14_dp, 'M is 1 at half a turn')
        call tap%near(middle_ratio(1.0e-3_dp), 3.0_dp - 0.3e-6_dp, 1.0e-12_dp, 'and 3 towards none')
    end subroutine check_figures

    !> Against the formulas in 128 bits, from a thousandth to half a turn.
    subroutine check_small(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(random_type) :: random
        real(dp) :: alpha, s, worst, limit
        integer :: i

        worst = 0.0_dp
        do i = 1, 3000
            alpha = 10.0_dp**random%between(-3.0_dp, 0.497_dp)
            s = random%unit()
            worst = max(worst, maxval(abs(cyclic_point(unit, alpha, s) &
                - real(wide(real(alpha, qp), real(alpha, qp)*real(s, qp)), dp))))
        end do
        call tap%near(worst, 0.0_dp, 5.0e-15_dp, 'no figures are lost to small angles')
        limit = 0.0_dp
        do i = 0, 10
            s = 0.1_dp*real(i, dp)
            limit = max(limit, &
                norm2(cyclic_point(polygon, 1.0e-5_dp, s) - bezier_point(polygon, s)))
        end do
        call tap%near(limit, 0.0_dp, 1.0e-10_dp, 'towards none it is a Bezier cubic')
    end subroutine check_small

    !> The four functions by their formulas in 128 bits.
    pure function wide(alpha, t) result(z)
        real(qp), intent(in) :: alpha   !! radians
        real(qp), intent(in) :: t       !! radians
        real(qp) :: z(4), u, k, m

        u = alpha - t
        k = (alpha - sin(alpha))/(1.0_qp - cos(alpha))
        m = sin(alpha)/(alpha - 2.0_qp*k)
        z(1) = (u - sin(u))/(alpha - sin(alpha))
        z(4) = (t - sin(t))/(alpha - sin(alpha))
        z(2) = m*((1.0_qp - cos(u))/(1.0_qp - cos(alpha)) - z(1))
        z(3) = m*((1.0_qp - cos(t))/(1.0_qp - cos(alpha)) - z(4))
    end function wide

    !> An arc of the unit circle is one exactly.
    subroutine check_circle(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp) :: alpha, k, pole(2, 4), worst
        integer :: i, j

        worst = 0.0_dp
        do j = 1, 31
            alpha = 0.1_dp*real(j, dp)
            k = start_ratio(alpha)
            pole = reshape([1.0_dp, 0.0_dp, 1.0_dp, k, cos(alpha) + k*sin(alpha), &
                sin(alpha) - k*cos(alpha), cos(alpha), sin(alpha)], [2, 4])
            do i = 0, 20
                associate (t => alpha*0.05_dp*real(i, dp))
                    worst = max(worst, norm2(cyclic_point(pole, alpha, 0.05_dp*real(i, dp)) &
                        - [cos(t), sin(t)]))
                end associate
            end do
        end do
        call tap%near(worst, 0.0_dp, 2.0e-15_dp, 'arcs of a circle are exact')
    end subroutine check_circle

    !> Parts, also backwards.
    subroutine check_parts(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(random_type) :: random
        real(dp) :: part(2, 4), alpha, share, from, to, s, worst
        integer :: i

        worst = 0.0_dp
        do i = 1, 1000
            alpha = random%between(0.01_dp, 3.1_dp)
            from = random%unit()
            to = random%unit()
            s = random%unit()
            call cyclic_part(polygon, alpha, from, to, part, share)
            worst = max(worst, norm2(cyclic_point(part, share, s) &
                - cyclic_point(polygon, alpha, from + s*(to - from))))
        end do
        call tap%near(worst, 0.0_dp, 1.0e-14_dp, 'a part is such a curve again')
    end subroutine check_parts

end program test_cyclic
