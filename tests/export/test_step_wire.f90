!> Cuts and control lines in STEP files.
program test_step_wire
    use base_kinds, only: dp
    use export_drawing, only: contour_type, curve_type, shape_type
    use export_receipt, only: receipt_type
    use export_step_text, only: step_file_type
    use export_step_wire, only: add_shape
    use geom_bspline, only: bspline_type
    use support_step_records, only: count_of, record_named, record_type, records_of, refers_back
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_cut()
    call check_line()
    call check_empty()
    call tap%finish()

contains

    !> Two contours: a closed one of two curves, an open one of three.
    subroutine check_cut()
        type(step_file_type) :: file
        type(record_type), allocatable :: records(:)
        type(receipt_type) :: receipt
        type(shape_type) :: shape
        integer :: number

        shape%name = 'STA-20'
        allocate (shape%contours(2))
        call draw_path([0, 1, 0], shape%contours(1))
        shape%contours(1)%is_closed = .true.
        call draw_path([2, 3, 4, 5], shape%contours(2))
        shape%contours(2)%curves(2)%is_exact = .false.
        shape%contours(2)%curves(2)%error = 2.0e-4_dp
        shape%contours(2)%curves(2)%worst = [1.0_dp, 2.0_dp, 3.0_dp]
        call add_shape(file, shape, number, receipt)
        records = records_of(file%text())
        call tap%ok(refers_back(records) .and. number == size(records), 'instances in order')
        call tap%ok(count_of(records, 'B_SPLINE_CURVE_WITH_KNOTS') == 5, 'every curve is there')
        call tap%ok(count_of(records, 'COMPOSITE_CURVE') == 2 .and. &
            count_of(records, 'COMPOSITE_CURVE_SEGMENT') == 5, 'each contour is one curve')
        call tap%ok(count_of(records, 'COMPOSITE_CURVE_SEGMENT(.DISCONTINUOUS.,.T.,#24)') == 0 &
            .and. index(record_named(records, number - 2), &
            'COMPOSITE_CURVE_SEGMENT(.DISCONTINUOUS.') == 1 .and. &
            index(record_named(records, 8), 'COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.') == 1, &
            'only an open one ends')
        call tap%same(record_named(records, 9), 'COMPOSITE_CURVE(''STA-20'',(#4,#8),.F.)', &
            'it has the name of the cut')
        call tap%ok(index(record_named(records, number), &
            'GEOMETRIC_CURVE_SET(''STA-20'',(#9,#') == 1, 'a cut is a set of curves')
        call tap%ok(receipt%count == 5 .and. receipt%entities(4)%error == 2.0e-4_dp .and. &
            .not. receipt%entities(4)%is_exact .and. receipt%entities(4)%has_place .and. &
            all(receipt%entities(4)%worst == [1.0_dp, 2.0_dp, 3.0_dp]) .and. &
            receipt%entities(3)%is_exact .and. receipt%entities(3)%name == 'STA-20' .and. &
            receipt%entities(3)%kind == 'B_SPLINE_CURVE_WITH_KNOTS' .and. &
            receipt%entities(3)%points == 2 .and. receipt%entities(3)%spans == 1, &
            'the receipt has each curve')
    end subroutine check_cut

    subroutine check_line()
        type(step_file_type) :: file
        type(record_type), allocatable :: records(:)
        type(receipt_type) :: receipt
        type(shape_type) :: shape
        integer :: number

        shape%name = 'UCL'
        allocate (shape%contours(2))
        call draw_path([0, 1], shape%contours(1))
        allocate (shape%contours(2)%curves(0))
        shape%contours(2)%at = [20.0_dp, 0.0_dp, 7.0_dp]
        call add_shape(file, shape, number, receipt)
        records = records_of(file%text())
        call tap%same(record_named(records, number), 'GEOMETRIC_CURVE_SET(''UCL'',(#3,#4))', &
            'a single curve stands alone')
        call tap%same(record_named(records, 4), 'CARTESIAN_POINT('''',(20.,0.,7.))', &
            'where there is no curve there is a point')
        call tap%ok(receipt%count == 1, 'which is no curve')
        call tap%ok(index(record_named(records, 3), 'B_SPLINE_CURVE_WITH_KNOTS(''UCL'',1,') == 1, &
            'with the name of its line')
    end subroutine check_line

    subroutine check_empty()
        type(step_file_type) :: file
        type(receipt_type) :: receipt
        type(shape_type) :: shape
        integer :: number

        shape%name = 'STA-0'
        allocate (shape%contours(0))
        call add_shape(file, shape, number, receipt)
        call tap%ok(number == 0 .and. file%text() == '' .and. receipt%count == 0, &
            'a cut that misses the body is left out')
    end subroutine check_empty

    !> A contour of straight curves from place to place on a parabola.
    subroutine draw_path(places, contour)
        integer, intent(in) :: places(:)            !! along BL
        type(contour_type), intent(inout) :: contour !! gets them
        real(dp) :: pole(3, 2)
        integer :: i

        allocate (contour%curves(size(places) - 1))
        do i = 1, size(contour%curves)
            pole(:, 1) = [20.0_dp, real(places(i), dp), real(places(i)**2, dp)]
            pole(:, 2) = [20.0_dp, real(places(i + 1), dp), real(places(i + 1)**2, dp)]
            contour%curves(i)%spline = bspline_type(1, [0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp], pole, &
                [1.0_dp, 1.0_dp])
            contour%curves(i)%is_exact = .true.
        end do
    end subroutine draw_path

end program test_step_wire
