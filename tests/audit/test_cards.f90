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
    call tap%finish()

end program test_cards
