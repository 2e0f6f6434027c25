!> Tests of what R2000 wants beside the entities. Oracle: Autodesk's "DXF Reference" for AutoCAD
!> 2000: every handle that is pointed to belongs to something.
program test_dxf_objects
    use export_dxf_objects, only: put_blocks, put_classes, put_objects
    use export_dxf_tag, only: dxf_type, model_layout, model_space, paper_layout, paper_space
    use support_dxf_pairs, only: pairs_type, read_pairs
    use support_tap, only: tap_type
    implicit none (type, external)
    type(tap_type) :: tap

    call check_old()
    call check_new()
    call tap%finish()

contains

    subroutine check_old()
        type(dxf_type) :: file
        call put_classes(file)
        call put_blocks(file)
        call put_objects(file)
        call tap%same(file%out%text(), '', 'R12 has none of it')
    end subroutine check_old

    subroutine check_new()
        type(dxf_type) :: file
        type(pairs_type) :: pairs
        logical :: are_there
        integer :: i, first

        file%has_handles = .true.
        call put_classes(file)
        call put_blocks(file)
        call put_objects(file)
        call read_pairs(file%out%text(), pairs)
        call tap%ok(pairs%is_valid, 'pairs')
        call tap%ok(pairs%entity_count('SECTION', '') == 3 .and. &
            pairs%entity_count('ENDSEC', '') == 3, 'three sections')
        call tap%ok(pairs%entity_count('BLOCK', '') == 2 .and. &
            pairs%entity_count('ENDBLK', '') == 2, 'blocks of model and paper')
        first = pairs%find(2, 'OBJECTS', 1) + 1
        call tap%same(trim(pairs%value(first)), 'DICTIONARY', 'the root dictionary comes first')
        call tap%same(pairs%text(330, first), '0', 'and belongs to nothing')
        are_there = .true.
        do i = first, pairs%count
            if (pairs%code(i) /= 350 .and. pairs%code(i) /= 340) cycle
            are_there = are_there .and. pairs%find(5, trim(pairs%value(i)), first) > 0
        end do
        call tap%ok(are_there, 'what a dictionary points to is there')
        call tap%ok(pairs%find(5, model_layout, first) > 0 .and. &
            pairs%find(5, paper_layout, first) > 0, 'model and paper have layouts')
        call tap%ok(pairs%find(330, model_space, first) > 0 .and. &
            pairs%find(330, paper_space, first) > 0, 'which point back to the blocks')
    end subroutine check_new

end program test_dxf_objects
