!> Layers and colours of STEP files.
program test_step_style
    use export_drawing, only: shape_kind
    use export_step_head, only: product_type
    use export_step_style, only: palette_type
    use export_step_text, only: step_file_type
    use support_step_records, only: count_of, record_named, record_type, records_of, refers_back
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(step_file_type) :: file
    type(palette_type) :: palette
    type(product_type) :: product
    type(record_type), allocatable :: records(:)
    integer :: i, item

    do i = 1, 5
        call file%add('CARTESIAN_POINT('''',(0.,0.,0.))', item)
    end do
    product%context = 5
    call palette%paint_skin(file, [integer ::])
    call palette%finish(file, product)
    records = records_of(file%text())
    call tap%ok(size(records) == 5, 'where nothing is painted there are no styles')

    call palette%paint_skin(file, [1, 2])
    call palette%paint_shape(file, shape_kind%station, 'STA-20', 'STATION 20', 3)
    call palette%paint_shape(file, shape_kind%line, 'UCL', 'it''s', 4)
    call palette%paint_shape(file, shape_kind%station, 'STA-40', 'STATION 40', 4)
    call palette%finish(file, product)
    records = records_of(file%text())
    call tap%ok(refers_back(records), 'instances in order')
    call tap%ok(count_of(records, 'PRESENTATION_STYLE_ASSIGNMENT') == 3 .and. &
        count_of(records, 'CURVE_STYLE') == 2, 'a style for each kind that is there')
    call tap%ok(count_of(records, 'STYLED_ITEM') == 5, 'each item has its style')
    call tap%same(last_with('PRESENTATION_LAYER_ASSIGNMENT(''SKIN'''), &
        'PRESENTATION_LAYER_ASSIGNMENT(''SKIN'','''',(#1,#2))', 'the skin has one layer')
    call tap%same(last_with('PRESENTATION_LAYER_ASSIGNMENT(''STA-20'''), &
        'PRESENTATION_LAYER_ASSIGNMENT(''STA-20'',''STATION 20'',(#3))', &
        'a cut has its own, with its title')
    call tap%same(last_with('PRESENTATION_LAYER_ASSIGNMENT(''UCL'''), &
        'PRESENTATION_LAYER_ASSIGNMENT(''UCL'',''it''''s'',(#4))', 'so has a line')
    call tap%ok(style(1) == style(2) .and. style(1) /= style(3) .and. style(3) /= style(4) .and. &
        style(3) == style(5), 'kinds differ in style')
    call tap%same(last_with('MECHANICAL_DESIGN'), &
        'MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('''','//all_styled()//',#5)', &
        'all that are painted are presented')
    call tap%finish()

contains

    !> The style of a styled item, by its place among them.
    function style(which)
        integer, intent(in) :: which !! 1 for the first
        character(:), allocatable :: style
        integer :: number, met
        met = 0
        do number = 1, size(records)
            if (index(records(number)%text, 'STYLED_ITEM(') /= 1) cycle
            met = met + 1
            if (met == which) exit
        end do
        style = record_named(records, number)
        style = style(index(style, '(#'):index(style, ')'))
    end function style

    !> All styled items, in parentheses.
    function all_styled() result(list)
        character(:), allocatable :: list
        character(8) :: digits
        integer :: number
        list = ''
        do number = 1, size(records)
            if (index(records(number)%text, 'STYLED_ITEM(') /= 1) cycle
            write (digits, '(i0)') number
            list = list//',#'//trim(digits)
        end do
        list = '('//list(2:)//')'
    end function all_styled

    !> The last instance that begins so.
    function last_with(words)
        character(*), intent(in) :: words !! its beginning
        character(:), allocatable :: last_with
        integer :: number
        last_with = ''
        do number = 1, size(records)
            if (index(records(number)%text, words) == 1) last_with = record_named(records, number)
        end do
    end function last_with

end program test_step_style
