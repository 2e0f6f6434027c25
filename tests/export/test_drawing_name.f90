!> Tests of the names and titles of shapes.
program test_drawing_name
    use base_error, only: error_type
    use base_kinds, only: dp
    use cut_outline, only: cut_type
    use cut_plane, only: buttock_plane, oblique_plane, plane_through, station_plane, waterline_plane
    use export_drawing, only: drawing_type
    use export_drawing_name, only: cut_name, cut_title, make_unique, safe_name
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(cut_type) :: cut
    type(drawing_type) :: drawing
    type(error_type), allocatable :: error
    character(8), parameter :: asked(5) = &
        ['FRAME   ', 'KEEL    ', 'frame   ', 'FRAME-2 ', 'FRAME   ']
    integer :: i

    cut%plane = station_plane(20.0_dp)
    call tap%same(trim(cut_name(cut))//'|'//trim(cut_title(cut)), 'STA_20|STATION 20', 'a station')
    cut%plane = buttock_plane(-4.5_dp)
    call tap%same(trim(cut_name(cut))//'|'//trim(cut_title(cut)), &
        'BL_-4.5|BUTT LINE -4.5', 'a butt line')
    cut%plane = waterline_plane(-16.0_dp)
    cut%name = 'FLOOR'
    call tap%same(trim(cut_name(cut))//'|'//trim(cut_title(cut)), &
        'WL_-16_FLOOR|WATERLINE -16 FLOOR', &
        'a waterline with a name')
    cut%name = ' A/B'//char(7)//'c'
    call tap%same(trim(cut_name(cut)), 'WL_-16_A_B_c', 'bytes that no file name has become _')
    call tap%same(trim(cut_title(cut)), &
        'WATERLINE -16 A/B'//char(7)//'c', 'but in titles they stay')
    call oblique_plane([40.0_dp, -24.0_dp], [50.0_dp, 24.0_dp], cut%plane, error)
    call tap%same(trim(cut_name(cut)), 'OBL_A_B_c', 'an oblique plane')
    cut%name = ''
    call tap%same(trim(cut_name(cut))//'|'//trim(cut_title(cut)), &
        'OBL|OBLIQUE THROUGH STA 40 BL 0 WL -24', &
        'an oblique plane without a name')
    call plane_through([1.0_dp, 2.5_dp, 0.1_dp], [1.0_dp, 1.0_dp, 1.0_dp], cut%plane, error)
    call tap%same(trim(cut_name(cut))//'|'//trim(cut_title(cut)), &
        'PLANE|PLANE THROUGH STA 1 BL 2.5 WL 0.1', &
        'any plane')
    call tap%same(safe_name(''), '_', 'no name is empty')
    call tap%same(safe_name('..a-b_C.9 '), '..a-b_C.9', 'letters, figures and - _ . stay')

    allocate (drawing%cuts(3), drawing%lines(2))
    do i = 1, 3
        drawing%cuts(i)%name = trim(asked(i))
    end do
    do i = 1, 2
        drawing%lines(i)%name = trim(asked(3 + i))
    end do
    call make_unique(drawing)
    call tap%same(drawing%cuts(1)%name//' '//drawing%cuts(2)%name//' '//drawing%cuts(3)%name, &
        'FRAME KEEL frame-2', 'a name that is there in other letters gets a suffix')
    call tap%same(drawing%lines(1)%name//' '//drawing%lines(2)%name, 'FRAME-2-2 FRAME-3', &
        'of lines, too; a suffix that is taken is passed over')
    deallocate (drawing%lines)
    call make_unique(drawing)
    call tap%same(drawing%cuts(3)%name, 'frame-2', 'unique names stay; lines may be missing')
    deallocate (drawing%cuts)
    allocate (drawing%lines(2))
    drawing%lines(1)%name = 'UCL'
    drawing%lines(2)%name = 'UCL'
    call make_unique(drawing)
    call tap%same(drawing%lines(2)%name, 'UCL-2', 'cuts may be missing')
    call tap%finish()
end program test_drawing_name
