!> Sections at their stations: arcs, points, lines; port; ranges; angles as end slopes.
program test_section
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_line, only: limit_line, line_type
    use body_section, only: end_slope_type, is_point, limit_section, section_arc, section_joints, &
        section_type, trace_at, trace_type
    use geom_arc, only: arc_type, weight
    use geom_arc_point, only: point
    use geom_place, only: at_shoulder
    use support_bodies, only: constant_view, control_line, ellipsoid, level, plain_section, &
        straight_view, upright
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(arc_type) :: arc
    type(trace_type) :: trace
    type(error_type), allocatable :: error

    call check_ellipsoid()
    call check_fin()
    call check_angle()
    call tap%finish()

contains

    !> A section of an ellipsoid is an ellipse; at the ends it is a point.
    subroutine check_ellipsoid()
        type(section_type) :: port
        body = ellipsoid([5.0_dp, 2.0_dp, 1.0_dp], 0.0_dp, 0.0_dp)
        call tap%ok(body%sections(1)%from == -5.0_dp .and. body%sections(1)%to == 5.0_dp, &
            'a section is where all its lines are')
        call section_arc(body%lines, body%sections(1), 3.0_dp, arc, error)
        call tap%ok(.not. allocated(error), 'it has an arc there')
        call tap%near(norm2(arc%start - [0.0_dp, -0.8_dp]), 0.0_dp, 1.0e-15_dp, 'from the keel')
        call tap%near(norm2(arc%finish - [1.6_dp, 0.0_dp]), 0.0_dp, 1.0e-15_dp, &
            'to the greatest breadth')
        call tap%near(weight(arc), sqrt(0.5_dp), 1.0e-15_dp, 'a quarter of an ellipse')
        port = body%sections(1)
        port%is_port = .true.
        call section_arc(body%lines, port, 3.0_dp, arc, error)
        call tap%near(norm2(arc%finish + [1.6_dp, 0.0_dp]), 0.0_dp, 1.0e-15_dp, &
            'and its image to port')
        trace = trace_at(body%lines, body%sections(1), -5.0_dp)
        call tap%ok(is_point(trace), 'at the nose it is a point')
        call section_arc(body%lines, body%sections(1), -5.0_dp, arc, error)
        call tap%ok(allocated(error), 'which has no arc')
        if (allocated(error)) call tap%ok(error%cause == cause%points_coincide, 'of that cause')
        call tap%ok(size(section_joints(body%lines, body%sections(1))) == 0, &
            'its lines have no joints')
    end subroutine check_ellipsoid

    !> A section that shrinks to a straight line at the end of its range.
    subroutine check_fin()
        type(line_type) :: lines(3)
        type(section_type) :: section
        lines(1) = control_line('KEEL', constant_view(0.0_dp), constant_view(0.0_dp))
        lines(2) = control_line('SIDE', constant_view(1.0_dp), &
            straight_view([0.0_dp, 1.0_dp], [10.0_dp, 0.0_dp]))
        lines(3) = control_line('TOP', constant_view(2.0_dp), constant_view(0.0_dp))
        section = plain_section('FIN', [1, 2, 3], level, level)
        call limit_section(lines, section)
        call tap%ok(section%from == 0.0_dp .and. section%to == 10.0_dp, &
            'a fin has the range of its side')
        call section_arc(lines, section, 5.0_dp, arc, error)
        call tap%ok(.not. allocated(error) .and. .not. arc%is_line, 'it is curved inside')
        call section_arc(lines, section, 10.0_dp, arc, error)
        call tap%ok(.not. allocated(error) .and. arc%is_line, 'and a straight line at its edge')
        section%from = 20.0_dp
        call limit_section(lines, section)
        call tap%ok(section%to < section%from, 'asked beyond its lines it has no range')
    end subroutine check_fin

    !> An end slope by angle is that of the number, also past 90 degrees.
    subroutine check_angle()
        type(line_type) :: lines(4)
        type(section_type) :: section
        real(dp) :: at(2)
        lines(1) = control_line('A', constant_view(0.0_dp), constant_view(0.0_dp))
        lines(2) = control_line('B', constant_view(1.0_dp), constant_view(3.0_dp))
        lines(3) = control_line('C', constant_view(3.0_dp), constant_view(2.0_dp))
        lines(4)%name = 'T'
        lines(4)%has_angle = .true.
        lines(4)%angle = straight_view([0.0_dp, 90.0_dp], [10.0_dp, 130.0_dp])
        call limit_line(lines(4))
        section = plain_section('S', [1, 2, 3], level, upright)
        section%slope(2) = end_slope_type(is_angle=.true., line=4)
        call limit_section(lines, section)
        call tap%ok(section%from == 0.0_dp .and. section%to == 10.0_dp, &
            'the line of an end slope limits the section')
        trace = trace_at(lines, section, 7.5_dp)
        call tap%near(norm2(trace%finish%tangent - [cos(acos(-1.0_dp)*120.0_dp/180.0_dp), &
            sqrt(0.75_dp)]), 0.0_dp, 1.0e-15_dp, '120 degrees lean back')
        call section_arc(lines, section, 7.5_dp, arc, error)
        call tap%ok(.not. allocated(error), 'an arc leans inwards at its end')
        at = point(arc, at_shoulder)
        call tap%ok(at(1) > 2.0_dp, 'and is wider below')
    end subroutine check_angle

end program test_section
