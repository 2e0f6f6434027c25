!> Coons patches by the Boolean sum: the figures worked out for the seed's formulas, what holds of
!> every patch, frames whose sides do not agree.
program test_coons
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_bicubic, only: bicubic_point, corners_of_frame, zero_twists
    use geom_coons, only: check_corners, coons_jet, coons_point, coons_type, corner_gaps, &
        new_coons, patch_jet_type, twist_gaps
    use geom_coons_blend, only: blend
    use support_coons_frames, only: broken_frame_type, power_frame_type, power_jet, &
        seed_frame_type, seed_surface
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_facts(tap)
    call check_sides(tap)
    call check_polynomials(tap)
    call check_derivatives(tap)
    call check_neighbours(tap)
    call check_faults(tap)
    call tap%finish()

contains

    !> The figures of the surface (u + .1 v (1 - v), v, exp(u) sin(2 v) + u**6 v**5) at (.3, .7).
    subroutine check_facts(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(seed_frame_type) :: frame
        type(patch_jet_type) :: corner
        real(dp) :: h(3, 4, 4)
        real(dp) :: point(3)
        integer :: kind
        real(dp), parameter :: z(4) = [1.2289429971074_dp, 1.2035514858643_dp, &
            1.3108926659833_dp, 1.3303405346621_dp]
        real(dp), parameter :: twist(3) = [1.78343183856_dp, 0.0_dp, 2.0_dp]
        character(10), parameter :: name(4) = [character(10) :: 'linear', 'cubic', 'slopes', &
            'curvatures']

        do kind = 1, 4
            point = coons_point(new_coons(frame, kind), 0.3_dp, 0.7_dp)
            call tap%near(point(3), z(kind), 6.0e-14_dp, 'z of the seed''s patch, '//name(kind))
            call tap%near(maxval(abs(point(:2) - [0.321_dp, 0.7_dp])), 0.0_dp, 1.0e-15_dp, &
                'x and y of it, '//name(kind))
        end do
        do kind = 1, 3
            corner = coons_jet(new_coons(frame, kind), 0.0_dp, 0.0_dp)
            call tap%near(corner%uv(3), twist(kind), 6.0e-12_dp, &
                'its twist at (0, 0), '//name(kind))
        end do
        point = seed_surface(0.3_dp, 0.7_dp, 0, 0)
        call tap%near(point(3), 1.3303405204783_dp, 6.0e-14_dp, 'z of the surface itself')
        h = corners_of_frame(frame)
        point = bicubic_point(h, 0.3_dp, 0.7_dp)
        call tap%near(point(3), 1.2867484746879_dp, 6.0e-14_dp, 'z of the bicubic patch')
        call tap%near(maxval(abs(point(:2) - [0.321_dp, 0.7_dp])), 0.0_dp, 1.0e-15_dp, &
            'x and y of the bicubic patch')
        point = bicubic_point(zero_twists(h), 0.3_dp, 0.7_dp)
        call tap%near(point(3), 1.0149413294563_dp, 6.0e-14_dp, 'z of Ferguson''s patch')
    end subroutine check_facts

    !> Sides, slopes and second derivatives are kept, on all four sides.
    subroutine check_sides(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(seed_frame_type) :: frame
        type(patch_jet_type) :: jet
        type(coons_type) :: patch
        real(dp) :: off(0:2), t, end
        integer :: kind, i, side

        do kind = 1, 4
            patch = new_coons(frame, kind)
            off = 0.0_dp
            do side = 0, 1
                end = real(side, dp)
                do i = 0, 20
                    t = real(i, dp)/20.0_dp
                    jet = coons_jet(patch, end, t)
                    off(0) = max(off(0), maxval(abs(jet%at - seed_surface(end, t, 0, 0))))
                    off(1) = max(off(1), maxval(abs(jet%u - seed_surface(end, t, 1, 0))))
                    off(2) = max(off(2), maxval(abs(jet%uu - seed_surface(end, t, 2, 0))))
                    jet = coons_jet(patch, t, end)
                    off(0) = max(off(0), maxval(abs(jet%at - seed_surface(t, end, 0, 0))))
                    off(1) = max(off(1), maxval(abs(jet%v - seed_surface(t, end, 0, 1))))
                    off(2) = max(off(2), maxval(abs(jet%vv - seed_surface(t, end, 0, 2))))
                end do
            end do
            call tap%near(off(0), 0.0_dp, 1.0e-12_dp, 'a patch keeps its sides')
            if (kind >= blend%slopes) call tap%near(off(1), 0.0_dp, 1.0e-12_dp, &
                'a patch with slopes keeps them')
            if (kind < blend%slopes) call tap%ok(off(1) > 0.1_dp, &
                'a patch of sides alone does not keep slopes')
            if (kind == blend%curvatures) call tap%near(off(2), 0.0_dp, 1.0e-12_dp, &
                'a patch with curvatures keeps them')
        end do
    end subroutine check_sides

    !> Which polynomial surfaces a patch is, exactly; maps and exchange of u and v.
    subroutine check_polynomials(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(power_frame_type) :: frame, mapped, turned
        type(random_type) :: random
        real(dp) :: map(3, 3), off, moved, exchanged
        integer, parameter :: degree(4) = [1, 1, 3, 5]
        integer :: kind, i, k, l

        do kind = 1, 4
            allocate (frame%c(3, degree(kind) + 1, degree(kind) + 1))
            do l = 1, degree(kind) + 1
                do k = 1, degree(kind) + 1
                    frame%c(:, k, l) = [(random%between(-1.0_dp, 1.0_dp), i = 1, 3)]
                end do
            end do
            ! Blended by cubics a saddle has no twists, and so is no saddle.
            if (kind == blend%cubic) frame%c(:, 2, 2) = 0.0_dp
            map = reshape([(random%between(-1.0_dp, 1.0_dp), i = 1, 9)], [3, 3])
            mapped = frame
            do l = 1, degree(kind) + 1
                do k = 1, degree(kind) + 1
                    mapped%c(:, k, l) = matmul(map, frame%c(:, k, l))
                end do
            end do
            mapped%c(:, 1, 1) = mapped%c(:, 1, 1) + [1.0_dp, 2.0_dp, -3.0_dp]
            turned = frame
            turned%is_swapped = .true.
            off = 0.0_dp
            moved = 0.0_dp
            exchanged = 0.0_dp
            do i = 1, 50
                associate (u => random%between(0.0_dp, 1.0_dp), v => random%between(0.0_dp, 1.0_dp))
                    off = max(off, maxval(abs(coons_point(new_coons(frame, kind), u, v) &
                        - power_jet(frame%c, u, v, 0, 0))))
                    moved = max(moved, maxval(abs(coons_point(new_coons(mapped, kind), u, v) &
                        - matmul(map, coons_point(new_coons(frame, kind), u, v)) &
                        - [1.0_dp, 2.0_dp, -3.0_dp])))
                    exchanged = max(exchanged, maxval(abs( &
                        coons_point(new_coons(turned, kind), v, u) &
                        - coons_point(new_coons(frame, kind), u, v))))
                end associate
            end do
            call tap%near(off, 0.0_dp, 1.0e-13_dp, 'the patch of a surface of its own kind is it')
            call tap%near(moved, 0.0_dp, 1.0e-13_dp, 'a patch goes with an affine map')
            call tap%near(exchanged, 0.0_dp, 1.0e-14_dp, 'u and v may be exchanged')
            deallocate (frame%c)
        end do
    end subroutine check_polynomials

    !> Derivatives inside against differences of points.
    subroutine check_derivatives(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp), parameter :: h = 1.0e-3_dp, u = 0.3_dp, v = 0.6_dp
        type(seed_frame_type) :: frame
        type(coons_type) :: patch
        type(patch_jet_type) :: jet
        real(dp) :: p(3, -1:1, -1:1)
        integer :: kind, i, j

        do kind = 1, 4
            patch = new_coons(frame, kind)
            jet = coons_jet(patch, u, v)
            do j = -1, 1
                do i = -1, 1
                    p(:, i, j) = coons_point(patch, u + real(i, dp)*h, v + real(j, dp)*h)
                end do
            end do
            call tap%near(norm2(jet%u - (p(:, 1, 0) - p(:, -1, 0))/(2.0_dp*h)), 0.0_dp, 1.0e-5_dp, &
                'derivative by u')
            call tap%near(norm2(jet%v - (p(:, 0, 1) - p(:, 0, -1))/(2.0_dp*h)), 0.0_dp, 1.0e-5_dp, &
                'derivative by v')
            call tap%near(norm2(jet%uu - (p(:, 1, 0) - 2.0_dp*jet%at + p(:, -1, 0))/h**2), 0.0_dp, &
                1.0e-4_dp, 'second derivative by u')
            call tap%near(norm2(jet%vv - (p(:, 0, 1) - 2.0_dp*jet%at + p(:, 0, -1))/h**2), 0.0_dp, &
                1.0e-4_dp, 'second derivative by v')
            call tap%near(norm2(jet%uv - (p(:, 1, 1) - p(:, -1, 1) - p(:, 1, -1) + p(:, -1, -1)) &
                /(4.0_dp*h**2)), 0.0_dp, 1.0e-4_dp, 'twist')
        end do
    end subroutine check_derivatives

    !> Two patches side by side that share a side: here a surface for u above 0 and for u below 0,
    !> which go into each other with their slope, and with (8) so do the patches.
    subroutine check_neighbours(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(power_frame_type) :: left, right
        type(patch_jet_type) :: before, after
        real(dp) :: c(3, 5, 5), off
        integer :: i, k, l

        c = 0.0_dp
        do l = 1, 5
            do k = 1, 5
                c(:, k, l) = [sin(real(3*k + l, dp)), cos(real(k*l, dp)), sin(real(k - 2*l, dp))]
            end do
        end do
        right%c = c
        left%c = c
        do k = 2, 5, 2
            left%c(:, k, :) = -c(:, k, :)
        end do
        off = 0.0_dp
        do i = 0, 10
            before = coons_jet(new_coons(left, blend%slopes), 0.0_dp, real(i, dp)/10.0_dp)
            after = coons_jet(new_coons(right, blend%slopes), 0.0_dp, real(i, dp)/10.0_dp)
            off = max(off, norm2(before%at - after%at), norm2(before%u + after%u))
        end do
        call tap%near(off, 0.0_dp, 1.0e-12_dp, 'neighbours agree in points and slopes')
    end subroutine check_neighbours

    !> Sides that do not meet, slopes that do not fit each other.
    subroutine check_faults(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(seed_frame_type) :: sound
        type(error_type), allocatable :: error
        real(dp) :: gap(0:1, 0:1)

        call check_corners(sound, 1.0e-12_dp, error)
        call tap%ok(.not. allocated(error), 'sides of one surface meet')
        gap = twist_gaps(sound)
        call tap%near(maxval(gap), 0.0_dp, 1.0e-14_dp, 'their twists agree')
        gap = corner_gaps(broken_frame_type(gap=0.25_dp))
        call tap%ok(all(abs(gap - reshape([0.0_dp, 0.0_dp, 0.0_dp, 0.25_dp], [2, 2])) &
            <= 0.0_dp), 'the gap of a corner')
        call check_corners(broken_frame_type(gap=0.25_dp), 0.001_dp, error)
        call tap%ok(allocated(error), 'sides that do not meet are an error')
        if (allocated(error)) then
            call tap%ok(error%cause == cause%joint_gap, 'its cause is a gap')
            call tap%same(error%message, 'sides 2 and 3 do not meet in corner 3: the gap is '// &
                '0.25; 0.001 is allowed', 'it names the corner and the gap')
        end if
        gap = twist_gaps(broken_frame_type(twist=0.5_dp))
        call tap%ok(all(abs(gap - reshape([0.5_dp, 0.0_dp, 0.5_dp, 0.0_dp], [2, 2])) <= 0.0_dp), &
            'twists that do not agree are told')
    end subroutine check_faults

end program test_coons
