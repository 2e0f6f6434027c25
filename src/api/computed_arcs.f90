!> The circular arcs of a cut or a faired outline, as its listing has them.
module api_computed_arcs
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_outline, only: outline_type
    use cut_outline, only: cut_type
    use export_arcs, only: arc_contour_type, arcs_of_contour, part_for_curves
    use export_drawing, only: shape_type
    use export_drawing_cut, only: draw_cut
    use export_drawing_faired, only: outline_shape
    use report_arc_listing, only: arc_table_type
    implicit none (type, external)
    private

    public :: arcs_of_cut, arcs_of_outline

contains

    !> The arcs of each contour of a cut: its outlines and the insides of their skin; none where
    !> none are asked.
    !>
    !> Fails where a curve can't be drawn, and as `arcs_of_contour`.
    pure subroutine arcs_of_cut(body, cut, tables, error)
        type(body_type), intent(in) :: body                             !! finished
        type(cut_type), intent(in) :: cut                               !! of it
        type(arc_table_type), allocatable, intent(out) :: tables(:)     !! one a contour
        type(error_type), allocatable, intent(out) :: error             !! see above
        type(shape_type) :: shape

        allocate (tables(0))
        if (.not. cut%arcs > 0.0_dp) return
        call draw_cut(body, cut, part_for_curves*cut%arcs, 0.0_dp, shape, error)
        if (.not. allocated(error)) call arcs_of_shape(shape, tables, error)
    end subroutine arcs_of_cut

    !> The arcs of a faired outline; none where none are asked.
    !>
    !> Fails as `arcs_of_contour`.
    pure subroutine arcs_of_outline(outline, tables, error)
        type(outline_type), intent(in) :: outline                       !! faired
        type(arc_table_type), allocatable, intent(out) :: tables(:)     !! one, or none
        type(error_type), allocatable, intent(out) :: error             !! see above

        allocate (tables(0))
        if (outline%arcs > 0.0_dp) call arcs_of_shape(outline_shape(outline), tables, error)
    end subroutine arcs_of_outline

    !> The arcs of each contour of a shape.
    !>
    !> Fails as `arcs_of_contour`.
    pure subroutine arcs_of_shape(shape, tables, error)
        type(shape_type), intent(in) :: shape                           !! says its tolerance
        type(arc_table_type), allocatable, intent(inout) :: tables(:)   !! become one a contour
        type(error_type), allocatable, intent(out) :: error             !! see above
        type(arc_contour_type) :: chain
        integer :: i, count

        deallocate (tables)
        allocate (tables(size(shape%contours)))
        count = 0
        do i = 1, size(shape%contours)
            call arcs_of_contour(shape%plane, shape%contours(i), shape%arcs, chain, error)
            if (allocated(error)) exit
            if (size(chain%arcs) == 0) cycle
            count = count + 1
            tables(count)%is_closed = chain%is_closed
            tables(count)%is_inside = shape%contours(i)%is_inside
            tables(count)%arcs = chain%arcs
        end do
        tables = tables(:count)
    end subroutine arcs_of_shape

end module api_computed_arcs
