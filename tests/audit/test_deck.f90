!> A deck audited: how tables were printed, decimals that most of them have, sections held to their
!> lines, numbers known exactly that are bad.
program test_deck
    use audit_deck, only: deck_audit_type
    use audit_finding, only: verdict
    use audit_printing, only: printing
    use support_audit_deck, only: audit_of, parabola
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(deck_audit_type) :: found

    call audit_of(parabola, found)
    call tap%ok(all(found%item(1)%audit%finding%verdict == verdict%agrees), 'a sound table agrees')
    call tap%ok(found%item(1)%audit%printing == printing%rounded, &
        'a tie between ways of printing is plain rounding')
    call audit_of('AUDIT,PAR,SIDE|EXACT,X1,0.,Y1,0.,S1,0.|EXACT,X3,50.,Y3,25.|ABOUT,S3,1.00|'// &
        '5.,.2501,10.,1.0003,15.,2.2509|20.,4.0001,25.,6.2502,30.,9.000,35.,12.250|'// &
        '40.,16.000,45.,20.250|'//'AUDIT,OTH,SIDE|EXACT,X1,0.,Y1,0.,S1,0.|EXACT,X3,50.,Y3,25.|'// &
        '5.,.250,10.,1.000,15.,2.250,20.,4.000|25.,6.250,30.,9.000,35.,12.250|', found)
    call tap%ok(found%item(1)%audit%scale%decimals == 3, 'decimals are those of the deck')
    call tap%ok(all(found%item(1)%audit%finding(:5)%verdict == verdict%suspect) .and. &
        all(found%item(1)%audit%finding(6:9)%verdict == verdict%agrees), &
        'figures with one too many are suspect')
    call tap%same(trim(found%item(1)%audit%finding(3)%likely), '2.250', 'and put right')
    call audit_of('AUDIT,PAR,SIDE|EXACT,X1,0.,Y1,0.,S1,0.|EXACT,X3,50.,Y3,25.,X2,20.,Y2,-4.0|'// &
        'ABOUT,S3,1.00|5.,.250,10.,1.000,15.,2.250,20.,4.000|'// &
        '25.,6.250,30.,9.000,35.,12.250|', found)
    call tap%ok(found%item(1)%audit%finding(10)%verdict == verdict%suspect .and. &
        all(found%item(1)%audit%finding(:7)%verdict == verdict%agrees), &
        'a number known exactly is given up where rows say otherwise')
    call tap%same(trim(found%item(1)%audit%finding(10)%likely), '4.0', 'and put right')
    call audit_of('AUDIT,A,SIDE|0.,.000,10.,.333,20.,.667,30.,1.000,40.,1.333|'// &
        '50.,1.867,60.,2.000', found)
    call tap%ok(found%item(1)%audit%piece(1)%fit%problem%is_straight .and. &
        all(pack(found%item(1)%audit%finding%verdict, [1, 2, 3, 4, 5, 6, 7] /= 6) == &
        verdict%agrees), 'a straight line is found to be one, though a conic has more numbers')
    call tap%same(trim(found%item(1)%audit%finding(6)%likely), '1.667', &
        'so that its bad figure is the only one')
    call audit_of('AUDIT,A,SIDE|1.,1.0|', found)
    call tap%ok(.not. found%item(1)%is_audited, 'a table of one row has no line')
    call tap%finish()

end program test_deck
