!> Tests of the inside of the skin as contours.
program test_drawing_inside
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type, mirrored_body
    use cut_outline, only: cut_type
    use cut_plane, only: plane_type, station_plane
    use cut_request, only: request_type
    use export_drawing, only: contour_type, shape_type
    use export_drawing_inside, only: draw_inside
    use export_drawing_outside, only: way_round, way_round_type
    use support_bodies, only: ellipsoid, nose_of_the_book
    use support_cutting, only: by_number, cut_of, plane_of
    use support_drawn, only: is_end_to_end, largest_error, largest_miss
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(cut_type) :: cut
    type(shape_type) :: shape
    type(error_type), allocatable :: error

    body = ellipsoid([20.0_dp, 20.0_dp, 20.0_dp], 30.0_dp, 0.0_dp)
    call go(plane_of([30.0_dp, 2.0_dp, 5.0_dp], [1.0_dp, -0.3_dp, 0.4_dp]), 0.5_dp, 1.0e-3_dp)
    call tap%ok(size(shape%contours) == 1, 'the inside of a sphere is one contour')
    associate (contour => shape%contours(1))
        call tap%ok(contour%is_closed .and. contour%is_inside, 'closed, and says it is inside')
        call tap%ok(all(contour%curves%is_exact), 'a circle, exactly')
    end associate
    call judge(0.0_dp, 'circle')

    body = ellipsoid([30.0_dp, 20.0_dp, 14.0_dp], 30.0_dp, 0.0_dp)
    call go(plane_of([30.0_dp, 2.0_dp, 1.0_dp], [1.0_dp, -0.3_dp, 0.4_dp]), 0.5_dp, 1.0e-5_dp)
    call judge(1.0e-5_dp, 'canted frame')
    call tap%ok(shape%contours(1)%is_closed .and. size(shape%contours) == 1, &
        'the inside of an ellipsoid is one contour, though feet change their sections')
    call tap%ok(.not. any(shape%contours(1)%curves%is_exact), 'which is no conic')
    call go(station_plane(30.0_dp), 0.5_dp, 1.0e-7_dp)
    call judge(1.0e-7_dp, 'frame')
    call go(station_plane(0.5_dp), 4.0_dp, 1.0e-4_dp)
    call tap%ok(size(shape%contours) == 0, 'where the skin has no inside there is no contour')
    body = nose_of_the_book()
    call go(plane_of([20.0_dp, 0.0_dp, -10.0_dp], [1.0_dp, 0.0_dp, -0.5_dp]), 0.05_dp, 1.0e-5_dp)
    call judge(1.0e-5_dp, 'nose of the book')
    call tap%ok(.not. shape%contours(1)%is_closed, 'an open quarter stays open')
    call tap%finish()

contains

    !> Draws the inside of the first outline of a cut.
    subroutine go(plane, thickness, tolerance)
        type(plane_type), intent(in) :: plane
        real(dp), intent(in) :: thickness, tolerance
        type(way_round_type) :: round
        type(request_type) :: request
        type(contour_type), allocatable :: contours(:)

        request = by_number(plane, 40)
        request%skin = thickness
        cut = cut_of(body, request)
        call way_round(mirrored_body(body), cut%plane, cut%outlines(1), round)
        call draw_inside(mirrored_body(body), cut, round, tolerance, contours, error)
        call tap%ok(.not. allocated(error), 'the inside is drawn')
        if (allocated(shape%contours)) deallocate (shape%contours)
        call move_alloc(contours, shape%contours)
    end subroutine go

    !> The points that `make_cut` gives of the inside are on the curves.
    subroutine judge(tolerance, name)
        real(dp), intent(in) :: tolerance
        character(*), intent(in) :: name
        real(dp) :: miss
        miss = largest_miss(cut%inside, shape, .true.)
        call tap%ok(miss <= max(tolerance, 1.0e-12_dp), name//': has the points of the inside')
        call tap%ok(miss <= largest_error(shape) + 1.0e-12_dp .and. largest_error(shape) <= &
            max(tolerance, 1.0e-12_dp), name//': says how far it is off')
        call tap%ok(is_end_to_end(shape), name//': its curves meet in the same numbers')
    end subroutine judge

end program test_drawing_inside
