!> Cuts and control lines in a STEP file: a named set of curves for each (ISO 10303-42, clause 4),
!> in which curves end to end are one composite curve. Where a plane only touches the skin the set
!> has a point.
module export_step_wire
    use export_drawing, only: contour_type, shape_type
    use export_entity, only: curve_entity
    use export_receipt, only: receipt_type
    use export_step_curve, only: add_curve, add_point, curve_word
    use export_step_text, only: step_file_type, step_logical, step_reference, step_references, &
        step_string
    implicit none (type, external)
    private

    public :: add_shape

contains

    !> Adds a cut or a control line.
    subroutine add_shape(file, shape, number, receipt)
        type(step_file_type), intent(inout) :: file     !! gets it
        type(shape_type), intent(in) :: shape           !! in the unit of the file
        integer, intent(out) :: number                  !! of the instance; 0: there is none
        type(receipt_type), intent(inout) :: receipt    !! gets an entity for each curve
        integer :: elements(size(shape%contours)), i, k

        number = 0
        if (size(elements) == 0) return
        do i = 1, size(elements)
            call add_contour(file, shape%contours(i), shape%name, elements(i))
            do k = 1, size(shape%contours(i)%curves)
                call receipt%add(curve_entity(shape%contours(i)%curves(k), shape%name, &
                    curve_word(shape%contours(i)%curves(k)%spline)))
            end do
        end do
        call file%add('GEOMETRIC_CURVE_SET('//step_string(shape%name)//','// &
            step_references(elements)//')', number)
    end subroutine add_shape

    !> Adds the curves of a contour as one.
    subroutine add_contour(file, contour, name, number)
        type(step_file_type), intent(inout) :: file     !! gets it
        type(contour_type), intent(in) :: contour       !! curves end to end, or a point
        character(*), intent(in) :: name                !! of its shape
        integer, intent(out) :: number                  !! of the instance
        integer :: segments(size(contour%curves)), i, curve, last

        last = size(segments)
        if (last == 0) call add_point(file, contour%at, number)
        if (last == 1) call add_curve(file, contour%curves(1)%spline, name, number)
        if (last < 2) return
        do i = 1, last
            call add_curve(file, contour%curves(i)%spline, name, curve)
            call file%add('COMPOSITE_CURVE_SEGMENT('//trim(merge('.CONTINUOUS.   ', &
                '.DISCONTINUOUS.', i < last .or. contour%is_closed))//',.T.,'// &
                step_reference(curve)//')', segments(i))
        end do
        call file%add('COMPOSITE_CURVE('//step_string(name)//','//step_references(segments)// &
            ','//step_logical(.false.)//')', number)
    end subroutine add_contour

end module export_step_wire
