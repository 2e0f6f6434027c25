!> Tests of DXF files as wholes. Oracles: circles in closed form, the structure that Autodesk's "DXF
!> Reference" prescribes.
program test_dxf
    use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_value
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use base_output, only: output_type
    use export_drawing, only: drawing_type, mark_type, shape_kind, shape_type
    use export_dxf, only: write_dxf
    use export_receipt, only: receipt_type
    use export_settings, only: settings_type
    use support_dxf_pairs, only: numbers_of, pairs_type, read_pairs
    use support_sketch, only: add_contour, add_shape, ellipse, new_drawing, new_shape, segment
    use support_tap, only: tap_type
    implicit none (type, external)
    type(tap_type) :: tap

    call check_structure(.false., 'R12')
    call check_structure(.true., 'R2000')
    call check_layers()
    call check_page()
    call check_space()
    call check_sizes()
    call check_refusals()
    call tap%finish()

contains

    !> A ring with an inside, and an ellipse with a straight piece.
    subroutine sketch(drawing, settings)
        type(drawing_type), intent(out) :: drawing      !! two stations
        type(settings_type), intent(out) :: settings    !! R12 within a thousandth
        type(shape_type) :: shape

        drawing = new_drawing(1.0e-3_dp)
        shape = new_shape('STA-20.5', 20.5_dp)
        call add_contour(shape, ellipse(shape%plane, [0.0_dp, 5.0_dp], [10.0_dp, 10.0_dp]))
        call add_contour(shape, ellipse(shape%plane, [0.0_dp, 5.0_dp], [9.0_dp, 9.0_dp]))
        shape%contours(2)%is_inside = .true.
        call add_shape(drawing, shape)
        shape = new_shape('STA-30', 30.0_dp)
        call add_contour(shape, ellipse(shape%plane, [0.0_dp, 5.0_dp], [12.0_dp, 8.0_dp]))
        call add_contour(shape, segment([30.0_dp, -3.0_dp, 1.0_dp], [30.0_dp, 4.0_dp, 1.0_dp]))
        call add_shape(drawing, shape)
        settings%tolerance = 1.0e-3_dp
    end subroutine sketch

    !> Writes and reads back.
    subroutine write_and_read(drawing, settings, pairs, receipt)
        type(drawing_type), intent(in) :: drawing       !! what to write
        type(settings_type), intent(in) :: settings     !! how
        type(pairs_type), intent(out) :: pairs          !! of the file
        type(receipt_type), intent(out) :: receipt      !! of the file
        type(output_type) :: out
        type(error_type), allocatable :: error
        call write_dxf(drawing, settings, out, receipt, error)
        call read_pairs(out%text(), pairs)
        if (allocated(error)) call tap%note(error%message)
    end subroutine write_and_read

    subroutine check_structure(has_splines, name)
        logical, intent(in) :: has_splines  !! R2000
        character(*), intent(in) :: name    !! of the version
        type(drawing_type) :: drawing
        type(settings_type) :: settings
        type(output_type) :: out, again
        type(receipt_type) :: receipt
        type(error_type), allocatable :: error
        type(pairs_type) :: pairs

        call sketch(drawing, settings)
        settings%has_splines = has_splines
        call write_dxf(drawing, settings, out, receipt, error)
        call tap%ok(.not. allocated(error), name//': two cuts are written')
        call read_pairs(out%text(), pairs)
        call tap%ok(pairs%is_valid, name//': every code has its value')
        call tap%ok(pairs%entity_count('SECTION', '') == merge(6, 3, has_splines) .and. &
            pairs%entity_count('ENDSEC', '') == merge(6, 3, has_splines), &
            name//': every section begins and ends')
        call tap%ok(pairs%value(pairs%count) == 'EOF', name//': the file ends')
        call tap%ok(all_handles_differ(pairs), name//': no handle is given twice')
        call tap%same(pairs%text(70, pairs%find(9, '$INSUNITS', 1)), '1', name//': inches')
        call tap%ok(pairs%find(1, 'ALL DIMENSIONS IN INCHES', 1) > 0, name//': inches in words')
        call write_dxf(drawing, settings, again, receipt, error)
        call tap%ok(again%text() == out%text(), name//': the same drawing gives the same bytes')
    end subroutine check_structure

    !> True where no handle stands twice, and each is below $HANDSEED.
    logical function all_handles_differ(pairs) result(differ)
        type(pairs_type), intent(in) :: pairs   !! of a file
        integer, allocatable :: handles(:)
        integer :: handle, i, seed

        allocate (handles(0))
        seed = huge(seed)
        differ = .true.
        do i = 1, pairs%count
            if (pairs%code(i) /= 5 .and. pairs%code(i) /= 105) cycle
            read (pairs%value(i), '(z8)') handle
            if (pairs%value(i - 1) == '$HANDSEED') then
                seed = handle
                cycle
            end if
            differ = differ .and. .not. any(handles == handle) .and. handle < seed
            handles = [handles, handle]
        end do
    end function all_handles_differ

    subroutine check_layers()
        type(drawing_type) :: drawing
        type(settings_type) :: settings
        type(receipt_type) :: receipt
        type(pairs_type) :: pairs
        type(shape_type) :: shape
        real(dp), allocatable :: u(:), v(:)

        call sketch(drawing, settings)
        call write_and_read(drawing, settings, pairs, receipt)
        call tap%ok(pairs%entity_count('POLYLINE', 'STA-20_5') == 1 .and. &
            pairs%entity_count('POLYLINE', 'STA-20_5-IN') == 1 .and. &
            pairs%entity_count('POLYLINE', 'STA-30') == 2, &
            'each contour is one polyline on the layer of its cut')
        call tap%ok(pairs%find(2, 'STA-30-IN', 1) == 0, 'no layer for an inside that is not there')
        call tap%has(receipt%notes, 'layer STA-20_5 is STA-20.5', 'the receipt says which is which')
        call tap%ok(receipt%count == 4 .and. all(receipt%entities(:4)%error <= 1.0e-3_dp), &
            'four entities, all within the tolerance')
        allocate (u, source=numbers_of(pairs, 'VERTEX', 10))
        allocate (v, source=numbers_of(pairs, 'VERTEX', 20))
        call tap%near(maxval(u), 12.0_dp, 1.0e-4_dp, 'butt lines run to the right')
        call tap%near(maxval(v), 15.0_dp, 1.0e-4_dp, 'waterlines up')
        shape = drawing%cuts(1)
        shape%name = 'sta-20_5'
        call add_shape(drawing, shape)
        shape%name = 'Text'
        call add_shape(drawing, shape)
        call write_and_read(drawing, settings, pairs, receipt)
        call tap%ok(pairs%entity_count('POLYLINE', 'STA-20_5_2') == 1 .and. &
            pairs%entity_count('POLYLINE', 'TEXT_2') == 1, &
            'no two cuts share a layer, nor with words')
    end subroutine check_layers

    subroutine check_page()
        type(drawing_type) :: drawing
        type(settings_type) :: settings
        type(receipt_type) :: receipt
        type(pairs_type) :: pairs
        real(dp) :: low(2), high(2)

        call sketch(drawing, settings)
        drawing%title = 'R'//char(195)//char(188)//'mpf'//char(10)//'  0'
        drawing%cuts(1)%contours(1)%marks = [mark_type([10.0_dp, 5.0_dp], [1.0_dp, 0.0_dp], &
            -12.34_dp)]
        call write_and_read(drawing, settings, pairs, receipt)
        call tap%ok(pairs%is_valid .and. pairs%find(1, 'R\U+00FCmpf?  0', 1) > 0, &
            'a title of any bytes is one line of ASCII')
        call tap%ok(pairs%find(1, '-12.3', 1) == 0, 'bevels of several cuts would hide each other')
        call tap%ok(pairs%entity_count('LINE', 'REFERENCE') == 10, 'reference lines on their layer')
        call tap%ok(pairs%find(1, 'CL BL 0', 1) > 0 .and. pairs%find(1, 'WL 10', 1) > 0, &
            'with their ordinates')
        read (pairs%value(pairs%find(9, '$EXTMIN', 1) + 1:pairs%find(9, '$EXTMIN', 1) + 2), *) low
        read (pairs%value(pairs%find(9, '$EXTMAX', 1) + 1:pairs%find(9, '$EXTMAX', 1) + 2), *) high
        call tap%ok(low(1) <= minval(numbers_of(pairs, 'TEXT', 10)) .and. &
            low(2) <= minval(numbers_of(pairs, 'TEXT', 20)) .and. &
            high(1) >= maxval(numbers_of(pairs, 'LINE', 11)) .and. &
            high(2) >= maxval(numbers_of(pairs, 'LINE', 21)), 'all is within the limits')
        drawing%cuts = drawing%cuts(:1)
        call write_and_read(drawing, settings, pairs, receipt)
        call tap%ok(pairs%find(1, '-12.3', 1) > 0, 'those of one cut are words')
        call tap%ok(pairs%entity_count('LINE', 'TEXT') == 1, 'with a tick')
    end subroutine check_page

    subroutine check_space()
        type(drawing_type) :: drawing
        type(settings_type) :: settings
        type(receipt_type) :: receipt
        type(pairs_type) :: pairs
        type(shape_type) :: shape

        call sketch(drawing, settings)
        shape = new_shape('MHB', 0.0_dp)
        shape%kind = shape_kind%line
        call add_contour(shape, segment([0.0_dp, 1.0_dp, 2.0_dp], [60.0_dp, 5.0_dp, 7.0_dp]))
        drawing%lines = [shape]
        call write_and_read(drawing, settings, pairs, receipt)
        call tap%ok(pairs%find(2, 'MHB', 1) == 0, 'true shapes have no control lines')
        settings%is_in_space = .true.
        call write_and_read(drawing, settings, pairs, receipt)
        call tap%ok(pairs%entity_count('POLYLINE', 'MHB') == 1, 'in space they have a layer each')
        call tap%ok(all(nint(numbers_of(pairs, 'POLYLINE', 70)) == [9, 9, 9, 8, 8]), &
            'polylines of space, rings closed')
        call tap%near(maxval(numbers_of(pairs, 'VERTEX', 30)), 15.0_dp, 1.0e-4_dp, &
            'waterlines are heights')
        call tap%ok(pairs%find(1, 'STA 60', 1) > 0, 'reference lines are those of the side view')
        deallocate (drawing%cuts)
        allocate (drawing%cuts(0))
        call write_and_read(drawing, settings, pairs, receipt)
        call tap%ok(pairs%entity_count('POLYLINE', '') == 1, 'lines without cuts are drawn')
    end subroutine check_space

    subroutine check_sizes()
        type(drawing_type) :: drawing
        type(settings_type) :: settings
        type(receipt_type) :: receipt
        type(pairs_type) :: pairs
        type(shape_type) :: shape

        drawing = new_drawing(1.0e60_dp)
        shape = new_shape('HUGE', 1.0e70_dp)
        call add_contour(shape, ellipse(shape%plane, [0.0_dp, 0.0_dp], [1.0e70_dp, 1.0e70_dp]))
        call add_shape(drawing, shape)
        settings%tolerance = 1.0e66_dp
        call write_and_read(drawing, settings, pairs, receipt)
        call tap%ok(pairs%is_valid .and. pairs%entity_count('POLYLINE', 'HUGE') == 1, &
            'a body of any size is drawn')
        call tap%ok(all(index(pairs%value(:pairs%count), '**') == 0), 'no number is asterisks')
        call tap%near(maxval(numbers_of(pairs, 'VERTEX', 10))*1.0e-70_dp, 1.0_dp, 1.0e-15_dp, &
            'its numbers are right')
    end subroutine check_sizes

    subroutine check_refusals()
        type(drawing_type) :: drawing
        type(settings_type) :: settings

        call sketch(drawing, settings)
        settings%tolerance = 0.0_dp
        call refused(drawing, settings, cause%usage, 'tolerance', 'no tolerance')
        settings%tolerance = 1.0e-3_dp
        drawing%units = 'CUBITS'
        call refused(drawing, settings, cause%usage, 'CUBITS', 'a unit that is none')
        drawing%units = 'FEET'
        drawing%cuts(2)%contours(1)%curves(1)%spline%pole(2, 1) = &
            ieee_value(1.0_dp, ieee_positive_inf)
        call refused(drawing, settings, cause%no_arc, 'STATION STA-30', 'an infinite coordinate')
        call sketch(drawing, settings)
        drawing%cuts(2)%contours(1)%curves(1)%error = 1.0e-3_dp
        call refused(drawing, settings, cause%no_convergence, 'exact shape', &
            'a curve that leaves nothing of the tolerance')
        deallocate (drawing%cuts)
        allocate (drawing%cuts(0))
        call refused(drawing, settings, cause%usage, 'nothing to draw', 'no cuts')
        call add_shape(drawing, new_shape('EMPTY', 1.0_dp))
        call refused(drawing, settings, cause%usage, 'nothing to draw', 'a cut without outline')
    end subroutine check_refusals

    subroutine refused(drawing, settings, why, words, name)
        type(drawing_type), intent(in) :: drawing       !! what to write
        type(settings_type), intent(in) :: settings     !! how
        integer, intent(in) :: why                      !! the cause
        character(*), intent(in) :: words               !! in the message
        character(*), intent(in) :: name                !! of the case
        type(output_type) :: out
        type(receipt_type) :: receipt
        type(error_type), allocatable :: error
        call write_dxf(drawing, settings, out, receipt, error)
        call tap%ok(allocated(error), name//': refused')
        if (.not. allocated(error)) return
        call tap%ok(error%cause == why, name//': with its cause')
        call tap%has(error%message, words, name//': and says why')
    end subroutine refused

end program test_dxf
