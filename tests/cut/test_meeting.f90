!> Planes on a quarter of a circle of radius 5: which branches there are, and where.
program test_meeting
    use base_error, only: error_type
    use base_kinds, only: dp
    use cut_meeting, only: cut_branch, edge_height, has_branch, height_noise, is_across, &
        meeting_of, &
        meeting_type, openness, place_of, turning_place
    use cut_plane, only: buttock_plane, plane_type, station_plane, waterline_plane
    use geom_arc, only: arc_through, arc_type, end_type, line_between
    use geom_arc_point, only: point
    use geom_place, only: is_finish, is_start
    use geom_twofold, only: to_real, twofold
    use support_cutting, only: plane_of
    use support_tap, only: tap_type
    implicit none (type, external)

    logical, parameter :: none(2) = .false.
    type(tap_type) :: tap
    type(arc_type) :: circle
    type(plane_type) :: plane
    type(meeting_type) :: it
    type(error_type), allocatable :: error

    call arc_through(end_type([0.0_dp, -5.0_dp], [1.0_dp, 0.0_dp]), [3.0_dp, -4.0_dp], &
        end_type([5.0_dp, 0.0_dp], [0.0_dp, 1.0_dp]), circle, error)
    it = meeting_of(circle, 0.0_dp, waterline_plane(-3.0_dp), none)
    call tap%ok(has_branch(it, cut_branch%rising) .and. .not. has_branch(it, cut_branch%falling), &
        'from keel to side a waterline is passed once, upwards')
    call tap%near(norm2(point(circle, place_of(it, cut_branch%rising)) - [4.0_dp, -3.0_dp]), &
        0.0_dp, &
        1.0e-15_dp, 'at (4, -3)')
    it = meeting_of(circle, 0.0_dp, waterline_plane(-5.5_dp), none)
    call tap%ok(.not. has_branch(it, cut_branch%rising) .and. .not. has_branch(it, &
        cut_branch%falling), &
        'one below is missed')
    call tap%ok(openness(it) <= 1.0_dp .and. openness(it) >= -1.0_dp, 'openness is at most one')
    plane = plane_of([0.0_dp, 3.0_dp, -4.0_dp], [0.0_dp, 1.0_dp, -1.0_dp])
    it = meeting_of(circle, 0.0_dp, plane, none)
    call tap%ok(has_branch(it, cut_branch%rising) .and. has_branch(it, cut_branch%falling), &
        'a slant plane is passed twice')
    call tap%near(norm2(point(circle, place_of(it, cut_branch%rising)) - [3.0_dp, -4.0_dp]), &
        0.0_dp, &
        1.0e-15_dp, 'first away from the middle, at (3, -4)')
    call tap%near(norm2(point(circle, place_of(it, cut_branch%falling)) - [4.0_dp, -3.0_dp]), &
        0.0_dp, &
        1.0e-15_dp, 'then back, at (4, -3)')
    call tap%ok(openness(it) > 0.0_dp, 'there openness is above zero')
    it = meeting_of(circle, 0.0_dp, plane_of([0.0_dp, 0.0_dp, -7.5_dp], [0.0_dp, 1.0_dp, &
        -1.0_dp]), none)
    call tap%ok(openness(it) < 0.0_dp, 'beyond the arc it is below')
    plane = plane_of([0.0_dp, 3.0_dp, -4.0_dp], [0.0_dp, 3.0_dp, -4.0_dp])
    it = meeting_of(circle, 0.0_dp, plane, none)
    call tap%near(openness(it), 0.0_dp, 1.0e-15_dp, 'on a tangent plane it is zero')
    call tap%near(norm2(point(circle, turning_place(it)) - [3.0_dp, -4.0_dp]), 0.0_dp, 1.0e-14_dp, &
        'whose place is where it touches')
    it = meeting_type(twofold(-1.0_dp), twofold(2.6e156_dp), twofold(2.0_dp))
    call tap%near(openness(it), 1.0_dp, 1.0e-15_dp, 'heights beyond squaring are opened by')
    it = meeting_type(twofold(-4.0e-200_dp), twofold(2.0e-200_dp), twofold(4.0e-200_dp))
    call tap%near(openness(it), 1.0_dp, 1.0e-15_dp, 'and so are those below it')
    it = meeting_type(twofold(0.0_dp), twofold(0.0_dp), twofold(0.0_dp))
    call tap%near(openness(it), 0.0_dp, 0.0_dp, 'no heights are not')
    it = meeting_of(circle, 0.0_dp, buttock_plane(1.0e-30_dp), [.true., .false.])
    call tap%ok(is_start(place_of(it, cut_branch%rising)), &
        'an edge known to be in the plane is the place')
    it = meeting_of(circle, 0.0_dp, waterline_plane(0.0_dp), none)
    call tap%ok(is_finish(place_of(it, cut_branch%rising)), 'so is one that is so exactly')
    it = meeting_of(line_between([0.0_dp, 0.0_dp], [4.0_dp, 8.0_dp]), 3.0_dp, &
        plane_of([3.0_dp, 1.0_dp, 2.0_dp], [1.0_dp, 1.0_dp, 1.0_dp]), none)
    call tap%near(norm2(point(line_between([0.0_dp, 0.0_dp], [4.0_dp, 8.0_dp]), &
        place_of(it, cut_branch%rising)) - [1.0_dp, 2.0_dp]), 0.0_dp, 1.0e-15_dp, &
            'a line is passed where it is')
    it = meeting_of(line_between([0.0_dp, 1.0_dp], [4.0_dp, 1.0_dp]), 0.0_dp, &
        waterline_plane(1.0_dp), none)
    call tap%ok(.not. (has_branch(it, cut_branch%rising) .or. has_branch(it, cut_branch%falling)), &
        'a line all in the plane has no branch')
    call tap%near(to_real(edge_height(plane, 0.0_dp, [4.0_dp, -4.0_dp])), 3.0_dp, 0.0_dp, &
        'heights are of the normal''s length')
    call tap%ok(height_noise(plane, 1000.0_dp, [4.0_dp, -4.0_dp]) < 1.0e-12_dp, &
        'noise is that of rounding')
    call tap%ok(is_across(station_plane(1.0_dp)) .and. .not. is_across(plane), &
        'only stations are across STA')
    call tap%finish()
end program test_meeting
