!> The inside of a skin against closed forms: spheres within spheres, the book's nose by distance.
program test_inside
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_inside, only: inside_outlines
    use cut_outline, only: cut_type, note_type
    use cut_plane, only: height_over, plane_type, station_plane, waterline_plane
    use cut_request, only: request_type
    use support_bodies, only: ellipsoid
    use support_cutting, only: by_number, cut_of, plane_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(cut_type) :: cut

    body = ellipsoid([5.0_dp, 5.0_dp, 5.0_dp], 0.0_dp, 0.0_dp)
    call check_sphere(station_plane(3.0_dp), 'a station')
    call check_sphere(waterline_plane(2.0_dp), 'a waterline')
    call check_sphere(plane_of([0.5_dp, 0.2_dp, 0.1_dp], [1.0_dp, 2.0_dp, 3.0_dp]), &
        'a general plane')
    cut = cut_of(body, request_of(waterline_plane(0.0_dp), 1.0_dp))
    call tap%near(cut%inside(1)%points(1)%at(1), -4.0_dp, 0.0_dp, 'also at the round nose')
    cut = cut_of(body, request_of(waterline_plane(2.0_dp), 5.5_dp))
    call tap%ok(size(cut%inside(1)%points) == 0, 'a skin thicker than the radius has no inside')
    call tap%ok(size(cut%notes) == 1, 'of which there is a note')
    if (size(cut%notes) == 1) then
        call tap%ok(index(cut%notes(1)%message, 'thicker than the radius of curvature 5.') > 0, &
            'that says so')
        call tap%ok(.not. cut%notes(1)%is_error, 'and is no error')
    end if
    cut = cut_of(body, request_of(waterline_plane(4.5_dp), 1.0_dp))
    call tap%ok(size(cut%inside(1)%points) == 0, 'a plane that passes the inside by has none')
    call tap%ok(size(cut%notes) == 1, 'and a note')
    call check_ellipsoid()
    call check_edge()
    cut = cut_of(body, by_number(waterline_plane(2.0_dp), 5))
    call tap%ok(size(cut%inside) == 0, 'where no skin is asked there is no inside')
    call tap%finish()

contains

    !> A cut with a skin.
    type(request_type) function request_of(plane, skin)
        type(plane_type), intent(in) :: plane
        real(dp), intent(in) :: skin
        request_of = by_number(plane, 9)
        request_of%skin = skin
    end function request_of

    !> Inside a sphere of radius 5 a skin of 1 leaves a sphere of radius 4.
    subroutine check_sphere(plane, name)
        type(plane_type), intent(in) :: plane
        character(*), intent(in) :: name
        real(dp) :: worst(4), radius
        integer :: k
        cut = cut_of(body, request_of(plane, 1.0_dp))
        radius = sqrt(16.0_dp - height_over(plane, [0.0_dp, 0.0_dp, 0.0_dp])**2)
        worst = 0.0_dp
        do k = 1, size(cut%inside(1)%points)
            associate (point => cut%inside(1)%points(k))
                worst(1) = max(worst(1), abs(norm2(point%at) - 4.0_dp))
                worst(2) = max(worst(2), abs(height_over(plane, point%at)))
                worst(3) = max(worst(3), norm2(point%normal - point%at/4.0_dp))
                worst(4) = max(worst(4), abs(abs(point%curvature) - 1.0_dp/radius))
            end associate
        end do
        call tap%ok(size(cut%inside(1)%points) == size(cut%outlines(1)%points), &
            'every point of '//name//' has one inside')
        call tap%near(worst(1), 0.0_dp, 2.0e-15_dp, 'on the inner sphere, '//name)
        call tap%near(worst(2), 0.0_dp, 4.0e-15_dp, 'in the plane, '//name)
        call tap%near(worst(3), 0.0_dp, 1.0e-14_dp, 'with its normal, '//name)
        call tap%near(worst(4), 0.0_dp, 1.0e-12_dp, 'and its curvature, '//name)
        call tap%ok(all(cut%inside(1)%points%curvature*cut%outlines(1)%points%curvature > 0.0_dp), &
            'turning the same way, '//name)
    end subroutine check_sphere

    !> Where the skin ends at the greatest breadth, its inside ends opposite to it.
    subroutine check_edge()
        type(body_type) :: half
        half = body
        half%sections = body%sections(:1)
        cut = cut_of(half, request_of(station_plane(3.0_dp), 1.0_dp))
        call tap%ok(size(cut%inside(1)%points) == 9, 'the inside of a lower half is whole')
        call tap%near(norm2(cut%inside(1)%points(9)%at - [3.0_dp, sqrt(7.0_dp), 0.0_dp]), 0.0_dp, &
            1.0e-14_dp, 'and ends opposite to the edge')
        call tap%ok(size(cut%notes) == 0, 'which needs no note')
    end subroutine check_edge

    !> A point of the inside is P = Q - t n(Q) with Q on the ellipsoid.
    subroutine check_ellipsoid()
        real(dp), parameter :: axes(3) = [5.0_dp, 2.0_dp, 1.5_dp], t = 0.2_dp
        real(dp) :: worst, q(3)
        integer :: k
        cut = cut_of(ellipsoid(axes, 0.0_dp, 0.0_dp), &
            request_of(plane_of([0.5_dp, 0.2_dp, 0.1_dp], [1.0_dp, 2.0_dp, 3.0_dp]), t))
        worst = 0.0_dp
        do k = 1, size(cut%inside(1)%points)
            q = cut%inside(1)%points(k)%at + t*cut%inside(1)%points(k)%normal
            worst = max(worst, abs(sum((q/axes)**2) - 1.0_dp), norm2(q/axes**2/norm2(q/axes**2) &
                - cut%inside(1)%points(k)%normal))
        end do
        call tap%ok(cut%inside(1)%is_closed, &
            'inside a closed outline of an ellipsoid is a closed one')
        call tap%near(worst, 0.0_dp, 1.0e-12_dp, &
            'each of whose points is a thickness from the ellipsoid')
    end subroutine check_ellipsoid

end program test_inside
