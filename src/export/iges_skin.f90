!> The skin of a body in an IGES file: a surface (128) for each face, its normal outward, all on one
!> level; faces that meet share their edge poles, so that a reader sews them without a gap. Flat
!> faces are trimmed planes (144).
module export_iges_skin
    use export_entity, only: face_entity
    use export_iges_cap, only: add_cap
    use export_iges_file, only: entry_type, iges_file_type
    use export_iges_shape, only: add_name
    use export_iges_surface, only: add_surface, turned_outward
    use export_receipt, only: receipt_type
    use export_shell, only: skin_model_type
    implicit none (type, external)
    private

    public :: add_skin, has_skin

contains

    !> True for a skin that has faces.
    pure logical function has_skin(model)
        type(skin_model_type), intent(in) :: model  !! may be empty
        has_skin = .false.
        if (allocated(model%faces)) has_skin = size(model%faces) > 0
    end function has_skin

    !> Adds all faces of a skin.
    subroutine add_skin(file, model, level, receipt)
        type(iges_file_type), intent(inout) :: file     !! gets them
        type(skin_model_type), intent(in) :: model      !! in the unit of the file, has faces
        integer, intent(in) :: level                    !! its level
        type(receipt_type), intent(inout) :: receipt    !! gets an entity for each face
        integer :: i

        do i = 1, size(model%faces)
            call add_face(file, model, i, level)
            call receipt%add(face_entity(model%faces(i), trim(merge( &
                '144 TRIMMED PLANE   ', '128 B-SPLINE SURFACE', model%faces(i)%is_flat))))
        end do
    end subroutine add_skin

    !> Adds a face.
    subroutine add_face(file, model, number, level)
        type(iges_file_type), intent(inout) :: file     !! gets it
        type(skin_model_type), intent(in) :: model      !! the skin
        integer, intent(in) :: number                   !! which of its faces
        integer, intent(in) :: level                    !! its level
        type(entry_type) :: entry
        integer :: name, pointer

        entry = entry_type(level=level, number=number, label='SKIN', is_line=.true.)
        associate (face => model%faces(number))
            call add_name(file, face%name, name)
            if (face%is_flat) then
                entry%label = 'CAP'
                call add_cap(file, entry, model, face, name, pointer)
            else if (face%is_outward) then
                call add_surface(file, entry, face%surface, name, pointer)
            else
                call add_surface(file, entry, turned_outward(face%surface), name, pointer)
            end if
        end associate
    end subroutine add_face

end module export_iges_skin
