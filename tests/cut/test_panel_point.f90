!> Normal, slope, curvature and bevel on a saddle, in closed form.
program test_panel_point
    use base_constants, only: degrees
    use base_kinds, only: dp
    use cut_outline, only: cut_point_type
    use cut_panel_point, only: point_on_panel
    use cut_panel_track, only: panel_track_type, panel_tracks
    use cut_panel_walk, only: point_at, walk_type
    use cut_plane, only: buttock_plane, waterline_plane
    use support_saddle, only: saddle
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(walk_type) :: walk
    type(panel_track_type), allocatable :: tracks(:)
    type(cut_point_type) :: point
    real(dp) :: normal(3), way(3)
    integer :: i

    walk%panel = saddle()
    walk%plane = waterline_plane(1.0_dp)
    call panel_tracks(walk%panel, walk%plane, tracks)
    walk%track = tracks(1)
    do i = 1, 5
        way = point_at(walk, real(4*i, dp)) - point_at(walk, real(4*i, dp) - 0.5_dp)
        point = point_on_panel(walk, real(4*i, dp) - 0.3_dp, way, .false.)
        associate (x => point%at(1), y => point%at(2))
            call tap%near(y, 25.0_dp/x, 1.0e-13_dp, 'on the hyperbola')
            call tap%near(point%slope%value, -25.0_dp/x**2, 1.0e-12_dp, 'its slope')
            call tap%near(point%curvature, sign(1.0_dp, way(1))*50.0_dp/x**3 &
                /(1.0_dp + 625.0_dp/x**4)**1.5_dp, 1.0e-12_dp, 'its curvature')
            normal = [-0.04_dp*y, -0.04_dp*x, 1.0_dp]
            normal = normal/norm2(normal)
            call tap%near(norm2(point%normal - normal), 0.0_dp, 1.0e-13_dp, 'the normal')
            call tap%near(point%bevel, -asin(normal(3))*degrees, 1.0e-11_dp, 'the bevel')
        end associate
    end do
    walk%plane = buttock_plane(5.0_dp)
    call panel_tracks(walk%panel, walk%plane, tracks)
    walk%track = tracks(1)
    point = point_on_panel(walk, 7.5_dp, [1.0_dp, 0.0_dp, 0.2_dp], .true.)
    call tap%near(point%slope%value, 0.2_dp, 1.0e-13_dp, 'a buttock is straight: its slope')
    call tap%near(point%curvature, 0.0_dp, 1.0e-13_dp, 'and it has no curvature')
    call tap%near(point%at(2), 5.0_dp, 0.0_dp, 'it is in its plane')
    call tap%finish()
end program test_panel_point
