!> Vertices along the sides of a panel: its own, and those of others.
program test_mesh_border
    use base_kinds, only: dp
    use body_panel, only: panel_type
    use export_mesh, only: add_normal, add_triangle, add_vertex, mesh_part_type, mesh_type
    use export_mesh_border, only: border_type, lay_borders
    use support_saddle, only: saddle
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(panel_type) :: panel
    type(mesh_type) :: mesh
    type(border_type) :: border(4)

    panel = saddle()
    allocate (mesh%parts(0), mesh%vertices(3, 8))
    call lay_borders(panel, [5, 3], [integer ::], .false., mesh, border)
    call tap%ok(all([size(border(1)%vertex), size(border(2)%vertex), size(border(3)%vertex), &
        size(border(4)%vertex)] == [6, 4, 6, 4]), 'a vertex at each cell')
    call tap%ok(mesh%vertex_count == 16, 'each corner once')
    call tap%ok(border(1)%vertex(6) == border(2)%vertex(1) .and. &
        border(4)%vertex(4) == border(1)%vertex(1), 'sides go round')
    ! A triangle of another part, beside side 1: BL 0, from STA 0 to 4.
    deallocate (mesh%parts)
    allocate (mesh%parts(1))
    mesh%parts(1) = mesh_part_type(name='OTHER', section=1)
    mesh%vertex_count = 0
    call add_vertex(mesh, [0.0_dp, 0.0_dp, 0.0_dp])
    call add_vertex(mesh, [2.0_dp, -3.0_dp, 0.0_dp])
    call add_vertex(mesh, [4.3_dp, 0.0_dp, 0.0_dp])
    call add_normal(mesh, [0.0_dp, 0.0_dp, 1.0_dp])
    call add_triangle(mesh, [1, 2, 3], [1, 1, 1])
    call lay_borders(panel, [5, 3], [1, 2, 3], .false., mesh, border)
    call tap%ok(border(1)%vertex(1) == 1, 'the corner of another part is its own')
    call tap%ok(border(1)%vertex(2) == 3, 'so is the next vertex, none between')
    call tap%near(border(1)%t(2), 0.43_dp, 1.0e-12_dp, 'where that is')
    call tap%near(border(1)%t(3), 0.6_dp, 1.0e-15_dp, 'then its own cells go on')
    call tap%finish()
end program test_mesh_border
