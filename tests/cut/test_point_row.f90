!> Points of a station in rows: figure for figure those of one place after another.
program test_point_row
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_section, only: section_arc
    use cut_outline, only: cut_point_type
    use cut_plane, only: station_plane
    use cut_point, only: point_on_arc
    use cut_point_row, only: points_on_arc
    use cut_request, only: cut_fact, request_type
    use geom_arc, only: arc_type
    use geom_place, only: place_at
    use support_bodies, only: ellipsoid, nose_of_the_book
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call compare(nose_of_the_book(), 20.0_dp, 'the nose of the book')
    call compare(ellipsoid([30.0_dp, 5.0_dp, 7.0_dp], 11.0_dp, 3.0_dp), -4.0_dp, 'an ellipsoid')
    call tap%finish()

contains

    !> Compares the points of a section at a station.
    subroutine compare(body, sta, name)
        type(body_type), intent(in) :: body
        real(dp), intent(in) :: sta
        character(*), intent(in) :: name
        type(request_type) :: request
        type(cut_point_type) :: points(150), less(150), one
        type(arc_type) :: arc
        type(error_type), allocatable :: error
        integer :: i, wrong(5)

        request%plane = station_plane(sta)
        call section_arc(body%lines, body%sections(1), sta, arc, error)
        call points_on_arc(body, 1, arc, place_at([(real(i - 1, dp)/149.0_dp, i=1, 150)]), &
            request, points)
        request%facts = cut_fact%slope
        call points_on_arc(body, 1, arc, points%place, request, less)
        wrong = 0
        do i = 1, 150
            one = point_on_arc(body, 1, arc, points(i)%place, request%plane, .false.)
            if (any(points(i)%at /= one%at) .or. any(points(i)%uv /= one%uv)) &
                wrong(1) = wrong(1) + 1
            if (points(i)%slope%value /= one%slope%value .or. &
                (points(i)%slope%is_vertical .neqv. one%slope%is_vertical)) wrong(2) = wrong(2) + 1
            if (any(abs(points(i)%normal - one%normal) > 4.0e-16_dp)) wrong(3) = wrong(3) + 1
            if (abs(points(i)%bevel - one%bevel) > 1.0e-13_dp) wrong(3) = wrong(3) + 1
            if (points(i)%curvature /= one%curvature) wrong(4) = wrong(4) + 1
            if (any(less(i)%at /= one%at) .or. less(i)%has_normal) wrong(5) = wrong(5) + 1
        end do
        call tap%ok(wrong(1) == 0, 'points of '//name)
        call tap%ok(wrong(2) == 0, 'slopes of '//name)
        call tap%ok(wrong(3) == 0, 'normals and bevels of '//name)
        call tap%ok(wrong(4) == 0, 'curvatures of '//name)
        call tap%ok(wrong(5) == 0, 'where only slopes are asked there is no normal of '//name)
    end subroutine compare

end program test_point_row
