!> STEP files as a whole. That OpenCASCADE reads them is proved by tests/judges.
program test_step
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use base_output, only: output_type
    use export_drawing, only: drawing_type, shape_kind
    use export_receipt, only: receipt_type
    use export_settings, only: settings_type
    use export_shell, only: skin_model_type
    use export_step, only: write_step
    use geom_bspline, only: bspline_type
    use support_sewn, only: ball_skin
    use support_step_records, only: count_of, is_sound, record_named, record_type, records_of, &
        refers_back
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_all()
    call check_sheet()
    call check_curves_alone()
    call check_refusal()
    call tap%finish()

contains

    subroutine check_all()
        character(:), allocatable :: text, again
        type(record_type), allocatable :: records(:)
        type(receipt_type) :: receipt

        call written(ball_skin(2.0_dp), deck(), .false., text, receipt)
        records = records_of(text)
        call tap%ok(index(text, 'ISO-10303-21;'//new_line('a')) == 1 .and. index(text, &
            new_line('a')//'ENDSEC;'//new_line('a')//'END-ISO-10303-21;'//new_line('a'), &
            back=.true.) > 0, 'it begins and ends as it should')
        call tap%ok(is_sound(text, 80), 'lines, quotes and parentheses are sound')
        call tap%ok(refers_back(records), 'each reference is to an instance before')
        call tap%ok(count_of(records, 'ADVANCED_BREP_SHAPE_REPRESENTATION') == 1 .and. count_of( &
            records, 'GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION') == 1 .and. &
            count_of(records, 'MANIFOLD_SURFACE_SHAPE_REPRESENTATION') == 0, &
            'solid and curves each have their representation')
        call tap%ok(count_of(records, 'GEOMETRIC_CURVE_SET') == 2 .and. &
            count_of(records, 'PRESENTATION_LAYER_ASSIGNMENT') == 3, &
            'a cut and a line, each in its layer')
        call tap%ok(all_used(records), 'nothing is there without use')
        call tap%ok(receipt%count == 8 + 2 .and. receipt%entities(9)%name == 'STA-0' .and. &
            receipt%entities(10)%name == 'UCL', 'the receipt has faces, cuts, lines')
        call written(ball_skin(2.0_dp), deck(), .false., again, receipt)
        call tap%same(again, text, 'the same again is the same bytes')
    end subroutine check_all

    subroutine check_sheet()
        character(:), allocatable :: text
        type(record_type), allocatable :: records(:)
        type(receipt_type) :: receipt

        call written(ball_skin(2.0_dp), deck(), .true., text, receipt)
        records = records_of(text)
        call tap%ok(count_of(records, 'ADVANCED_BREP_SHAPE_REPRESENTATION') == 0 .and. &
            count_of(records, 'MANIFOLD_SURFACE_SHAPE_REPRESENTATION') == 1, &
            'an open skin is a surface model')
    end subroutine check_sheet

    subroutine check_curves_alone()
        character(:), allocatable :: text
        type(record_type), allocatable :: records(:)
        type(receipt_type) :: receipt
        type(skin_model_type) :: none

        call written(none, deck(), .false., text, receipt)
        records = records_of(text)
        call tap%ok(count_of(records, 'ADVANCED_FACE') == 0 .and. refers_back(records) .and. &
            count_of(records, 'GEOMETRIC_CURVE_SET') == 2 .and. receipt%count == 2, &
            'without a skin there are the curves')
    end subroutine check_curves_alone

    subroutine check_refusal()
        type(skin_model_type) :: none
        type(drawing_type) :: drawing
        type(settings_type) :: settings
        type(output_type) :: out
        type(receipt_type) :: receipt
        type(error_type), allocatable :: error

        drawing%deck = 'empty.crd'
        drawing%title = ''
        drawing%units = 'MM'
        allocate (drawing%cuts(0), drawing%lines(0))
        call write_step(drawing, none, settings, out, receipt, error)
        call tap%ok(allocated(error), 'nothing to export is an error')
        if (allocated(error)) call tap%ok(error%cause == cause%usage, 'of its cause')
        call tap%same(out%text(), '', 'and nothing is written')
        drawing = deck()
        drawing%units = 'CUBITS'
        call write_step(drawing, none, settings, out, receipt, error)
        call tap%ok(allocated(error), 'an unknown unit is an error')
        if (allocated(error)) call tap%has(error%message, 'CUBITS', 'which it names')
    end subroutine check_refusal

    !> The text of a file.
    subroutine written(skin, drawing, is_open, text, receipt)
        type(skin_model_type), intent(in) :: skin               !! of a body
        type(drawing_type), intent(in) :: drawing               !! of it
        logical, intent(in) :: is_open                          !! no solids
        character(:), allocatable, intent(out) :: text          !! what was written
        type(receipt_type), intent(out) :: receipt              !! of it
        type(output_type) :: out
        type(settings_type) :: settings
        type(error_type), allocatable :: error

        settings%tolerance = 0.001_dp
        settings%is_open = is_open
        call write_step(drawing, skin, settings, out, receipt, error)
        text = out%text()
        if (allocated(error)) text = 'error: '//error%message
    end subroutine written

    !> A drawing of a cut and a line.
    function deck() result(drawing)
        type(drawing_type) :: drawing
        integer :: i

        drawing%deck = 'ball.crd'
        drawing%title = 'A BALL; #1=(''NOT AN INSTANCE'');'
        drawing%units = 'FEET'
        allocate (drawing%cuts(1), drawing%lines(1))
        drawing%cuts(1)%name = 'STA-0'
        drawing%cuts(1)%title = 'STATION 0'
        drawing%cuts(1)%kind = shape_kind%station
        drawing%lines(1)%name = 'UCL'
        drawing%lines(1)%title = 'UCL'
        drawing%lines(1)%kind = shape_kind%line
        allocate (drawing%cuts(1)%contours(1), drawing%lines(1)%contours(1))
        allocate (drawing%cuts(1)%contours(1)%curves(1), drawing%lines(1)%contours(1)%curves(1))
        drawing%cuts(1)%contours(1)%curves(1)%spline = bspline_type(2, [0.0_dp, 0.0_dp, 0.0_dp, &
            1.0_dp, 1.0_dp, 1.0_dp], reshape([0.0_dp, 0.0_dp, -2.0_dp, 0.0_dp, 2.0_dp, -2.0_dp, &
            0.0_dp, 2.0_dp, 0.0_dp], [3, 3]), [1.0_dp, sqrt(0.5_dp), 1.0_dp])
        drawing%lines(1)%contours(1)%curves(1)%spline = bspline_type(1, [0.0_dp, 0.0_dp, 1.0_dp, &
            1.0_dp], reshape([(real(i, dp), i=1, 6)], [3, 2]), [1.0_dp, 1.0_dp])
    end function deck

    !> True where only what says something of the whole is not referred to.
    logical function all_used(records)
        type(record_type), intent(in) :: records(:) !! a data section
        character(:), allocatable :: text
        character(12) :: reference
        integer :: i

        text = ''
        do i = 1, size(records)
            text = text//records(i)%text//';'
        end do
        all_used = .true.
        do i = 1, size(records)
            write (reference, '(a,i0)') '#', i
            if (index(text, trim(reference)//',') + index(text, trim(reference)//')') > 0) cycle
            all_used = all_used .and. is_root(record_named(records, i))
        end do
    end function all_used

    !> True for what says something of the whole.
    pure logical function is_root(text)
        character(*), intent(in) :: text !! of an instance
        character(*), parameter :: roots(6) = [character(60) :: 'APPLICATION_PROTOCOL_DEFINITION', &
            'PRODUCT_RELATED_PRODUCT_CATEGORY', 'SHAPE_DEFINITION_REPRESENTATION', &
            'SHAPE_REPRESENTATION_RELATIONSHIP', 'PRESENTATION_LAYER_ASSIGNMENT', &
            'MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION']
        integer :: i
        is_root = any([(index(text, trim(roots(i))//'(') == 1, i=1, size(roots))])
    end function is_root

end program test_step
