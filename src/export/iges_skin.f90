!> The skin of a body in an IGES file: a surface (128) for each face, its normal outward, all on one
!> level; faces that meet share their edge poles, so that a reader sews them without a gap. Flat
!> faces are trimmed planes (144).
module export_iges_skin
    use export_iges_cap, only: add_cap
    use export_iges_file, only: entry_type, iges_file_type
    use export_iges_shape, only: add_name
    use export_iges_surface, only: add_surface, turned_outward
    use export_receipt, only: entity_type, receipt_type
    use export_shell, only: face_type, skin_model_type
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
            call receipt%add(entity_of(model%faces(i)))
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

    !> What a receipt says of a face.
    pure type(entity_type) function entity_of(face) result(entity)
        type(face_type), intent(in) :: face !! of the skin

        entity%name = face%name
        entity%kind = '144 TRIMMED PLANE'
        if (.not. face%is_flat) then
            entity%kind = '128 B-SPLINE SURFACE'
            entity%points = size(face%surface%weight)
            entity%spans = face%spans
        end if
        entity%is_exact = face%is_exact
        entity%error = face%error
        entity%has_place = .not. face%is_exact
        entity%worst = face%worst
    end function entity_of

end module export_iges_skin
