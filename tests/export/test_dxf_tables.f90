!> Tests of the tables. Oracle: Autodesk's "DXF Reference": which tables a version needs, how many
!> records each says it has.
program test_dxf_tables
    use base_error, only: error_type
    use base_kinds, only: dp
    use export_dxf_header, only: box_type
    use export_dxf_tables, only: layer_type, put_tables
    use export_dxf_tag, only: dxf_type
    use export_units, only: find_unit, unit_type
    use support_dxf_pairs, only: numbers_of, pairs_type, read_pairs
    use support_tap, only: tap_type
    implicit none (type, external)
    type(tap_type) :: tap

    call check_tables(.false., 'R12')
    call check_tables(.true., 'R2000')
    call check_view()
    call tap%finish()

contains

    subroutine tables(has_handles, box, pairs)
        logical, intent(in) :: has_handles      !! R2000
        type(box_type), intent(in) :: box       !! of the drawing
        type(pairs_type), intent(out) :: pairs  !! of the section
        type(dxf_type) :: file
        type(unit_type) :: unit
        type(error_type), allocatable :: error

        call find_unit('MM', unit, error)
        file%has_handles = has_handles
        call put_tables(file, [layer_type('STA-1', 3, .false.), &
            layer_type('REFERENCE', 8, .true.)], box, unit)
        call read_pairs(file%out%text(), pairs)
    end subroutine tables

    subroutine check_tables(has_handles, name)
        logical, intent(in) :: has_handles      !! R2000
        character(*), intent(in) :: name        !! of the version
        type(pairs_type) :: pairs
        integer :: at

        call tables(has_handles, box_type([0.0_dp, 0.0_dp, 0.0_dp], [3.0_dp, 2.0_dp, 0.0_dp]), &
            pairs)
        call tap%ok(pairs%is_valid, name//': pairs')
        call tap%ok(pairs%entity_count('TABLE', '') == merge(9, 4, has_handles) .and. &
            pairs%entity_count('ENDTAB', '') == merge(9, 4, has_handles), &
            name//': every table begins and ends')
        call check_count(pairs, 'VPORT', name)
        call check_count(pairs, 'LTYPE', name)
        call check_count(pairs, 'LAYER', name)
        call check_count(pairs, 'STYLE', name)
        if (has_handles) then
            call check_count(pairs, 'APPID', name)
            call check_count(pairs, 'DIMSTYLE', name)
            call check_count(pairs, 'BLOCK_RECORD', name)
        end if
        at = pairs%find(2, 'STA-1', 1)
        call tap%same(pairs%text(62, at), '3', name//': a layer has its colour')
        call tap%same(pairs%text(6, at), 'CONTINUOUS', name//': full lines')
        call tap%same(pairs%text(6, pairs%find(2, 'REFERENCE', 1)), 'CENTER', &
            name//': reference lines are centre lines')
        call tap%near(sum(abs(numbers_of(pairs, 'LTYPE', 49))), 2.0_dp*25.4_dp, 1.0e-12_dp, &
            name//': whose pattern is two inches long')
    end subroutine check_tables

    !> A table says how many records it has.
    subroutine check_count(pairs, table, name)
        type(pairs_type), intent(in) :: pairs   !! of the section
        character(*), intent(in) :: table       !! its name
        character(*), intent(in) :: name        !! of the version
        integer :: said
        character(:), allocatable :: text
        text = pairs%text(70, pairs%find(2, table, 1))
        read (text, *) said
        call tap%ok(said == pairs%entity_count(table, ''), name//': records of '//table)
    end subroutine check_count

    subroutine check_view()
        type(pairs_type) :: pairs
        real(dp) :: height(1)

        call tables(.false., box_type([0.0_dp, 0.0_dp, 0.0_dp], [30.0_dp, 60.0_dp, 0.0_dp]), pairs)
        height = numbers_of(pairs, 'VPORT', 40)
        call tap%ok(height(1) > 60.0_dp .and. height(1) < 70.0_dp, &
            'the view shows all of a tall one')
        call tables(.false., box_type([0.0_dp, 0.0_dp, 0.0_dp], [300.0_dp, 60.0_dp, 0.0_dp]), pairs)
        height = numbers_of(pairs, 'VPORT', 40)
        call tap%ok(1.5_dp*height(1) > 300.0_dp .and. height(1) < 230.0_dp, 'and of a wide one')
        call tap%ok(all(abs(numbers_of(pairs, 'VPORT', 36) - [1.0_dp]) <= 0.0_dp), 'from above')
        call tables(.false., box_type([0.0_dp, 0.0_dp, 0.0_dp], [300.0_dp, 60.0_dp, 9.0_dp]), pairs)
        call tap%ok(all(abs(numbers_of(pairs, 'VPORT', 26) - [-1.0_dp]) <= 0.0_dp), &
            'a drawing in space is seen from the port side')
    end subroutine check_view

end program test_dxf_tables
