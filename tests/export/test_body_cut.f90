!> Tests of the picture of a cut.
program test_body_cut
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_make, only: make_cut
    use cut_outline, only: cut_type
    use cut_plane, only: buttock_plane, cut_kind, plane_through, plane_type, station_plane
    use cut_request, only: request_type
    use export_body_cut, only: cut_drawing, kind_word, plane_words
    use export_body_drawing, only: drawing_type
    use support_solids, only: ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(plane_type) :: canted
    type(cut_type) :: cut
    type(drawing_type) :: drawing
    type(error_type), allocatable :: error

    body = ellipsoid([5.0_dp, 3.0_dp, 2.0_dp])
    cut = cut_by(station_plane(3.0_dp))
    cut%name = 'FRAME'
    drawing = cut_drawing(cut, cut, 7, .true., 'EGG', 'inches')
    call tap%same(drawing%view, 'Cut 7: FRAME, station 3', 'the plane is stated')
    call tap%same(drawing%x_axis//'|'//drawing%y_axis, &
        'butt line (BL), inches|waterline (WL), inches', 'axes of a station are BL and WL')
    call tap%same(styles(), ' centre mirror outline point', 'port half and centre line are drawn')
    call tap%ok(all(drawing%low <= [-2.4_dp, -1.6_dp]) .and. all(drawing%high >= [2.4_dp, &
        1.6_dp]), &
        'the box holds both halves: .8 of the axes')
    call tap%near(drawing%dot(1), drawing%dot(2), 0.0_dp, 'a unit is as long upwards as across')
    call tap%ok(drawing%layer(4)%count == size(cut%outlines(1)%points), 'every point is drawn')

    cut = cut_by(buttock_plane(1.0_dp))
    drawing = cut_drawing(cut, cut, 1, .true., 'EGG', 'inches')
    call tap%same(styles(), ' outline point', 'a buttock has no other half')
    call plane_through([0.0_dp, 0.0_dp, 0.0_dp], [1.0_dp, 1.0_dp, 0.0_dp], canted, error)
    cut = cut_by(canted)
    drawing = cut_drawing(cut, cut, 1, .true., 'EGG', 'inches')
    call tap%same(plane_words(cut), 'plane through (0, 0, 0), normal (0.7071, 0.7071, 0)', &
        'any plane by point and normal')
    call tap%same(drawing%note, 'u along (-0.7071, 0.7071, 0), v along (0, 0, 1) from STA, BL, '// &
        'WL 0, 0, 0', 'its axes are stated')
    call tap%same(styles(), ' centre outline point', 'a canted plane cuts both halves')
    cut%outlines = cut%outlines(:0)
    drawing = cut_drawing(cut, cut, 1, .true., 'EGG', 'inches')
    call tap%ok(drawing%layers == 0, 'a plane that misses the body gives no picture')
    call tap%same(kind_word(cut_kind%oblique), 'oblique', 'kinds have words')
    call tap%finish()

contains

    !> The cut of the body by a plane.
    type(cut_type) function cut_by(plane) result(made)
        type(plane_type), intent(in) :: plane
        type(request_type) :: request
        type(error_type), allocatable :: trouble
        request%plane = plane
        call make_cut(body, request, made, trouble)
        if (allocated(trouble)) error stop 'no cut'
    end function cut_by

    !> The styles of the drawing, each with a blank in front.
    function styles() result(text)
        character(:), allocatable :: text
        integer :: i
        text = ''
        do i = 1, drawing%layers
            text = text//' '//trim(drawing%layer(i)%style)
        end do
    end function styles

end program test_body_cut
