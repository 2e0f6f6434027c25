!> Header, product and units of STEP files.
program test_step_head
    use base_constants, only: version
    use base_kinds, only: dp
    use base_output, only: output_type
    use export_drawing, only: drawing_type
    use export_step_head, only: add_product, add_representation, product_type, put_header
    use export_step_text, only: step_file_type
    use support_step_records, only: count_of, is_sound, record_named, record_type, records_of, &
        refers_back
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_header()
    call check_product()
    call check_unit('INCHES', 'INCH', '25.4')
    call check_unit('FEET', 'FOOT', '304.8')
    call check_metric('MM', '(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))')
    call check_metric('M', '(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.))')
    call check_representation()
    call tap%finish()

contains

    subroutine check_header()
        type(output_type) :: out

        call put_header(out, deck_of('MM', 'FIN  '), 0.001_dp)
        call tap%has(out%text(), 'FILE_NAME(''fin.crd'',''1970-01-01T00:00:00'',(''''),(''''),'// &
            '''LOFT '//version//'''', 'the deck, and a time that never changes')
        call tap%ok(index(out%text(), 'ISO-10303-21;'//new_line('a')//'HEADER;'//new_line('a')// &
            'FILE_DESCRIPTION((''FIN'',''lengths in MM, within 0.001 of the exact shape''),'// &
            '''2;1'');') == 1, 'the title without blanks behind it, what is stated')
        call tap%has(out%text(), 'FILE_SCHEMA((''AP242_MANAGED_MODEL_BASED_3D_'// &
            'ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }''));', 'the schema')
        call tap%ok(is_sound(out%text(), 80), 'lines and quotes are sound')
    end subroutine check_header

    subroutine check_product()
        type(step_file_type) :: file
        type(record_type), allocatable :: records(:)
        type(product_type) :: product

        call add_product(file, deck_of('MM', ''), product)
        records = records_of(file%text())
        call tap%ok(refers_back(records), 'instances in order')
        call tap%has(file%text(), 'PRODUCT(''fin.crd'',''fin.crd'',''x is STA, y is BL, z '// &
            'is WL''',             'a deck without title goes by its file name')
        call tap%ok(count_of(records, 'PRODUCT_DEFINITION_SHAPE') == 1 .and. &
            count_of(records, 'SHAPE_DEFINITION_REPRESENTATION') == 1, 'one product, one shape')
        call tap%has(file%text(), 'LENGTH_MEASURE(1.E-07)', 'edges meet but for rounding')
        call tap%ok(index(record_named(records, product%context), &
            'GEOMETRIC_REPRESENTATION_CONTEXT(3)') > 0 .and. &
            index(record_named(records, product%shape), 'SHAPE_REPRESENTATION(') == 1 .and. &
            index(record_named(records, product%place), 'AXIS2_PLACEMENT_3D(') == 1, &
            'what others refer to is what it is called')
    end subroutine check_product

    !> A unit that is some millimetres long.
    subroutine check_unit(unit, name, millimetres)
        character(*), intent(in) :: unit        !! of the drawing
        character(*), intent(in) :: name        !! in STEP
        character(*), intent(in) :: millimetres !! as written
        type(step_file_type) :: file
        type(product_type) :: product

        call add_product(file, deck_of(unit, ''), product)
        call tap%has(file%text(), '=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE('//millimetres// &
            '),#11);', unit//': how many millimetres it has')
        call tap%has(file%text(), '#11=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));', &
            unit//': which are millimetres')
        call tap%has(file%text(), '#13=(CONVERSION_BASED_UNIT('''//name// &
            ''',#12)LENGTH_UNIT()NAMED_UNIT(#10));', unit//': its name')
        call tap%has(file%text(), 'GLOBAL_UNIT_ASSIGNED_CONTEXT((#13,', unit//': of all lengths')
    end subroutine check_unit

    !> A unit of the metric system.
    subroutine check_metric(unit, record)
        character(*), intent(in) :: unit    !! of the drawing
        character(*), intent(in) :: record  !! in STEP
        type(step_file_type) :: file
        type(product_type) :: product

        call add_product(file, deck_of(unit, ''), product)
        call tap%has(file%text(), '#10='//record, unit//': its name')
        call tap%has(file%text(), 'GLOBAL_UNIT_ASSIGNED_CONTEXT((#10,', unit//': of all lengths')
    end subroutine check_metric

    subroutine check_representation()
        type(step_file_type) :: file
        type(record_type), allocatable :: records(:)
        type(product_type) :: product
        integer :: before

        call add_product(file, deck_of('MM', ''), product)
        records = records_of(file%text())
        before = size(records)
        call add_representation(file, product, 'ADVANCED_BREP_SHAPE_REPRESENTATION', [integer ::])
        records = records_of(file%text())
        call tap%ok(size(records) == before, 'without items there is no representation')
        call add_representation(file, product, 'ADVANCED_BREP_SHAPE_REPRESENTATION', [3, 4])
        records = records_of(file%text())
        call tap%has(record_named(records, before + 1), &
            'ADVANCED_BREP_SHAPE_REPRESENTATION('''',(#', 'a representation of items')
        call tap%has(record_named(records, before + 1), ',#3,#4),#', 'with its axes before them')
        call tap%has(record_named(records, before + 2), 'SHAPE_REPRESENTATION_RELATIONSHIP(', &
            'belongs to the product')
    end subroutine check_representation

    !> A drawing without shapes.
    type(drawing_type) function deck_of(units, title) result(drawing)
        character(*), intent(in) :: units !! of it
        character(*), intent(in) :: title !! of it
        drawing%deck = 'fin.crd'
        drawing%title = title
        drawing%units = units
    end function deck_of

end program test_step_head
