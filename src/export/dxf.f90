!> A drawing as a DXF file: R12 (AC1009) with polylines, which every cutter reads, or R2000
!> (AC1015) with splines, which are exact.
!>
!> Each cut has a layer of its own, its inside of the skin another; control lines, which stand only
!> in drawings in space, have one each. REFERENCE has the reference lines and their ordinates, TEXT
!> the words and, of a drawing of one cut in its true shape, the bevel marks, so that both can be
!> switched off.
module export_dxf
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: to_text
    use export_drawing, only: drawing_type, shape_type
    use export_drawn, only: check_shapes, check_tolerance, draw_shapes
    use export_dxf_entity, only: on_page, put_line, put_words
    use export_dxf_header, only: box_type, put_header
    use export_dxf_notes, only: add_bevels, add_notes
    use export_dxf_objects, only: put_blocks, put_classes, put_objects
    use export_dxf_page, only: add_references, page_axes, page_type, stroke_type, &
        words_type
    use export_dxf_shape, only: in_drawing, pen_type, put_shape
    use export_dxf_tables, only: layer_type, put_tables
    use export_dxf_tag, only: dxf_type
    use export_dxf_text, only: layer_name, name_length
    use export_receipt, only: receipt_type
    use export_settings, only: settings_type
    use export_units, only: find_unit, unit_type
    implicit none (type, external)
    private

    public :: write_dxf

    !> Layers of reference lines and of words, and names that readers have for themselves.
    character(*), parameter :: reference_layer = 'REFERENCE', text_layer = 'TEXT'
    character(name_length), parameter :: taken(4) = [character(name_length) :: '0', 'DEFPOINTS', &
        reference_layer, text_layer]
    !> Colours of shapes by turns, and of reference lines (grey).
    integer, parameter :: shape_colours = 6, grey = 8

contains

    !> Writes a drawing.
    !>
    !> Fails with `cause%usage` where there is nothing to draw, the tolerance is not above zero or
    !> the unit is none; with `cause%no_arc` where a coordinate is no finite number; and where
    !> `chord_polygon` does.
    subroutine write_dxf(drawing, settings, out, receipt, error)
        type(drawing_type), intent(in) :: drawing           !! in the unit of the file
        type(settings_type), intent(in) :: settings         !! its tolerance, splines, space, half
        type(output_type), intent(inout) :: out             !! gets the file
        type(receipt_type), intent(inout) :: receipt        !! gets what is in it
        type(error_type), allocatable, intent(out) :: error !! see above
        type(shape_type), allocatable :: shapes(:)
        type(pen_type), allocatable :: pens(:)
        type(dxf_type) :: entities
        type(page_type) :: page
        type(unit_type) :: unit
        integer :: i

        call find_unit(drawing%units, unit, error)
        if (.not. allocated(error)) call check_tolerance(settings%tolerance, error)
        if (allocated(error)) return
        call draw_shapes(drawing, settings%is_half, settings%is_in_space, shapes)
        call check_shapes(shapes, error)
        if (allocated(error)) return
        allocate (pens, source=pens_for(shapes, settings))
        call lay_page(drawing, shapes, settings%is_in_space, page)
        call add_notes(page, drawing, unit, settings, pens%layer)
        if (size(shapes) == 1 .and. .not. settings%is_in_space) &
            call add_all_bevels(page, shapes(1))
        entities%has_handles = settings%has_splines
        do i = 1, size(shapes)
            call put_shape(entities, shapes(i), pens(i), receipt, error)
            if (allocated(error)) return
        end do
        call put_page(entities, reference_layer, page%references, page%ordinates, page%height, &
            settings%is_in_space)
        call put_page(entities, text_layer, page%ticks, page%words, page%height, &
            settings%is_in_space)
        call assemble(entities, pens, box_of(shapes, page, settings%is_in_space), unit, out)
        call tell(shapes, pens, page, receipt)
    end subroutine write_dxf

    !> The layers of shapes and how they are drawn.
    pure function pens_for(shapes, settings) result(pens)
        type(shape_type), intent(in) :: shapes(:)   !! cuts and lines
        type(settings_type), intent(in) :: settings !! as asked for
        type(pen_type), allocatable :: pens(:)
        character(name_length), allocatable :: names(:)
        integer :: i

        allocate (pens(size(shapes)))
        allocate (names, source=taken)
        do i = 1, size(shapes)
            pens(i)%layer = layer_name(shapes(i)%name, names)
            names = [names, pens(i)%layer]
            if (.not. any(shapes(i)%contours%is_inside)) cycle
            pens(i)%inside = layer_name(shapes(i)%name//'-IN', names)
            names = [names, pens(i)%inside]
        end do
        pens%is_in_space = settings%is_in_space
        pens%tolerance = settings%tolerance
    end function pens_for

    !> Lays the reference lines around the shapes.
    pure subroutine lay_page(drawing, shapes, is_in_space, page)
        type(drawing_type), intent(in) :: drawing   !! what is drawn
        type(shape_type), intent(in) :: shapes(:)   !! of it
        logical, intent(in) :: is_in_space          !! the page is BL 0
        type(page_type), intent(out) :: page        !! without words
        character(:), allocatable :: u_name, v_name
        type(box_type) :: box
        integer :: up

        box = hull_of(shapes, is_in_space)
        up = merge(3, 2, is_in_space)
        page%low = box%low([1, up])
        page%high = box%high([1, up])
        call page_axes(drawing, is_in_space, u_name, v_name)
        call add_references(page, u_name, v_name)
    end subroutine lay_page

    !> Adds the bevels of a shape to a page. Those of several would hide each other.
    pure subroutine add_all_bevels(page, shape)
        type(page_type), intent(inout) :: page      !! with its notes
        type(shape_type), intent(in) :: shape       !! in its plane
        integer :: i
        do i = 1, size(shape%contours)
            call add_bevels(page, shape%contours(i))
        end do
    end subroutine add_all_bevels

    !> The box of the poles of shapes, in which they lie as well.
    pure type(box_type) function hull_of(shapes, is_in_space) result(box)
        type(shape_type), intent(in) :: shapes(:)   !! at least one contour
        logical, intent(in) :: is_in_space          !! not in their planes
        integer :: i, k, j, rows

        rows = merge(3, 2, is_in_space)
        box%low(:rows) = huge(1.0_dp)
        box%high(:rows) = -huge(1.0_dp)
        do i = 1, size(shapes)
            do k = 1, size(shapes(i)%contours)
                associate (contour => shapes(i)%contours(k))
                    if (size(contour%curves) == 0) call take_points(box, &
                        in_drawing(shapes(i), reshape(contour%at, [3, 1]), is_in_space))
                    do j = 1, size(contour%curves)
                        call take_points(box, in_drawing(shapes(i), &
                            contour%curves(j)%spline%pole, is_in_space))
                    end do
                end associate
            end do
        end do
    end function hull_of

    !> Widens a box so that points are in it.
    pure subroutine take_points(box, at)
        type(box_type), intent(inout) :: box    !! as wide as the points before it
        real(dp), intent(in) :: at(:, :)        !! by columns
        integer :: rows
        rows = size(at, 1)
        box%low(:rows) = min(box%low(:rows), minval(at, dim=2))
        box%high(:rows) = max(box%high(:rows), maxval(at, dim=2))
    end subroutine take_points

    !> The box of all: shapes, reference lines and words.
    pure type(box_type) function box_of(shapes, page, is_in_space) result(box)
        type(shape_type), intent(in) :: shapes(:)   !! at least one contour
        type(page_type), intent(in) :: page         !! around them
        logical, intent(in) :: is_in_space          !! the page is BL 0
        type(box_type) :: flat
        integer :: i, axes(2)

        box = hull_of(shapes, is_in_space)
        flat%low(:2) = page%low
        flat%high(:2) = page%high
        do i = 1, size(page%references)
            associate (line => page%references(i))
                call take_points(flat, reshape([line%from, line%to], [2, 2]))
            end associate
        end do
        call take_words(flat, page%ordinates, page%height)
        call take_words(flat, page%words, page%height)
        axes = [1, merge(3, 2, is_in_space)]
        box%low(axes) = min(box%low(axes), flat%low(:2))
        box%high(axes) = max(box%high(axes), flat%high(:2))
    end function box_of

    !> Widens a box so that words are in it; letters are taken to be as wide as high.
    pure subroutine take_words(box, words, height)
        type(box_type), intent(inout) :: box        !! on the page
        type(words_type), intent(in) :: words(:)    !! on it, too
        real(dp), intent(in) :: height              !! of letters
        real(dp) :: size_of(2), left(2)
        integer :: i

        do i = 1, size(words)
            size_of = height*[real(len(words(i)%text), dp), 1.0_dp]
            left = words(i)%at - size_of*[0.5_dp*real(words(i)%side, dp), 0.5_dp]
            call take_points(box, reshape([left, left + size_of], [2, 2]))
        end do
    end subroutine take_words

    !> Puts lines and words of the page.
    subroutine put_page(file, layer, lines, words, height, is_in_space)
        type(dxf_type), intent(inout) :: file       !! gets them
        character(*), intent(in) :: layer           !! its name
        type(stroke_type), intent(in) :: lines(:)   !! first
        type(words_type), intent(in) :: words(:)    !! then
        real(dp), intent(in) :: height              !! of letters
        logical, intent(in) :: is_in_space          !! the page is BL 0
        integer :: i

        do i = 1, size(lines)
            call put_line(file, layer, on_page(lines(i)%from, is_in_space), &
                on_page(lines(i)%to, is_in_space))
        end do
        do i = 1, size(words)
            call put_words(file, layer, words(i), height, is_in_space)
        end do
    end subroutine put_page

    !> Puts the sections together.
    subroutine assemble(entities, pens, box, unit, out)
        type(dxf_type), intent(in) :: entities      !! without the begin and end of their section
        type(pen_type), intent(in) :: pens(:)       !! of the shapes
        type(box_type), intent(in) :: box           !! of the drawing
        type(unit_type), intent(in) :: unit         !! of it
        type(output_type), intent(inout) :: out     !! gets the file
        type(dxf_type) :: header, tables, objects

        tables%has_handles = entities%has_handles
        tables%handle = entities%handle
        call put_tables(tables, layers_of(pens), box, unit)
        call put_blocks(tables)
        call tables%section('ENTITIES')
        header%has_handles = tables%has_handles
        header%handle = tables%handle
        call put_header(header, box, unit)
        call put_classes(header)
        objects%has_handles = entities%has_handles
        call objects%section('')
        call put_objects(objects)
        call objects%tag(0, 'EOF')
        call out%put(header%out%text())
        call out%put(tables%out%text())
        call out%put(entities%out%text())
        call out%put(objects%out%text())
    end subroutine assemble

    !> The layers of the file.
    pure function layers_of(pens) result(layers)
        type(pen_type), intent(in) :: pens(:)   !! of the shapes
        type(layer_type), allocatable :: layers(:)
        integer :: i, colour

        allocate (layers(0))
        do i = 1, size(pens)
            colour = 1 + mod(i - 1, shape_colours)
            layers = [layers, layer_type(pens(i)%layer, colour, .false.)]
            if (pens(i)%inside /= '') &
                layers = [layers, layer_type(pens(i)%inside, colour, .false.)]
        end do
        layers = [layers, layer_type(reference_layer, grey, .true.), layer_type(text_layer)]
    end function layers_of

    !> Says in the receipt which layer has which shape where the names differ, and what else is
    !> in the file.
    pure subroutine tell(shapes, pens, page, receipt)
        type(shape_type), intent(in) :: shapes(:)       !! what was drawn
        type(pen_type), intent(in) :: pens(:)           !! of them
        type(page_type), intent(in) :: page             !! around them
        type(receipt_type), intent(inout) :: receipt    !! gets the lines
        integer :: i

        do i = 1, size(shapes)
            if (shapes(i)%name /= pens(i)%layer) call receipt%say('layer '// &
                trim(pens(i)%layer)//' is '//shapes(i)%name)
        end do
        call receipt%say('layer '//reference_layer//' has '//to_text(size(page%references))// &
            ' reference lines, layer '//text_layer//' '//to_text(size(page%words))//' texts')
    end subroutine tell

end module export_dxf
