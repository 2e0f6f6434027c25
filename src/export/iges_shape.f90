!> Cuts and control lines of an IGES file: each has a name (406, form 15), a level, and a label and
!> a colour for its kind; its curves follow each other in the order of its contours.
module export_iges_shape
    use base_kinds, only: dp
    use export_drawing, only: contour_type, curve_type, shape_kind, shape_type
    use export_entity, only: curve_entity
    use export_iges_conic, only: add_conic, conic_error, suits_conic
    use export_iges_curve, only: add_line, add_point, add_spline, no_normal
    use export_iges_file, only: entry_type, iges_file_type, iges_status
    use export_iges_record, only: record_type
    use export_receipt, only: entity_type, receipt_type
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: add_shape, add_name, add_level

    !> Labels and colours of the kinds, in the order of `shape_kind`: 4 blue, 2 red, 3 green,
    !> 6 magenta, 1 black.
    character(8), parameter :: labels(shape_kind%card) = [character(8) :: 'STATION', 'BUTTOCK', &
        'WATERLN', 'OBLIQUE', 'PLANE', 'LINE', 'CARD']
    integer, parameter :: colours(shape_kind%card) = [4, 2, 3, 6, 6, 1, 4]

contains

    !> Adds the curves of a cut or a control line, and its points where it has only touched.
    subroutine add_shape(file, shape, level, has_conics, receipt)
        type(iges_file_type), intent(inout) :: file     !! gets them
        type(shape_type), intent(in) :: shape           !! in the unit of the file
        integer, intent(in) :: level                    !! its level
        logical, intent(in) :: has_conics               !! conics and lines as such
        type(receipt_type), intent(inout) :: receipt    !! gets an entity for each curve
        type(entry_type) :: entry
        integer :: name, i, k

        if (size(shape%contours) == 0) return
        call add_name(file, shape%name, name)
        entry = entry_type(level=level, colour=colours(shape%kind), number=shape%number, &
            label=labels(shape%kind), is_line=.true.)
        do i = 1, size(shape%contours)
            associate (contour => shape%contours(i))
                if (size(contour%curves) == 0) call touch(contour)
                do k = 1, size(contour%curves)
                    call add_curve(contour%curves(k))
                end do
            end associate
        end do
    contains
        !> Adds the point of a contour that has no curves.
        subroutine touch(contour)
            type(contour_type), intent(in) :: contour !! a point
            type(entity_type) :: entity
            integer :: pointer

            call add_point(file, entry, contour%at, name, pointer)
            entity%name = shape%name
            entity%kind = '116 POINT'
            entity%is_exact = .true.
            entity%points = 1
            call receipt%add(entity)
        end subroutine touch

        !> Adds a curve as what suits it.
        subroutine add_curve(curve)
            type(curve_type), intent(in) :: curve !! of the shape
            integer :: pointer

            if (has_conics .and. is_straight(curve)) then
                call add_line(file, entry, curve%spline%pole, name, pointer)
                call receipt%add(curve_entity(curve, shape%name, '110 LINE'))
            else if (has_conics .and. suits_conic(curve, shape%plane)) then
                call add_conic(file, entry, curve, shape%plane, name, pointer)
                call receipt%add(conic_entity(curve, shape))
            else
                call add_spline(file, entry, curve%spline, normal_of(shape), name, pointer)
                call receipt%add(curve_entity(curve, shape%name, '126 B-SPLINE CURVE'))
            end if
        end subroutine add_curve
    end subroutine add_shape

    !> True for a straight curve.
    pure logical function is_straight(curve)
        type(curve_type), intent(in) :: curve !! any curve
        is_straight = curve%spline%degree == 1 .and. size(curve%spline%weight) == 2
    end function is_straight

    !> The unit normal of a cut; a control line is not said to be in a plane.
    pure function normal_of(shape) result(normal)
        type(shape_type), intent(in) :: shape !! any shape
        real(dp) :: normal(3)

        normal = no_normal
        if (shape%kind == shape_kind%line) return
        associate (u => shape%plane%u, v => shape%plane%v)
            normal = [cross(u(2:3), v(2:3)), cross(u([3, 1]), v([3, 1])), cross(u(1:2), v(1:2))]
        end associate
        normal = normal/norm2(normal) + 0.0_dp
    end function normal_of

    !> What a receipt says of a curve that is written as a conic.
    pure type(entity_type) function conic_entity(curve, shape) result(entity)
        type(curve_type), intent(in) :: curve   !! of the shape
        type(shape_type), intent(in) :: shape   !! any

        entity = curve_entity(curve, shape%name, '104 CONIC ARC')
        entity%points = 0
        entity%spans = 0
        entity%error = conic_error(curve, shape%plane)
    end function conic_entity

    !> Adds a name that entities can refer to: property 406, form 15.
    subroutine add_name(file, name, pointer)
        type(iges_file_type), intent(inout) :: file     !! gets it
        character(*), intent(in) :: name                !! any bytes
        integer, intent(out) :: pointer                 !! to the entity
        type(record_type) :: record

        call record%whole(406)
        call record%whole(1)
        call record%text(name)
        call file%add(406, entry_type(form=15, status=iges_status%name), record, pointer)
    end subroutine add_name

    !> Says what a level is for: property 406, form 3.
    subroutine add_level(file, level, words)
        type(iges_file_type), intent(inout) :: file     !! gets it
        integer, intent(in) :: level                    !! which
        character(*), intent(in) :: words               !! any bytes
        type(record_type) :: record
        integer :: pointer

        call record%whole(406)
        call record%whole(2)
        call record%whole(level)
        call record%text(words)
        call file%add(406, entry_type(form=3, level=level, status=iges_status%definition), record, &
            pointer)
    end subroutine add_level

end module export_iges_shape
