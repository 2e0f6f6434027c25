!> A deck of printed tables as a file: headings, the order of faults, cards outside of a table.
program test_audit_reader
    use base_fault, only: fault_list_type
    use deck_audit, only: audit_deck_type
    use support_audit_deck, only: table_faults, tables_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(audit_deck_type) :: deck
    type(fault_list_type) :: faults

    call tables_of('TITLE   OLD TABLES|UNITS   MM|AUDIT   A       SIDE|5.      1.0|', deck, faults)
    call tap%same(deck%title//'/'//deck%units, 'OLD TABLES/MM', 'headings')
    call tables_of('AUDIT   A       SIDE|5.      1.0|', deck, faults)
    call tap%same(deck%title//'/'//deck%units, '/INCHES', &
        'without them there is no title, and inches')
    call tap%same(table_faults('AUDIT   A       SID|5.      1.0|ABOUT   S9      3|'), &
        '1:17-24 error: VIEW is SIDE, PLAN, STATION, BUTTOCK or WATERLN, not SID; did you mean '// &
        'SIDE?|3:9-16 error: WHAT is X1, Y1, S1, X2, Y2, X3, Y3, S3, A, B, C, D, E, XI or YI, '// &
        'not S9; did you mean S1?|', 'all faults, in the order of the deck')
    call tables_of('AUDIT|', deck, faults)
    call tap%ok(deck%count == 0 .and. faults%count > 0, 'a table without a name is none')
    call tap%finish()

end program test_audit_reader
