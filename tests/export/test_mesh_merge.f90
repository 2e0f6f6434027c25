!> Meshes of several bodies put together: every triangle keeps its corners and normals.
program test_mesh_merge
    use base_kinds, only: dp
    use export_mesh, only: mesh_type
    use export_mesh_merge, only: append_mesh
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(mesh_type) :: mesh
    integer :: i
    logical :: is_sound

    call append_mesh(mesh, body(1.0_dp, .true.))
    call tap%ok(mesh%triangle_count == 2 .and. mesh%is_closed, 'the first mesh is as it was')
    call append_mesh(mesh, body(3.0_dp, .true.))
    call append_mesh(mesh, body(2.0_dp, .false.))
    call tap%ok(all([mesh%vertex_count, mesh%normal_count, mesh%triangle_count, &
        mesh%stations, size(mesh%parts)] == [12, 6, 6, 15, 3]), 'counts add up')
    call tap%ok(all([size(mesh%vertices, 2), size(mesh%normals, 2), size(mesh%triangles, 2), &
        size(mesh%corners, 2)] == [12, 6, 6, 6]), 'and so do the lists')
    is_sound = .true.
    do i = 1, 3
        is_sound = is_sound .and. sees(mesh, i, [1.0_dp, 3.0_dp, 2.0_dp])
    end do
    call tap%ok(is_sound, 'each triangle has the corners and normals it had')
    call tap%ok(all(mesh%parts%first == [1, 3, 5]) .and. all(mesh%parts%last == [2, 4, 6]), &
        'parts have their triangles')
    call tap%near(mesh%error, 3.0_dp, 0.0_dp, 'the largest error')
    call tap%near(mesh%worst(2), 3.0_dp, 0.0_dp, 'is where it was')
    call tap%near(mesh%turn, 6.0_dp, 0.0_dp, 'the largest turn')
    call tap%near(mesh%turn_at(3), 6.0_dp, 0.0_dp, 'too')
    call tap%ok(.not. mesh%is_closed, 'with one that is open all are')
    call tap%same(mesh%why, 'a hole in 2', 'for its reason')
    call tap%finish()

contains

    !> A made-up mesh: four vertices, two normals, two triangles of one part.
    function body(mark, is_closed) result(made)
        real(dp), intent(in) :: mark        !! STA of its vertices
        logical, intent(in) :: is_closed    !! or open
        type(mesh_type) :: made
        integer :: i
        made%vertex_count = 4
        made%normal_count = 2
        made%triangle_count = 2
        made%stations = 5
        allocate (made%vertices(3, 4), made%normals(3, 2), made%parts(1))
        made%vertices = reshape([(mark, real(i, dp), 0.0_dp, i=1, 4)], [3, 4])
        made%normals = reshape([(mark, real(i, dp), 1.0_dp, i=1, 2)], [3, 2])
        made%triangles = reshape([1, 2, 3, 2, 3, 4], [3, 2])
        made%corners = reshape([1, 1, 2, 2, 2, 1], [3, 2])
        made%parts(1)%name = 'P'
        made%parts(1)%last = 2
        made%is_closed = is_closed
        made%why = ''
        if (.not. is_closed) made%why = 'a hole in 2'
        made%error = mark
        made%worst = mark
        made%turn = 2.0_dp*mark
        made%turn_at = 2.0_dp*mark
    end function body

    !> True where the triangles of a part lead to vertices and normals with its mark.
    logical function sees(whole, part, marks)
        type(mesh_type), intent(in) :: whole    !! several meshes
        integer, intent(in) :: part             !! which
        real(dp), intent(in) :: marks(:)        !! STA of the vertices of each
        type(mesh_type) :: alone
        integer :: i, k
        alone = body(marks(part), .true.)
        sees = .true.
        do i = 1, 2
            do k = 1, 3
                sees = sees .and. all(abs( &
                    whole%vertices(:, whole%triangles(k, whole%parts(part)%first + i - 1)) - &
                    alone%vertices(:, alone%triangles(k, i))) <= 0.0_dp) .and. all(abs( &
                    whole%normals(:, whole%corners(k, whole%parts(part)%first + i - 1)) - &
                    alone%normals(:, alone%corners(k, i))) <= 0.0_dp)
            end do
        end do
    end function sees

end program test_mesh_merge
