!> What is said of a point of a cut: a sphere of radius 5 about (100, 0, 20), where all is known.
program test_point
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_outline, only: cut_point_type
    use cut_plane, only: buttock_plane, plane_type, station_plane, waterline_plane
    use cut_point, only: give_bevel, left_of, point_on_arc, point_on_track, turned_back
    use cut_track, only: track_type, tracks_on
    use geom_arc, only: arc_type
    use geom_place, only: at_finish, at_start
    use body_section, only: section_arc
    use base_error, only: error_type
    use support_bodies, only: ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: bl(3) = [0.0_dp, 1.0_dp, 0.0_dp], &
        wl(3) = [0.0_dp, 0.0_dp, 1.0_dp]
    type(tap_type) :: tap
    type(body_type) :: body
    type(plane_type) :: plane
    type(track_type), allocatable :: tracks(:)
    type(cut_point_type) :: point
    type(arc_type) :: arc
    type(error_type), allocatable :: error

    body = ellipsoid([5.0_dp, 5.0_dp, 5.0_dp], 100.0_dp, 20.0_dp)
    plane = waterline_plane(23.0_dp)
    allocate (tracks(0))
    tracks = tracks_on(body, 2, plane, [0.0_dp, 200.0_dp])
    point = point_on_track(body, plane, tracks(1), 100.0_dp, .false.)
    call tap%near(norm2(point%at - [100.0_dp, 4.0_dp, 23.0_dp]), 0.0_dp, 1.0e-14_dp, &
        'a waterline 3 up is 4 wide')
    call tap%near(norm2(point%normal - [0.0_dp, 0.8_dp, 0.6_dp]), 0.0_dp, 1.0e-15_dp, &
        'its normal is from the centre')
    call tap%near(point%bevel, -asin(0.6_dp)*180.0_dp/acos(-1.0_dp), 1.0e-13_dp, &
        'its bevel is -asin .6')
    call tap%near(point%curvature, -0.25_dp, 1.0e-14_dp, 'to starboard it turns right at 1/4')
    call tap%near(point%slope%value, 0.0_dp, 1.0e-15_dp, 'and goes straight aft')
    call tap%ok(all(point%uv == point%at(:2)), 'u and v are STA and BL')
    point = point_on_track(body, plane, tracks(1), 97.6_dp, .true.)
    call tap%near(point%slope%value, 0.75_dp, 1.0e-13_dp, '2.4 forward the slope is 3/4')
    call tap%near(point%bevel, asin(0.6_dp)*180.0_dp/acos(-1.0_dp), 1.0e-12_dp, &
        'a forward flange has the other bevel')
    point = point_on_track(body, plane, tracks(1), tracks(1)%from%sta, .false.)
    call tap%ok(point%slope%is_vertical, 'on the crown it is vertical, exactly')
    point = turned_back(point)
    call tap%near(point%curvature, 0.25_dp, 1.0e-12_dp, 'backwards it turns the other way')
    plane = buttock_plane(0.0_dp)
    tracks = tracks_on(body, 2, plane, [0.0_dp, 200.0_dp])
    point = point_on_track(body, plane, tracks(1), 95.0_dp, .false.)
    call tap%ok(point%has_normal .and. point%normal(1) == -1.0_dp, 'the round nose looks forward')
    call tap%ok(point%slope%is_vertical .and. .not. point%has_curvature, &
        'is vertical, of no curvature known')
    plane = station_plane(103.0_dp)
    call section_arc(body%lines, body%sections(1), 103.0_dp, arc, error)
    point = point_on_arc(body, 1, arc, at_start, plane, .false.)
    call tap%near(point%bevel, -asin(0.6_dp)*180.0_dp/acos(-1.0_dp), 1.0e-13_dp, &
        'a frame aft has a closed flange')
    call tap%near(point%curvature, 0.25_dp, 1.0e-15_dp, 'a radius of 4')
    point = point_on_arc(body, 1, arc, at_finish, plane, .false.)
    call tap%ok(point%slope%is_vertical, 'and is vertical at the side')
    call tap%ok(all(left_of(plane, bl) == wl), 'left of starboard is up, looking forward')
    call give_bevel([0.6_dp, 0.8_dp, 0.0_dp], plane, .true., point)
    call tap%near(point%bevel, asin(0.6_dp)*180.0_dp/acos(-1.0_dp), 1.0e-14_dp, &
        'a bevel is minus asin n.f')
    call tap%finish()
end program test_point
