!> A shape in a DXF file: in R12 each contour is one POLYLINE within the tolerance, in R2000 each
!> curve is a SPLINE or a LINE, exactly. What has shrunk to a point is a POINT.
!>
!> Where a shape asks for circular arcs, each of its contours is one polyline with bulges: POLYLINE
!> in R12, LWPOLYLINE in R2000. Closed contours stay one closed entity, as cutters want them, which
!> ARC entities would not. In space, where polylines have no bulges, a shape is as without arcs.
module export_dxf_shape
    use base_error, only: error_type
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use export_arcs, only: arc_contour_type, arc_rounding, arcs_of_contour, decimals_of_arcs, &
        parted_arcs
    use export_chords, only: chord_polygon, decimals_for, polygon_type, round_polygon, rounded, &
        rounding_error
    use export_drawing, only: contour_type, curve_type, shape_kind, shape_type
    use export_drawing_join, only: in_plane
    use export_dxf_entity, only: put_light_polyline, put_line, put_point, put_polyline, put_spline
    use export_dxf_tag, only: dxf_type
    use export_dxf_text, only: name_length
    use export_receipt, only: entity_type, receipt_type
    use geom_bspline, only: bspline_type, is_rational, spline_breaks
    use geom_circular, only: circular_type
    implicit none (type, external)
    private

    public :: pen_type, put_shape, in_drawing

    !> How shapes are drawn.
    type :: pen_type
        character(name_length) :: layer = ''  !! of the outside of the skin, and of control lines
        character(name_length) :: inside = '' !! layer of the inside of the skin
        logical :: is_inside = .false.      !! what is drawn is of the inside
        logical :: is_in_space = .false.    !! not in the plane of the shape
        real(dp) :: tolerance = 0.0_dp      !! of polygons, unit of the drawing
    end type pen_type

    !> Decimals of coordinates in R12, or more where the tolerance asks for them.
    integer, parameter :: usual_decimals = 4

contains

    !> Points of space where a drawing has them: in the plane of their shape or where they are.
    pure function in_drawing(shape, at, is_in_space) result(place)
        type(shape_type), intent(in) :: shape   !! whose points they are
        real(dp), intent(in) :: at(:, :)        !! STA, BL, WL by columns
        logical, intent(in) :: is_in_space      !! where they are
        real(dp), allocatable :: place(:, :)
        if (is_in_space) then
            allocate (place, source=at)
        else
            allocate (place, source=in_plane(shape%plane, at))
        end if
    end function in_drawing

    !> Puts all contours of a shape. Fails where `chord_polygon` or `arcs_of_contour` does.
    subroutine put_shape(file, shape, pen, receipt, error)
        type(dxf_type), intent(inout) :: file               !! the file
        type(shape_type), intent(in) :: shape               !! what to put
        type(pen_type), intent(in) :: pen                   !! how
        type(receipt_type), intent(inout) :: receipt        !! gets the entities
        type(error_type), allocatable, intent(out) :: error !! see above
        type(pen_type) :: nib
        integer :: i, k

        do i = 1, size(shape%contours)
            nib = pen
            nib%is_inside = shape%contours(i)%is_inside
            if (nib%is_inside) nib%layer = pen%inside
            if (shape%arcs > 0.0_dp .and. .not. pen%is_in_space .and. &
                size(shape%contours(i)%curves) > 0) then
                call put_arcs(file, shape, shape%contours(i), nib, receipt, error)
                if (allocated(error)) return
            else if (file%has_handles .and. size(shape%contours(i)%curves) > 0) then
                do k = 1, size(shape%contours(i)%curves)
                    call put_curve(file, shape, shape%contours(i)%curves(k), nib, receipt)
                end do
            else
                call put_contour(file, shape, shape%contours(i), nib, receipt, error)
                if (allocated(error)) return
            end if
        end do
    end subroutine put_shape

    !> Puts a contour as one polygon, or as a point.
    subroutine put_contour(file, shape, contour, pen, receipt, error)
        type(dxf_type), intent(inout) :: file               !! the file
        type(shape_type), intent(in) :: shape               !! whose contour it is
        type(contour_type), intent(in) :: contour           !! what to put
        type(pen_type), intent(in) :: pen                   !! how
        type(receipt_type), intent(inout) :: receipt        !! gets the entity
        type(error_type), allocatable, intent(out) :: error !! see `chord_polygon`
        type(polygon_type) :: polygon
        type(entity_type) :: entity
        integer :: decimals

        decimals = decimals_for(pen%tolerance, usual_decimals)
        call chord_polygon(contour, pen%tolerance - rounding_error(decimals, 3), polygon, error)
        if (allocated(error)) return
        polygon%at = in_drawing(shape, polygon%at, pen%is_in_space)
        call round_polygon(polygon, decimals)
        entity%name = shape%name
        entity%points = size(polygon%at, 2)
        entity%error = polygon%error
        entity%has_place = .true.
        entity%worst = polygon%worst
        if (entity%points == 1) then
            entity%kind = 'POINT'
            call put_point(file, trim(pen%layer), polygon%at(:, 1))
        else
            entity%kind = trim(merge('CLOSED POLYLINE', 'POLYLINE       ', polygon%is_closed))
            call put_polyline(file, trim(pen%layer), polygon%at, polygon%is_closed)
        end if
        if (pen%is_inside) entity%kind = entity%kind//' INSIDE'
        call receipt%add(entity)
    end subroutine put_contour

    !> Puts a contour as circular arcs.
    subroutine put_arcs(file, shape, contour, pen, receipt, error)
        type(dxf_type), intent(inout) :: file               !! the file
        type(shape_type), intent(in) :: shape               !! whose contour it is
        type(contour_type), intent(in) :: contour           !! what to put, with curves
        type(pen_type), intent(in) :: pen                   !! how
        type(receipt_type), intent(inout) :: receipt        !! gets the entity
        type(error_type), allocatable, intent(out) :: error !! see `arcs_of_contour`
        type(arc_contour_type) :: chain
        type(entity_type) :: entity
        real(dp), allocatable :: at(:, :), bulge(:)
        integer :: decimals

        call arcs_of_contour(shape%plane, contour, shape%arcs, chain, error)
        if (allocated(error)) return
        decimals = decimals_of_arcs(shape%arcs, usual_decimals)
        call corners_of(chain, decimals, at, bulge)
        entity%name = shape%name
        entity%points = size(at, 2)
        entity%spans = count(abs(bulge) > 0.0_dp)
        entity%error = chain%error + arc_rounding(decimals)
        entity%has_place = .true.
        entity%worst = chain%worst
        if (entity%points == 1) then
            entity%kind = 'POINT'
            call put_point(file, trim(pen%layer), at(:, 1))
        else if (file%has_handles) then
            entity%kind = trim(merge('CLOSED LWPOLYLINE ARCS', 'LWPOLYLINE ARCS       ', &
                chain%is_closed))
            call put_light_polyline(file, trim(pen%layer), at, chain%is_closed, bulge)
        else
            entity%kind = trim(merge('CLOSED POLYLINE ARCS', 'POLYLINE ARCS       ', &
                chain%is_closed))
            call put_polyline(file, trim(pen%layer), at, chain%is_closed, bulge)
        end if
        if (pen%is_inside) entity%kind = entity%kind//' INSIDE'
        call receipt%add(entity)
    end subroutine put_arcs

    !> The corners of a polyline of arcs, rounded, those left out that fall on the next, and the
    !> bulges of the arcs that begin there. The last corner of an open one has none.
    pure subroutine corners_of(chain, decimals, at, bulge)
        type(arc_contour_type), intent(in) :: chain         !! of curves
        integer, intent(in) :: decimals                     !! of coordinates
        real(dp), allocatable, intent(out) :: at(:, :)      !! corners by columns
        real(dp), allocatable, intent(out) :: bulge(:)      !! of each corner
        type(circular_type), allocatable :: arcs(:)
        logical, allocatable :: is_kept(:)
        integer :: i, count

        allocate (arcs(0))
        arcs = parted_arcs(chain)
        count = size(arcs)
        allocate (at(2, count + 1), bulge(count + 1), is_kept(count + 1))
        at = spread(chain%start, 2, count + 1)
        bulge = 0.0_dp
        is_kept = .not. chain%is_closed
        do i = 1, count
            at(:, i) = rounded(arcs(i)%start, decimals)
            at(:, i + 1) = rounded(arcs(i)%finish, decimals)
            if (.not. arcs(i)%is_line) bulge(i) = tan(0.25_dp*arcs(i)%turn)
            is_kept(i) = any(abs(at(:, i + 1) - at(:, i)) > 0.0_dp)
        end do
        if (.not. any(is_kept)) is_kept(1) = .true.
        at = at(:, pack([(i, i=1, count + 1)], is_kept))
        bulge = pack(bulge, is_kept)
    end subroutine corners_of

    !> Puts a curve as it is.
    subroutine put_curve(file, shape, curve, pen, receipt)
        type(dxf_type), intent(inout) :: file           !! of R2000
        type(shape_type), intent(in) :: shape           !! whose curve it is
        type(curve_type), intent(in) :: curve           !! what to put
        type(pen_type), intent(in) :: pen               !! how
        type(receipt_type), intent(inout) :: receipt    !! gets the entity
        type(bspline_type) :: spline
        type(entity_type) :: entity
        integer :: last

        spline%degree = curve%spline%degree
        allocate (spline%knot, source=curve%spline%knot)
        allocate (spline%weight, source=curve%spline%weight)
        allocate (spline%pole, source=in_drawing(shape, curve%spline%pole, pen%is_in_space))
        last = size(spline%pole, 2)
        entity%name = shape%name
        if (curve%section /= '') entity%name = shape%name//' '//curve%section
        entity%is_exact = curve%is_exact
        entity%error = curve%error
        entity%has_place = .not. curve%is_exact
        entity%worst = curve%worst
        entity%points = last
        if (all(is_equal(spline%pole, spread(spline%pole(:, 1), 2, last)))) then
            entity%kind = 'POINT'
            entity%points = 1
            call put_point(file, trim(pen%layer), spline%pole(:, 1))
        else if (last == 2) then
            entity%kind = 'LINE'
            call put_line(file, trim(pen%layer), spline%pole(:, 1), spline%pole(:, 2))
        else
            entity%kind = trim(merge('RATIONAL SPLINE', 'SPLINE         ', is_rational(spline)))
            entity%spans = size(spline_breaks(spline)) - 1
            call put_spline(file, trim(pen%layer), spline, normal_of(shape, pen%is_in_space))
        end if
        if (pen%is_inside) entity%kind = entity%kind//' INSIDE'
        call receipt%add(entity)
    end subroutine put_curve

    !> The normal of the plane of a shape in the drawing; zero for a line in space.
    pure function normal_of(shape, is_in_space) result(normal)
        type(shape_type), intent(in) :: shape   !! any shape
        logical, intent(in) :: is_in_space      !! not in its plane
        real(dp) :: normal(3)
        normal = 0.0_dp
        if (shape%kind == shape_kind%line) return
        normal = [0.0_dp, 0.0_dp, 1.0_dp]
        if (is_in_space) normal = shape%plane%normal/norm2(shape%plane%normal)
    end function normal_of

end module export_dxf_shape
