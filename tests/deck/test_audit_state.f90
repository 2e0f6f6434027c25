!> Tables card by card: what opens one, what belongs to it, what is no card.
program test_audit_state
    use base_fault, only: fault_list_type
    use deck_audit, only: audit_deck_type, audit_view
    use support_audit_deck, only: table_faults, tables_of
    use support_tap, only: tap_type
    implicit none (type, external)

    character(*), parameter :: row = '5.      1.0|'
    type(tap_type) :: tap
    type(audit_deck_type) :: deck
    type(fault_list_type) :: faults

    call tables_of('AUDIT   LOWER   STATION 10.     LCL     LSH     MHB|CONICS  2|SHIFT   200.|'// &
        'ALONG   Y       2|'//row//'AUDIT   A       PLAN|'//row//'END|', deck, faults)
    call tap%ok(deck%count == 2 .and. faults%count == 0, 'two tables')
    associate (table => deck%table(1))
        call tap%ok(table%view == audit_view%station .and. table%conics == 2 .and. &
            nint(table%shift) == 200 .and. nint(table%at) == 10, 'what the first is of')
        call tap%same(table%control(1)//table%control(2)//table%control(3), &
            'LCL     LSH     MHB     ', 'its lines')
        call tap%ok(table%entry(1)%is_along_y .and. table%entry(1)%column == 2, &
            'its row is along Y, in the second column')
    end associate
    call tap%ok(.not. deck%table(2)%entry(1)%is_along_y .and. deck%table(2)%entry(1)%column == 1, &
        'the second table begins anew')
    call tap%same(table_faults('AUDIT   A       STATION|'//row), '1:25-32 error: AT is where a '// &
        'STATION, BUTTOCK or WATERLN is; SIDE and PLAN have none|', 'a section is at a station')
    call tap%same(table_faults('AUDIT   A       SIDE    5.|'//row), &
        '1:25-32 error: AT is where a STATION, BUTTOCK or WATERLN is; SIDE and PLAN have none|', &
        'a side view is not')
    call tap%same(table_faults('AUDIT   A       SIDE            B|'//row), &
        '1:33-56 error: only a STATION has lines of its points|', 'nor has it lines')
    call tap%same(table_faults('AUDIT   A       SIDE|CONICS  10|'//row), &
        '2:9-16 error: a chain has 1 to 9 conics|', 'conics in a chain')
    call tap%same(table_faults('AUDIT   A       SIDE|ALONG   X       3|'//row), &
        '2:17-24 error: COLUMN is 1 or 2|', 'columns of a page')
    call tap%same(table_faults('AUDIT   A       SIDE|'), '1:9-16 warning: table A has no rows|', &
        'a table without rows')
    call tap%same(table_faults('AUDIT   A       SIDE|EXAKT   X1      5.|'//row), &
        '2:1-8 error: EXAKT is no card of a deck of printed tables, which are AUDIT, PRINTED, '// &
        'CONICS, SHIFT, EXACT, ABOUT, BETWEEN, ALONG or END; did you mean EXACT?|', &
        'a word that is no card')
    call tap%same(table_faults('AUDIT A SIDE|'//row//row), &
        '1:1-8 error: more than the word in the first field; the next field begins in '// &
        'column 9, or put commas between all fields|', &
        'fields with one blank between; the rows are its own')
    call tables_of('AUDIT   A       SIDEWAYS|'//row//'AUDIT   B       SIDE|ABOUT   S1      5.|'// &
        row//'AUDIT   C       SIDE|'//row, deck, faults)
    call tap%ok(deck%count == 1 .and. faults%count == 2, &
        'bad tables are left out, each with its fault')
    call tap%same(trim(deck%table(1)%name), 'C', 'sound ones stay')
    call tap%finish()

end program test_audit_state
