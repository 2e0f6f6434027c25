!> Meshes of several bodies in one file: their lists put behind each other, references moved on.
module export_mesh_merge
    use export_mesh, only: mesh_part_type, mesh_type
    implicit none (type, external)
    private

    public :: append_mesh

contains

    !> Puts the mesh of another body behind those of some; nothing of the two is shared.
    pure subroutine append_mesh(mesh, other)
        type(mesh_type), intent(inout) :: mesh  !! gets it; as declared it has none
        type(mesh_type), intent(in) :: other    !! trimmed, in the same unit
        type(mesh_part_type), allocatable :: parts(:)
        integer :: count

        if (.not. allocated(mesh%parts)) then
            mesh = other
            return
        end if
        call append_lists(mesh, other)
        count = size(mesh%parts)
        allocate (parts(count + size(other%parts)))
        parts(:count) = mesh%parts
        parts(count + 1:) = other%parts
        parts(count + 1:)%first = other%parts%first + mesh%triangle_count
        parts(count + 1:)%last = other%parts%last + mesh%triangle_count
        call move_alloc(parts, mesh%parts)
        mesh%vertex_count = mesh%vertex_count + other%vertex_count
        mesh%normal_count = mesh%normal_count + other%normal_count
        mesh%triangle_count = mesh%triangle_count + other%triangle_count
        mesh%stations = mesh%stations + other%stations
        if (mesh%is_closed .and. .not. other%is_closed) mesh%why = other%why
        mesh%is_closed = mesh%is_closed .and. other%is_closed
        if (other%error > mesh%error) then
            mesh%error = other%error
            mesh%worst = other%worst
        end if
        if (other%turn > mesh%turn) then
            mesh%turn = other%turn
            mesh%turn_at = other%turn_at
        end if
    end subroutine append_mesh

    !> Puts vertices, normals and triangles behind those that are there.
    pure subroutine append_lists(mesh, other)
        type(mesh_type), intent(inout) :: mesh  !! gets them; counts are left
        type(mesh_type), intent(in) :: other    !! trimmed
        integer :: points, ways, areas

        points = mesh%vertex_count
        ways = mesh%normal_count
        areas = mesh%triangle_count
        mesh%vertices = reshape([mesh%vertices(:, :points), other%vertices], &
            [3, points + other%vertex_count])
        mesh%normals = reshape([mesh%normals(:, :ways), other%normals], &
            [3, ways + other%normal_count])
        mesh%triangles = reshape([mesh%triangles(:, :areas), other%triangles + points], &
            [3, areas + other%triangle_count])
        mesh%corners = reshape([mesh%corners(:, :areas), other%corners + ways], &
            [3, areas + other%triangle_count])
    end subroutine append_lists

end module export_mesh_merge
