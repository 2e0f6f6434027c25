!> Which side of a section is the outside; mirrored bodies; the stops of a section.
program test_body
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type, finish_body, mirrored_body, smooth_stops
    use geom_arc, only: line_between
    use geom_chain, only: chain_type, new_chain
    use support_bodies, only: constant_view, control_line, ellipsoid, level, nose_of_the_book, &
        plain_section, straight_view, upright
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body, whole

    body = ellipsoid([5.0_dp, 2.0_dp, 1.0_dp], 0.0_dp, 0.0_dp)
    call tap%ok(all(body%sections%outward == 1.0_dp), &
        'from keel to crown the outside is to the right')
    whole = mirrored_body(body)
    call tap%ok(size(whole%sections) == 4, 'a symmetric body has a mirrored half')
    call tap%ok(all(whole%sections(3:)%is_port), 'to port')
    call tap%ok(all(whole%sections(3:)%outward == -1.0_dp), 'whose outside is to the left')
    call finish_body(whole)
    call tap%ok(all(whole%sections%outward == [1.0_dp, 1.0_dp, -1.0_dp, -1.0_dp]), &
        'as is found of it, too')
    whole = mirrored_body(whole)
    call tap%ok(size(whole%sections) == 4, 'a whole body is not doubled')
    call turn(body, 2)
    call finish_body(body)
    call tap%ok(all(body%sections%outward == [1.0_dp, -1.0_dp]), &
        'a section run backwards has it left')
    call turn(body, 1)
    call finish_body(body)
    call tap%ok(all(body%sections%outward == -1.0_dp), 'both run backwards have')
    body = nose_of_the_book()
    call tap%ok(all(body%sections%outward == 1.0_dp), 'an open quarter faces away from BL 0')
    call check_fairing()
    call check_stops()
    call tap%finish()

contains

    !> Runs a section backwards.
    subroutine turn(it, which)
        type(body_type), intent(inout) :: it
        integer, intent(in) :: which
        associate (section => it%sections(which))
            section%line = section%line(3:1:-1)
            section%slope = section%slope(2:1:-1)
        end associate
    end subroutine turn

    !> A hollow fairing between a belly and a side is outside on the side the run says.
    subroutine check_fairing()
        body = body_type()
        body%lines = [ &
            control_line('KEEL', constant_view(-5.0_dp), constant_view(0.0_dp)), &
            control_line('LSH', constant_view(-4.8_dp), constant_view(2.0_dp)), &
            control_line('LOW', constant_view(-3.0_dp), constant_view(3.0_dp)), &
            control_line('HOLLOW', constant_view(-1.8_dp), constant_view(3.2_dp)), &
            control_line('HIGH', constant_view(-1.0_dp), constant_view(5.0_dp)), &
            control_line('USH', constant_view(3.0_dp), constant_view(4.0_dp)), &
            control_line('CROWN', straight_view([0.0_dp, 4.0_dp], [9.0_dp, 4.0_dp]), &
                constant_view(0.0_dp))]
        body%sections = [plain_section('BELLY', [1, 2, 3], level, upright), &
            plain_section('FAIR', [3, 4, 5], upright, level), plain_section('TOP', [5, 6, 7], &
                upright, level)]
        body%sections%from = 0.0_dp
        body%sections%to = 9.0_dp
        call finish_body(body)
        call tap%ok(all(body%sections%outward == 1.0_dp), &
            'a hollow fairing is outside as its run is')
    end subroutine check_fairing

    !> Joints of the lines divide the range.
    subroutine check_stops()
        type(chain_type) :: view
        type(error_type), allocatable :: error
        real(dp), allocatable :: stops(:)
        call new_chain([line_between([0.0_dp, 4.0_dp], [3.0_dp, 5.0_dp]), &
            line_between([3.0_dp, 5.0_dp], [9.0_dp, 4.0_dp])], view, error)
        body%lines(7)%side = view
        allocate (stops(0))
        stops = smooth_stops(body, body%sections(3))
        call tap%ok(size(stops) == 3, 'a joint of a line stops its section')
        call tap%ok(all(stops == [0.0_dp, 3.0_dp, 9.0_dp]), 'between the ends of its range')
        stops = smooth_stops(body, body%sections(1))
        call tap%ok(all(stops == [0.0_dp, 9.0_dp]), 'but not another')
    end subroutine check_stops

end program test_body
