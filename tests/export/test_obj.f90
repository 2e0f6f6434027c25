!> Tests of OBJ files.
program test_obj
    use base_output, only: output_type
    use export_mesh, only: mesh_type
    use export_obj, only: write_obj
    use export_receipt, only: receipt_type
    use support_tap, only: tap_type
    use support_tetrahedron, only: tetrahedron
    implicit none (type, external)

    type(tap_type) :: tap
    type(mesh_type) :: mesh
    type(output_type) :: out, other
    type(receipt_type) :: receipt
    character(*), parameter :: feed = new_line('a')

    mesh = tetrahedron()
    call write_obj(mesh, out, receipt)
    call tap%ok(index(out%text(), '# LOFT ') == 1, 'a comment says who wrote it')
    call tap%has(out%text(), ', DECK a b.crd'//feed//'# FOUR FACES'//feed//'# UNITS=INCHES, ', &
        'from which deck, its title and the units')
    call tap%has(out%text(), feed//'o a_b.crd'//feed//'v 0 0 0'//feed//'v 1 0 0'//feed// &
        'v 0 2 0'//feed//'v 0 0 0.1'//feed//'vn 0.000000000 0.000000000 -1.000000000'//feed// &
        'vn 0.333333333 0.666666667 0.666666667'//feed//'g CAP_STA_0'//feed//'f 1//1 3//1 2//1'// &
        feed//'g UPPER_P'//feed//'f 1//2 2//2 4//2'//feed//'f 2//2 3//2 4//2'//feed// &
        'f 3//2 1//2 4//2'//feed, 'then vertices, normals, and a group for each part')
    call tap%ok(receipt%count == 2, 'the receipt has the parts')
    mesh%title = ''
    mesh%deck = 'bad'//achar(27)//'name'
    mesh%parts(1)%last = 0
    call write_obj(mesh, other, receipt)
    call tap%has(other%text(), 'DECK bad?name'//feed//'# UNITS', 'no control byte, no empty title')
    call tap%ok(index(other%text(), 'CAP') == 0, 'an empty part is left out')
    call tap%finish()
end program test_obj
