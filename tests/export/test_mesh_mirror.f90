!> Tests of the port half of a mesh.
program test_mesh_mirror
    use base_kinds, only: dp
    use export_mesh, only: add_normal, add_triangle, add_vertex, mesh_part_type, mesh_type
    use export_mesh_mirror, only: add_port_half
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(mesh_type) :: mesh
    type(mesh_part_type) :: part

    part%name = 'UPPER'
    part%section = 2
    part%error = 0.5_dp
    part%worst = [1.0_dp, 2.0_dp, 3.0_dp]
    allocate (mesh%parts(1))
    mesh%parts(1) = part
    call add_vertex(mesh, [0.0_dp, 0.0_dp, 5.0_dp])
    call add_vertex(mesh, [1.0_dp, 0.1_dp, 4.0_dp])
    call add_vertex(mesh, [2.0_dp, 0.0_dp, 5.0_dp])
    call add_normal(mesh, [0.0_dp, 0.6_dp, 0.8_dp])
    call add_normal(mesh, [0.0_dp, 0.0_dp, 1.0_dp])
    call add_triangle(mesh, [1, 2, 3], [2, 1, 2])
    call add_port_half(mesh)
    call tap%ok(mesh%vertex_count == 4 .and. mesh%normal_count == 3, &
        'what is in BL 0 belongs to both halves')
    call tap%ok(all(mesh%triangles(:, 2) == [1, 3, 4]), 'triangles are turned round')
    call tap%ok(all(mesh%corners(:, 2) == [2, 2, 3]), 'with their normals')
    call tap%near(norm2(mesh%vertices(:, 4) - [1.0_dp, -0.1_dp, 4.0_dp]), 0.0_dp, 0.0_dp, &
        'vertices are exact images')
    call tap%near(norm2(mesh%normals(:, 3) - [0.0_dp, -0.6_dp, 0.8_dp]), 0.0_dp, 0.0_dp, &
        'normals too')
    call tap%ok(size(mesh%parts) == 2, 'each part has its image')
    call tap%same(mesh%parts(2)%name, 'UPPER P', 'which is named for it')
    call tap%ok(mesh%parts(2)%is_port .and. mesh%parts(2)%section == 2 .and. &
        mesh%parts(2)%first == 2 .and. mesh%parts(2)%last == 2, 'and knows its triangles')
    call tap%near(mesh%parts(2)%error - mesh%parts(2)%worst(2), 2.5_dp, 0.0_dp, &
        'its error, at the image of the place')
    call tap%finish()
end program test_mesh_mirror
