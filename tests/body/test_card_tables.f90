!> Which tables a card asks for, and that they are there: the rules of the CSV contract on cards.
program test_card_tables
    use base_fault, only: fault_list_type
    use base_kinds, only: dp, i64
    use body_card_arc, only: arc_of_card
    use body_card_tables, only: card_table_type, tables_of_card
    use deck_conic_card, only: conic_card_type, read_conic_card
    use deck_source, only: line_type
    use geom_arc, only: arc_type
    use support_tap, only: tap_type
    implicit none (type, external)

    !> A quarter of a circle of radius 5 about the origin, from (-5, 0) over (-4, 3) to (0, 5).
    character(*), parameter :: quarter = &
        '-5.     0.      999.999 -4.     3.      0.      5.      0.      '
    type(tap_type) :: tap
    type(card_table_type), allocatable :: tables(:)
    type(fault_list_type) :: faults

    call run('2.')
    call tap%ok(size(tables) == 1, 'XI alone gives an X table')
    if (size(tables) == 1) then
        call tap%ok(size(tables(1)%row) == 4 .and. tables(1)%axis == 1, &
            'steps of 2 from -5 to 0: -5, -3, -1 and the end')
        call tap%near(tables(1)%row(2)%y, 4.0_dp, 1.0e-15_dp, 'at X = -3 the circle is at 4')
        call tap%near(tables(1)%row(3)%y, sqrt(24.0_dp), 1.0e-15_dp, 'at X = -1 at root 24')
        call tap%ok(tables(1)%row(1)%slope%is_vertical, 'point 1 is vertical')
    end if
    call run('1.    1.     1')
    call tap%ok(size(tables) == 2, 'ITYP gives a Y table behind the X table')
    if (size(tables) == 2) call tap%ok(tables(2)%axis == 2, 'the second table steps Y')
    call run('      1.     1')
    call tap%ok(size(tables) == 1 .and. faults%count == 0, 'a blank XI with ITYP: a Y table alone')
    if (size(tables) == 1) call tap%ok(tables(1)%axis == 2, 'and it steps Y')
    call run('1.')
    if (size(tables) == 1) call tap%ok(size(tables(1)%row) == 6, &
        'a step that meets the end is it, once')
    call run('-1.   1.     1')
    call tap%ok(size(tables) == 1 .and. faults%count == 1, &
        'a wrong sign of XI is one fault and leaves the Y table')
    call run('')
    call tap%ok(size(tables) == 0 .and. faults%count == 1, 'no increment at all is a fault')
    call run('.00001')
    call tap%ok(size(tables) == 0 .and. faults%count == 1, 'a table that is too long is a fault')
    if (faults%count == 1) call tap%ok(faults%item(1)%first == 65, 'and stands on XI')
    call tap%finish()

contains

    !> Reads the quarter circle with increments, and makes its tables.
    subroutine run(increments)
        character(*), intent(in) :: increments !! columns 65 on
        type(conic_card_type) :: card
        type(line_type) :: line
        type(arc_type) :: arc
        logical :: has_arc

        call faults%clear()
        line%text = quarter//increments
        line%length = len(line%text, i64)
        call read_conic_card(line, card, faults)
        call arc_of_card(card, arc, has_arc, faults)
        call tables_of_card(card, arc, tables, faults)
    end subroutine run

end program test_card_tables
