!> What stands around the tables and entities of an R2000 file and R12 does not know: classes,
!> blocks of model and paper, and the objects: the root dictionary with groups, layouts and plot
!> styles.
!>
!> Source: Autodesk, "DXF Reference" for AutoCAD 2000, CLASSES, BLOCKS and OBJECTS sections.
module export_dxf_objects
    use base_kinds, only: dp
    use export_dxf_tag, only: dxf_type, model_layout, model_space, paper_layout, paper_space, &
        plot_style
    implicit none (type, external)
    private

    public :: put_classes, put_blocks, put_objects

    !> Handles of the dictionaries.
    character(*), parameter :: root = 'C', groups = 'D', plot_styles = 'E', layouts = '1A'

contains

    !> Puts the section CLASSES: of the objects that release 14 did not have.
    subroutine put_classes(file)
        type(dxf_type), intent(inout) :: file   !! the file
        if (.not. file%has_handles) return
        call file%section('CLASSES')
        call put_object_class(file, 'ACDBDICTIONARYWDFLT', 'AcDbDictionaryWithDefault')
        call put_object_class(file, 'ACDBPLACEHOLDER', 'AcDbPlaceHolder')
        call put_object_class(file, 'LAYOUT', 'AcDbLayout')
        call file%section('')
    end subroutine put_classes

    !> Puts the class of an object.
    subroutine put_object_class(file, record, class)
        type(dxf_type), intent(inout) :: file   !! of R2000
        character(*), intent(in) :: record      !! its name in the file
        character(*), intent(in) :: class       !! its name in C++
        call file%tag(0, 'CLASS')
        call file%tag(1, record)
        call file%tag(2, class)
        call file%tag(3, 'ObjectDBX Classes')
        call file%tag(90, 0)
        call file%tag(280, 0)
        call file%tag(281, 0)
    end subroutine put_object_class

    !> Puts the section BLOCKS, which in R12 is empty and left out.
    subroutine put_blocks(file)
        type(dxf_type), intent(inout) :: file   !! the file
        if (.not. file%has_handles) return
        call file%section('BLOCKS')
        call put_block(file, '*Model_Space', model_space)
        call put_block(file, '*Paper_Space', paper_space)
        call file%section('')
    end subroutine put_blocks

    !> Puts a block without entities of its own.
    subroutine put_block(file, name, record)
        type(dxf_type), intent(inout) :: file   !! of R2000
        character(*), intent(in) :: name        !! of the block
        character(*), intent(in) :: record      !! handle of its record
        call begin_part(file, 'BLOCK', 'AcDbBlockBegin', record)
        call file%tag(2, name)
        call file%tag(70, 0)
        call file%point(10, [0.0_dp, 0.0_dp, 0.0_dp])
        call file%tag(3, name)
        call file%tag(1, '')
        call begin_part(file, 'ENDBLK', 'AcDbBlockEnd', record)
    end subroutine put_block

    !> Begins the begin or the end of a block.
    subroutine begin_part(file, kind, class, record)
        type(dxf_type), intent(inout) :: file   !! of R2000
        character(*), intent(in) :: kind        !! BLOCK or ENDBLK
        character(*), intent(in) :: class       !! of it
        character(*), intent(in) :: record      !! handle of the block's record
        call file%tag(0, kind)
        call file%tag(5, file%next_handle())
        call file%tag(330, record)
        call file%class('AcDbEntity')
        call file%tag(8, '0')
        call file%class(class)
    end subroutine begin_part

    !> Puts the section OBJECTS.
    subroutine put_objects(file)
        type(dxf_type), intent(inout) :: file   !! the file

        if (.not. file%has_handles) return
        call file%section('OBJECTS')
        call begin_dictionary(file, root, '0')
        call entry(file, 'ACAD_GROUP', groups)
        call entry(file, 'ACAD_LAYOUT', layouts)
        call entry(file, 'ACAD_PLOTSTYLENAME', plot_styles)
        call begin_dictionary(file, groups, root)
        call begin_dictionary(file, layouts, root)
        call entry(file, 'Layout1', paper_layout)
        call entry(file, 'Model', model_layout)
        call begin_object(file, 'ACDBDICTIONARYWDFLT', plot_styles, root)
        call file%class('AcDbDictionary')
        call file%tag(281, 1)
        call entry(file, 'Normal', plot_style)
        call file%class('AcDbDictionaryWithDefault')
        call file%tag(340, plot_style)
        call begin_object(file, 'ACDBPLACEHOLDER', plot_style, plot_styles)
        call put_layout(file, model_layout, 'Model', model_space)
        call put_layout(file, paper_layout, 'Layout1', paper_space)
        call file%section('')
    end subroutine put_objects

    !> Begins an object.
    subroutine begin_object(file, kind, handle, owner)
        type(dxf_type), intent(inout) :: file   !! of R2000
        character(*), intent(in) :: kind        !! DICTIONARY...
        character(*), intent(in) :: handle      !! of it
        character(*), intent(in) :: owner       !! handle of what it belongs to
        call file%tag(0, kind)
        call file%tag(5, handle)
        call file%tag(330, owner)
    end subroutine begin_object

    !> Begins a dictionary.
    subroutine begin_dictionary(file, handle, owner)
        type(dxf_type), intent(inout) :: file   !! of R2000
        character(*), intent(in) :: handle      !! of it
        character(*), intent(in) :: owner       !! handle of what it belongs to
        call begin_object(file, 'DICTIONARY', handle, owner)
        call file%class('AcDbDictionary')
        call file%tag(281, 1)
    end subroutine begin_dictionary

    !> Puts an entry of a dictionary.
    subroutine entry(file, name, handle)
        type(dxf_type), intent(inout) :: file   !! of R2000
        character(*), intent(in) :: name        !! of the entry
        character(*), intent(in) :: handle      !! what it stands for
        call file%tag(3, name)
        call file%tag(350, handle)
    end subroutine entry

    !> Puts the layout of a block, which has no page set up.
    subroutine put_layout(file, handle, name, block)
        type(dxf_type), intent(inout) :: file   !! of R2000
        character(*), intent(in) :: handle      !! of it
        character(*), intent(in) :: name        !! of it
        character(*), intent(in) :: block       !! handle of the block's record
        logical :: is_model

        is_model = block == model_space
        call begin_object(file, 'LAYOUT', handle, layouts)
        call file%class('AcDbPlotSettings')
        call file%tag(1, '')
        call file%tag(70, merge(1024, 0, is_model))
        call file%class('AcDbLayout')
        call file%tag(1, name)
        call file%tag(70, 1)
        call file%tag(71, merge(0, 1, is_model))
        call file%tag(330, block)
    end subroutine put_layout

end module export_dxf_objects
