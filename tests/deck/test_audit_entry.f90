!> What cards put into a table: pairs of figures, what is known, faults of theirs.
program test_audit_entry
    use base_exact, only: is_equal
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use deck_audit, only: audit_deck_type, entry_kind, known
    use support_audit_deck, only: table_faults, tables_of
    use support_tap, only: tap_type
    implicit none (type, external)

    character(*), parameter :: head = 'AUDIT   A       SIDE|5.      1.0     6.      ?.2|'
    type(tap_type) :: tap
    type(audit_deck_type) :: deck
    type(fault_list_type) :: faults

    call tables_of(head//'7.|ABOUT   X1      0.      S1      .40|BETWEEN S3      -1.     2.|'// &
        'EXACT   X3      9.|'// &
        'PRINTED 1970    FIE     2|', deck, faults)
    associate (entry => deck%table(1)%entry)
        call tap%ok(deck%table(1)%count == 7 .and. all(entry(:3)%kind == entry_kind%row), &
            'figures in pairs, also the one that is blank')
        call tap%same(trim(entry(2)%text)//'/'//trim(entry(3)%text)//'/'//trim(entry(5)%text), &
            '?.2//.40', 'their very characters')
        call tap%ok(is_equal(entry(3)%along, 7.0_dp) .and. entry(5)%what == known%s1 .and. &
            entry(6)%kind == entry_kind%between .and. is_equal(entry(6)%low, -1.0_dp) .and. &
            is_equal(entry(6)%high, 2.0_dp), 'what else they say')
        call tap%ok(all(int(entry(:7)%line) == [2, 2, 3, 4, 4, 5, 6]), 'and where they stand')
    end associate
    call tap%ok(deck%table(1)%printing == 3 .and. deck%table(1)%is_fie .and. &
        deck%table(1)%decimals == 2, 'how it was printed')
    call tap%same(table_faults(head//'8.      2.0             5.0'), &
        '3:17-32 error: a figure without the ordinate that it is for|', 'a figure needs its X')
    call tap%same(table_faults(head//'ABOUT   S1      .4      S1      .5|EXACT   X1      0.'), &
        '3:25-32 error: S1 is given twice|', 'nothing is known twice')
    call tap%same(table_faults(head//'ABOUT   A'), &
        '3:9-24 error: a pair: what is known and its figure|', 'what is known has a figure')
    call tap%same(table_faults(head//'BETWEEN A       1.      2.'), &
        '3:9-16 error: a coefficient is given as it is printed: ABOUT or EXACT|', &
        'coefficients are printed')
    call tap%same(table_faults(head//'BETWEEN S1      3.      2.|EXACT   X1      0.'), &
        '3:17-32 error: LOW is more than HIGH|', 'low is not above high')
    call tap%same(table_faults(head//'8.      l.5'), '3:9-9 error: FIGURE: a figure as printed '// &
        'has digits, a sign and a point, or dashes between feet, inches and eighths, at most '// &
        '24 characters; ? is one that can''t be read|', 'letters are no figures')
    call tap%same(table_faults(head//'ABOUT   S1      .4'), '1:9-16 error: table A: what is '// &
        'known of a point needs its X on an EXACT card|', 'a slope needs its point')
    call tap%finish()

end program test_audit_entry
