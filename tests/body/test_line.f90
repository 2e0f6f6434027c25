!> The range of a control line from those of its views.
program test_line
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_line, only: limit_line, line_point, line_type
    use geom_arc, only: line_between
    use geom_chain, only: chain_type, constant_chain, new_chain
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type) :: line

    line = line_type(name='MHB')
    line%has_side = .true.
    line%side = straight(-30.0_dp, 50.0_dp)
    call constant_chain(0.0_dp, line%plan)
    call limit_line(line)
    call tap%ok(line%from == -30.0_dp .and. line%to == 50.0_dp, &
        'a centre line is where its side view is')
    call tap%near(maxval(abs(line_point(line, 10.0_dp) - [0.0_dp, 0.5_dp])), 0.0_dp, 1.0e-15_dp, &
        'a centre line is at BL 0')
    line%has_plan = .true.
    line%plan = straight(-20.0_dp, 60.0_dp)
    call tap%near(maxval(abs(line_point(line, 10.0_dp) - [0.375_dp, 0.5_dp])), 0.0_dp, &
        1.0e-15_dp, 'others have the BL of their plan and the WL of their side view')
    call limit_line(line)
    call tap%ok(line%from == -20.0_dp .and. line%to == 50.0_dp, &
        'a line is where both its views are')
    line%plan = straight(60.0_dp, 70.0_dp)
    call limit_line(line)
    call tap%ok(line%to < line%from, 'views apart leave nothing')
    line%plan = straight(-20.0_dp, 60.0_dp)
    line%has_angle = .true.
    line%angle = straight(0.0_dp, 10.0_dp)
    call limit_line(line)
    call tap%ok(line%from == -20.0_dp .and. line%to == 50.0_dp, &
        'an angle of the same name does not limit it')
    line%has_side = .false.
    line%has_plan = .false.
    call limit_line(line)
    call tap%ok(line%from == 0.0_dp .and. line%to == 10.0_dp, &
        'a line of angles alone is where they are')
    call constant_chain(90.0_dp, line%angle)
    call limit_line(line)
    call tap%ok(line%from == -huge(1.0_dp) .and. line%to == huge(1.0_dp), &
        'a constant is everywhere')
    call tap%finish()

contains

    !> A straight view from a station to another.
    type(chain_type) function straight(from, to) result(chain)
        real(dp), intent(in) :: from, to
        type(error_type), allocatable :: error
        call new_chain([line_between([from, 0.0_dp], [to, 1.0_dp])], chain, error)
    end function straight

end program test_line
