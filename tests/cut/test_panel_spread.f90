!> Points along tracks of panels by each rule, and limits.
program test_panel_spread
    use base_decimal, only: decimal_type, new_grid
    use base_error, only: error_type
    use base_kinds, only: dp, i64
    use cut_panel_spread, only: places_on, tracks_within
    use cut_panel_track, only: panel_track_type, panel_tracks
    use cut_panel_walk, only: last_place, point_at, walk_type
    use cut_plane, only: waterline_plane
    use cut_request, only: cut_rule, request_type
    use support_saddle, only: saddle
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(walk_type) :: walk
    type(request_type) :: request
    type(panel_track_type), allocatable :: tracks(:), parts(:)
    type(error_type), allocatable :: error
    real(dp), allocatable :: places(:), length(:), at(:, :)
    integer :: i

    walk%panel = saddle()
    walk%plane = waterline_plane(1.0_dp)
    request%plane = walk%plane
    call panel_tracks(walk%panel, walk%plane, tracks)
    walk%track = tracks(1)
    request%number = 11
    call spread_it()
    allocate (length(0))
    length = [(norm2(at(:, i + 1) - at(:, i)), i = 1, size(places) - 1)]
    call tap%ok(size(places) == 11, 'as many points as asked')
    call tap%near(maxval(length)/minval(length), 1.0_dp, 2.0e-2_dp, 'evenly along the outline')
    request%rule = cut_rule%length
    request%step = 0.5_dp
    call spread_it()
    length = [(norm2(at(:, i + 1) - at(:, i)), i = 1, size(places) - 1)]
    call tap%near(maxval(abs(length - 0.5_dp)), 0.0_dp, 2.0e-2_dp, 'lengths as asked')
    request%rule = cut_rule%chord
    request%step = 1.0e-3_dp
    call spread_it()
    call tap%ok(all(places(2:) > places(:size(places) - 1)), 'chords go on')
    call tap%ok(size(places) > 10 .and. size(places) < 200, 'and are as many as it takes')
    request%rule = cut_rule%length
    request%step = 1.0e-6_dp
    call places_on(walk, request, places, error)
    call tap%ok(allocated(error), 'too many points are an error')
    request%limit(1)%has_from = .true.
    request%limit(1)%from = 4.0_dp
    request%limit(2)%has_from = .true.
    request%limit(2)%from = 3.0_dp
    call tracks_within(walk, request, parts)
    call tap%ok(size(parts) == 1, 'a part within limits')
    if (size(parts) == 1) then
        call tap%near(minval(parts(1)%at(1, :)), 4.0_dp, 1.0e-12_dp, 'from the one')
        call tap%near(minval(parts(1)%at(2, :)), 3.0_dp, 1.0e-12_dp, 'to the other')
    end if
    call check_steps()
    call tap%finish()

contains

    !> Steps of STA of which the first and the last are the ends of the track, but for an edge that
    !> is not quite on its side.
    subroutine check_steps()
        type(decimal_type), parameter :: quarter = decimal_type(25_i64, -1)
        walk%panel%error = 1.0e-8_dp
        associate (at => walk%track%at)
            at(1, 1) = at(1, 1) + sign(1.0e-9_dp, at(1, 1) - at(1, size(at, 2)))
        end associate
        request%rule = cut_rule%step
        request%axis = 1
        call new_grid(quarter, quarter, request%grid, error)
        call places_on(walk, request, places, error)
        call tap%ok(size(places) == 4, 'a step that is an end is there once')
    end subroutine check_steps

    !> Spreads points as asked.
    subroutine spread_it()
        call places_on(walk, request, places, error)
        if (allocated(at)) deallocate (at)
        allocate (at(3, size(places)))
        do i = 1, size(places)
            at(:, i) = point_at(walk, places(i))
        end do
        call tap%near(places(size(places)), last_place(walk), 0.0_dp, 'the end is a point')
    end subroutine spread_it

end program test_panel_spread
