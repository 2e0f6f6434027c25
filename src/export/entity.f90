!> What a receipt says of the curves and faces of a CAD file.
module export_entity
    use export_drawing, only: curve_type
    use export_receipt, only: entity_type
    use export_shell, only: face_type
    use geom_bspline, only: spline_breaks
    implicit none (type, external)
    private

    public :: curve_entity, face_entity

contains

    !> What a receipt says of a curve that is written as its spline.
    pure type(entity_type) function curve_entity(curve, name, kind) result(entity)
        type(curve_type), intent(in) :: curve   !! of a shape
        character(*), intent(in) :: name        !! of the shape
        character(*), intent(in) :: kind        !! in the words of the format

        entity%name = name
        entity%kind = kind
        entity%is_exact = curve%is_exact
        entity%points = size(curve%spline%weight)
        entity%spans = size(spline_breaks(curve%spline)) - 1
        entity%error = curve%error
        entity%has_place = .not. curve%is_exact
        entity%worst = curve%worst
    end function curve_entity

    !> What a receipt says of a face.
    pure type(entity_type) function face_entity(face, kind) result(entity)
        type(face_type), intent(in) :: face     !! of the skin
        character(*), intent(in) :: kind        !! in the words of the format

        entity%name = face%name
        entity%kind = kind
        entity%is_exact = face%is_exact
        if (.not. face%is_flat) then
            entity%points = size(face%surface%weight)
            entity%spans = face%spans
        end if
        entity%error = face%error
        entity%has_place = .not. face%is_exact
        entity%worst = face%worst
    end function face_entity

end module export_entity
