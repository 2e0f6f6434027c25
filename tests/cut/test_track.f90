!> Tracks of planes on the sections of an ellipsoid: how many, from where to where, on which branch.
program test_track
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_event, only: happening
    use cut_meeting, only: cut_branch
    use cut_plane, only: buttock_plane, waterline_plane
    use cut_track, only: place_on, track_type, tracks_on
    use geom_place, only: is_finish, is_start, place_type
    use support_bodies, only: ellipsoid
    use support_cutting, only: plane_of
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: all_stations(2) = [-100.0_dp, 100.0_dp]
    type(tap_type) :: tap
    type(body_type) :: body
    type(track_type), allocatable :: tracks(:)
    type(place_type) :: place
    logical :: is_arc

    body = ellipsoid([5.0_dp, 2.0_dp, 1.0_dp], 0.0_dp, 0.0_dp)
    allocate (tracks(0))
    tracks = tracks_on(body, 1, buttock_plane(1.6_dp), all_stations)
    call tap%ok(size(tracks) == 1, 'a buttock has one track on the lower section')
    call tap%near(tracks(1)%from%sta, -3.0_dp, 1.0e-15_dp, 'from where the breadth reaches it')
    call tap%near(tracks(1)%to%sta, 3.0_dp, 1.0e-15_dp, 'to where it leaves it')
    call tap%ok(tracks(1)%branch == cut_branch%rising, 'outwards as the section runs')
    call place_on(body, buttock_plane(1.6_dp), tracks(1), tracks(1)%from%sta, place, is_arc)
    call tap%ok(is_arc .and. is_finish(place), 'where it begins it is on the edge, exactly')
    tracks = tracks_on(body, 1, buttock_plane(1.6_dp), [0.0_dp, 100.0_dp])
    call tap%ok(tracks(1)%from%sta == 0.0_dp .and. tracks(1)%from%kind == happening%nothing, &
        'limits shorten it')
    tracks = tracks_on(body, 1, buttock_plane(1.6_dp), [4.0_dp, 100.0_dp])
    call tap%ok(size(tracks) == 0, 'or leave nothing')
    tracks = tracks_on(body, 1, buttock_plane(0.0_dp), all_stations)
    call tap%ok(size(tracks) == 1 .and. tracks(1)%edge == 1, &
        'the plane of symmetry runs along the keel')
    call place_on(body, buttock_plane(0.0_dp), tracks(1), 1.0_dp, place, is_arc)
    call tap%ok(is_start(place), 'where the section starts')
    call place_on(body, buttock_plane(0.0_dp), tracks(1), -5.0_dp, place, is_arc)
    call tap%ok(.not. is_arc, 'at the nose there is no arc')
    tracks = tracks_on(body, 2, waterline_plane(-0.5_dp), all_stations)
    call tap%ok(size(tracks) == 0, 'a low waterline has none on the upper section')
    tracks = tracks_on(body, 2, plane_of([0.0_dp, 1.15_dp, 0.78_dp], [0.0_dp, 0.3_dp, 0.8_dp]), &
        all_stations)
    call tap%ok(size(tracks) == 2, 'an island has two tracks')
    call tap%ok(tracks(1)%branch == -tracks(2)%branch, 'one on each branch')
    call tap%ok(all(tracks%from%kind == happening%turn .and. tracks%to%kind == happening%turn), &
        'that turn into each other at both ends')
    call tap%finish()
end program test_track
