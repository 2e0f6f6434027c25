!> Points by every rule along a quarter of a circle of radius 5.
program test_arc_spread
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use cut_arc_spread, only: places_on
    use cut_plane, only: station_plane
    use cut_request, only: cut_rule, request_type
    use geom_arc, only: arc_through, arc_type, end_type, line_between
    use geom_arc_point, only: point
    use geom_place, only: place_type
    use support_cutting, only: by_number, by_step
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(arc_type) :: circle
    type(place_type), allocatable :: places(:)
    type(request_type) :: request
    type(error_type), allocatable :: error
    real(dp) :: at(2), before(2), worst
    integer :: i

    call arc_through(end_type([0.0_dp, -5.0_dp], [1.0_dp, 0.0_dp]), [3.0_dp, -4.0_dp], &
        end_type([5.0_dp, 0.0_dp], [0.0_dp, 1.0_dp]), circle, error)
    call places_on(circle, by_number(station_plane(0.0_dp), 4), places, error)
    call tap%ok(size(places) == 4, 'as many points as asked')
    at = point(circle, places(2))
    call tap%near(norm2(at - 5.0_dp*[0.5_dp, -sqrt(0.75_dp)]), 0.0_dp, 1.0e-9_dp, &
        'the second at 30 degrees')
    call places_on(circle, by_step(station_plane(0.0_dp), 2, 3000), places, error)
    at = point(circle, places(2))
    call tap%ok(size(places) == 3 .and. at(1) == 3.0_dp, 'steps of 3 along BL')
    call places_on(circle, by_step(station_plane(0.0_dp), 3, 2000), places, error)
    at = point(circle, places(2))
    call tap%ok(size(places) == 4 .and. at(2) == -4.0_dp, 'steps of 2 along WL')
    call places_on(circle, by_step(station_plane(0.0_dp), 1, 2000), places, error)
    call tap%ok(size(places) == 25, 'where STA is stepped, 25')
    request = request_type()
    call places_on(circle, request, places, error)
    call tap%ok(size(places) == 25, 'as where nothing is asked')
    request%rule = cut_rule%length
    request%step = 1.0_dp
    call places_on(circle, request, places, error)
    call tap%ok(size(places) == 9, 'a length of 1 goes into 7.85 eight times, nearly')
    request%step = 1.0e-10_dp
    call places_on(circle, request, places, error)
    call tap%ok(error%cause == cause%too_many, 'a length that gives more points than a table has')
    request%step = 1.0e-70_dp
    call places_on(circle, request, places, error)
    call tap%ok(error%cause == cause%too_many, 'a length that gives more than can be counted')
    request%rule = cut_rule%chord
    request%step = 0.001_dp
    call places_on(circle, request, places, error)
    worst = 0.0_dp
    before = circle%start
    do i = 2, size(places)
        at = point(circle, places(i))
        worst = max(worst, 5.0_dp - norm2(0.5_dp*(at + before)))
        before = at
    end do
    call tap%ok(worst <= 0.001_dp .and. worst > 0.0002_dp, &
        'chords stay as near as asked, not nearer')
    call places_on(line_between([0.0_dp, 0.0_dp], [1.0_dp, 2.0_dp]), request, places, error)
    call tap%ok(size(places) == 2, 'a line is one chord')
    request%step = 1.0e-13_dp
    call places_on(circle, request, places, error)
    call has_too_many('chords of a tolerance below rounding')
    request%rule = cut_rule%length
    request%step = 1.0e-9_dp
    call places_on(circle, request, places, error)
    call has_too_many('lengths of a thousand-millionth')
    call tap%finish()

contains

    !> What was asked makes too many points, and the error says so.
    subroutine has_too_many(what)
        character(*), intent(in) :: what !! was asked
        call tap%ok(allocated(error), what//' are too many')
        if (allocated(error)) call tap%ok(error%cause == cause%too_many, 'of that cause')
    end subroutine has_too_many

end program test_arc_spread
