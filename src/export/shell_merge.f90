!> Skins of several bodies in one file: their lists put behind each other, references moved on.
module export_shell_merge
    use export_shell, only: edge_type, face_type, shell_type, skin_model_type, vertex_type
    implicit none (type, external)
    private

    public :: append_model

contains

    !> Puts the skin of another body behind those of some; nothing of the two is shared.
    pure subroutine append_model(model, other)
        type(skin_model_type), intent(inout) :: model   !! gets it; as declared it has none
        type(skin_model_type), intent(in) :: other      !! the skin of a body
        type(vertex_type), allocatable :: vertices(:)
        type(edge_type), allocatable :: edges(:)
        type(face_type), allocatable :: faces(:)
        type(shell_type), allocatable :: shells(:)
        integer :: points, lines, areas, i

        if (.not. allocated(model%faces)) then
            model = other
            return
        end if
        points = size(model%vertices)
        lines = size(model%edges)
        areas = size(model%faces)
        allocate (vertices(points + size(other%vertices)), edges(lines + size(other%edges)), &
            faces(areas + size(other%faces)), shells(size(model%shells) + size(other%shells)))
        vertices(:points) = model%vertices
        vertices(points + 1:) = other%vertices
        edges(:lines) = model%edges
        do i = 1, size(other%edges)
            edges(lines + i) = other%edges(i)
            edges(lines + i)%from = other%edges(i)%from + points
            edges(lines + i)%to = other%edges(i)%to + points
        end do
        faces(:areas) = model%faces
        do i = 1, size(other%faces)
            faces(areas + i) = moved_face(other%faces(i), points, lines)
        end do
        shells(:size(model%shells)) = model%shells
        do i = 1, size(other%shells)
            shells(size(model%shells) + i) = other%shells(i)
            shells(size(model%shells) + i)%faces = other%shells(i)%faces + areas
        end do
        call move_alloc(vertices, model%vertices)
        call move_alloc(edges, model%edges)
        call move_alloc(faces, model%faces)
        call move_alloc(shells, model%shells)
    end subroutine append_model

    !> A face whose edges and vertices stand further on in their lists.
    pure type(face_type) function moved_face(face, points, lines) result(moved)
        type(face_type), intent(in) :: face !! as it was
        integer, intent(in) :: points       !! how far vertices are moved
        integer, intent(in) :: lines        !! how far edges are moved
        moved = face
        where (face%sides%edge > 0)
            moved%sides%edge = face%sides%edge + lines
        elsewhere
            moved%sides%vertex = face%sides%vertex + points
        end where
    end function moved_face

end module export_shell_merge
