!> Curves of cuts on panels against the hyperbola of a saddle.
program test_panel_curve
    use base_kinds, only: dp
    use cut_outline, only: panel_curve_type
    use cut_panel_curve, only: curve_of_walk
    use cut_panel_track, only: panel_track_type, panel_tracks
    use cut_panel_walk, only: walk_type
    use cut_plane, only: waterline_plane
    use geom_bspline, only: spline_point, spline_to
    use support_saddle, only: saddle
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(walk_type) :: walk
    type(panel_track_type), allocatable :: tracks(:)
    type(panel_curve_type) :: curve
    real(dp) :: off, at(3)
    integer :: i

    walk%panel = saddle()
    walk%plane = waterline_plane(1.0_dp)
    call panel_tracks(walk%panel, walk%plane, tracks)
    walk%track = tracks(1)
    curve = curve_of_walk(walk)
    call tap%ok(curve%error <= 1.0e-7_dp, 'it is as near as promised')
    off = 0.0_dp
    do i = 0, 2000
        at = spline_point(curve%spline, spline_to(curve%spline)*real(i, dp)/2000.0_dp)
        off = max(off, abs(at(1)*at(2) - 25.0_dp)/norm2(at(:2)))
    end do
    call tap%near(off, 0.0_dp, 1.1e-7_dp, 'everywhere')
    call tap%near(at(3), 1.0_dp, 1.0e-14_dp, 'in the plane')
    call tap%finish()
end program test_panel_curve
