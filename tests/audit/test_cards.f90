!> The deck of 1970 that an audit gives.
program test_cards
    use audit_cards, only: print_audit_cards
    use audit_deck, only: audit_the_deck, deck_audit_type
    use base_fault, only: fault_list_type
    use base_output, only: output_type
    use deck_audit, only: audit_deck_type
    use support_audit_deck, only: parabola, tables_of
    use support_tap, only: tap_type
    implicit none (type, external)

    character, parameter :: lf = new_line('a')
    type(tap_type) :: tap
    type(audit_deck_type) :: deck
    type(deck_audit_type) :: found
    type(fault_list_type) :: faults
    type(output_type) :: out

    call tables_of('TITLE   OLD|UNITS   MM|'//parabola//'AUDIT,A,PLAN|1.,1.0|', deck, faults)
    call audit_the_deck(deck, found)
    call print_audit_cards(deck, found, out)
    call tap%same(out%text(), 'TITLE   OLD'//lf//'UNITS   MM'//lf//'* PAR SIDE'//lf// &
        '0.      0.      0.      25.     6.25    50.     25.     1.      5.'//lf// &
        '* A PLAN: no line found'//lf, 'a card under its name')
    ! The same read backwards along Y; then points and slopes that no conic has.
    call out%clear()
    call tables_of('AUDIT,PAR,SIDE|EXACT,X1,0.,Y1,0.,S1,0.|EXACT,X3,50.,Y3,25.,S3,1.|'// &
        'ALONG,Y|20.25,45.000,16.,40.000,12.25,35.000,9.,30.000,6.25,25.000|', deck, faults)
    call audit_the_deck(deck, found)
    call print_audit_cards(deck, found, out)
    call tap%same(out%text(), 'UNITS   INCHES'//lf//'* PAR SIDE'//lf// &
        '0.      0.      0.      25.     6.25    50.     25.     1.      51.   4.25   1'//lf, &
        'an increment goes from point 1 to point 3')
    call out%clear()
    call tables_of('AUDIT,F,STATION,0.,L,S,M|EXACT,X1,0.,Y1,-13.,S1,0.|'// &
        'EXACT,X2,9.,Y2,-10.|EXACT,X3,11.901,Y3,-7.1,S3,999.999|4.5,-17.705,9.,-15.999|'// &
        'AUDIT,M,SIDE|0.,-7.099,5.,-6.717,10.,-6.438,15.,-6.0209,20.,-5.4996|'// &
        '25.,-5.391,30.,-5.096,35.,-4.8159,40.,-4.534,45.,-4.264', deck, faults)
    call audit_the_deck(deck, found)
    call print_audit_cards(deck, found, out)
    call tap%ok(index(out%text(), '* F STATION 0.: no card: '// &
        'no conic goes through its points with its slopes'//lf) > 0, &
        'a card that would not run is not given')
    call tap%finish()

end program test_cards
