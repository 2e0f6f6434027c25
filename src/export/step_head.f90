!> What surrounds the shapes of a STEP file: the header, the product, its units and uncertainty, and
!> the representations that make shapes the product's.
!>
!> The time stamp, which a header must have, is always the first second of 1970: the same deck gives
!> the same bytes.
module export_step_head
    use base_constants, only: version
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: compact
    use base_tolerances, only: step_tolerance
    use export_drawing, only: drawing_type
    use export_step_curve, only: add_placement
    use export_step_text, only: put_statement, step_file_type, step_list, step_real, &
        step_reference, step_references, step_string
    implicit none (type, external)
    private

    public :: product_type, put_header, add_product, add_representation

    !> The application protocol: the schema AP242 and its object identifier (ISO 10303-242:2014).
    character(*), parameter :: schema = &
        'AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }'
    !> The time stamp of every file.
    character(*), parameter :: no_time = '1970-01-01T00:00:00'
    !> Millimetres of an inch and of a foot, exactly (the international ones of 1959).
    real(dp), parameter :: inch = 25.4_dp, foot = 304.8_dp

    !> Instances all shapes refer to.
    type :: product_type
        integer :: context = 0  !! units and uncertainty
        integer :: place = 0    !! axes of the body: STA, BL, WL
        integer :: shape = 0    !! the representation that the others are of the same shape as
    end type product_type

contains

    !> Puts the header and begins the data section.
    subroutine put_header(out, drawing, tolerance)
        type(output_type), intent(inout) :: out     !! where to
        type(drawing_type), intent(in) :: drawing   !! for its names and its unit
        real(dp), intent(in) :: tolerance           !! of skin and curves

        call out%line('ISO-10303-21;')
        call out%line('HEADER;')
        call put_statement(out, 'FILE_DESCRIPTION(('//step_string(title_of(drawing))//','// &
            step_string('lengths in '//drawing%units//', within '//compact(tolerance)// &
            ' of the exact shape')//'),''2;1'')')
        call put_statement(out, 'FILE_NAME('//step_string(drawing%deck)//','// &
            step_string(no_time)//',(''''),(''''),'//step_string('LOFT '//version)//','// &
            step_string('LOFT '//version)//','''')')
        call put_statement(out, 'FILE_SCHEMA(('//step_string(schema)//'))')
        call out%line('ENDSEC;')
        call out%line('DATA;')
    end subroutine put_header

    !> The title of a deck, or its file name where it has none.
    pure function title_of(drawing) result(title)
        type(drawing_type), intent(in) :: drawing !! of the deck
        character(:), allocatable :: title
        title = trim(drawing%title)
        if (len(title) == 0) title = drawing%deck
    end function title_of

    !> Adds the product, its units and its axes.
    subroutine add_product(file, drawing, product)
        type(step_file_type), intent(inout) :: file     !! gets it
        type(drawing_type), intent(in) :: drawing       !! for its names and its unit
        type(product_type), intent(out) :: product      !! instances
        integer :: application, part, definition

        call file%add('APPLICATION_CONTEXT(''managed model based 3d engineering'')', application)
        call file%add('APPLICATION_PROTOCOL_DEFINITION(''international standard'','// &
            '''ap242_managed_model_based_3d_engineering'',2014,'//step_reference(application)// &
            ')', part)
        call file%add('PRODUCT_CONTEXT('''','//step_reference(application)//',''mechanical'')', &
            part)
        call file%add('PRODUCT('//step_string(drawing%deck)//','//step_string(title_of(drawing))// &
            ',''x is STA, y is BL, z is WL'','//step_references([part])//')', part)
        call file%add('PRODUCT_RELATED_PRODUCT_CATEGORY(''part'',$,'//step_references([part])// &
            ')', definition)
        call file%add('PRODUCT_DEFINITION_FORMATION('''','''','//step_reference(part)//')', part)
        call file%add('PRODUCT_DEFINITION_CONTEXT(''part definition'','// &
            step_reference(application)//',''design'')', definition)
        call file%add('PRODUCT_DEFINITION(''design'','''','//step_reference(part)//','// &
            step_reference(definition)//')', part)
        call file%add('PRODUCT_DEFINITION_SHAPE('''','''','//step_reference(part)//')', definition)
        call add_context(file, drawing%units, product%context)
        call add_placement(file, [0.0_dp, 0.0_dp, 0.0_dp], [0.0_dp, 0.0_dp, 1.0_dp], product%place)
        call file%add('SHAPE_REPRESENTATION('//step_string(title_of(drawing))//','// &
            step_references([product%place])//','//step_reference(product%context)//')', &
            product%shape)
        call file%add('SHAPE_DEFINITION_REPRESENTATION('//step_reference(definition)//','// &
            step_reference(product%shape)//')', part)
    end subroutine add_product

    !> Adds units and uncertainty.
    subroutine add_context(file, units, number)
        type(step_file_type), intent(inout) :: file !! gets it
        character(*), intent(in) :: units           !! INCHES, MM, FEET or M
        integer, intent(out) :: number              !! of the instance
        integer :: length, plane_angle, solid_angle, uncertainty

        select case (units)
        case ('INCHES')
            call add_converted_unit(file, 'INCH', inch, length)
        case ('FEET')
            call add_converted_unit(file, 'FOOT', foot, length)
        case ('MM')
            call file%add('(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))', length)
        case default
            call file%add('(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.))', length)
        end select
        call file%add('(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))', plane_angle)
        call file%add('(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())', solid_angle)
        call file%add('UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE('//step_real(step_tolerance)// &
            '),'//step_reference(length)//',''distance_accuracy_value'','// &
            '''how far vertices, edges and faces that meet may be apart'')', uncertainty)
        call file%add('(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT('// &
            step_references([uncertainty])//')GLOBAL_UNIT_ASSIGNED_CONTEXT('// &
            step_references([length, plane_angle, solid_angle])//')REPRESENTATION_CONTEXT(''''' // &
            ',''STA, BL, WL''))', number)
    end subroutine add_context

    !> Adds a unit of length that is some millimetres long.
    subroutine add_converted_unit(file, name, length, number)
        type(step_file_type), intent(inout) :: file !! gets it
        character(*), intent(in) :: name            !! of the unit
        real(dp), intent(in) :: length              !! millimetres
        integer, intent(out) :: number              !! of the instance
        integer :: dimensions, millimetre, measure

        call file%add('DIMENSIONAL_EXPONENTS'//step_list([1.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, &
            0.0_dp, 0.0_dp]), dimensions)
        call file%add('(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))', millimetre)
        call file%add('LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE('//step_real(length)//'),'// &
            step_reference(millimetre)//')', measure)
        call file%add('(CONVERSION_BASED_UNIT('//step_string(name)//','//step_reference(measure)// &
            ')LENGTH_UNIT()NAMED_UNIT('//step_reference(dimensions)//'))', number)
    end subroutine add_converted_unit

    !> Adds a representation of the product's shape.
    subroutine add_representation(file, product, kind, items)
        type(step_file_type), intent(inout) :: file !! gets it
        type(product_type), intent(in) :: product   !! whose
        character(*), intent(in) :: kind            !! the entity
        integer, intent(in) :: items(:)             !! instances of its items; where there is none
                                                    !! nothing is added
        integer :: representation, relation

        if (size(items) == 0) return
        call file%add(kind//'('''','//step_references([product%place, items])//','// &
            step_reference(product%context)//')', representation)
        call file%add('SHAPE_REPRESENTATION_RELATIONSHIP('''','''','// &
            step_reference(product%shape)//','//step_reference(representation)//')', relation)
    end subroutine add_representation

end module export_step_head
