!> Points of a track in rows: those of one station after another, but for the last figure.
program test_track_row
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_outline, only: cut_point_type
    use cut_plane, only: buttock_plane, oblique_plane, plane_type, waterline_plane
    use cut_point, only: point_on_track
    use cut_request, only: request_type
    use cut_track, only: track_type, tracks_on
    use cut_track_row, only: points_on_track, step_type, walk_on_track
    use support_bodies, only: ellipsoid, nose_of_the_book
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(plane_type) :: plane
    type(error_type), allocatable :: error

    call compare(nose_of_the_book(), waterline_plane(-16.0_dp), 'a waterline of the nose')
    call compare(nose_of_the_book(), buttock_plane(4.5_dp), 'a buttock of the nose')
    call oblique_plane([20.0_dp, -16.0_dp], [30.0_dp, -6.0_dp], plane, error)
    call compare(nose_of_the_book(), plane, 'an oblique frame of the nose')
    call compare(ellipsoid([30.0_dp, 5.0_dp, 7.0_dp], 11.0_dp, 3.0_dp), buttock_plane(2.0_dp), &
        'a buttock of an ellipsoid')
    call tap%finish()

contains

    !> Compares the points of the first track of a plane.
    subroutine compare(body, plane, name)
        type(body_type), intent(in) :: body
        type(plane_type), intent(in) :: plane
        character(*), intent(in) :: name
        type(track_type), allocatable :: tracks(:)
        type(request_type) :: request
        type(cut_point_type) :: points(150), one
        type(step_type) :: steps(150)
        real(dp) :: sta(150), worst(5)
        integer :: i

        request%plane = plane
        allocate (tracks(0))
        tracks = tracks_on(body, 1, plane, [-100.0_dp, 100.0_dp])
        associate (from => tracks(1)%from%sta, to => tracks(1)%to%sta)
            sta = [(from + (to - from)*real(i - 1, dp)/149.0_dp, i=1, 150)]
        end associate
        sta(150) = tracks(1)%to%sta
        call points_on_track(body, tracks(1), sta, request, points)
        call walk_on_track(body, plane, tracks(1), sta, steps)
        worst = 0.0_dp
        do i = 1, 150
            one = point_on_track(body, plane, tracks(1), sta(i), .false.)
            worst(1) = max(worst(1), maxval(abs(points(i)%at - one%at)))
            if (points(i)%slope%is_vertical .neqv. one%slope%is_vertical) worst(2) = 1.0_dp
            worst(2) = max(worst(2), abs(points(i)%slope%value - one%slope%value) &
                /(1.0_dp + one%slope%value**2))
            worst(3) = max(worst(3), maxval(abs(points(i)%normal - one%normal)), &
                1.0e-2_dp*abs(points(i)%bevel - one%bevel))
            worst(4) = max(worst(4), abs(points(i)%curvature - one%curvature) &
                /(1.0_dp + abs(one%curvature)))
            if (steps(i)%is_done) worst(5) = max(worst(5), maxval(abs(steps(i)%at - one%at)))
        end do
        call tap%near(worst(1), 0.0_dp, 8.0e-15_dp, 'points of '//name)
        call tap%near(worst(2), 0.0_dp, 1.0e-14_dp, 'slopes of '//name)
        call tap%near(worst(3), 0.0_dp, 1.0e-14_dp, 'normals and bevels of '//name)
        call tap%near(worst(4), 0.0_dp, 1.0e-13_dp, 'curvatures of '//name)
        call tap%near(worst(5), 0.0_dp, 2.0e-14_dp, 'steps along '//name)
        call tap%ok(count(steps%is_done) == 148, 'all but the ends of '//name)
    end subroutine compare

end program test_track_row
