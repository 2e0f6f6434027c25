!> Limits along BL and WL, of tracks and of arcs, on a sphere of radius 5.
program test_clip
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_clip, only: clipped, places_within
    use cut_plane, only: waterline_plane
    use cut_request, only: limit_type, request_type
    use cut_track, only: track_type, tracks_on
    use geom_arc, only: arc_through, arc_type, end_type
    use geom_arc_point, only: point
    use geom_place, only: is_finish, is_start, place_type
    use support_bodies, only: ellipsoid
    use support_cutting, only: by_number
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(track_type), allocatable :: tracks(:), parts(:)
    type(request_type) :: request
    type(arc_type) :: circle
    type(place_type), allocatable :: places(:)
    type(limit_type) :: limit(2)
    type(error_type), allocatable :: error

    body = ellipsoid([5.0_dp, 5.0_dp, 5.0_dp], 0.0_dp, 0.0_dp)
    request = by_number(waterline_plane(3.0_dp), 5)
    tracks = tracks_on(body, 2, request%plane, [-10.0_dp, 10.0_dp])
    allocate (parts(0))
    parts = clipped(body, request, tracks)
    call tap%ok(size(parts) == 1, 'without limits a track is whole')
    request%limit(2) = limit_type(.true., .false., from=2.4_dp)
    parts = clipped(body, request, tracks)
    call tap%ok(size(parts) == 1, 'beyond BL 2.4 there is one part')
    call tap%near(maxval(abs([parts(1)%from%sta + 3.2_dp, parts(1)%to%sta - 3.2_dp])), 0.0_dp, &
        1.0e-14_dp, &
        'from -3.2 to 3.2')
    request%limit(2) = limit_type(.true., .true., 2.4_dp, 3.2_dp)
    parts = clipped(body, request, tracks)
    call tap%ok(size(parts) == 2, 'between BL 2.4 and 3.2 there are two')
    call tap%near(parts(2)%from%sta, 2.4_dp, 1.0e-14_dp, 'the second from 2.4 on')
    request%limit(2) = limit_type(.true., .false., from=4.5_dp)
    parts = clipped(body, request, tracks)
    call tap%ok(size(parts) == 0, 'beyond the track there is none')
    request%limit(2) = limit_type()
    request%limit(3) = limit_type(.true., .true., 3.0_dp, 3.0_dp)
    parts = clipped(body, request, tracks)
    call tap%ok(size(parts) == 1, 'a limit at its own waterline leaves it')

    call arc_through(end_type([0.0_dp, -5.0_dp], [1.0_dp, 0.0_dp]), [3.0_dp, -4.0_dp], &
        end_type([5.0_dp, 0.0_dp], [0.0_dp, 1.0_dp]), circle, error)
    allocate (places(0))
    places = places_within(circle, limit)
    call tap%ok(size(places) == 2 .and. is_start(places(1)) .and. is_finish(places(2)), &
        'without limits an arc is whole')
    limit(1) = limit_type(.true., .true., 3.0_dp, 4.0_dp)
    places = places_within(circle, limit)
    call tap%ok(size(places) == 2, 'between BL 3 and 4 there is one part')
    call tap%near(norm2(point(circle, places(1)) - [3.0_dp, -4.0_dp]), 0.0_dp, 1.0e-15_dp, &
        'from (3, -4)')
    call tap%near(norm2(point(circle, places(2)) - [4.0_dp, -3.0_dp]), 0.0_dp, 1.0e-15_dp, &
        'to (4, -3)')
    limit(2) = limit_type(.true., .false., from=-2.0_dp)
    places = places_within(circle, limit)
    call tap%ok(size(places) == 0, 'above WL -2 none of it is left')
    call tap%finish()
end program test_clip
