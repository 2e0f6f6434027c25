!> What faces of patches and ducts have alike: corners in order, sides that go round, also of an
!> image, and a side that is a point.
program test_shell_panel_face
    use base_kinds, only: dp
    use body_panel, only: mirrored_panel, panel_type
    use export_shell, only: face_type, vertex_type
    use export_shell_panel_face, only: put_corners, put_face
    use support_saddle, only: saddle
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(panel_type) :: panel
    type(vertex_type) :: vertices(4)
    type(face_type) :: face, image
    integer :: last(2)

    panel = saddle()
    call put_corners(panel%surface, vertices)
    last = [size(panel%surface%pole, 2), size(panel%surface%pole, 3)]
    call tap%ok(all([vertices(2)%at == panel%surface%pole(:, last(1), 1), &
        vertices(4)%at == panel%surface%pole(:, 1, last(2))]) .and. &
        norm2(vertices(1)%at - vertices(3)%at) > 0.0_dp, 'vertices stand in the corners')
    call put_face(panel, panel%surface, [5, 6, 7, 8], [0, 0, 0, 0], face)
    call tap%ok(all(face%sides%edge == [5, 6, 7, 8]) .and. &
        all(face%sides%is_forward .eqv. [.true., .true., .false., .false.]), &
        'its sides go round counter-clockwise')
    call put_face(mirrored_panel(panel), panel%surface, [5, 0, 7, 8], [1, 2, 3, 4], image)
    call tap%ok(all(image%sides%edge == [5, 8, 7, 0]) .and. &
        all(image%sides%is_forward .eqv. [.false., .true., .true., .false.]), &
        'those of an image the other way')
    call tap%ok(all(image%sides%vertex == [0, 0, 0, 2]), 'a side without an edge is a point')
    call tap%same(image%name, face%name//' PORT', 'an image is said to be')
    call tap%finish()

end program test_shell_panel_face
