!> Tables of either form are read alike.
program test_audit_file
    use base_fault, only: fault_list_type
    use deck_audit, only: audit_deck_type
    use support_audit_deck, only: tables_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(audit_deck_type) :: cards, values
    type(fault_list_type) :: faults
    integer :: i

    call tables_of('* two rows|AUDIT   A       SIDE|EXACT   X1      0.      Y1      2.0|'// &
        '5.      1.0     6.      1.?', cards, faults)
    call tables_of('Table,View,At,What,Along,Printed|A,SIDE,,exact X1,,0.|'// &
        'A,SIDE,,exact Y1,,2.0|A,SIDE,,x,5.,1.0|A,SIDE,,x,6.,1.?|', values, faults)
    call tap%ok(cards%count == 1 .and. values%count == 1, 'a table each')
    call tap%ok(cards%table(1)%count == 4 .and. values%table(1)%count == 4, 'four figures each')
    call tap%ok(all([(cards%table(1)%entry(i)%text == values%table(1)%entry(i)%text .and. &
        cards%table(1)%entry(i)%kind == values%table(1)%entry(i)%kind .and. &
        cards%table(1)%entry(i)%along_text == values%table(1)%entry(i)%along_text, i = 1, 4)]), &
        'which are the same')
    call tap%finish()

end program test_audit_file
