!> Stations of whole and half bodies: chains of arcs, which stay conic arcs also where limited.
program test_station
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type, mirrored_body
    use cut_outline, only: cut_type, outline_type
    use cut_plane, only: station_plane
    use cut_request, only: limit_type, request_type
    use cut_station, only: station_outlines
    use geom_arc, only: weight
    use support_bodies, only: ellipsoid
    use support_cutting, only: by_number, by_step, cut_of, misses_of, misses_type
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: axes(3) = [5.0_dp, 2.0_dp, 1.0_dp]
    type(tap_type) :: tap
    type(body_type) :: body, whole
    type(outline_type), allocatable :: outlines(:)
    type(request_type) :: request
    type(misses_type) :: misses
    type(error_type), allocatable :: error

    body = ellipsoid(axes, 0.0_dp, 0.0_dp)
    whole = mirrored_body(body)
    request = by_number(station_plane(3.0_dp), 9)
    call station_outlines(whole, request, 1.0e-9_dp, outlines, error)
    call tap%ok(size(outlines) == 1 .and. outlines(1)%is_closed, &
        'a whole body has one closed outline')
    call tap%ok(size(outlines(1)%pieces) == 4 .and. all(outlines(1)%pieces%section == [1, 2, 4, &
        3]), &
        'of four quarters in order')
    call tap%ok(all(outlines(1)%points%curvature > 0.0_dp), 'that turns left all round')
    call tap%ok(all(outlines(1)%pieces%first == [1, 10, 19, 28]), 'nine points each')
    call tap%near(maxval(abs([weight(outlines(1)%pieces(1)%arc), &
        weight(outlines(1)%pieces(3)%arc)] &
        - sqrt(0.5_dp))), 0.0_dp, 1.0e-15_dp, 'its pieces are the conics')
    misses = misses_of(cut_of(body, request), axes, [0.0_dp, 0.0_dp, 0.0_dp])
    call tap%near(max(misses%surface, misses%normal, misses%bevel, misses%slope), 0.0_dp, &
        1.0e-13_dp, &
        'points, normals, bevels and slopes are those of the ellipse')
    call tap%near(misses%curvature, 0.0_dp, 1.0e-13_dp, 'so are curvatures')

    request%limit(3) = limit_type(.true., .true., -0.48_dp, 0.64_dp)
    call station_outlines(body, request, 1.0e-9_dp, outlines, error)
    call tap%ok(size(outlines) == 1 .and. size(outlines(1)%pieces) == 2, &
        'between two waterlines two parts are left')
    associate (points => outlines(1)%points)
        call tap%near(norm2(points(1)%at - [3.0_dp, 1.28_dp, -0.48_dp]), 0.0_dp, 1.0e-15_dp, &
            'from the lower one')
        call tap%near(norm2(points(18)%at - [3.0_dp, 0.96_dp, 0.64_dp]), 0.0_dp, 1.0e-15_dp, &
            'to the upper one')
        call tap%near(points(1)%curvature, outlines(1)%points(1)%curvature, 0.0_dp, &
            'with curvature')
        call tap%near(maxval(abs((points%at(2)/1.6_dp)**2 + (points%at(3)/0.8_dp)**2 - 1.0_dp)), &
            0.0_dp, &
            1.0e-15_dp, 'on the ellipse')
        call tap%ok(all(abs(points%at(3) - 0.08_dp) <= 0.56_dp + 1.0e-15_dp), &
            'within the limits')
    end associate
    call tap%ok(all(outlines(1)%pieces%is_arc), 'and arcs still')
    request%limit(3) = limit_type(.true., .false., from=0.9_dp)
    call station_outlines(body, request, 1.0e-9_dp, outlines, error)
    call tap%ok(size(outlines) == 0, 'above the crown nothing is left')

    call station_outlines(body, by_step(station_plane(3.0_dp), 2, 500), 1.0e-9_dp, outlines, error)
    call tap%ok(size(outlines(1)%points) == 10, 'steps of .5 along BL, and the ends, on both arcs')
    call station_outlines(body, by_number(station_plane(-5.0_dp), 9), 1.0e-9_dp, outlines, error)
    call tap%ok(size(outlines) == 1 .and. size(outlines(1)%points) == 1, &
        'a section that is a point is that point')
    call tap%ok(size(outlines(1)%pieces) == 0, 'without arcs')
    call tap%finish()
end program test_station
