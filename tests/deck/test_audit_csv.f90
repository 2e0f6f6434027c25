!> Printed tables as comma-separated values.
program test_audit_csv
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use deck_audit, only: audit_deck_type, audit_view, entry_kind, known
    use support_audit_deck, only: table_faults, tables_of
    use support_tap, only: tap_type
    implicit none (type, external)

    character(*), parameter :: head = 'table,view,at,what,along,printed,computed|'
    type(tap_type) :: tap
    type(audit_deck_type) :: deck
    type(fault_list_type) :: faults

    call tables_of(head//'LOW,station,10.,lines LCL LSH MHB,,|LOW,station,10.,exact X1,,0.,,,|'// &
        'LOW,station,10.,x,4.5,-19.467,-19.5,agrees|LOW,station,10.,y 2,-16.,12.5?7|'// &
        'LOW,station,10.,between S1,-.1,.2|MHB,plan,,conics 2,,|MHB,plan,,x,1,2.0|', deck, faults)
    call tap%ok(deck%count == 2 .and. faults%count == 0, 'two tables')
    associate (table => deck%table(1))
        call tap%ok(table%view == audit_view%station .and. nint(table%at) == 10 .and. &
            table%control(2) == 'LSH', 'what the first is of')
        call tap%ok(all(table%entry(:4)%kind == [entry_kind%exact, entry_kind%row, &
            entry_kind%row, entry_kind%between]) .and. table%entry(1)%what == known%x1, &
            'its figures')
        call tap%ok(table%entry(3)%is_along_y .and. table%entry(3)%column == 2 .and. &
            table%entry(3)%text == '12.5?7', 'a row along Y of the second column')
        call tap%ok(nint(10.0_dp*table%entry(4)%low) == -1 .and. &
            nint(10.0_dp*table%entry(4)%high) == 2, 'the bounds of a slope')
    end associate
    call tap%ok(deck%table(2)%conics == 2, 'the second is a chain')
    call tables_of('"table","view","at","what","along","printed"|"LOW","station","10.","lines '// &
        'LCL LSH MHB",,""|"LOW",station,"10."," x ","4.5","-19.4?7"|'// &
        '"LOW","station","10.","exact X1","","0."|"MHB","plan","","x","1","1-2-3"|', deck, faults)
    call tap%ok(deck%count == 2 .and. faults%count == 0, 'cells in quotes')
    call tap%ok(deck%table(1)%name == 'LOW' .and. deck%table(1)%control(3) == 'MHB', &
        'names out of them')
    call tap%ok(deck%table(1)%entry(1)%text == '-19.4?7' .and. &
        deck%table(1)%entry(2)%what == known%x1 .and. deck%table(2)%entry(1)%text == '1-2-3', &
        'figures out of them')
    call tap%has(table_faults(head//'A,side,,"x","1","two"'), '2:18-18 error: FIGURE: a figure '// &
        'as printed has digits, a sign and a point', 'a fault is shown where it is')
    call tap%same(table_faults(head//'A,side,5'), '2:1-1 error: a row has 6 cells: '// &
        'table,view,at,what,along,printed|', 'a row that is too short')
    call tap%same(table_faults(head//'A,side,,what,1,2'), '2:9-12 error: WHAT is x, y, exact, '// &
        'about, between, lines, printed, conics or shift|2:1-1 warning: table A has no rows|', &
        'words that mean nothing')
    call tap%finish()

end program test_audit_csv
