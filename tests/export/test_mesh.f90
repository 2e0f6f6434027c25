!> Tests of the parts of a mesh.
program test_mesh
    use base_kinds, only: dp
    use export_mesh, only: add_normal, add_triangle, add_vertex, mesh_part_type, mesh_type, &
        scale_mesh, trim_mesh
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(mesh_type) :: mesh, empty
    type(mesh_part_type) :: part
    integer :: i

    part%name = 'ONE'
    part%error = 0.25_dp
    part%worst = [1.0_dp, 2.0_dp, 3.0_dp]
    allocate (mesh%parts(1))
    mesh%parts(1) = part
    do i = 1, 3000
        call add_vertex(mesh, [real(i, dp), 0.0_dp, -1.0_dp])
        call add_normal(mesh, [0.0_dp, 0.0_dp, 1.0_dp])
    end do
    call tap%ok(mesh%vertex_count == 3000 .and. mesh%normal_count == 3000, 'lists grow')
    call tap%near(mesh%vertices(1, 1025), 1025.0_dp, 0.0_dp, 'and keep what is in them')
    do i = 3, 2999, 2
        call add_triangle(mesh, [i, i - 2, 2999], [1, 2, 3])
    end do
    call tap%ok(mesh%triangle_count == 1499, 'triangles are counted')
    call tap%ok(mesh%parts(1)%last == 1499, 'and belong to the last part')
    call trim_mesh(mesh)
    call tap%ok(mesh%vertex_count == 1500, 'vertices without a triangle are left out')
    call tap%ok(all(shape(mesh%vertices) == [3, 1500]) .and. &
        all(shape(mesh%triangles) == [3, 1499]), 'so is room not in use')
    call tap%ok(all(mesh%triangles(:, 2) == [3, 2, 1500]), 'triangles go on to their vertices')
    call tap%near(mesh%vertices(1, 3), 5.0_dp, 0.0_dp, 'the fifth vertex is now the third')
    mesh%tolerance = 0.5_dp
    mesh%error = 0.25_dp
    mesh%worst = part%worst
    mesh%turn_at = part%worst
    mesh%turn = 7.0_dp
    call scale_mesh(mesh, 25.4_dp, 'MM')
    call tap%same(mesh%units, 'MM', 'a scaled mesh has the new unit')
    call tap%near(mesh%vertices(1, 3), 127.0_dp, 0.0_dp, 'vertices are scaled')
    call tap%near(mesh%tolerance + mesh%error, 19.05_dp, 1.0e-14_dp, 'so are its errors')
    call tap%near(mesh%worst(3) + mesh%turn_at(2), 127.0_dp, 1.0e-13_dp, 'their places')
    call tap%near(mesh%parts(1)%error + mesh%parts(1)%worst(1), 31.75_dp, 1.0e-14_dp, &
        'and those of parts')
    call tap%near(mesh%turn, 7.0_dp, 0.0_dp, 'an angle is not')
    call tap%near(mesh%normals(3, 9), 1.0_dp, 0.0_dp, 'nor is a normal')
    call trim_mesh(empty)
    call tap%ok(size(empty%vertices) + size(empty%normals) + size(empty%triangles) == 0, &
        'a mesh without a triangle is an empty one')
    call tap%finish()
end program test_mesh
