!> Tests of the edges of a mesh.
program test_mesh_edge
    use base_kinds, only: dp
    use export_mesh, only: mesh_part_type, mesh_type
    use export_mesh_edge, only: find_turn, find_twins, half_edge
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(mesh_type) :: mesh
    type(mesh_part_type) :: part
    integer, allocatable :: twin(:)
    integer :: i

    ! A tetrahedron.
    mesh%vertices = reshape([0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, &
        0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp], [3, 4])
    mesh%triangles = reshape([1, 3, 2, 1, 2, 4, 2, 3, 4, 3, 1, 4], [3, 4])
    mesh%vertex_count = 4
    mesh%triangle_count = 4
    call tap%ok(all(half_edge(mesh, 6) == [4, 1]), 'half edges are numbered by triangles')
    twin = find_twins(mesh)
    call tap%ok(all(twin > 0), 'a tetrahedron is closed')
    call tap%ok(all([(twin(twin(i)) == i, i=1, 12)]), 'the twin of a twin is itself')
    call tap%ok(all([(all(half_edge(mesh, i) == reversed(half_edge(mesh, twin(i)))), i=1, 12)]), &
        'twins run opposite ways')
    mesh%triangles(:, 4) = [3, 4, 1]
    twin = find_twins(mesh)
    call tap%ok(count(twin == 0) == 6, 'a face turned over meets none')
    mesh%triangle_count = 3
    twin = find_twins(mesh)
    call tap%ok(size(twin) == 9 .and. count(twin == 0) == 3, 'a face taken out leaves three open')

    ! A roof: two faces that turn by 60 degrees along their edge from station 0 to 2, and a third.
    mesh%vertices = reshape([0.0_dp, 0.0_dp, 0.0_dp, 2.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, &
        0.0_dp, 1.0_dp, -0.5_dp, -0.5_dp*sqrt(3.0_dp), 2.0_dp, 1.0_dp, 0.5_dp], [3, 5])
    mesh%triangles = reshape([1, 2, 3, 2, 1, 4, 2, 5, 3], [3, 3])
    mesh%vertex_count = 5
    allocate (mesh%parts(1))
    part%section = 1
    part%last = 3
    mesh%parts(1) = part
    twin = find_twins(mesh)
    call find_turn(mesh, twin, [0.0_dp, 2.0_dp])
    call tap%near(mesh%turn, 60.0_dp, 1.0e-12_dp, 'the turn across an edge')
    call tap%near(norm2(mesh%turn_at - [1.0_dp, 0.0_dp, 0.0_dp]), 0.0_dp, 0.0_dp, &
        'its place is the middle of it')
    mesh%vertices(1, 1) = 2.0_dp
    call find_turn(mesh, twin, [0.0_dp, 2.0_dp])
    call tap%ok(mesh%turn < 59.0_dp, 'along a row at a stop it does not count')
    mesh%vertices(1, 1) = 0.0_dp
    mesh%parts = [part, part]
    mesh%parts(1)%last = 1
    mesh%parts(2)%first = 2
    call find_turn(mesh, twin, [0.0_dp, 2.0_dp])
    call tap%near(mesh%turn, 0.0_dp, 0.0_dp, 'nor between sections')
    mesh%parts = [part]
    mesh%parts(1)%section = 0
    call find_turn(mesh, twin, [0.0_dp, 2.0_dp])
    call tap%near(mesh%turn, 0.0_dp, 0.0_dp, 'nor in a flat part')
    call tap%finish()

contains

    !> The other way.
    function reversed(ends)
        integer, intent(in) :: ends(2)
        integer :: reversed(2)
        reversed = ends([2, 1])
    end function reversed

end program test_mesh_edge
