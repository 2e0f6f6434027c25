!> A contour as the path of a tool: in straight pieces or in circular arcs within the tolerance.
module export_nc_follow
    use base_error, only: error_type
    use base_kinds, only: dp
    use export_arcs, only: arc_contour_type, arc_rounding, arcs_of_contour, parted_arcs
    use export_chords, only: chord_polygon, polygon_type, round_polygon, rounding_error
    use export_drawing, only: contour_type, shape_type
    use export_drawing_join, only: in_plane
    use export_nc_arcs, only: arc_path
    use export_nc_path, only: path_type, run_type, straight_path
    use export_receipt, only: entity_type
    implicit none (type, external)
    private

    public :: follow_chords, follow_arcs

contains

    !> The path along a contour in straight pieces. Fails as `chord_polygon`.
    pure subroutine follow_chords(shape, contour, run, path, entity, error)
        type(shape_type), intent(in) :: shape               !! whose contour it is
        type(contour_type), intent(in) :: contour           !! what to cut
        type(run_type), intent(in) :: run                   !! how
        type(path_type), intent(out) :: path                !! no segments: it is a point
        type(entity_type), intent(inout) :: entity          !! gets kind and error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(polygon_type) :: polygon

        allocate (path%segments(0))
        call chord_polygon(contour, run%tolerance - rounding_error(run%decimals, 2), polygon, error)
        if (allocated(error)) return
        polygon%at = in_plane(shape%plane, polygon%at)
        call round_polygon(polygon, run%decimals)
        if (size(polygon%at, 2) > 1) path = straight_path(polygon%at, polygon%is_closed)
        path%start = polygon%at(:, 1)
        entity%kind = trim(merge('CLOSED PATH', 'PATH       ', polygon%is_closed))
        entity%error = polygon%error
        entity%worst = polygon%worst
    end subroutine follow_chords

    !> The path along a contour in circular arcs. Fails as `arcs_of_contour`.
    pure subroutine follow_arcs(shape, contour, run, path, entity, error)
        type(shape_type), intent(in) :: shape               !! whose contour it is
        type(contour_type), intent(in) :: contour           !! what to cut
        type(run_type), intent(in) :: run                   !! how
        type(path_type), intent(out) :: path                !! no segments: it is a point
        type(entity_type), intent(inout) :: entity          !! gets kind and error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(arc_contour_type) :: chain

        allocate (path%segments(0))
        call arcs_of_contour(shape%plane, contour, run%tolerance, chain, error)
        if (allocated(error)) return
        path = arc_path(parted_arcs(chain), run%decimals)
        entity%kind = trim(merge('CLOSED PATH OF ARCS', 'PATH OF ARCS       ', chain%is_closed))
        entity%spans = count(path%segments%is_arc)
        entity%error = chain%error + arc_rounding(run%decimals)
        entity%worst = chain%worst
    end subroutine follow_arcs

end module export_nc_follow
