!> Layers and colours of a STEP file (ISO 10303-46): a layer for the skin and for each cut and
!> control line, a colour for each kind of them.
module export_step_style
    use base_kinds, only: dp
    use export_drawing, only: shape_kind
    use export_step_head, only: product_type
    use export_step_text, only: step_file_type, step_list, step_real, step_reference, &
        step_references, step_string
    implicit none (type, external)
    private

    public :: palette_type

    !> Red, green and blue of the kinds of shape, in the order of `shape_kind`, and of the skin.
    real(dp), parameter :: colour(3, shape_kind%card) = reshape([ &
        0.0_dp, 0.25_dp, 0.7_dp, 0.7_dp, 0.1_dp, 0.1_dp, 0.0_dp, 0.45_dp, 0.2_dp, &
        0.5_dp, 0.0_dp, 0.5_dp, 0.5_dp, 0.0_dp, 0.5_dp, 0.1_dp, 0.1_dp, 0.1_dp, &
        0.0_dp, 0.25_dp, 0.7_dp], [3, shape_kind%card])
    real(dp), parameter :: skin_colour(3) = [0.75_dp, 0.8_dp, 0.85_dp]
    !> Width of curves on a screen, in units of length, which readers make a hairline.
    real(dp), parameter :: hairline = 0.01_dp

    !> Styles, each added when it is first used, and what has them.
    type :: palette_type
        private
        integer :: skin = 0                     !! instance of the style of the skin; 0: none yet
        integer :: curve(shape_kind%card) = 0   !! and of the kinds of shape
        integer, allocatable :: styled(:)       !! instances of items with a style
    contains
        procedure :: paint_skin
        procedure :: paint_shape
        procedure :: finish
        procedure, private :: paint
    end type palette_type

contains

    !> Adds a colour.
    subroutine add_colour(file, parts, number)
        type(step_file_type), intent(inout) :: file     !! gets it
        real(dp), intent(in) :: parts(3)                !! red, green, blue: 0 to 1
        integer, intent(out) :: number                  !! of the instance
        character(:), allocatable :: list

        list = step_list(parts)
        call file%add('COLOUR_RGB('''','//list(2:), number)
    end subroutine add_colour

    !> Adds the style of the skin, both of its sides.
    subroutine add_skin_style(file, number)
        type(step_file_type), intent(inout) :: file     !! gets it
        integer, intent(out) :: number                  !! of the instance
        integer :: part

        call add_colour(file, skin_colour, part)
        call file%add('FILL_AREA_STYLE_COLOUR('''','//step_reference(part)//')', part)
        call file%add('FILL_AREA_STYLE('''','//step_references([part])//')', part)
        call file%add('SURFACE_STYLE_FILL_AREA('//step_reference(part)//')', part)
        call file%add('SURFACE_SIDE_STYLE('''','//step_references([part])//')', part)
        call file%add('SURFACE_STYLE_USAGE(.BOTH.,'//step_reference(part)//')', part)
        call file%add('PRESENTATION_STYLE_ASSIGNMENT('//step_references([part])//')', number)
    end subroutine add_skin_style

    !> Adds the style of a kind of curves.
    subroutine add_curve_style(file, parts, number)
        type(step_file_type), intent(inout) :: file     !! gets it
        real(dp), intent(in) :: parts(3)                !! red, green, blue: 0 to 1
        integer, intent(out) :: number                  !! of the instance
        integer :: font, part

        call file%add('DRAUGHTING_PRE_DEFINED_CURVE_FONT(''continuous'')', font)
        call add_colour(file, parts, part)
        call file%add('CURVE_STYLE('''','//step_reference(font)//',POSITIVE_LENGTH_MEASURE('// &
            step_real(hairline)//'),'//step_reference(part)//')', part)
        call file%add('PRESENTATION_STYLE_ASSIGNMENT('//step_references([part])//')', number)
    end subroutine add_curve_style

    !> Gives skins their colour and puts them into a layer.
    subroutine paint_skin(palette, file, items)
        class(palette_type), intent(inout) :: palette   !! the styles
        type(step_file_type), intent(inout) :: file     !! of the items
        integer, intent(in) :: items(:)                 !! their instances, may be none
        integer :: i, layer

        if (size(items) == 0) return
        if (palette%skin == 0) call add_skin_style(file, palette%skin)
        do i = 1, size(items)
            call palette%paint(file, palette%skin, items(i))
        end do
        call file%add('PRESENTATION_LAYER_ASSIGNMENT(''SKIN'','''','//step_references(items)//')', &
            layer)
    end subroutine paint_skin

    !> Gives a cut or a control line its colour and its own layer.
    subroutine paint_shape(palette, file, kind, name, title, item)
        class(palette_type), intent(inout) :: palette   !! the styles
        type(step_file_type), intent(inout) :: file     !! of the item
        integer, intent(in) :: kind                     !! one of `shape_kind%...`
        character(*), intent(in) :: name                !! of the layer
        character(*), intent(in) :: title               !! what it is: any bytes
        integer, intent(in) :: item                     !! its instance
        integer :: layer

        if (palette%curve(kind) == 0) &
            call add_curve_style(file, colour(:, kind), palette%curve(kind))
        call palette%paint(file, palette%curve(kind), item)
        call file%add('PRESENTATION_LAYER_ASSIGNMENT('//step_string(name)//','// &
            step_string(title)//','//step_references([item])//')', layer)
    end subroutine paint_shape

    !> Gives an item a style.
    subroutine paint(palette, file, style, item)
        class(palette_type), intent(inout) :: palette   !! remembers it
        type(step_file_type), intent(inout) :: file     !! of the item
        integer, intent(in) :: style                    !! instance
        integer, intent(in) :: item                     !! instance
        integer :: styled

        call file%add('STYLED_ITEM('''','//step_references([style])//','//step_reference(item)// &
            ')', styled)
        if (.not. allocated(palette%styled)) allocate (palette%styled(0))
        palette%styled = [palette%styled, styled]
    end subroutine paint

    !> Adds the presentation of all that has a style.
    subroutine finish(palette, file, product)
        class(palette_type), intent(in) :: palette      !! the styles
        type(step_file_type), intent(inout) :: file     !! of the items
        type(product_type), intent(in) :: product       !! for its units
        integer :: number

        if (.not. allocated(palette%styled)) return
        call file%add('MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('''','// &
            step_references(palette%styled)//','//step_reference(product%context)//')', number)
    end subroutine finish

end module export_step_style
