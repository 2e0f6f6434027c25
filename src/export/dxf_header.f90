!> The header of a DXF file: version, limits, units.
!>
!> Source: Autodesk, "DXF Reference" for release 12 and for AutoCAD 2000, HEADER section.
module export_dxf_header
    use base_kinds, only: dp
    use export_dxf_tag, only: dxf_type
    use export_units, only: unit_type
    implicit none (type, external)
    private

    public :: box_type, put_header

    !> What the drawing takes up.
    type :: box_type
        real(dp) :: low(3) = 0.0_dp     !! least coordinates
        real(dp) :: high(3) = 0.0_dp    !! greatest coordinates
    end type box_type

contains

    !> Puts the section HEADER. R12 has no $INSUNITS of its own; AutoCAD of that time passes over
    !> it, readers of today take the unit from it.
    subroutine put_header(file, box, unit)
        type(dxf_type), intent(inout) :: file   !! knows all handles but those of this section
        type(box_type), intent(in) :: box       !! of the drawing
        type(unit_type), intent(in) :: unit     !! of it

        call file%section('HEADER')
        call variable(file, '$ACADVER')
        call file%tag(1, trim(merge('AC1015', 'AC1009', file%has_handles)))
        call variable(file, '$DWGCODEPAGE')
        call file%tag(3, 'ANSI_1252')
        call variable(file, '$INSBASE')
        call file%point(10, [0.0_dp, 0.0_dp, 0.0_dp])
        call variable(file, '$EXTMIN')
        call file%point(10, box%low)
        call variable(file, '$EXTMAX')
        call file%point(10, box%high)
        call variable(file, '$LIMMIN')
        call file%vector(10, box%low(:2))
        call variable(file, '$LIMMAX')
        call file%vector(10, box%high(:2))
        call variable(file, '$LUNITS')
        call file%tag(70, 2)
        call variable(file, '$INSUNITS')
        call file%tag(70, unit%dxf)
        if (file%has_handles) then
            call variable(file, '$MEASUREMENT')
            call file%tag(70, merge(1, 0, unit%is_metric))
            call variable(file, '$HANDSEED')
            call file%tag(5, file%next_handle())
        end if
        call file%section('')
    end subroutine put_header

    !> Begins a variable of the header.
    subroutine variable(file, name)
        type(dxf_type), intent(inout) :: file   !! the file
        character(*), intent(in) :: name        !! with its `$`
        call file%tag(9, name)
    end subroutine variable

end module export_dxf_header
