!> Faired curves: figures worked out from the equations of seed 002 with dense matrices (numpy
!> 2.4.6, 2026), and what holds of every faired curve.
program test_fairing
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_fairing, only: critical_multiplier, fair, fair_to_area, faired_energy, fairing_type
    use geom_fairing_system, only: fairing_data_type, fairing_end, spline_energy
    use support_inlet, only: inlet
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_open(tap)
    call check_closed(tap)
    call check_steps(tap)
    call check_held(tap)
    call check_moved(tap)
    call check_weights(tap)
    call check_range(tap)
    call check_bad(tap)
    call tap%finish()

contains

    !> The inlet of the paper: 15 points open, the last being the first; 14 closed.
    function inlet_data(weight, ends) result(given)
        real(dp), intent(in) :: weight  !! of all points
        integer, intent(in) :: ends     !! one of `fairing_end%...`
        type(fairing_data_type) :: given
        allocate (given%point, source=inlet(:, :merge(14, 15, ends == fairing_end%closed)))
        allocate (given%weight(size(given%point, 2)), source=weight)
        given%ends = ends
    end function inlet_data

    !> The inlet faired at a multiplier.
    function faired_inlet(weight, ends, lambda) result(fairing)
        real(dp), intent(in) :: weight  !! of all points
        integer, intent(in) :: ends     !! one of `fairing_end%...`
        real(dp), intent(in) :: lambda  !! the multiplier
        type(fairing_type) :: fairing
        type(error_type), allocatable :: error
        call fair(inlet_data(weight, ends), lambda, fairing, error)
    end function faired_inlet

    !> Compares E, E2, E3, S and the largest deviation with figures of ten decimals.
    subroutine check_figures(tap, fairing, figures, name)
        type(tap_type), intent(inout) :: tap        !! the tally
        type(fairing_type), intent(in) :: fairing   !! a faired curve
        real(dp), intent(in) :: figures(5)          !! what was worked out
        character(*), intent(in) :: name            !! of the case
        call tap%near(faired_energy(fairing), figures(1), 6.0e-11_dp, name//': E')
        call tap%near(fairing%energy(1), figures(2), 6.0e-11_dp, name//': E2')
        call tap%near(fairing%energy(2), figures(3), 6.0e-11_dp, name//': E3')
        call tap%near(fairing%area, figures(4), 6.0e-11_dp, name//': S')
        call tap%near(fairing%deviation, figures(5), 6.0e-11_dp, name//': largest deviation')
    end subroutine check_figures

    !> Compares a curve of given area: multiplier, energy, area, deviation.
    subroutine check_area(tap, given, figures, name)
        type(tap_type), intent(inout) :: tap            !! the tally
        type(fairing_data_type), intent(in) :: given    !! the points
        real(dp), intent(in) :: figures(4)              !! S, lambda, E, deviation
        character(*), intent(in) :: name                !! of the case
        type(fairing_type) :: fairing
        type(error_type), allocatable :: error

        call fair_to_area(given, figures(1), fairing, error)
        call tap%ok(.not. allocated(error), name//' is reached')
        if (allocated(error)) return
        call tap%near(fairing%area, figures(1), 1.0e-10_dp*abs(figures(1)), '... to 1e-10')
        call tap%near(fairing%lambda, figures(2), 6.0e-11_dp, '... by its multiplier')
        call tap%near(faired_energy(fairing), figures(3), 6.0e-11_dp, '... with its energy')
        call tap%near(fairing%deviation, figures(4), 6.0e-11_dp, '... and deviation')
        call tap%ok(fairing%steps >= 3 .and. fairing%steps <= 5, '... in 3 to 5 steps of Newton')
    end subroutine check_area

    !> The open form, as in the paper.
    subroutine check_open(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(fairing_type) :: fairing

        call check_figures(tap, faired_inlet(1.0e6_dp, fairing_end%free, 0.0_dp), &
            [1.2763644078_dp, 0.5097238554_dp, 2.0430049602_dp, 1.1980909201_dp, 5.9048e-6_dp], &
            'open, weight 1e6')
        fairing = faired_inlet(100.0_dp, fairing_end%free, 0.0_dp)
        call check_figures(tap, fairing, [0.3639321162_dp, 0.3103063085_dp, 0.4175579240_dp, &
            1.1927295002_dp, 0.0207209168_dp], 'open, weight 100')
        call tap%near(fairing%area_slope, -0.0062097486_dp, 6.0e-11_dp, '... slope of the area')
        call tap%near(maxval(abs(fairing%vertex(:, :4) - reshape([0.3742413720_dp, &
            -0.2973318523_dp, 0.5186294875_dp, -0.0030320862_dp, 0.5608109940_dp, &
            0.3049461484_dp, 0.5032640331_dp, 0.6047162749_dp], [2, 4]))), 0.0_dp, 6.0e-11_dp, &
            '... first vertices')
        call check_figures(tap, faired_inlet(1.0_dp, fairing_end%free, 0.0_dp), &
            [0.1169460986_dp, 0.1913809988_dp, 0.0425111984_dp, 1.1143775177_dp, &
            0.0864675011_dp], 'open, weight 1')
        call check_area(tap, inlet_data(100.0_dp, fairing_end%free), [1.18_dp, 2.0672755095_dp, &
            0.3592412679_dp, 0.0243991044_dp], 'open, area 1.18')
        call check_area(tap, inlet_data(100.0_dp, fairing_end%free), [1.2_dp, -1.1652226277_dp, &
            0.3668208974_dp, 0.0212893557_dp], 'open, area 1.2')
        call tap%near(critical_multiplier(inlet_data(100.0_dp, fairing_end%free)), 147.129_dp, &
            5.0e-4_dp, 'critical multiplier of the open inlet')
    end subroutine check_open

    !> The closed form.
    subroutine check_closed(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(fairing_type) :: fairing

        call check_figures(tap, faired_inlet(1.0e6_dp, fairing_end%closed, 0.0_dp), &
            [1.4202488113_dp, 0.5082742853_dp, 2.3322233372_dp, 1.1967199850_dp, 5.8363e-6_dp], &
            'closed, weight 1e6')
        fairing = faired_inlet(100.0_dp, fairing_end%closed, 0.0_dp)
        call check_figures(tap, fairing, [0.3711988229_dp, 0.3080390458_dp, 0.4343586001_dp, &
            1.1924299839_dp, 0.0208367921_dp], 'closed, weight 100')
        call tap%near(fairing%area_slope, -0.0055862192_dp, 6.0e-11_dp, '... slope of the area')
        call check_figures(tap, faired_inlet(1.0_dp, fairing_end%closed, 0.0_dp), &
            [0.1340057244_dp, 0.2159858353_dp, 0.0520256135_dp, 1.1244644664_dp, &
            0.0784675219_dp], 'closed, weight 1')
        call check_area(tap, inlet_data(100.0_dp, fairing_end%closed), [1.18_dp, &
            2.2421231135_dp, 0.3676866940_dp, 0.0249152430_dp], 'closed, area 1.18')
        call tap%near(critical_multiplier(inlet_data(100.0_dp, fairing_end%closed)), 148.812_dp, &
            5.0e-4_dp, 'critical multiplier of the closed inlet')
        call tap%near(maxval(abs(fairing%vertex(1, :) + cshift(fairing%vertex(1, 14:1:-1), 3))), &
            0.0_dp, 1.0e-13_dp, 'a mirror-symmetric outline stays so: breadths')
        call tap%near(maxval(abs(fairing%vertex(2, :) - cshift(fairing%vertex(2, 14:1:-1), 3))), &
            0.0_dp, 1.0e-13_dp, '... heights')
    end subroutine check_closed

    !> Newton's steps by hand, from the slope of the area.
    subroutine check_steps(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp), parameter :: wanted(3) = [2.0499220033_dp, 2.0672742898_dp, 2.0672755095_dp]
        type(fairing_type) :: fairing
        real(dp) :: lambda
        integer :: i

        lambda = 0.0_dp
        do i = 1, 3
            fairing = faired_inlet(100.0_dp, fairing_end%free, lambda)
            lambda = lambda - (fairing%area - 1.18_dp)/fairing%area_slope
            call tap%near(lambda, wanted(i), 6.0e-11_dp, 'a step of Newton''s')
        end do
    end subroutine check_steps

    !> Held ends are the first and the last point; the others are where the least is, by comparison
    !> with huge weights at the ends.
    subroutine check_held(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(fairing_data_type) :: given
        type(fairing_type) :: held, heavy
        type(error_type), allocatable :: error

        given = inlet_data(10.0_dp, fairing_end%held)
        call fair(given, 0.3_dp, held, error)
        given%ends = fairing_end%free
        given%weight([1, 15]) = 1.0e9_dp
        call fair(given, 0.3_dp, heavy, error)
        call tap%near(maxval(abs(held%near(:, [1, 15]) - inlet(:, [1, 15]))), 0.0_dp, 0.0_dp, &
            'held ends are given points to the bit')
        call tap%near(maxval(abs(held%vertex - heavy%vertex)), 0.0_dp, 1.0e-7_dp, &
            'they are what huge weights lead to')
        given%point = reshape([0.0_dp, 1.0_dp, 1.0_dp, 3.0_dp, 2.0_dp, 5.0_dp], [2, 3])
        given%weight = [0.0_dp, 0.0_dp, 0.0_dp]
        given%ends = fairing_end%held
        call fair(given, 0.0_dp, held, error)
        call tap%near(held%near(2, 2), 3.0_dp, 1.0e-14_dp, 'held by its ends alone it is straight')
    end subroutine check_held

    !> Rotation, translation, size and direction.
    subroutine check_moved(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp), parameter :: turn(2, 2) = reshape([0.6_dp, 0.8_dp, -0.8_dp, 0.6_dp], [2, 2])
        type(fairing_data_type) :: given
        type(fairing_type) :: base, moved
        type(error_type), allocatable :: error

        base = faired_inlet(100.0_dp, fairing_end%closed, 2.0_dp)
        given = inlet_data(100.0_dp, fairing_end%closed)
        given%point = matmul(turn, given%point)
        call fair(given, 2.0_dp, moved, error)
        call check_same(tap, base, moved, 1.0_dp, 'rotated')
        given%point = inlet(:, :14) + spread([3.0_dp, -7.0_dp], 2, 14)
        call fair(given, 2.0_dp, moved, error)
        call check_same(tap, base, moved, 1.0_dp, 'moved')
        given%point = 5.0_dp*inlet(:, :14)
        call fair(given, 2.0_dp, moved, error)
        call check_same(tap, base, moved, 25.0_dp, 'enlarged')
        given%point = inlet(:, 14:1:-1)
        call fair(given, -2.0_dp, moved, error)
        moved%area = -moved%area
        call check_same(tap, base, moved, 1.0_dp, 'run backwards, the area negative')
    end subroutine check_moved

    !> Compares energies and areas.
    subroutine check_same(tap, base, moved, factor, name)
        type(tap_type), intent(inout) :: tap        !! the tally
        type(fairing_type), intent(in) :: base      !! a faired curve
        type(fairing_type), intent(in) :: moved     !! the same elsewhere
        real(dp), intent(in) :: factor              !! of its area
        character(*), intent(in) :: name            !! what was done
        call tap%near(maxval(abs(moved%energy/factor - base%energy)), 0.0_dp, 1.0e-12_dp, &
            name//': the energies are the same')
        call tap%near(moved%area/factor, base%area, 1.0e-13_dp, name//': the area is the same')
    end subroutine check_same

    !> The heavier the weights, the more energy and the less misfit; and an identity between two.
    subroutine check_weights(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(fairing_type) :: light, heavy
        real(dp) :: step(2), weight
        integer :: i

        do i = 0, 5
            weight = 10.0_dp**(i - 2)
            light = faired_inlet(weight, fairing_end%closed, 0.0_dp)
            heavy = faired_inlet(10.0_dp*weight, fairing_end%closed, 0.0_dp)
            call tap%ok(faired_energy(light) < faired_energy(heavy), 'heavier: more energy')
            call tap%ok(light%misfit/weight > heavy%misfit/(10.0_dp*weight), '... nearer')
            step = spline_energy(heavy%vertex - light%vertex, .true.)
            call tap%near(0.5_dp*sum(step), faired_energy(heavy) - faired_energy(light) &
                - 2.0_dp*weight*sum((inlet(:, :14) - light%near)*(heavy%near - light%near)), &
                1.0e-12_dp, '... the energy between them')
        end do
        light = faired_inlet(100.0_dp, fairing_end%closed, 2.2421231135_dp)
        heavy = faired_inlet(100.0_dp, fairing_end%closed, 0.0_dp)
        call tap%ok(faired_energy(light) + light%misfit > faired_energy(heavy) + heavy%misfit, &
            'an area asked for costs energy and misfit')
    end subroutine check_weights

    !> Areas that can't be reached.
    subroutine check_range(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(fairing_data_type) :: given
        type(fairing_type) :: fairing
        type(error_type), allocatable :: error
        real(dp) :: angle
        integer :: i

        given%ends = fairing_end%closed
        allocate (given%point(2, 12))
        do i = 1, 12
            angle = acos(-1.0_dp)*real(i, dp)/6.0_dp
            given%point(:, i) = [cos(angle), sin(angle)]
        end do
        allocate (given%weight(12), source=10.0_dp)
        call fair_to_area(given, 3.0_dp, fairing, error)
        call tap%near(fairing%area, 3.0_dp, 3.0e-10_dp, 'a circle is given the area 3')
        call tap%near(maxval(norm2(fairing%near, dim=1)) - minval(norm2(fairing%near, dim=1)), &
            0.0_dp, 1.0e-13_dp, '... and is a circle')
        call fair_to_area(given, -100.0_dp, fairing, error)
        call tap%ok(allocated(error), 'an area that can''t be reached is refused')
        call tap%ok(error%cause == cause%no_area, '... as that')
        call tap%has(error%message, 'with these weights it is from ', '... with what can be')
    end subroutine check_range

    !> What can't be faired.
    subroutine check_bad(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(fairing_data_type) :: given
        type(fairing_type) :: fairing
        type(error_type), allocatable :: error

        given = inlet_data(100.0_dp, fairing_end%closed)
        call fair(given, 149.0_dp, fairing, error)
        call tap%ok(error%cause == cause%singular, 'a multiplier beyond the critical is refused')
        call tap%has(error%message, 'from -148.81', '... and the critical one said')
        given%beta = 1.01_dp
        call fair(given, 0.0_dp, fairing, error)
        call tap%ok(error%cause == cause%bad_weight, 'beta of 1.01 is refused')
        given%beta = 0.0_dp
        given%ends = fairing_end%free
        given%weight(3:) = 0.0_dp
        call fair(given, 0.0_dp, fairing, error)
        call tap%ok(error%cause == cause%singular, 'two points fix no parabola')
        given%beta = 0.5_dp
        call fair(given, 0.0_dp, fairing, error)
        call tap%ok(.not. allocated(error), '... but a straight line')
        given%weight(3) = -1.0_dp
        call fair_to_area(given, 1.0_dp, fairing, error)
        call tap%ok(error%cause == cause%bad_weight, 'a weight below zero is refused')
        given%weight = 0.0_dp
        given%ends = fairing_end%closed
        call fair(given, 0.0_dp, fairing, error)
        call tap%ok(error%cause == cause%singular, 'points without weight are refused')
        given%point = inlet(:, :2)
        given%weight = [1.0_dp, 1.0_dp]
        call fair(given, 0.0_dp, fairing, error)
        call tap%ok(error%cause == cause%too_few, 'two points fix no closed curve')
        given%point = inlet(:, [1, 2, 2, 5])
        given%weight = [1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp]
        call fair(given, 0.0_dp, fairing, error)
        call tap%ok(.not. allocated(error), 'a point that was measured twice is no trouble')
    end subroutine check_bad

end program test_fairing
