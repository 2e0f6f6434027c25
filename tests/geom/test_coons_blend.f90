!> Blending functions: the conditions of (3), (9) and (12), and derivatives.
program test_coons_blend
    use base_kinds, only: dp
    use geom_coons_blend, only: blend, blend_jet, blend_orders
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_ends(tap)
    call check_inside(tap)
    call tap%finish()

contains

    !> At the ends each function has 1 for its own derivative, and 0 else.
    subroutine check_ends(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp) :: jet(0:2, 0:2, 0:1), wanted
        integer :: kind, order, end, at, derivative
        logical :: holds

        do kind = 1, 4
            holds = .true.
            do at = 0, 1
                jet = blend_jet(kind, real(at, dp))
                do end = 0, 1
                    do order = 0, blend_orders(kind) - 1
                        do derivative = 0, blend_orders(kind) - 1
                            wanted = merge(1.0_dp, 0.0_dp, end == at .and. order == derivative)
                            holds = holds .and. abs(jet(derivative, order, end) - wanted) <= 0.0_dp
                        end do
                    end do
                end do
            end do
            call tap%ok(holds, 'the conditions at the ends, exactly')
        end do
        jet = blend_jet(blend%cubic, 1.0_dp)
        call tap%near(jet(1, 0, 1), 0.0_dp, 0.0_dp, 'F1 is 3 t**2 - 2 t**3: flat at its end')
    end subroutine check_ends

    !> Inside: sums, values worked by hand, derivatives against differences.
    subroutine check_inside(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp), parameter :: h = 1.0e-4_dp
        real(dp) :: jet(0:2, 0:2, 0:1), before(0:2, 0:2, 0:1), after(0:2, 0:2, 0:1)
        integer :: kind

        do kind = 1, 4
            jet = blend_jet(kind, 0.3_dp)
            call tap%near(sum(jet(0, 0, :)), 1.0_dp, 2.0e-16_dp, 'F0 + F1 = 1')
            before = blend_jet(kind, 0.3_dp - h)
            after = blend_jet(kind, 0.3_dp + h)
            call tap%near(maxval(abs(jet(1, :, :) &
                - (after(0, :, :) - before(0, :, :))/(2.0_dp*h))), &
                0.0_dp, 1.0e-6_dp, 'first derivatives')
            call tap%near(maxval(abs(jet(2, :, :) &
                - (after(1, :, :) - before(1, :, :))/(2.0_dp*h))), &
                0.0_dp, 1.0e-6_dp, 'second derivatives')
        end do
        jet = blend_jet(blend%slopes, 0.25_dp)
        call tap%near(maxval(abs(jet(0, :1, :) - reshape([0.84375_dp, 0.140625_dp, 0.15625_dp, &
            -0.046875_dp], [2, 2]))), 0.0_dp, 0.0_dp, 'F and G of third degree at 1/4')
        jet = blend_jet(blend%curvatures, 0.5_dp)
        call tap%near(maxval(abs(jet(0, :, :) - reshape([0.5_dp, 0.15625_dp, 0.015625_dp, 0.5_dp, &
            -0.15625_dp, 0.015625_dp], [3, 2]))), 0.0_dp, 1.0e-16_dp, &
            'F, G and H of fifth degree at 1/2')
    end subroutine check_inside

end program test_coons_blend
