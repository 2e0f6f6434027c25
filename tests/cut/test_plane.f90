!> Planes: their true-shape axes as the trade draws them, heights, flanges.
program test_plane
    use base_error, only: error_type
    use base_kinds, only: dp
    use cut_plane, only: buttock_plane, cut_kind, flange_normal, height_over, in_space, in_view, &
        oblique_plane, plane_through, plane_type, station_plane, true_shape, waterline_plane
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: sta(3) = [1.0_dp, 0.0_dp, 0.0_dp], bl(3) = [0.0_dp, 1.0_dp, 0.0_dp], &
        wl(3) = [0.0_dp, 0.0_dp, 1.0_dp], p(3) = [7.0_dp, 8.0_dp, 9.0_dp]
    type(tap_type) :: tap
    type(plane_type) :: plane
    type(error_type), allocatable :: error

    plane = station_plane(5.0_dp)
    call tap%ok(all(plane%u == bl) .and. all(plane%v == wl), 'a station is seen as WL over BL')
    call tap%near(height_over(plane, p), 2.0_dp, 0.0_dp, 'heights over it are along STA')
    call tap%ok(all(true_shape(plane, p) == [8.0_dp, 9.0_dp]), &
        'its true shape has the coordinates themselves')
    plane = buttock_plane(5.0_dp)
    call tap%ok(all(plane%u == sta) .and. all(plane%v == wl), 'a buttock is seen as WL over STA')
    plane = waterline_plane(5.0_dp)
    call tap%ok(all(plane%u == sta) .and. all(plane%v == bl), 'a waterline is seen as BL over STA')
    call tap%ok(all(in_view(plane, p) == [7.0_dp, 8.0_dp]), 'a vector has two parts in it')
    call oblique_plane([20.0_dp, -16.0_dp], [30.0_dp, -6.0_dp], plane, error)
    call tap%ok(plane%kind == cut_kind%oblique .and. .not. allocated(error), &
        'an oblique plane by two points')
    call tap%near(abs(height_over(plane, [30.0_dp, 4.0_dp, -6.0_dp])), 0.0_dp, 0.0_dp, &
        'goes through both')
    call tap%ok(all(plane%origin == [20.0_dp, 0.0_dp, -16.0_dp]), 'its origin is the first')
    call tap%ok(all(plane%u == bl), 'its u is BL')
    call tap%near(norm2(plane%v - [1.0_dp, 0.0_dp, 1.0_dp]*sqrt(0.5_dp)), 0.0_dp, 1.0e-15_dp, &
        'its v goes up along the line')
    call oblique_plane([30.0_dp, -6.0_dp], [20.0_dp, -16.0_dp], plane, error)
    call tap%ok(plane%v(3) > 0.0_dp .and. all(plane%u == bl), 'also where the points come down')
    call oblique_plane([20.0_dp, -16.0_dp], [20.0_dp, -16.0_dp], plane, error)
    call tap%ok(allocated(error), 'one point is no oblique plane')
    call plane_through(p, [1.0_dp, 2.0_dp, 3.0_dp], plane, error)
    call tap%near(dot_product(plane%u, [1.0_dp, 2.0_dp, 3.0_dp]), 0.0_dp, 1.0e-15_dp, &
        'axes lie in a plane')
    call tap%near(dot_product(plane%v, [1.0_dp, 2.0_dp, 3.0_dp]), 0.0_dp, 1.0e-15_dp, 'both')
    call tap%near(dot_product(plane%u, plane%v), 0.0_dp, 1.0e-16_dp, 'across each other')
    call tap%near(norm2(plane%u) + norm2(plane%v), 2.0_dp, 1.0e-15_dp, 'of unit length')
    call tap%ok(plane%u(3) == 0.0_dp .and. plane%u(2) > 0.0_dp .and. plane%v(3) > 0.0_dp, &
        'u level to starboard, v up')
    call tap%near(norm2(true_shape(plane, in_space(plane, [3.0_dp, 4.0_dp])) - [3.0_dp, 4.0_dp]), &
        0.0_dp, &
        1.0e-14_dp, 'true shape and space go back and forth')
    call plane_through(p, [0.0_dp, 0.0_dp, 0.0_dp], plane, error)
    call tap%ok(allocated(error), 'a normal of nothing is none')
    call plane_through(p, [-2.0_dp, 0.0_dp, 0.0_dp], plane, error)
    call tap%ok(all(flange_normal(plane, .false.) == sta), &
        'an aft flange is on the aft side whatever the normal')
    call tap%ok(all(flange_normal(plane, .true.) == -sta), 'a forward one on the other')
    call tap%ok(all(flange_normal(buttock_plane(3.0_dp), .false.) == bl), &
        'aft of a buttock is to starboard')
    call tap%finish()
end program test_plane
