!> Ends of sections at a station: of an ellipsoid, whose tangents are level and upright.
program test_ring_end
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_ring_end, only: break_between, break_in_mirror, ends_at, is_centred, line_of_end, &
        name_of_end, section_end_type, section_of, touch
    use support_bodies, only: ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: half_angle = 180.0_dp/acos(-1.0_dp)*atan(0.5_dp), good = 1.0e-13_dp
    type(tap_type) :: tap
    type(body_type) :: body
    type(section_end_type) :: ends(4), other

    body = ellipsoid([10.0_dp, 5.0_dp, 3.0_dp], 0.0_dp, 2.0_dp)
    ends = ends_at(body, 6.0_dp)
    call tap%ok(all(ends%is_there), 'two sections have four ends')
    call tap%near(norm2(ends(1)%point - [0.0_dp, -0.4_dp]), 0.0_dp, good, 'the first at the keel')
    call tap%near(norm2(ends(2)%point - [4.0_dp, 2.0_dp]), 0.0_dp, good, 'the second at the side')
    call tap%ok(ends(1)%out(1) < 0.0_dp .and. ends(2)%out(2) > 0.0_dp, 'their tangents lead out')
    call tap%ok(touch(ends(2), ends(3)) .and. .not. touch(ends(1), ends(4)), &
        'lower and upper section touch at the side')
    call tap%ok(all(is_centred(ends) .eqv. [.true., .false., .false., .true.]), &
        'the outer ones are at BL 0')
    call tap%near(break_between(ends(2), ends(3)), 0.0_dp, good, 'the skin goes on at the side')
    call tap%near(break_in_mirror(ends(4)), 0.0_dp, good, 'and over the top')
    other = ends(3)
    other%out = [1.0_dp, -2.0_dp]
    call tap%near(break_between(ends(2), other), half_angle, good, 'a slope of 1:2 breaks')
    other%out = [-1.0_dp, 0.5_dp]
    call tap%near(break_in_mirror(other), 2.0_dp*half_angle, good, 'in the mirror twice')
    other%point = ends(3)%point + [0.0_dp, 0.9_dp*ends(3)%reach]
    call tap%ok(touch(ends(2), other), 'ends may miss each other by their reach')
    other%point = ends(3)%point + [0.0_dp, 1.1_dp*ends(3)%reach]
    call tap%ok(.not. touch(ends(2), other), 'no more')
    call tap%near(ends(3)%reach, 1.0e-6_dp*hypot(4.0_dp, 2.4_dp), 1.0e-18_dp, &
        'which is a millionth of the longest chord')
    ends = ends_at(body, -10.0_dp)
    call tap%ok(.not. any(ends%is_there), 'a point has no ends')
    ends = ends_at(body, 11.0_dp)
    call tap%ok(.not. any(ends%is_there), 'nor has a section that is not there')
    body%sections(1)%to = 0.0_dp
    ends = ends_at(body, 5.0_dp)
    call tap%ok(all(ends%is_there .eqv. [.false., .false., .true., .true.]), 'each for itself')
    call tap%ok(all(section_of([1, 2, 3, 4]) == [1, 1, 2, 2]), 'ends belong to sections')
    call tap%same(name_of_end(body, 3)//' '//line_of_end(body, 3)//' '//line_of_end(body, 4), &
        'UPPER MHB UCL', 'and have the names of them and of their lines')
    body%sections(2)%is_port = .true.
    call tap%same(name_of_end(body, 4), 'UPPER P', 'port is said')
    call tap%finish()
end program test_ring_end
