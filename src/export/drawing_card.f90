!> The shape of a card of a 1970 deck: its arc, exactly, with x as station and y as waterline.
module export_drawing_card
    use base_kinds, only: dp
    use cut_plane, only: buttock_plane
    use export_drawing, only: shape_kind, shape_type
    use export_drawing_fit, only: arc_curve
    use export_drawing_join, only: put_in_space
    use geom_arc, only: arc_type
    implicit none (type, external)
    private

    public :: draw_card

contains

    !> The shape of a card, at BL 0.
    pure subroutine draw_card(arc, number, name, shape)
        type(arc_type), intent(in) :: arc       !! of the card
        integer, intent(in) :: number           !! which data card of the deck
        character(*), intent(in) :: name        !! of the shape
        type(shape_type), intent(out) :: shape  !! of one contour of one curve

        shape%name = name
        shape%title = name
        shape%kind = shape_kind%card
        shape%number = number
        shape%plane = buttock_plane(0.0_dp)
        allocate (shape%contours(1))
        associate (contour => shape%contours(1))
            allocate (contour%curves(1), contour%marks(0))
            contour%curves(1) = arc_curve(arc)
            call put_in_space(shape%plane, contour%curves(1))
        end associate
    end subroutine draw_card

end module export_drawing_card
