!> OBJ files: vertices, the normals of the exact skin, and triangles in a group for each section.
!>
!> Source: Wavefront Technologies, "Advanced Visualizer Manual", appendix B1, Object Files (.obj),
!> version 3.0. The format has no place for units; a comment says them.
module export_obj
    use base_constants, only: version
    use base_digits, only: fixed, shortest
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: printable, to_text
    use export_mesh, only: mesh_type
    use export_mesh_receipt, only: note_mesh
    use export_receipt, only: receipt_type
    implicit none (type, external)
    private

    public :: write_obj

    !> Decimals of normals.
    integer, parameter :: decimals = 9

contains

    !> Writes a mesh.
    subroutine write_obj(mesh, out, receipt)
        type(mesh_type), intent(in) :: mesh             !! in the unit of the file
        type(output_type), intent(inout) :: out         !! gets the file
        type(receipt_type), intent(inout) :: receipt    !! gets what was written
        integer :: i

        call note_mesh(mesh, 'GROUP OF TRIANGLES', receipt)
        call out%line('# LOFT '//version//', DECK '//trim(printable(mesh%deck)))
        if (len(mesh%title) > 0) call out%line('# '//trim(printable(mesh%title)))
        call out%line('# UNITS='//mesh%units//', x = STA aft, y = BL to starboard, z = WL up')
        call out%line('o '//name_of(trim(printable(mesh%deck))))
        do i = 1, mesh%vertex_count
            call out%line('v '//shortest(mesh%vertices(1, i))//' '// &
                shortest(mesh%vertices(2, i))//' '//shortest(mesh%vertices(3, i)))
        end do
        do i = 1, mesh%normal_count
            call out%line('vn '//decimal(mesh%normals(1, i))//' '// &
                decimal(mesh%normals(2, i))//' '//decimal(mesh%normals(3, i)))
        end do
        do i = 1, size(mesh%parts)
            call write_part(mesh, i, out)
        end do
    end subroutine write_obj

    !> Writes the triangles of a part.
    subroutine write_part(mesh, number, out)
        type(mesh_type), intent(in) :: mesh         !! any
        integer, intent(in) :: number               !! of the part
        type(output_type), intent(inout) :: out     !! gets them
        integer :: i

        associate (part => mesh%parts(number))
            if (part%last < part%first) return
            call out%line('g '//name_of(part%name))
            do i = part%first, part%last
                call out%line('f '//corner(i, 1)//' '//corner(i, 2)//' '//corner(i, 3))
            end do
        end associate
    contains
        !> A corner of a triangle: vertex and normal.
        function corner(triangle, k) result(text)
            integer, intent(in) :: triangle !! which
            integer, intent(in) :: k        !! which corner
            character(:), allocatable :: text
            text = to_text(mesh%triangles(k, triangle))//'//'//to_text(mesh%corners(k, triangle))
        end function corner
    end subroutine write_part

    !> A name without blanks: `CAP_STA_280`.
    pure function name_of(words) result(name)
        character(*), intent(in) :: words !! any text
        character(:), allocatable :: name
        integer :: i
        name = trim(words)
        do i = 1, len(name)
            if (name(i:i) == ' ') name(i:i) = '_'
        end do
    end function name_of

    !> A number of a normal.
    pure function decimal(value) result(text)
        real(dp), intent(in) :: value !! -1 to 1
        character(:), allocatable :: text
        text = trim(adjustl(fixed(value, decimals + 3, decimals)))
    end function decimal

end module export_obj
