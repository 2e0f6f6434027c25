!> What a file of triangles says in its receipt.
module export_mesh_receipt
    use base_kinds, only: i64
    use base_text, only: compact, counted
    use export_mesh, only: mesh_type
    use export_receipt, only: entity_type, receipt_type
    implicit none (type, external)
    private

    public :: note_mesh

contains

    !> Adds an entity for each part of a mesh, and says whether it is closed.
    pure subroutine note_mesh(mesh, kind, receipt)
        type(mesh_type), intent(in) :: mesh             !! as written
        character(*), intent(in) :: kind                !! in the words of the format
        type(receipt_type), intent(inout) :: receipt    !! gets it
        type(entity_type) :: entity
        integer :: i

        do i = 1, size(mesh%parts)
            associate (part => mesh%parts(i))
                if (part%last < part%first) cycle
                entity%name = part%name
                entity%kind = kind
                entity%points = part%last - part%first + 1
                entity%is_exact = part%section == 0
                entity%error = part%error
                entity%has_place = part%section /= 0
                entity%worst = part%worst
            end associate
            call receipt%add(entity)
        end do
        call receipt%say(counted(int(mesh%triangle_count, i64), 'triangle')//', '// &
            vertices(mesh%vertex_count)//' on the exact skin at '// &
            counted(int(mesh%stations, i64), 'station'))
        if (mesh%is_closed) call receipt%say('closed: each edge belongs to two triangles')
        if (.not. mesh%is_closed) call receipt%say('open, not a solid: '//mesh%why)
        call receipt%say('largest turn between neighbours in a section '//compact(mesh%turn)// &
            ' degrees at STA '//compact(mesh%turn_at(1))//', BL '//compact(mesh%turn_at(2))// &
            ', WL '//compact(mesh%turn_at(3))//', asked '//compact(mesh%angle))
    end subroutine note_mesh

    !> A count of vertices.
    pure function vertices(number) result(text)
        integer, intent(in) :: number !! how many
        character(:), allocatable :: text
        text = counted(int(number, i64), 'vertice')
        if (number == 1) text = '1 vertex'
    end function vertices

end module export_mesh_receipt
