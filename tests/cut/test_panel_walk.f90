!> Places on the tracks of panels.
program test_panel_walk
    use base_kinds, only: dp
    use cut_panel_track, only: panel_track_type, panel_tracks
    use cut_panel_walk, only: last_place, part_between, point_at, turned_track, uv_at, walk_type
    use cut_plane, only: waterline_plane
    use support_saddle, only: saddle
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(walk_type) :: walk
    type(panel_track_type), allocatable :: tracks(:)
    type(panel_track_type) :: part
    real(dp) :: off, at(3), uv(2)
    integer :: i

    walk%panel = saddle()
    walk%plane = waterline_plane(1.0_dp)
    call panel_tracks(walk%panel, walk%plane, tracks)
    walk%track = tracks(1)
    off = 0.0_dp
    do i = 0, 1000
        at = point_at(walk, last_place(walk)*real(i, dp)/1000.0_dp)
        off = max(off, abs(at(3) - 1.0_dp), 0.1_dp*abs(at(1)*at(2) - 25.0_dp))
    end do
    call tap%near(off, 0.0_dp, 1.0e-13_dp, 'every place is on panel and plane')
    uv = uv_at(walk, 3.0_dp)
    call tap%near(maxval(abs(uv - walk%track%uv(:, 4))), 0.0_dp, 0.0_dp, 'points are places')
    part = part_between(walk, 1.5_dp, 4.25_dp)
    call tap%ok(size(part%uv, 2) == 5, 'a part has the points between and its ends')
    call tap%near(norm2(part%at(:, 1) - point_at(walk, 1.5_dp)), 0.0_dp, 0.0_dp, 'it begins there')
    part = turned_track(walk%track)
    call tap%near(norm2(part%at(:, 1) - point_at(walk, last_place(walk))), 0.0_dp, 0.0_dp, &
        'turned round it begins at the end')
    call tap%finish()
end program test_panel_walk
