!> Ducts through rings: cones and cylinders in closed form; of any duct what makes it the one it is:
!> it meets its rings, its second derivatives go on, and vanish at both ends.
program test_ring_loft
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_bspline_surface, only: bspline_surface_type, surface_point
    use geom_coons, only: patch_jet_type
    use geom_fairing_system, only: spline_area
    use geom_ring_loft, only: new_ring_loft, ring_at, ring_loft_surface, ring_loft_type, &
        ring_loft_volume, stretch_of
    use geom_surface_jet, only: second_jet
    use support_ducts, only: wheel
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(error_type), allocatable :: error
    real(dp), parameter :: sta(4) = [10.0_dp, 12.0_dp, 20.0_dp, 25.0_dp]

    call check_cone()
    call check_any()
    call check_back()
    call tap%finish()

contains

    !> Rings that grow evenly: a cone, whatever their stations.
    subroutine check_cone()
        type(ring_loft_type) :: loft
        type(bspline_surface_type) :: surface
        real(dp) :: ring(2, 12, 4), area, worst, at(3), other(3)
        integer :: k

        do k = 1, 4
            ring(:, :, k) = wheel(12, [1.0_dp, 2.0_dp]*sta(k)/10.0_dp, [0.5_dp, 0.1_dp]*sta(k), &
                0.3_dp)
        end do
        call new_ring_loft(ring, sta, loft, error)
        call tap%ok(.not. allocated(error), 'a cone is lofted')
        area = spline_area(ring(:, :, 1), .true.)
        call tap%near(spline_area(ring_at(loft, 17.0_dp), .true.), 1.7_dp**2*area, &
            1.0e-14_dp*area, 'its areas go with the square of the distance')
        call tap%near(maxval(abs(ring_at(loft, 15.0_dp) - 1.5_dp*ring(:, :, 1))), 0.0_dp, &
            1.0e-14_dp, 'its rings are scaled')
        call tap%near(ring_loft_volume(loft), area*(2.5_dp**3 - 1.0_dp)*10.0_dp/3.0_dp, &
            1.0e-13_dp*area*50.0_dp, 'its volume is that of a cone')
        surface = ring_loft_surface(loft)
        worst = 0.0_dp
        do k = 0, 20
            at = surface_point(surface, 0.05_dp*real(k, dp), 0.0_dp)
            other = surface_point(surface, 0.05_dp*real(k, dp), 0.37_dp)
            worst = max(worst, norm2(other - other(1)/at(1)*at))
        end do
        call tap%near(worst, 0.0_dp, 1.0e-13_dp, 'its surface is that of lines through the apex')
        ring = spread(ring(:, :, 1), 3, 4)
        call new_ring_loft(ring, sta, loft, error)
        call tap%near(ring_loft_volume(loft), 15.0_dp*area, 1.0e-13_dp*area, 'a cylinder')
        call new_ring_loft(ring(:, :, :2), sta(:2), loft, error)
        call tap%near(ring_loft_volume(loft), 2.0_dp*area, 1.0e-14_dp*area, 'of two rings too')
    end subroutine check_cone

    !> Rings without any rule.
    subroutine check_any()
        type(ring_loft_type) :: loft
        type(bspline_surface_type) :: surface
        type(patch_jet_type) :: before, after
        real(dp) :: ring(2, 12, 4), worst(3), u, t, small
        integer :: i, k, number

        ring(:, :, 1) = wheel(12, [3.0_dp, 1.0_dp], [0.0_dp, 0.0_dp], 0.0_dp)
        ring(:, :, 2) = wheel(12, [2.0_dp, 2.0_dp], [0.0_dp, 1.0_dp], 0.1_dp)
        ring(:, :, 3) = wheel(12, [4.0_dp, 3.0_dp], [1.0_dp, 4.0_dp], 0.0_dp)
        ring(:, :, 4) = wheel(12, [2.5_dp, 3.0_dp], [2.0_dp, 5.0_dp], -0.1_dp)
        call new_ring_loft(ring, sta, loft, error)
        surface = ring_loft_surface(loft)
        worst = 0.0_dp
        do k = 1, 4
            worst(1) = max(worst(1), maxval(abs(ring_at(loft, sta(k)) - ring(:, :, k))))
        end do
        call tap%near(worst(1), 0.0_dp, 0.0_dp, 'rings are met, to the last bit')
        small = 1.0e-9_dp
        worst = 0.0_dp
        do k = 5, 6
            do i = 0, 40
                u = real(i, dp)/40.0_dp
                before = second_jet(surface, u, surface%v_knot(k) - small)
                after = second_jet(surface, u, surface%v_knot(k) + small)
                worst(1) = max(worst(1), norm2(after%vv - before%vv))
                worst(2) = max(worst(2), norm2(after%v - before%v), norm2(after%uv - before%uv))
            end do
        end do
        call tap%near(worst(1), 0.0_dp, 1.0e-4_dp, 'second derivatives go on along')
        call tap%near(worst(2), 0.0_dp, 1.0e-4_dp, '... and the first, and twists')
        worst = 0.0_dp
        do i = 0, 40
            before = second_jet(surface, 0.0_dp, 0.025_dp*real(i, dp))
            after = second_jet(surface, 1.0_dp, 0.025_dp*real(i, dp))
            worst(1) = max(worst(1), norm2(after%at - before%at), norm2(after%u - before%u))
            worst(2) = max(worst(2), norm2(after%uu - before%uu))
            before = second_jet(surface, 0.025_dp*real(i, dp), 0.0_dp)
            after = second_jet(surface, 0.025_dp*real(i, dp), 1.0_dp)
            worst(3) = max(worst(3), norm2(before%vv), norm2(after%vv))
        end do
        call tap%near(worst(1), 0.0_dp, 1.0e-12_dp, 'around it goes on where it began')
        call tap%near(worst(2), 0.0_dp, 1.0e-11_dp, '... with its second derivatives')
        call tap%near(worst(3), 0.0_dp, 1.0e-11_dp, 'at both ends it is free')
        call stretch_of(loft, 14.0_dp, number, t)
        call tap%ok(number == 2 .and. t > 0.0_dp .and. t < 1.0_dp, 'a station has its stretch')
    end subroutine check_any

    !> Rings far beside each other, and then not.
    subroutine check_back()
        type(ring_loft_type) :: loft
        real(dp) :: ring(2, 12, 4)
        integer :: k

        do k = 1, 4
            ring(:, :, k) = wheel(12, [1.0_dp, 1.0_dp], [merge(0.0_dp, 60.0_dp, k < 3), 0.0_dp], &
                0.0_dp)
        end do
        call new_ring_loft(ring, [0.0_dp, 10.0_dp, 10.5_dp, 20.0_dp], loft, error)
        call tap%ok(allocated(error), 'lines that turn back are refused')
        call tap%ok(error%cause == cause%not_single_valued, 'for that cause')
        call tap%has(error%message, 'between stations 10. and 10.5', 'it is said where')
    end subroutine check_back

end program test_ring_loft
