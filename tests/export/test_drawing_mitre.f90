!> Corners of the inside of a skin: a house of flat walls, whose corners are known.
program test_drawing_mitre
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type, mirrored_body
    use cut_outline, only: cut_type
    use cut_plane, only: station_plane
    use cut_request, only: request_type
    use export_drawing, only: contour_type, shape_type
    use export_drawing_inside, only: draw_inside
    use export_drawing_mitre, only: mitre, mitre_image, side_type
    use export_drawing_opposite, only: new_opposite
    use export_drawing_outside, only: way_round, way_round_type
    use support_cutting, only: by_number, cut_of
    use support_drawn, only: distance_from_contour, is_end_to_end
    use support_house, only: house, ridge_inside
    use support_tap, only: tap_type
    implicit none (type, external)

    !> Thickness of the skin, and the station of the cut.
    real(dp), parameter :: skin = 0.1_dp, sta = 5.0_dp
    type(tap_type) :: tap
    type(way_round_type) :: round
    type(cut_type) :: cut
    type(contour_type), allocatable :: contours(:)
    type(shape_type) :: shape

    call corners(0.0_dp, 'a house')
    call corners(0.1_dp, 'one that rises')
    call sides()
    call tap%finish()

contains

    !> The corners of the inside of a house.
    subroutine corners(rise, name)
        real(dp), intent(in) :: rise        !! of all of it, dWL/dSTA
        character(*), intent(in) :: name

        call draw(house(rise))
        call tap%ok(size(contours) == 1, 'the inside of '//name//' is one contour')
        call tap%ok(.not. contours(1)%is_closed, 'open at its floor')
        shape%contours = contours
        call tap%ok(is_end_to_end(shape), 'its walls meet in the same numbers')
        call tap%near(distance_from_contour(contours(1), [sta, 1.9_dp, ridge(rise) - 0.95_dp]), &
            0.0_dp, 1.0e-10_dp, 'in the corner under the eaves')
        call tap%near(distance_from_contour(contours(1), [sta, 0.0_dp, ridge(rise)]), 0.0_dp, &
            1.0e-10_dp, 'and under the ridge')
        call tap%near(highest(contours(1)), ridge(rise), 1.0e-10_dp, 'above which nothing stands')
    end subroutine corners

    !> WL of the ridge of the inside.
    pure real(dp) function ridge(rise)
        real(dp), intent(in) :: rise        !! dWL/dSTA
        ridge = ridge_inside(rise, sta, skin)
    end function ridge

    !> Draws the inside at station 5.
    subroutine draw(body)
        type(body_type), intent(in) :: body
        type(request_type) :: request
        type(error_type), allocatable :: error

        request = by_number(station_plane(sta), 9)
        request%skin = skin
        cut = cut_of(body, request)
        call way_round(mirrored_body(body), cut%plane, cut%outlines(1), round)
        round%is_half = .true.
        call draw_inside(mirrored_body(body), cut, round, 1.0e-4_dp, contours, error)
        call tap%ok(.not. allocated(error), 'the inside is drawn')
    end subroutine draw

    !> The greatest WL of the poles of a contour.
    pure real(dp) function highest(contour)
        type(contour_type), intent(in) :: contour
        integer :: i
        highest = -huge(1.0_dp)
        do i = 1, size(contour%curves)
            highest = max(highest, maxval(contour%curves(i)%spline%pole(3, :)))
        end do
    end function highest

    !> Two sides whose insides cross, and the same turned about.
    subroutine sides()
        type(body_type) :: body
        type(side_type) :: wall, roof
        integer :: i

        body = house(0.0_dp)
        call draw(body)
        body = mirrored_body(body)
        i = findloc(round%path%section, 1, dim=1)
        wall = whole_side(body, i)
        roof = whole_side(body, i + 1)
        call mitre(wall, roof, 1.0e-14_dp)
        call tap%near(wall%path%until(1), 0.5_dp*(ridge(0.0_dp) - 0.95_dp), 1.0e-12_dp, &
            'the wall ends in the corner')
        call tap%near(norm2(roof%path%at(roof%from(1)) - [1.9_dp, ridge(0.0_dp) - 0.95_dp, &
            0.0_dp]), 0.0_dp, 1.0e-12_dp, 'where the roof begins')
        call mitre(wall, roof, 1.0e-14_dp)
        call tap%near(wall%path%until(1), 0.5_dp*(ridge(0.0_dp) - 0.95_dp), 1.0e-12_dp, &
            'sides that meet stay as they are')
        call mitre_image(roof, .true., 1.0e-14_dp)
        call tap%near(norm2(roof%path%at(roof%path%until(1)) - [0.0_dp, ridge(0.0_dp), 0.0_dp]), &
            0.0_dp, 1.0e-12_dp, 'the roof ends under the ridge')
        call mitre_image(wall, .false., 1.0e-14_dp)
        call tap%near(wall%from(1), 0.0_dp, 0.0_dp, 'a wall that begins beside BL 0 stays')
    end subroutine sides

    !> A path of the outline with all of its own inside.
    type(side_type) function whole_side(body, i) result(side)
        type(body_type), intent(in) :: body
        integer, intent(in) :: i    !! which path
        call new_opposite(body, cut%plane, skin, round%path(i), side%path)
        side%path%patch = [10000*round%path(i)%section + 1]
        side%path%until = [1.0_dp]
        side%from = [0.0_dp]
    end function whole_side

end program test_drawing_mitre
