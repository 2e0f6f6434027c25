!> The tables of a DXF file: viewport, line types, layers, text style. R12 needs these, R2000 all
!> that there are, each entry with its handle.
!>
!> Source: Autodesk, "DXF Reference" for release 12 and for AutoCAD 2000, TABLES section.
module export_dxf_tables
    use base_kinds, only: dp
    use export_dxf_header, only: box_type
    use export_dxf_tag, only: dxf_type, model_layout, model_space, paper_layout, paper_space, &
        plot_style
    use export_dxf_text, only: name_length
    use export_units, only: unit_type
    implicit none (type, external)
    private

    public :: layer_type, put_tables

    !> A layer.
    type :: layer_type
        character(name_length) :: name = ''      !! capitals, figures, `$`, `-`, `_`
        integer :: colour = 7           !! of AutoCAD's colours: 1 red ... 7 white or black
        logical :: is_chained = .false. !! lines as centre lines
    end type layer_type

    !> Name of the line type of centre lines, and its dashes and gaps in inches.
    character(*), parameter :: centre_line = 'CENTER'
    real(dp), parameter :: dashes(4) = [1.25_dp, -0.25_dp, 0.25_dp, -0.25_dp]
    !> Handle of the table of blocks.
    character(*), parameter :: of_blocks = '1'
    !> A text style that every reader has.
    character(*), parameter :: style = 'STANDARD'

contains

    !> Puts the section TABLES.
    subroutine put_tables(file, layers, box, unit)
        type(dxf_type), intent(inout) :: file       !! the file
        type(layer_type), intent(in) :: layers(:)   !! all but the layer 0
        type(box_type), intent(in) :: box           !! of the drawing
        type(unit_type), intent(in) :: unit         !! of it

        call file%section('TABLES')
        call put_view(file, box)
        call put_line_types(file, unit)
        call put_layers(file, layers)
        call begin_table(file, 'STYLE', '3', 1)
        call begin_record(file, 'STYLE', '3', 'AcDbTextStyleTableRecord', style)
        call file%tag(40, 0.0_dp)
        call file%tag(41, 1.0_dp)
        call file%tag(50, 0.0_dp)
        call file%tag(71, 0)
        call file%tag(42, 1.0_dp)
        call file%tag(3, 'txt')
        call file%tag(4, '')
        call end_table(file)
        if (file%has_handles) call put_new_tables(file)
        call file%section('')
    end subroutine put_tables

    !> Puts the tables that only R2000 needs.
    subroutine put_new_tables(file)
        type(dxf_type), intent(inout) :: file   !! of R2000

        call begin_table(file, 'VIEW', '6', 0)
        call end_table(file)
        call begin_table(file, 'UCS', '7', 0)
        call end_table(file)
        call begin_table(file, 'APPID', '9', 1)
        call begin_record(file, 'APPID', '9', 'AcDbRegAppTableRecord', 'ACAD')
        call end_table(file)
        call begin_table(file, 'DIMSTYLE', 'A', 1)
        call file%class('AcDbDimStyleTable')
        call begin_record(file, 'DIMSTYLE', 'A', 'AcDbDimStyleTableRecord', style)
        call end_table(file)
        call begin_table(file, 'BLOCK_RECORD', of_blocks, 2)
        call put_record_of(file, '*Model_Space', model_space, model_layout)
        call put_record_of(file, '*Paper_Space', paper_space, paper_layout)
        call end_table(file)
    end subroutine put_new_tables

    !> Puts the record of a block.
    subroutine put_record_of(file, name, handle, layout)
        type(dxf_type), intent(inout) :: file   !! of R2000
        character(*), intent(in) :: name        !! of the block
        character(*), intent(in) :: handle      !! of the record
        character(*), intent(in) :: layout      !! handle of its layout
        call file%tag(0, 'BLOCK_RECORD')
        call file%tag(5, handle)
        call file%tag(330, of_blocks)
        call file%class('AcDbSymbolTableRecord')
        call file%class('AcDbBlockTableRecord')
        call file%tag(2, name)
        call file%tag(340, layout)
    end subroutine put_record_of

    !> Begins a table.
    subroutine begin_table(file, name, handle, count)
        type(dxf_type), intent(inout) :: file   !! the file
        character(*), intent(in) :: name        !! of the table
        character(*), intent(in) :: handle      !! of the table
        integer, intent(in) :: count            !! of its records
        call file%tag(0, 'TABLE')
        call file%tag(2, name)
        if (file%has_handles) then
            call file%tag(5, handle)
            call file%tag(330, '0')
        end if
        call file%class('AcDbSymbolTable')
        call file%tag(70, count)
    end subroutine begin_table

    !> Begins a record of a table, whose flags are none.
    subroutine begin_record(file, kind, table, class, name)
        type(dxf_type), intent(inout) :: file   !! the file
        character(*), intent(in) :: kind        !! LAYER, STYLE...
        character(*), intent(in) :: table       !! handle of the table
        character(*), intent(in) :: class       !! of the record
        character(*), intent(in) :: name        !! of the record
        call file%tag(0, kind)
        if (file%has_handles) then
            call file%tag(merge(105, 5, kind == 'DIMSTYLE'), file%next_handle())
            call file%tag(330, table)
        end if
        call file%class('AcDbSymbolTableRecord')
        call file%class(class)
        call file%tag(2, name)
        call file%tag(70, 0)
    end subroutine begin_record

    !> Ends a table.
    subroutine end_table(file)
        type(dxf_type), intent(inout) :: file   !! the file
        call file%tag(0, 'ENDTAB')
    end subroutine end_table

    !> Puts the one viewport, so that the drawing fills it: seen from above, or from the port side
    !> where it stands in space.
    subroutine put_view(file, box)
        type(dxf_type), intent(inout) :: file   !! the file
        type(box_type), intent(in) :: box       !! of the drawing
        real(dp), parameter :: ratio = 1.5_dp, margin = 1.1_dp
        real(dp) :: size_of(3), centre(3)
        logical :: is_flat
        integer :: up

        is_flat = .not. box%high(3) > box%low(3)
        up = merge(2, 3, is_flat)
        size_of = max(box%high - box%low, spacing(maxval(abs([box%low, box%high]))))
        centre = box%low + 0.5_dp*(box%high - box%low)
        call begin_table(file, 'VPORT', '8', 1)
        call begin_record(file, 'VPORT', '8', 'AcDbViewportTableRecord', '*ACTIVE')
        call file%vector(10, [0.0_dp, 0.0_dp])
        call file%vector(11, [1.0_dp, 1.0_dp])
        call file%vector(12, [centre(1), centre(up)])
        call file%vector(13, [0.0_dp, 0.0_dp])
        call file%vector(14, [1.0_dp, 1.0_dp])
        call file%vector(15, [1.0_dp, 1.0_dp])
        call file%vector(16, merge([0.0_dp, 0.0_dp, 1.0_dp], [0.0_dp, -1.0_dp, 0.0_dp], is_flat))
        call file%vector(17, [0.0_dp, 0.0_dp, 0.0_dp])
        call file%tag(40, margin*max(size_of(up), size_of(1)/ratio))
        call file%tag(41, ratio)
        call end_table(file)
    end subroutine put_view

    !> Puts the line types.
    subroutine put_line_types(file, unit)
        type(dxf_type), intent(inout) :: file   !! the file
        type(unit_type), intent(in) :: unit     !! of the drawing
        integer :: i

        call begin_table(file, 'LTYPE', '5', merge(4, 2, file%has_handles))
        if (file%has_handles) then
            call put_line_type(file, 'ByBlock', '', [real(dp) ::])
            call put_line_type(file, 'ByLayer', '', [real(dp) ::])
        end if
        call put_line_type(file, 'CONTINUOUS', 'Solid line', [real(dp) ::])
        call put_line_type(file, centre_line, '____ _ ____ _ ____', &
            [(dashes(i)*unit%inch, i=1, size(dashes))])
        call end_table(file)
    end subroutine put_line_types

    !> Puts a line type.
    subroutine put_line_type(file, name, looks, pattern)
        type(dxf_type), intent(inout) :: file   !! the file
        character(*), intent(in) :: name        !! of the line type
        character(*), intent(in) :: looks       !! what it looks like
        real(dp), intent(in) :: pattern(:)      !! dashes, and gaps below zero
        integer :: i

        call begin_record(file, 'LTYPE', '5', 'AcDbLinetypeTableRecord', name)
        call file%tag(3, looks)
        call file%tag(72, 65)
        call file%tag(73, size(pattern))
        call file%tag(40, sum(abs(pattern)))
        do i = 1, size(pattern)
            call file%tag(49, pattern(i))
            if (file%has_handles) call file%tag(74, 0)
        end do
    end subroutine put_line_type

    !> Puts the layers, the layer 0 first.
    subroutine put_layers(file, layers)
        type(dxf_type), intent(inout) :: file       !! the file
        type(layer_type), intent(in) :: layers(:)   !! all but the layer 0
        integer :: i

        call begin_table(file, 'LAYER', '2', size(layers) + 1)
        call put_layer(file, layer_type('0'))
        do i = 1, size(layers)
            call put_layer(file, layers(i))
        end do
        call end_table(file)
    end subroutine put_layers

    !> Puts a layer.
    subroutine put_layer(file, layer)
        type(dxf_type), intent(inout) :: file   !! the file
        type(layer_type), intent(in) :: layer   !! the layer
        call begin_record(file, 'LAYER', '2', 'AcDbLayerTableRecord', trim(layer%name))
        call file%tag(62, layer%colour)
        call file%tag(6, trim(merge(centre_line//'    ', 'CONTINUOUS', layer%is_chained)))
        if (file%has_handles) then
            call file%tag(370, -3)
            call file%tag(390, plot_style)
        end if
    end subroutine put_layer

end module export_dxf_tables
