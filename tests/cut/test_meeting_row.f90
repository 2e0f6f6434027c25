!> Where a plane meets sections in a row: places and forms of one station after another.
program test_meeting_row
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_section, only: section_arc
    use body_section_row, only: row_arcs, row_patches
    use body_surface_row, only: patch_row_type
    use cut_meeting, only: cut_branch, meeting_of, meeting_type, place_of
    use cut_meeting_row, only: meetings_at, row_places
    use cut_plane, only: plane_type, waterline_plane
    use geom_arc, only: arc_type
    use geom_arc_point, only: point
    use geom_arc_row, only: arc_row_type, place_of_row, place_row_type
    use geom_place, only: place_type
    use geom_twofold, only: operator(-), to_real
    use geom_twofold_short, only: width
    use support_bodies, only: ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(plane_type) :: plane
    type(patch_row_type) :: patch
    type(arc_row_type) :: row
    type(place_row_type) :: places
    type(place_type) :: place
    type(arc_type) :: arc
    type(meeting_type) :: it(width), one
    type(error_type), allocatable :: error
    real(dp) :: sta(width), worst(2), at(2)
    logical :: is_sure(width), is_smooth(width)
    integer :: i

    body = ellipsoid([5.0_dp, 5.0_dp, 5.0_dp], 0.0_dp, 0.0_dp)
    plane = waterline_plane(3.0_dp)
    sta = [(-3.9_dp + 7.8_dp*real(i - 1, dp)/real(width - 1, dp), i=1, width)]
    call row_patches(body%lines, body%sections(2), sta, .false., patch, is_smooth)
    call row_arcs(patch, row, is_sure)
    call row_places(row, sta, plane, cut_branch%rising, places, is_sure)
    call tap%ok(all(is_sure), 'the waterline meets all sections')
    call meetings_at(body%lines, body%sections(2), plane, sta, it, is_smooth)
    call tap%ok(all(is_smooth), 'of which there is no doubt')
    worst = 0.0_dp
    do i = 1, width
        call section_arc(body%lines, body%sections(2), sta(i), arc, error)
        one = meeting_of(arc, sta(i), plane, [.false., .false.])
        worst(1) = max(worst(1), abs(to_real(one%start - it(i)%start)), &
            abs(to_real(one%middle - it(i)%middle)), abs(to_real(one%finish - it(i)%finish)))
        place = place_of_row(places, i)
        at = point(arc, place)
        worst(2) = max(worst(2), maxval(abs(at - [sqrt(16.0_dp - sta(i)**2), 3.0_dp])))
        if (any(at /= point(arc, place_of(one, cut_branch%rising)))) worst(2) = 1.0_dp
    end do
    call tap%near(worst(1), 0.0_dp, 1.0e-27_dp, 'forms are those of one after another')
    call tap%near(worst(2), 0.0_dp, 1.0e-15_dp, 'points are on the circle, and the same')
    call row_places(row, sta, waterline_plane(-3.0_dp), cut_branch%rising, places, is_sure)
    call tap%ok(.not. any(is_sure), 'below the section there is none')
    call tap%finish()
end program test_meeting_row
