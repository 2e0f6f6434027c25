!> Tests of half shapes made whole.
program test_drawing_whole
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_plane, only: buttock_plane, in_space, plane_type, station_plane, true_shape, &
        waterline_plane
    use cut_request, only: request_type
    use export_drawing, only: curve_type, shape_type
    use export_drawing_conic, only: distance_off
    use export_drawing_cut, only: draw_cut
    use export_drawing_whole, only: whole
    use geom_bspline, only: spline_point
    use support_bodies, only: ellipsoid, nose_of_the_book
    use support_cutting, only: by_number, cut_of, plane_of
    use support_drawn, only: is_end_to_end
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(shape_type) :: half, both

    body = ellipsoid([50.0_dp, 20.0_dp, 30.0_dp], 100.0_dp, 5.0_dp)
    call go(station_plane(80.0_dp))
    call tap%ok(half%is_half .and. .not. both%is_half, 'a frame of a symmetric body is half of one')
    call tap%ok(size(both%contours) == 2 .and. all(both%contours%is_closed), &
        'outside and inside, both closed')
    call tap%ok(size(both%contours(1)%curves) == 4, 'of all four arcs')
    half%contours%has_image = .false.
    both = whole(half)
    call tap%ok(size(both%contours) == 2 .and. size(both%contours(1)%curves) == 2 .and. &
        .not. both%is_half, 'contours that have no image are whole as they are')
    call go(station_plane(80.0_dp))
    call judge('frame')
    call tap%ok(size(both%contours(1)%marks) == 2*size(half%contours(1)%marks) - 1, &
        'a mark at BL 0 is there once')
    call go(waterline_plane(-9.0_dp))
    call judge('waterline')
    call tap%ok(both%contours(1)%is_closed, 'a waterline closes, too')
    call go(plane_of([100.0_dp, 3.0_dp, 5.0_dp], [1.0_dp, 0.0_dp, 0.4_dp]))
    call judge('canted frame with its origin off the centre')
    call tap%ok(both%contours(1)%is_closed .and. both%contours(2)%is_closed, 'it closes')
    call go(plane_of([100.0_dp, 3.0_dp, -5.0_dp], [0.0_dp, 0.0_dp, -1.0_dp]))
    call judge('level plane')
    call go(buttock_plane(4.0_dp))
    call tap%ok(.not. half%is_half .and. size(both%contours) == size(half%contours), &
        'a butt line is whole as it is')
    body = nose_of_the_book()
    call go(station_plane(20.0_dp))
    call judge('open quarter')
    call tap%ok(size(both%contours) == 2 .and. .not. any(both%contours%is_closed), &
        'quarters that meet at the keel stay open above')
    call tap%ok(size(both%contours(1)%curves) == 2, 'and are one contour')
    call go(waterline_plane(-9.0_dp))
    call tap%ok(size(both%contours) == 2*size(half%contours), 'sides that do not meet stay two')
    body%is_symmetric = .false.
    call go(station_plane(20.0_dp))
    call tap%ok(.not. half%is_half, 'a body without symmetry has no halves')

    deallocate (half%contours)
    allocate (half%contours(2))
    half%is_half = .true.
    allocate (half%contours(1)%curves(0), half%contours(1)%marks(0), half%contours(2)%curves(0), &
        half%contours(2)%marks(0))
    half%contours(2)%at = [1.0_dp, 2.0_dp, 3.0_dp]
    both = whole(half)
    call tap%ok(size(both%contours) == 3, 'a point at BL 0 is one, another is two')
    call tap%near(both%contours(3)%at(2), -2.0_dp, 0.0_dp, 'the other one to port')
    call tap%finish()

contains

    !> A cut with skin, drawn and made whole.
    subroutine go(plane)
        type(plane_type), intent(in) :: plane
        type(request_type) :: request
        type(error_type), allocatable :: error
        request = by_number(plane, 9)
        request%skin = 0.25_dp
        call draw_cut(body, cut_of(body, request), 1.0e-4_dp, 3.0_dp, half, error)
        if (allocated(error)) error stop 'a cut of a test can''t be drawn'
        both = whole(half)
    end subroutine go

    !> Half the curves are the half's, the others their images; splines and arcs go together; closed
    !> contours are counter-clockwise.
    subroutine judge(name)
        character(*), intent(in) :: name
        integer :: i, k, n, images
        logical :: is_arc_right, is_left
        real(dp) :: area

        call tap%ok(is_end_to_end(both), name//': curves meet in the same numbers')
        images = 0
        is_arc_right = .true.
        is_left = .true.
        do i = 1, size(both%contours)
            area = 0.0_dp
            do k = 1, size(both%contours(i)%curves)
                associate (curve => both%contours(i)%curves(k))
                    do n = 1, size(half%contours(i)%curves)
                        if (is_image(curve, half%contours(i)%curves(n))) images = images + 1
                    end do
                    is_arc_right = is_arc_right .and. arc_fits(curve)
                    area = area + swept(curve)
                end associate
            end do
            is_left = is_left .and. (area > 0.0_dp .or. .not. both%contours(i)%is_closed)
        end do
        call tap%ok(images == sum([(size(half%contours(i)%curves), i=1, size(half%contours))]), &
            name//': each curve has an image, BL with the other sign, to the last bit')
        call tap%ok(is_arc_right, name//': arcs lie where their splines do')
        call tap%ok(is_left, name//': closed contours are counter-clockwise')
    end subroutine judge

    !> True for a curve whose poles, backwards and mirrored, are those of another.
    logical function is_image(curve, other)
        type(curve_type), intent(in) :: curve, other
        integer :: last
        last = size(curve%spline%weight)
        is_image = last == size(other%spline%weight)
        if (.not. is_image) return
        associate (mine => curve%spline%pole, its => other%spline%pole)
            is_image = all(abs(mine(1, :) - its(1, :)) <= 0.0_dp) .and. all(abs(mine(2, :) &
                + its(2, :)) <= 0.0_dp) .and. all(abs(mine(3, :) - its(3, :)) <= 0.0_dp)
            if (.not. is_image) is_image = all(abs(mine(1, last:1:-1) - its(1, :)) <= 0.0_dp) &
                .and. all(abs(mine(2, last:1:-1) + its(2, :)) <= 0.0_dp) &
                .and. all(abs(mine(3, last:1:-1) - its(3, :)) <= 0.0_dp)
        end associate
    end function is_image

    !> True where the arc of a curve, if it has one, is its spline.
    logical function arc_fits(curve)
        type(curve_type), intent(in) :: curve
        real(dp) :: t
        integer :: k, last
        arc_fits = .true.
        if (.not. curve%is_conic) return
        do k = 0, 8
            t = real(k, dp)/8.0_dp
            arc_fits = arc_fits .and. distance_off(curve%arc, true_shape(both%plane, &
                spline_point(curve%spline, t))) < 1.0e-12_dp
        end do
        last = size(curve%spline%weight)
        arc_fits = arc_fits .and. norm2(in_space(both%plane, curve%arc%start) &
            - curve%spline%pole(:, 1)) < 1.0e-13_dp .and. norm2(in_space(both%plane, &
            curve%arc%finish) - curve%spline%pole(:, last)) < 1.0e-13_dp
    end function arc_fits

    !> Twice the area that a curve sweeps about STA 100, BL 0, WL 0 in the view of the shape.
    real(dp) function swept(curve) result(area)
        type(curve_type), intent(in) :: curve
        real(dp) :: p(3), q(3), normal(3)
        integer :: k
        normal = cshift(both%plane%u, 1)*cshift(both%plane%v, 2) &
            - cshift(both%plane%u, 2)*cshift(both%plane%v, 1)
        area = 0.0_dp
        do k = 1, 20
            p = spline_point(curve%spline, real(k - 1, dp)/20.0_dp) - [100.0_dp, 0.0_dp, 0.0_dp]
            q = spline_point(curve%spline, real(k, dp)/20.0_dp) - [100.0_dp, 0.0_dp, 0.0_dp]
            area = area + dot_product(normal, cshift(p, 1)*cshift(q, 2) - cshift(p, 2)*cshift(q, 1))
        end do
    end function swept

end program test_drawing_whole
