!> A STEP file of a body: its skin as a solid or as open shells, its cuts (both halves of symmetric
!> ones) and its control lines as curves.
!>
!> The file is of AP242, "Managed model-based 3D engineering" (ISO 10303-242:2014), the protocol
!> that took the place of AP203 and AP214; OpenCASCADE, and with it the programs built on it, reads
!> it without complaint (7.6.3 and 8.0.1 were tried). Of AP242 only what AP214 has too is used, by
!> the same names. One product has a representation for each kind of shape: ADVANCED_BREP for
!> solids, MANIFOLD_SURFACE for open shells, GEOMETRICALLY_BOUNDED_WIREFRAME for curves.
module export_step
    use base_error, only: cause, error_type, fail
    use base_output, only: output_type
    use export_drawing, only: drawing_type, shape_type
    use export_drawn, only: draw_shapes
    use export_receipt, only: receipt_type
    use export_settings, only: settings_type
    use export_shell, only: skin_model_type
    use export_step_head, only: add_product, add_representation, product_type, put_header
    use export_step_shell, only: add_skin, skin_items_type
    use export_step_style, only: palette_type
    use export_step_text, only: step_file_type
    use export_step_wire, only: add_shape
    use export_units, only: find_unit, unit_type
    implicit none (type, external)
    private

    public :: write_step

contains

    !> Writes a STEP file.
    !>
    !> Fails with `cause%usage` where the drawing has an unknown unit, or where there is neither a
    !> face nor a curve to write.
    subroutine write_step(drawing, model, settings, out, receipt, error)
        type(drawing_type), intent(in) :: drawing           !! cuts and lines, may have none
        type(skin_model_type), intent(in) :: model          !! skin, in the same unit; may be empty
        type(settings_type), intent(in) :: settings         !! tolerance; open shells or solids
        type(output_type), intent(inout) :: out             !! where to
        type(receipt_type), intent(inout) :: receipt        !! gets faces and curves
        type(error_type), allocatable, intent(out) :: error !! see above
        type(step_file_type) :: file
        type(product_type) :: product
        type(palette_type) :: palette
        type(skin_items_type) :: skin
        type(unit_type) :: unit
        type(shape_type), allocatable :: shapes(:)
        integer, allocatable :: wires(:)

        call find_unit(drawing%units, unit, error)
        if (allocated(error)) return
        allocate (wires(0))
        call add_product(file, drawing, product)
        call add_skin(file, model, settings%is_open, skin, receipt)
        call palette%paint_skin(file, [skin%solids, skin%sheets])
        call draw_shapes(drawing, .false., .true., shapes)
        call add_shapes(file, shapes, palette, wires, receipt)
        if (size(skin%solids) + size(skin%sheets) + size(wires) == 0) then
            call fail(error, cause%usage, 'there is nothing to export: no skin, no cut, no line')
            return
        end if
        call add_representation(file, product, 'ADVANCED_BREP_SHAPE_REPRESENTATION', skin%solids)
        call add_representation(file, product, 'MANIFOLD_SURFACE_SHAPE_REPRESENTATION', skin%sheets)
        call add_representation(file, product, &
            'GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION', wires)
        call palette%finish(file, product)
        call put_header(out, drawing, settings%tolerance)
        call out%put(file%text())
        call out%line('ENDSEC;')
        call out%line('END-ISO-10303-21;')
    end subroutine write_step

    !> Adds cuts or control lines.
    subroutine add_shapes(file, shapes, palette, wires, receipt)
        type(step_file_type), intent(inout) :: file         !! gets them
        type(shape_type), intent(in) :: shapes(:)           !! cuts or lines
        type(palette_type), intent(inout) :: palette        !! paints them
        integer, allocatable, intent(inout) :: wires(:)     !! instances, in order
        type(receipt_type), intent(inout) :: receipt        !! gets their curves
        integer :: i, wire

        do i = 1, size(shapes)
            call add_shape(file, shapes(i), wire, receipt)
            if (wire == 0) cycle
            wires = [wires, wire]
            call palette%paint_shape(file, shapes(i)%kind, shapes(i)%name, shapes(i)%title, wire)
        end do
    end subroutine add_shapes

end module export_step
