!> Points of the inside of a skin in its corners: a house of flat walls.
program test_inside_corner
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use body_body, only: body_type, mirrored_body
    use body_offset, only: foot_type
    use cut_inside_corner, only: find_corner, image_of, is_corner
    use cut_outline, only: cut_point_type, cut_type
    use cut_plane, only: station_plane
    use cut_request, only: request_type
    use support_bodies, only: ellipsoid
    use support_cutting, only: by_number, cut_of
    use support_house, only: house, ridge_inside
    use support_tap, only: tap_type
    implicit none (type, external)

    !> Thickness of the skin, and the station of the cut.
    real(dp), parameter :: skin = 0.1_dp, sta = 5.0_dp
    real(dp), parameter :: up(3) = [0.0_dp, 0.0_dp, 1.0_dp]
    type(tap_type) :: tap

    call corners(0.0_dp, 'a house')
    call corners(0.1_dp, 'one that rises')
    call feet()
    call pairs()
    call tap%finish()

contains

    !> The inside of a house as a table of points.
    subroutine corners(rise, name)
        real(dp), intent(in) :: rise        !! of all of it, dWL/dSTA
        character(*), intent(in) :: name
        type(cut_type) :: cut
        real(dp) :: eaves(3), ridge(3)

        cut = cut_of(house(rise), request_of())
        ridge = [sta, 0.0_dp, ridge_inside(rise, sta, skin)]
        eaves = [sta, 1.9_dp, ridge(3) - 0.95_dp]
        associate (point => cut%inside(1)%points)
            call tap%ok(size(point) == 10 .and. size(cut%notes) == 0, &
                'every point of '//name//' has one inside')
            call tap%near(norm2(point(5)%at - eaves), 0.0_dp, 1.0e-12_dp, &
                'the wall ends in a corner')
            call tap%near(norm2(point(6)%at - eaves), 0.0_dp, 1.0e-12_dp, 'where the roof begins')
            call tap%ok(point(5)%section == 1 .and. point(6)%section == 2, &
                'each with its own section')
            call tap%near(point(6)%slope%value, -0.5_dp, 1.0e-12_dp, 'and its own slope')
            call tap%near(norm2(point(10)%at - ridge), 0.0_dp, 1.0e-12_dp, &
                'the roof ends under the ridge')
            call tap%ok(is_equal(point(10)%at(2), 0.0_dp), 'on BL 0')
            call tap%near(point(10)%uv(2) - point(5)%uv(2), 0.95_dp, 1.0e-12_dp, &
                'in true shape, too')
        end associate
    end subroutine corners

    !> A station cut with a skin, five points an arc.
    type(request_type) function request_of() result(request)
        request = by_number(station_plane(sta), 5)
        request%skin = skin
    end function request_of

    !> The feet of a corner.
    subroutine feet()
        type(cut_type) :: cut
        type(foot_type) :: foot(2)
        type(body_type) :: body
        logical :: is_found

        body = mirrored_body(house(0.0_dp))
        cut = cut_of(house(0.0_dp), request_of())
        call find_corner(body, cut%plane, skin, cut%outlines(1)%points(5:6), foot, is_found)
        call tap%ok(is_found, 'a corner has its feet')
        call tap%near(norm2(foot(1)%at - skin*foot(1)%normal - foot(2)%at + skin*foot(2)%normal), &
            0.0_dp, 1.0e-9_dp*skin, 'which are a thickness from one point')
    end subroutine feet

    !> What is a corner and what is none.
    subroutine pairs()
        type(cut_type) :: cut
        type(cut_point_type) :: ridge, image
        type(body_type) :: body

        cut = cut_of(house(0.0_dp), request_of())
        body = mirrored_body(house(0.0_dp))
        ridge = cut%outlines(1)%points(10)
        image = image_of(body, ridge)
        associate (point => cut%outlines(1)%points)
            call tap%ok(is_corner(point(5:6), cut%plane, up), 'eaves are a corner')
            call tap%ok(.not. is_corner(point(5:6), cut%plane, -up), &
                'seen from the other side they are none')
            call tap%ok(.not. is_corner(point(4:5), cut%plane, up), 'nor are points of one section')
            call tap%ok(is_corner([ridge, image], cut%plane, [0.0_dp, -2.0_dp, 1.0_dp]), &
                'a ridge with its image is one')
            image = image_of(body, point(1))
            call tap%ok(image%section == 0, 'beside BL 0 there is no image')
        end associate
        cut = cut_of(ellipsoid([9.0_dp, 4.0_dp, 4.0_dp], 5.0_dp, 0.0_dp), request_of())
        call tap%ok(.not. is_corner(cut%outlines(1)%points(5:6), cut%plane, &
            up - [0.0_dp, 0.1_dp, 0.0_dp]), &
            'where the skin goes on smoothly there is none')
    end subroutine pairs

end program test_inside_corner
