!> Tests of DXF's pairs. Oracle: group codes and values of Autodesk's "DXF Reference", hand-written.
program test_dxf_tag
    use base_kinds, only: dp
    use export_dxf_tag, only: dxf_type
    use support_tap, only: tap_type
    implicit none (type, external)
    character, parameter :: nl = new_line('a')
    type(tap_type) :: tap

    call check_values()
    call check_points()
    call check_entities()
    call tap%finish()

contains

    subroutine check_values()
        type(dxf_type) :: file
        call file%tag(0, 'LINE')
        call file%tag(70, 8)
        call file%tag(1070, -3)
        call tap%same(file%out%text(), '  0'//nl//'LINE'//nl//' 70'//nl//'     8'//nl// &
            '1070'//nl//'    -3'//nl, 'texts and whole numbers, code and value on two lines')
        call check_real(12.5_dp, '12.5', 'a number as it is')
        call check_real(3.0_dp, '3.0', 'a whole value has a point')
        call check_real(-0.0_dp, '0.0', 'zero has no sign')
        call check_real(0.1_dp, '0.1', 'a tenth')
        call check_real(1.0e-10_dp, '1.0E-10', 'a power of ten has a point before it')
        call check_real(-1.25e-7_dp, '-1.25E-07', 'a small number')
        call check_real(1.0e20_dp, '1.0E+20', 'a large number')
        call check_real(1.0_dp/3.0_dp, '0.3333333333333333', 'all figures')
    end subroutine check_values

    subroutine check_real(value, expected, name)
        real(dp), intent(in) :: value           !! any
        character(*), intent(in) :: expected    !! in the file
        character(*), intent(in) :: name        !! of the check
        type(dxf_type) :: file
        call file%tag(40, value)
        call tap%same(file%out%text(), ' 40'//nl//expected//nl, name)
    end subroutine check_real

    subroutine check_points()
        type(dxf_type) :: file, other
        call file%point(10, [1.0_dp, 2.0_dp])
        call tap%same(file%out%text(), ' 10'//nl//'1.0'//nl//' 20'//nl//'2.0'//nl//' 30'//nl// &
            '0.0'//nl, 'a point of the plane is at height zero')
        call other%point(11, [1.0_dp, 2.0_dp, 3.0_dp])
        call tap%same(other%out%text(), ' 11'//nl//'1.0'//nl//' 21'//nl//'2.0'//nl//' 31'//nl// &
            '3.0'//nl, 'a point of space has three')
    end subroutine check_points

    subroutine check_entities()
        type(dxf_type) :: old, new
        call old%new('LINE', 'A')
        call old%class('AcDbLine')
        call tap%same(old%out%text(), '  0'//nl//'LINE'//nl//'  8'//nl//'A'//nl, &
            'R12 knows neither handles nor classes')
        new%has_handles = .true.
        call new%new('LINE', 'A')
        call new%class('AcDbLine')
        call tap%same(new%out%text(), '  0'//nl//'LINE'//nl//'  5'//nl//'100'//nl//'330'//nl// &
            '1F'//nl//'100'//nl//'AcDbEntity'//nl//'  8'//nl//'A'//nl//'100'//nl//'AcDbLine'// &
            nl, 'R2000 wants a handle, the owner and the classes')
        call tap%same(new%next_handle(), '101', 'the next handle is another')
        call new%section('')
        call tap%has(new%out%text(), '  0'//nl//'ENDSEC'//nl, 'a section ends')
    end subroutine check_entities

end program test_dxf_tag
