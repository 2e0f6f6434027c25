!> Tracks of planes on panels, found on the mesh.
program test_panel_track
    use base_kinds, only: dp
    use body_panel, only: panel_noise, panel_type
    use cut_panel_track, only: panel_track_type, panel_tracks
    use cut_plane, only: buttock_plane, plane_type, station_plane, waterline_plane
    use support_saddle, only: saddle
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(panel_track_type), allocatable :: tracks(:)

    call panel_tracks(saddle(), waterline_plane(1.0_dp), tracks)
    call tap%ok(size(tracks) == 1, 'one track of a waterline')
    if (size(tracks) == 1) then
        call tap%near(maxval(abs(tracks(1)%at(3, :) - 1.0_dp)), 0.0_dp, 1.0e-14_dp, 'in its plane')
        call tap%near(maxval(abs(tracks(1)%at(1, :)*tracks(1)%at(2, :) - 25.0_dp)), 0.0_dp, &
            1.0e-12_dp, 'on the hyperbola')
        call tap%ok(.not. tracks(1)%is_closed, 'open')
    end if
    call panel_tracks(saddle(), buttock_plane(0.0_dp), tracks)
    call tap%ok(size(tracks) == 1, 'a side in the plane is a track')
    call check_edge()
    call panel_tracks(saddle(), station_plane(10.0_dp), tracks)
    call tap%ok(size(tracks) == 1, 'so is the side behind')
    call panel_tracks(saddle(), waterline_plane(0.0_dp), tracks)
    call tap%ok(size(tracks) == 2, 'two sides in the plane are two')
    call panel_tracks(saddle(), waterline_plane(4.0_dp), tracks)
    call tap%ok(size(tracks) == 0, 'a corner that touches is none')
    call panel_tracks(saddle(), waterline_plane(5.0_dp), tracks)
    call tap%ok(size(tracks) == 0, 'a plane that misses has none')
    call tap%ok(panel_noise(saddle()) < 1.0e-12_dp, 'rounding is small')
    call tap%finish()
contains

    !> An edge that is as near to its side, which lies in the plane, as edges are: it crosses the
    !> plane in the middle, and is a track from end to end.
    subroutine check_edge()
        type(panel_type) :: panel
        panel = saddle()
        panel%error = 1.0e-8_dp
        panel%surface%pole(2, 1, 1) = panel%error
        panel%surface%pole(2, 2, 1) = -panel%error
        call panel_tracks(panel, buttock_plane(0.0_dp), tracks)
        call tap%ok(size(tracks) == 1, 'an edge next to a side in the plane is one track')
        if (size(tracks) == 1) call tap%near(maxval(tracks(1)%at(1, :)) - &
            minval(tracks(1)%at(1, :)), 10.0_dp, 1.0e-12_dp, 'all of it')
    end subroutine check_edge

end program test_panel_track
