!> Bicubic patches: the seed's net in its three forms, the matrices between them, twists.
program test_bicubic
    use base_kinds, only: dp
    use geom_bicubic, only: adini_twists, bernstein_powers, bicubic_jet, bicubic_point, &
        corner_matrix, corners_of_frame, corners_of_net, hermite_powers, net_of_corners, &
        net_of_sides, net_point, side_powers, side_vector_point, sides_of_net, swapped, &
        vertex_matrix, zero_twists
    use geom_coons, only: coons_jet, coons_point, new_coons, patch_jet_type
    use geom_coons_blend, only: blend
    use support_coons_frames, only: power_frame_type, seed_frame_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_net(tap)
    call check_matrices(tap)
    call check_twists(tap)
    call tap%finish()

contains

    !> The net b(i, j) = (i, j, .3 i**2 - .2 i j + .1 j**3), i and j from 0.
    pure function seed_net() result(net)
        real(dp) :: net(3, 0:3, 0:3), x, y
        integer :: i, j
        do j = 0, 3
            do i = 0, 3
                x = real(i, dp)
                y = real(j, dp)
                net(:, i, j) = [x, y, 0.3_dp*x**2 - 0.2_dp*x*y + 0.1_dp*y**3]
            end do
        end do
    end function seed_net

    !> The figures of that net.
    subroutine check_net(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp), parameter :: at(3) = [0.9_dp, 2.1_dp, 1.3518_dp]
        real(dp), parameter :: z(4, 4) = transpose(reshape([real(dp) :: 0, 2.7_dp, 0.3_dp, 5.7_dp, &
            2.7_dp, 3.6_dp, -1.5_dp, 3.9_dp, 0.9_dp, -0.9_dp, -1.8_dp, -1.8_dp, &
            4.5_dp, 2.7_dp, -1.8_dp, -1.8_dp], [4, 4]))
        real(dp) :: net(3, 4, 4), h(3, 4, 4), side(3, 4, 4), point(3)

        net = seed_net()
        h = corners_of_net(net)
        side = sides_of_net(net)
        call tap%near(maxval(abs(net_point(net, 0.3_dp, 0.7_dp) - at)), 0.0_dp, 1.0e-15_dp, &
            'the point of the vertices')
        call tap%near(maxval(abs(bicubic_point(h, 0.3_dp, 0.7_dp) - at)), 0.0_dp, 1.0e-15_dp, &
            'the point of the corners')
        call tap%near(maxval(abs(side_vector_point(side, 0.3_dp, 0.7_dp) - at)), 0.0_dp, &
            1.0e-15_dp, 'the point of the side vectors')
        point = bicubic_point(zero_twists(h), 0.3_dp, 0.7_dp)
        call tap%near(point(3), 1.3390992_dp, 1.0e-15_dp, 'z of Ferguson''s patch')
        call tap%near(maxval(abs(h(3, :, :) - z)), 0.0_dp, 1.0e-14_dp, 'z of H')
        call tap%near(maxval(abs(side(3, 2:, 2:) + 0.2_dp)), 0.0_dp, 1.0e-15_dp, &
            'z of the inner side vectors is -.2')
        call tap%near(maxval(abs(net_of_corners(h) - net)), 0.0_dp, 1.0e-14_dp, &
            'the net out of the corners')
        call tap%near(maxval(abs(net_of_sides(side) - net)), 0.0_dp, 1.0e-14_dp, &
            'the net out of the side vectors')
        call tap%near(h(3, 3, 3), 9.0_dp*(net(3, 1, 1) - net(3, 1, 2) - net(3, 2, 1) &
            + net(3, 2, 2)), 1.0e-14_dp, 'the twist out of four vertices')
        call tap%near(maxval(abs(bicubic_point(swapped(h), 0.7_dp, 0.3_dp) - at)), 0.0_dp, &
            1.0e-15_dp, 'u and v exchanged')
    end subroutine check_net

    !> M T = M_B, S L = M_B, T times its inverse.
    subroutine check_matrices(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp), parameter :: l(4, 4) = transpose(reshape([real(dp) :: 1, 0, 0, 0, -1, 1, 0, 0, &
            0, -1, 1, 0, 0, 0, -1, 1], [4, 4]))
        real(dp) :: one(4, 4)
        integer :: i

        one = 0.0_dp
        do i = 1, 4
            one(i, i) = 1.0_dp
        end do
        call tap%ok(all(abs(matmul(hermite_powers, corner_matrix) - bernstein_powers) <= 0.0_dp), &
            'M T is Bernstein''s matrix, exactly')
        call tap%ok(all(abs(matmul(side_powers, l) - bernstein_powers) <= 0.0_dp), &
            'S L is Bernstein''s matrix, exactly')
        call tap%ok(all(abs(matmul(corner_matrix, vertex_matrix) - one) <= 0.0_dp), &
            'T times its inverse is 1')
    end subroutine check_matrices

    !> Twists: the bicubic patch is that of (8) between its own sides; Adini's twists are those of
    !> the bilinear blend, exact where the surface is u v.
    subroutine check_twists(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(power_frame_type) :: frame
        type(seed_frame_type) :: seed
        type(patch_jet_type) :: corner
        real(dp) :: h(3, 4, 4), off
        integer :: i, k, l

        allocate (frame%c(3, 4, 4))
        do l = 1, 4
            do k = 1, 4
                frame%c(:, k, l) = [sin(real(3*k + l, dp)), cos(real(k*l, dp)), &
                    sin(real(k - 2*l, dp))]
            end do
        end do
        h = corners_of_frame(frame)
        off = 0.0_dp
        do i = 0, 10
            associate (u => real(i, dp)/10.0_dp, v => real(mod(7*i, 10), dp)/10.0_dp)
                off = max(off, maxval(abs(bicubic_point(h, u, v) &
                    - coons_point(new_coons(frame, blend%slopes), u, v))))
            end associate
        end do
        call tap%near(off, 0.0_dp, 1.0e-13_dp, '(8) between cubics is the bicubic patch')
        h = adini_twists(corners_of_frame(seed))
        do i = 0, 3
            corner = coons_jet(new_coons(seed, blend%linear), real(mod(i, 2), dp), real(i/2, dp))
            call tap%near(maxval(abs(h(:, 3 + mod(i, 2), 3 + i/2) - corner%uv)), 0.0_dp, &
                1.0e-14_dp, 'Adini''s twist is that of the bilinear blend')
        end do
        frame%c = 0.0_dp
        frame%c(:, 2, 1) = [1.0_dp, 0.0_dp, 0.0_dp]
        frame%c(:, 1, 2) = [0.0_dp, 1.0_dp, 0.0_dp]
        frame%c(:, 2, 2) = [0.0_dp, 0.0_dp, 3.0_dp]
        h = adini_twists(zero_twists(corners_of_frame(frame)))
        call tap%near(maxval(abs(h - corners_of_frame(frame))), 0.0_dp, 1.0e-15_dp, &
            'a saddle gets its twists back')
        corner = bicubic_jet(zero_twists(h), 0.25_dp, 0.25_dp)
        call tap%near(corner%at(3), 3.0_dp*(0.5_dp*0.15625_dp - 0.15625_dp**2), 1.0e-15_dp, &
            'without twists it is blended by cubics and no saddle')
    end subroutine check_twists

end program test_bicubic
