!> The points that an outline has from a track: those worked out one after another, aft and forward,
!> with and without the ends that its neighbours say.
program test_strand
    use base_error, only: error_type
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_outline, only: cut_point_type
    use cut_plane, only: buttock_plane
    use cut_point, only: point_on_track, turned_back
    use cut_request, only: cut_fact, request_type
    use cut_strand, only: close_at, join, points_said, say_points, spread_on, strand_type
    use cut_track, only: track_type, tracks_on
    use support_bodies, only: ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    integer, parameter :: number = 7
    type(tap_type) :: tap
    type(body_type) :: body
    type(track_type), allocatable :: tracks(:)
    type(request_type) :: request
    type(strand_type) :: aft, forward
    type(error_type), allocatable :: error

    body = ellipsoid([30.0_dp, 5.0_dp, 7.0_dp], 11.0_dp, 3.0_dp)
    request%plane = buttock_plane(2.0_dp)
    request%number = number
    allocate (tracks(0))
    tracks = tracks_on(body, 1, request%plane, [-100.0_dp, 100.0_dp])
    call spread_on(body, request, tracks(1), .true., aft, error)
    call tap%ok(.not. allocated(error), 'a track has points')
    call spread_on(body, request, tracks(1), .false., forward, error)
    call check(aft, .false., 'aft')
    call check(forward, .true., 'forward')

    call join(aft, forward)
    call tap%ok(.not. forward%says(1), 'where a track turns back it says no point again')
    call tap%ok(points_said(forward) == number - 1, 'it has one point less then')
    call check(forward, .true., 'forward from there')
    call close_at(forward, aft)
    call tap%ok(.not. forward%says(2), 'nor at the end of a closed outline')
    call check(forward, .true., 'forward between two others')
    call join(aft, aft)
    call tap%ok(aft%says(1), 'ends that are apart are both said')
    request%number = 2
    call spread_on(body, request, tracks(1), .true., aft, error)
    call tap%ok(points_said(aft) == 2, 'two points are the ends')
    call check(aft, .false., 'the ends')
    request%number = 100000000
    request%rule = 3
    request%step = 1.0e-9_dp
    call spread_on(body, request, tracks(1), .true., aft, error)
    call tap%ok(allocated(error), 'too many points are refused')
    call tap%finish()

contains

    !> Compares the points of a strand with those of its stations.
    subroutine check(strand, is_back, name)
        type(strand_type), intent(in) :: strand
        logical, intent(in) :: is_back
        character(*), intent(in) :: name
        type(cut_point_type) :: points(points_said(strand)), one
        real(dp), allocatable :: sta(:)
        real(dp) :: off, turn
        integer :: i

        request%facts = cut_fact%all
        call say_points(body, request, tracks(1), strand, points)
        sta = [tracks(1)%from%sta, strand%inside, tracks(1)%to%sta]
        if (is_back) sta = [tracks(1)%to%sta, strand%inside, tracks(1)%from%sta]
        sta = pack(sta, [strand%says(1), (.true., i=1, size(strand%inside)), strand%says(2)])
        call tap%ok(size(sta) == size(points) .and. all(is_equal(points%at(1), sta)), &
            'points at the stations: '//name)
        off = 0.0_dp
        turn = 0.0_dp
        do i = 1, size(points)
            one = point_on_track(body, request%plane, tracks(1), sta(i), .false.)
            if (is_back) one = turned_back(one)
            off = max(off, maxval(abs(points(i)%at - one%at)))
            turn = max(turn, abs(points(i)%curvature - one%curvature))
        end do
        call tap%near(off, 0.0_dp, 1.0e-14_dp, 'where one alone is: '//name)
        call tap%near(turn, 0.0_dp, 1.0e-12_dp, 'turning as the outline goes: '//name)
    end subroutine check

end program test_strand
