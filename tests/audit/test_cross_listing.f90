!> What tables say of one another, in words, and the count at the end.
program test_cross_listing
    use audit_cross_listing, only: print_cross, print_summary
    use audit_deck, only: deck_audit_type
    use base_output, only: output_type
    use report_page, only: page_type
    use support_audit_deck, only: audit_of, parabola
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(deck_audit_type) :: found
    type(output_type) :: out, none
    type(page_type) :: page

    call audit_of(parabola//'AUDIT,PAR,SIDE|EXACT,X1,0.,Y1,0.,S1,0.|EXACT,X3,50.,Y3,25.|'// &
        'ABOUT,S3,1.00|5.,.250,10.,1.000,15.,2.250,20.,4.500|25.,6.250,30.,'// &
        '9.000,35.,12.250|', found)
    call page%set_heading('T', 'D', 'U')
    call print_cross(page, found, out)
    call tap%ok(index(out%text(), 'AGREES   AT X 5.: PAR SIDE .250, PAR SIDE .250') > 0, &
        'rows of two tables that agree')
    call tap%ok(index(out%text(), 'DIFFERS  AT X 20.: PAR SIDE 4.000, PAR SIDE (4.500); -500.0 '// &
        'UNITS APART') > 0, 'and that do not, the suspect in brackets')
    call print_summary(page, found, out)
    call tap%ok(index(out%text(), 'FIGURES: ') > 0 .and. index(out%text(), '1 SUSPECT') > 0, &
        'the count')
    call audit_of('AUDIT,A,SIDE|1.,1.0', found)
    call print_cross(page, found, none)
    call tap%same(none%text(), '', 'nothing where there is nothing to say')
    call tap%finish()

end program test_cross_listing
