!> Sides of panels: parts of lines with vertical ends, arcs, points; forwards and backwards.
program test_panel_side
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_line, only: line_type
    use body_panel_side, only: arc_side, line_side, point_side, side_spline, side_type
    use geom_arc, only: line_between
    use geom_bspline, only: bspline_type, spline_point
    use support_bodies, only: constant_view, control_line, half_ellipse
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type) :: arch
    type(side_type) :: side
    type(bspline_type) :: spline
    type(error_type), allocatable :: error
    real(dp) :: at(3), off
    integer :: i

    arch = control_line('ARCH', half_ellipse(10.0_dp, 10.0_dp, 0.0_dp, 5.0_dp), &
        constant_view(2.0_dp))
    side = line_side(arch, 0.0_dp, 20.0_dp)
    call tap%ok(all(side%is_vertical), 'a half ellipse is vertical at both ends')
    call side_spline(side, .false., 1.0e-8_dp, spline, error)
    call tap%ok(.not. allocated(error), 'it is a spline all the same')
    off = 0.0_dp
    do i = 0, 100
        at = spline_point(spline, real(i, dp)/100.0_dp)
        off = max(off, abs(((at(1) - 10.0_dp)/10.0_dp)**2 + (at(3)/5.0_dp)**2 - 1.0_dp), &
            abs(at(2) - 2.0_dp))
    end do
    call tap%near(off, 0.0_dp, 1.0e-8_dp, 'on the ellipse')
    call side_spline(line_side(arch, 4.0_dp, 0.0_dp), .true., 1.0e-8_dp, spline, error)
    at = spline_point(spline, 0.0_dp)
    call tap%near(norm2(at - [0.0_dp, 2.0_dp, 0.0_dp]), 0.0_dp, 1.0e-14_dp, 'a side turned round')
    at = spline_point(spline, 1.0_dp)
    call tap%near(norm2(at - [4.0_dp, 2.0_dp, 4.0_dp]), 0.0_dp, 1.0e-14_dp, 'ends where it began')
    side = arc_side(line_between([1.0_dp, 2.0_dp], [3.0_dp, 4.0_dp]), 7.0_dp)
    call tap%near(norm2(side%at(0.5_dp) - [7.0_dp, 2.0_dp, 3.0_dp]), 0.0_dp, 1.0e-15_dp, &
        'the middle of an arc at a station')
    call side_spline(side, .true., 1.0e-8_dp, spline, error)
    call tap%near(norm2(spline_point(spline, 0.0_dp) - [7.0_dp, 3.0_dp, 4.0_dp]), 0.0_dp, &
        1.0e-15_dp, 'an arc turned round')
    side = point_side([1.0_dp, 2.0_dp, 3.0_dp])
    call side_spline(side, .false., 1.0e-8_dp, spline, error)
    call tap%near(norm2(spline_point(spline, 0.3_dp) - [1.0_dp, 2.0_dp, 3.0_dp]), 0.0_dp, &
        1.0e-15_dp, 'a point')
    call tap%finish()
end program test_panel_side
