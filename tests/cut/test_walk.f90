!> The way along a track: the length of a semicircle from its speed, coordinates from levels.
program test_walk
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_skin, only: skin_type
    use cut_plane, only: waterline_plane
    use cut_track, only: track_type, tracks_on
    use cut_walk, only: coordinate_type, point_at, skin_on, speed_type, station_of
    use geom_quadrature, only: integrate
    use support_bodies, only: ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(track_type), allocatable :: tracks(:)
    type(speed_type) :: speed
    type(coordinate_type) :: breadth
    type(skin_type) :: skin
    type(error_type), allocatable :: error
    real(dp) :: length

    body = ellipsoid([5.0_dp, 5.0_dp, 5.0_dp], 0.0_dp, 0.0_dp)
    allocate (tracks(0))
    tracks = tracks_on(body, 2, waterline_plane(3.0_dp), [-10.0_dp, 10.0_dp])
    speed%body = body
    speed%plane = waterline_plane(3.0_dp)
    speed%track = tracks(1)
    call integrate(speed, 0.0_dp, 1.0_dp, 1.0e-9_dp, length, error)
    call tap%ok(.not. allocated(error), 'the speed along a waterline of a sphere can be integrated')
    call tap%near(length, 4.0_dp*acos(-1.0_dp), 1.0e-8_dp, 'to half the circumference of radius 4')
    breadth = coordinate_type(body=body, plane=speed%plane, track=tracks(1), axis=2, level=3.0_dp)
    call tap%near(breadth%at(0.0_dp), 1.0_dp, 1.0e-15_dp, 'amidships it is 1 wider than 3')
    call tap%near(norm2(point_at(body, speed%plane, tracks(1), 2.4_dp) - [2.4_dp, 3.2_dp, &
        3.0_dp]), 0.0_dp, &
        1.0e-15_dp, '2.4 aft of that it is 3.2')
    skin = skin_on(body, speed%plane, tracks(1), 2.4_dp)
    call tap%near(norm2(skin%normal - [0.48_dp, 0.64_dp, 0.6_dp]), 0.0_dp, 1.0e-15_dp, &
        'with its normal')
    call tap%ok(station_of(tracks(1), 0.0_dp) == tracks(1)%from%sta .and. &
        station_of(tracks(1), 1.0_dp) == tracks(1)%to%sta, 'the parameter goes from end to end')
    call tap%near(station_of(tracks(1), 0.5_dp), 0.0_dp, 1.0e-14_dp, 'through the middle')
    call tap%finish()
end program test_walk
