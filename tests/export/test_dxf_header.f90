!> Tests of the header. Oracle: Autodesk's "DXF Reference".
program test_dxf_header
    use base_error, only: error_type
    use base_kinds, only: dp
    use export_dxf_header, only: box_type, put_header
    use export_dxf_tag, only: dxf_type
    use export_units, only: find_unit, unit_type
    use support_dxf_pairs, only: pairs_type, read_pairs
    use support_tap, only: tap_type
    implicit none (type, external)
    type(box_type), parameter :: box = box_type([-1.0_dp, -2.0_dp, 0.0_dp], &
        [3.0_dp, 4.0_dp, 5.0_dp])
    type(tap_type) :: tap

    call check_version(.false., 'AC1009', 'R12')
    call check_version(.true., 'AC1015', 'R2000')
    call tap%finish()

contains

    subroutine check_version(has_handles, version, name)
        logical, intent(in) :: has_handles      !! R2000
        character(*), intent(in) :: version     !! as $ACADVER has it
        character(*), intent(in) :: name        !! of the version
        type(dxf_type) :: file
        type(pairs_type) :: pairs
        type(unit_type) :: unit
        type(error_type), allocatable :: error

        call find_unit('MM', unit, error)
        file%has_handles = has_handles
        file%handle = 4095
        call put_header(file, box, unit)
        call read_pairs(file%out%text(), pairs)
        call tap%ok(pairs%is_valid, name//': pairs')
        call tap%same(value_of(pairs, '$ACADVER', 1), version, name//': its number')
        call tap%same(value_of(pairs, '$INSUNITS', 70), '4', name//': millimetres')
        call tap%same(value_of(pairs, '$EXTMIN', 20), '-2.0', name//': least ordinate')
        call tap%same(value_of(pairs, '$EXTMAX', 30), '5.0', name//': greatest height')
        call tap%same(value_of(pairs, '$LIMMAX', 10), '3.0', name//': limit')
        if (has_handles) then
            call tap%same(value_of(pairs, '$MEASUREMENT', 70), '1', name//': metric')
            call tap%same(value_of(pairs, '$HANDSEED', 5), 'FFF', name//': the next free handle')
        else
            call tap%ok(pairs%find(9, '$MEASUREMENT', 1) == 0, name//': knows no $MEASUREMENT')
        end if
        call tap%ok(pairs%code(pairs%count) == 0 .and. pairs%value(pairs%count) == 'ENDSEC', &
            name//': the section ends')
    end subroutine check_version

    !> The value of a variable of the header.
    function value_of(pairs, variable, code) result(value)
        type(pairs_type), intent(in) :: pairs   !! of the header
        character(*), intent(in) :: variable    !! with its `$`
        integer, intent(in) :: code             !! group code
        character(:), allocatable :: value
        value = pairs%text(code, pairs%find(9, variable, 1))
    end function value_of

end program test_dxf_header
