!> Points by every rule along the waterline 3 of a sphere of radius 5: half a circle of radius 4.
program test_spread
    use base_decimal, only: decimal_type, grid_type, new_grid
    use base_error, only: cause, error_type
    use base_kinds, only: dp, i64
    use body_body, only: body_type
    use cut_plane, only: waterline_plane
    use cut_request, only: cut_rule, request_type
    use cut_spread, only: stations_on, steps_inside
    use cut_track, only: track_type, tracks_on
    use support_bodies, only: ellipsoid
    use support_cutting, only: by_number, by_step
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: pi = acos(-1.0_dp)
    type(tap_type) :: tap
    type(body_type) :: body
    type(track_type), allocatable :: tracks(:)
    type(request_type) :: request
    type(error_type), allocatable :: error
    real(dp), allocatable :: sta(:)
    type(grid_type) :: grid
    integer :: i

    body = ellipsoid([5.0_dp, 5.0_dp, 5.0_dp], 0.0_dp, 0.0_dp)
    allocate (tracks(0))
    tracks = tracks_on(body, 2, waterline_plane(3.0_dp), [-10.0_dp, 10.0_dp])
    call stations_on(body, tracks(1), by_number(waterline_plane(3.0_dp), 7), sta, error)
    call tap%ok(size(sta) == 7, 'as many points as asked')
    call tap%near(maxval(abs(sta + [(4.0_dp*cos(pi*real(i, dp)/6.0_dp), i=0, 6)])), 0.0_dp, &
        1.0e-5_dp, &
        'at equal angles')
    call stations_on(body, tracks(1), by_step(waterline_plane(3.0_dp), 1, 1500), sta, error)
    call tap%ok(size(sta) == 7, 'steps of 1.5 along STA, and the ends')
    call tap%near(maxval(abs(sta - [-4.0_dp, -3.0_dp, -1.5_dp, 0.0_dp, 1.5_dp, 3.0_dp, 4.0_dp])), &
        0.0_dp, &
        1.0e-15_dp, 'at multiples of the step')
    call stations_on(body, tracks(1), by_step(waterline_plane(3.0_dp), 1, 2000), sta, error)
    call tap%ok(size(sta) == 5, 'a step that equals an end is that end')
    call stations_on(body, tracks(1), by_step(waterline_plane(3.0_dp), 2, 2400), sta, error)
    call tap%near(maxval(abs(sta - [-4.0_dp, -3.2_dp, 3.2_dp, 4.0_dp])), 0.0_dp, 1.0e-14_dp, &
        'steps along BL are passed out and back')
    call stations_on(body, tracks(1), by_step(waterline_plane(3.0_dp), 2, 1), sta, error)
    call tap%ok(size(sta) == 2*4000, 'thousandths along BL: 3999 out and back, the ends')
    if (size(sta) == 2*4000) call tap%near(maxval(abs(sta(2:7999) - [(sign(sqrt(16.0_dp &
        - (1.0e-3_dp*real(4000 - abs(i), dp))**2), real(i, dp)), i=-3999, -1), (sign(sqrt(16.0_dp &
        - (1.0e-3_dp*real(4000 - abs(i), dp))**2), real(i, dp)), i=1, 3999)])), 0.0_dp, 1.0e-9_dp, &
        'each where the circle has it')
    request = by_number(waterline_plane(3.0_dp), 0)
    request%rule = cut_rule%length
    request%step = 1.2_dp
    call stations_on(body, tracks(1), request, sta, error)
    call tap%ok(size(sta) == 11, 'lengths of 1.2 go into 4 pi ten times, nearly')
    request%rule = cut_rule%chord
    request%step = 0.01_dp
    call stations_on(body, tracks(1), request, sta, error)
    call tap%ok(size(sta) > 16 .and. size(sta) < 40, 'chords of .01 turn by 8 degrees at the most')
    call tap%ok(4.0_dp*(1.0_dp - cos(0.5_dp*maxval(angle(sta)))) <= 0.01_dp, &
        'none is further from the curve')
    request%rule = cut_rule%length
    request%step = 1.0e-9_dp
    call stations_on(body, tracks(1), request, sta, error)
    call tap%ok(allocated(error), 'lengths of a thousand-millionth are too many')
    if (allocated(error)) call tap%ok(error%cause == cause%too_many, 'of that cause')
    call new_grid(decimal_type(0_i64, 0), decimal_type(1_i64, -9), grid, error)
    request = by_step(waterline_plane(3.0_dp), 1, 1500)
    request%grid = grid
    call stations_on(body, tracks(1), request, sta, error)
    call tap%ok(allocated(error), 'a step of a thousand-millionth is too many')
    if (allocated(error)) call tap%ok(error%cause == cause%too_many, 'of that cause')
    call new_grid(decimal_type(10_i64, 0), decimal_type(-25_i64, -1), grid, error)
    call steps_inside(grid, [-1.0_dp, 6.0_dp], sta, error)
    call tap%ok(all(sta == [0.0_dp, 2.5_dp, 5.0_dp]), 'a step backwards is in order, too')
    call tap%finish()

contains

    !> Angles between neighbouring points of the circle.
    function angle(x)
        real(dp), intent(in) :: x(:)
        real(dp) :: angle(size(x) - 1), at(size(x))
        at = acos(max(-1.0_dp, min(1.0_dp, x/4.0_dp)))
        angle = abs(at(2:) - at(:size(x) - 1))
    end function angle

end program test_spread
