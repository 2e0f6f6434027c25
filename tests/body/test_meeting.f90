!> Where two control lines meet in space.
program test_meeting
    use base_kinds, only: dp
    use body_line, only: line_type
    use body_meeting, only: meetings_of, nearest_gap
    use support_bodies, only: constant_view, control_line, half_ellipse, straight_view
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type) :: arch, level, slant
    real(dp), allocatable :: found(:)
    real(dp) :: nearest(2)

    arch = control_line('ARCH', half_ellipse(10.0_dp, 10.0_dp, 0.0_dp, 5.0_dp), &
        constant_view(0.0_dp))
    level = control_line('LEVEL', constant_view(0.0_dp), constant_view(0.0_dp))
    allocate (found(0))
    found = meetings_of(arch, level, [0.0_dp, 20.0_dp], 1.0e-3_dp)
    call tap%ok(size(found) == 2, 'an ellipse meets its axis at both ends')
    if (size(found) == 2) call tap%near(maxval(abs(found - [0.0_dp, 20.0_dp])), 0.0_dp, 0.0_dp, &
        'there')
    found = meetings_of(arch, level, [0.0_dp, 15.0_dp], 1.0e-3_dp)
    call tap%ok(size(found) == 1, 'one of them within a range')
    slant = control_line('SLANT', straight_view([0.0_dp, 3.0_dp], [20.0_dp, 3.0_dp]), &
        straight_view([0.0_dp, -2.0_dp], [20.0_dp, 8.0_dp]))
    found = meetings_of(arch, slant, [0.0_dp, 20.0_dp], 1.0e-3_dp)
    call tap%ok(size(found) == 0, 'lines that cross in one view do not meet')
    slant = control_line('SLANT', constant_view(4.0_dp), straight_view([0.0_dp, -2.0_dp], &
        [20.0_dp, 8.0_dp]))
    found = meetings_of(arch, slant, [0.0_dp, 20.0_dp], 1.0e-3_dp)
    call tap%ok(size(found) == 1, 'lines that cross in both views meet')
    if (size(found) == 1) call tap%near(found(1), 4.0_dp, 1.0e-12_dp, 'at the 3-4-5 point')
    slant = control_line('HIGH', constant_view(6.0_dp), constant_view(0.0_dp))
    nearest = nearest_gap(arch, slant, [0.0_dp, 20.0_dp])
    call tap%near(nearest(2), 1.0_dp, 1.0e-12_dp, 'the gap between lines that do not meet')
    call tap%near(nearest(1), 10.0_dp, 1.0e-9_dp, 'and where it is')
    call tap%finish()
end program test_meeting
