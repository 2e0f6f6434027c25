!> The skin of a body in a STEP file (ISO 10303-42, clause 5): faces that share edges, edges that
!> share vertices; a shell that closes is the boundary of a solid.
!>
!> A side that has shrunk to a point is left out of its loop: the sides before and after it meet at
!> its vertex. Parameter curves are not written: each edge is a line of its surfaces of constant
!> parameter, which readers find without error.
module export_step_shell
    use export_entity, only: face_entity
    use export_receipt, only: receipt_type
    use export_shell, only: face_type, side_type, skin_model_type
    use export_step_curve, only: add_edge_curve, add_point
    use export_step_surface, only: add_surface, surface_word
    use export_step_text, only: step_file_type, step_logical, step_reference, step_references, &
        step_string
    implicit none (type, external)
    private

    public :: skin_items_type, add_skin

    !> Items of representations.
    type :: skin_items_type
        integer, allocatable :: solids(:)   !! MANIFOLD_SOLID_BREP
        integer, allocatable :: sheets(:)   !! SHELL_BASED_SURFACE_MODEL
    end type skin_items_type

contains

    !> Adds all of a skin.
    subroutine add_skin(file, model, wants_sheets, items, receipt)
        type(step_file_type), intent(inout) :: file     !! gets it
        type(skin_model_type), intent(in) :: model      !! in the unit of the file, may be empty
        logical, intent(in) :: wants_sheets             !! no solids, also where shells close
        type(skin_items_type), intent(out) :: items     !! what was added
        type(receipt_type), intent(inout) :: receipt    !! gets an entity for each face
        integer, allocatable :: edges(:)
        character(:), allocatable :: name
        integer :: i, shell, item

        allocate (items%solids(0), items%sheets(0), edges(0))
        if (.not. allocated(model%shells)) return
        call add_edges(file, model, edges)
        do i = 1, size(model%shells)
            name = step_string(trim(model%shells(i)%name))
            associate (closes => model%shells(i)%is_closed)
                call add_shell(file, model, i, edges, shell)
                do item = 1, size(model%shells(i)%faces)
                    associate (face => model%faces(model%shells(i)%faces(item)))
                        call receipt%add(face_entity(face, surface_word(face)))
                    end associate
                end do
                if (closes .and. .not. wants_sheets) then
                    call file%add('MANIFOLD_SOLID_BREP('//name//','//step_reference(shell)//')', &
                        item)
                    items%solids = [items%solids, item]
                else
                    call file%add('SHELL_BASED_SURFACE_MODEL('//name//','// &
                        step_references([shell])//')', item)
                    items%sheets = [items%sheets, item]
                end if
            end associate
        end do
    end subroutine add_skin

    !> Adds the vertices and edges.
    subroutine add_edges(file, model, edges)
        type(step_file_type), intent(inout) :: file         !! gets them
        type(skin_model_type), intent(in) :: model          !! not empty
        integer, allocatable, intent(inout) :: edges(:)     !! instances of its edges
        integer :: vertices(size(model%vertices)), i, part

        do i = 1, size(vertices)
            call add_point(file, model%vertices(i)%at, part)
            call file%add('VERTEX_POINT('''','//step_reference(part)//')', vertices(i))
        end do
        deallocate (edges)
        allocate (edges(size(model%edges)))
        do i = 1, size(edges)
            call add_edge_curve(file, model%edges(i)%curve, part)
            call file%add('EDGE_CURVE('''','//step_reference(vertices(model%edges(i)%from))//','// &
                step_reference(vertices(model%edges(i)%to))//','//step_reference(part)//',.T.)', &
                edges(i))
        end do
    end subroutine add_edges

    !> Adds a shell and its faces.
    subroutine add_shell(file, model, which, edges, number)
        type(step_file_type), intent(inout) :: file !! gets it
        type(skin_model_type), intent(in) :: model  !! all of the skin
        integer, intent(in) :: which                !! which of its shells
        integer, intent(in) :: edges(:)             !! instances of its edges
        integer, intent(out) :: number              !! of the instance
        character(:), allocatable :: rest
        integer :: faces(size(model%shells(which)%faces)), i

        do i = 1, size(faces)
            call add_face(file, model%faces(model%shells(which)%faces(i)), edges, faces(i))
        end do
        rest = '('//step_string(trim(model%shells(which)%name))//','//step_references(faces)//')'
        if (model%shells(which)%is_closed) then
            call file%add('CLOSED_SHELL'//rest, number)
        else
            call file%add('OPEN_SHELL'//rest, number)
        end if
    end subroutine add_shell

    !> Adds a face.
    subroutine add_face(file, face, edges, number)
        type(step_file_type), intent(inout) :: file !! gets it
        type(face_type), intent(in) :: face         !! of the skin
        integer, intent(in) :: edges(:)             !! instances of the edges of the skin
        integer, intent(out) :: number              !! of the instance
        integer :: loop, bound, surface

        call add_loop(file, face%sides, edges, loop)
        call file%add('FACE_OUTER_BOUND('''','//step_reference(loop)//',.T.)', bound)
        call add_surface(file, face, surface)
        call file%add('ADVANCED_FACE('//step_string(face%name)//','//step_references([bound])// &
            ','//step_reference(surface)//','//step_logical(face%is_flat .or. face%is_outward)// &
            ')', number)
    end subroutine add_face

    !> Adds the loop of a face.
    subroutine add_loop(file, sides, edges, number)
        type(step_file_type), intent(inout) :: file !! gets it
        type(side_type), intent(in) :: sides(:)     !! in order
        integer, intent(in) :: edges(:)             !! instances of the edges of the skin
        integer, intent(out) :: number              !! of the instance
        integer :: oriented(count(sides%edge > 0)), i, met

        met = 0
        do i = 1, size(sides)
            if (sides(i)%edge == 0) cycle
            met = met + 1
            call file%add('ORIENTED_EDGE('''',*,*,'//step_reference(edges(sides(i)%edge))//','// &
                step_logical(sides(i)%is_forward)//')', oriented(met))
        end do
        call file%add('EDGE_LOOP('''','//step_references(oriented)//')', number)
    end subroutine add_loop

end module export_step_shell
