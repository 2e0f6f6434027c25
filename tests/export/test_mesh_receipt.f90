!> Tests of what a mesh says in its receipt.
program test_mesh_receipt
    use base_kinds, only: dp
    use export_mesh, only: mesh_type
    use export_mesh_receipt, only: note_mesh
    use export_receipt, only: receipt_type
    use support_tap, only: tap_type
    use support_tetrahedron, only: tetrahedron
    implicit none (type, external)

    type(tap_type) :: tap
    type(mesh_type) :: mesh
    type(receipt_type) :: receipt, other

    mesh = tetrahedron()
    call note_mesh(mesh, 'TRIANGLES', receipt)
    call tap%ok(receipt%count == 2, 'an entity for each part')
    call tap%same(receipt%entities(2)%name//'|'//receipt%entities(2)%kind, 'UPPER P|TRIANGLES', &
        'with its name and kind')
    call tap%ok(receipt%entities(2)%points == 3, 'its triangles')
    call tap%near(receipt%entities(2)%error + receipt%entities(2)%worst(3), 3.25_dp, 0.0_dp, &
        'its error and where')
    call tap%ok(receipt%entities(1)%is_exact .and. .not. receipt%entities(2)%is_exact, &
        'a flat cap is what it is')
    call tap%ok(receipt%entities(2)%has_place .and. .not. receipt%entities(1)%has_place, &
        'and has no worst place')
    call tap%same(receipt%notes, '4 triangles, 4 vertices on the exact skin at 2 stations'// &
        new_line('a')//'closed: each edge belongs to two triangles'//new_line('a')// &
        'largest turn between neighbours in a section 12.5 degrees at STA 4., BL 5., WL -6., '// &
        'asked 10.'//new_line('a'), 'and in words what the whole is')
    mesh%is_closed = .false.
    mesh%why = 'a reason'
    mesh%vertex_count = 1
    mesh%parts(1)%last = 0
    call note_mesh(mesh, 'TRIANGLES', other)
    call tap%has(other%notes, 'open, not a solid: a reason', 'an open one says why')
    call tap%has(other%notes, ', 1 vertex on', 'one vertex is one')
    call tap%ok(other%count == 1, 'an empty part is not told')
    call tap%finish()
end program test_mesh_receipt
