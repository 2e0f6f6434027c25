!> The listing of an audit: each figure with its verdict, the card, suspects with their reason.
program test_listing
    use audit_deck, only: audit_the_deck, deck_audit_type
    use audit_listing, only: print_audit
    use base_fault, only: fault_list_type
    use base_output, only: output_type
    use deck_audit, only: audit_deck_type
    use support_audit_deck, only: parabola, tables_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character(:), allocatable :: text

    text = listing_of('TITLE   A PARABOLA|'//parabola//'X')
    call tap%ok(index(text, 'A PARABOLA') == 1 .and. index(text, 'deck.crd') > 0, 'the heading')
    call tap%ok(has('TABLE PAR SIDE') .and. has( &
        '0.      0.      0.      25.     6.25    50.     25.     1.      5.'), 'the card')
    call tap%ok(has('X 25.       6.250     6.25000      0.0  AGREES           6.250'), &
        'a figure that agrees')
    text = listing_of('AUDIT,PAR,SIDE|EXACT,X1,0.,Y1,0.,S1,0.|EXACT,X3,50.,Y3,25.|'// &
        'ABOUT,S3,1.00|5.,.250,10.,1.000,15.,2.280,20.,4.000|25.,6.?50,30.,9.000,35.,12.250|40.,|')
    call tap%ok(has('X 15.       2.280     2.25000     30.0  SUSPECT          2.250'), &
        'a figure that does not')
    call tap%ok(has('ONE DIGIT TAKEN FOR ANOTHER'), 'and why')
    call tap%ok(has('6.?50') .and. has('UNREADABLE       6.250'), 'one that can not be read')
    call tap%ok(has('BLANK           16.000'), 'one that is not printed')
    call tap%ok(has('12 FIGURES: 9 AGREES, 1 SUSPECT, 1 UNREADABLE, 1 BLANK'), 'the count')
    text = listing_of('AUDIT,A,SIDE|1.,1.0')
    call tap%ok(has('NO LINE: ITS FIGURES ARE TOO FEW FOR A CONIC'), 'a table without a line')
    text = listing_of('AUDIT,PAR,SIDE|ABOUT,S1,0.00,S3,1.00|EXACT,X1,0.,Y1,0.,X3,50.,Y3,25.|'// &
        '5.,.250,10.,1.000,15.,2.250,20.,4.000|25.,6.250,30.,9.000,35.,12.250|')
    call tap%ok(has('S1 AND S3 TOGETHER:  0.00 WITH 1.00'), &
        'slopes that are both open come in pairs')
    text = listing_of('AUDIT,TOP,SIDE|0.,5.000,5.,8.852,10.,11.844,15.,14.309,20.,16.400|'// &
        '25.,18.204,30.,19.777,35.,21.155,40.,22.365,45.,23.426,50.,24.353,55.,25.159|'// &
        '60.,25.851,65.,26.438,70.,26.926,75.,27.318,80.,27.619,85.,27.832,90.,27.958|'// &
        '95.,28.000')
    call tap%ok(has('23.9055  23.9056') .and. .not. has('...'), &
        'five round numbers stand without a gap')
    call tap%finish()

contains

    !> True where the listing has a text.
    logical function has(words)
        character(*), intent(in) :: words !! the text
        has = index(text, words) > 0
    end function has

    !> The listing of a deck.
    function listing_of(cards) result(listing)
        character(*), intent(in) :: cards   !! its lines with `|` between them
        character(:), allocatable :: listing
        type(audit_deck_type) :: deck
        type(deck_audit_type) :: found
        type(fault_list_type) :: faults
        type(output_type) :: out
        call tables_of(cards, deck, faults)
        call audit_the_deck(deck, found)
        call print_audit(deck, found, 'deck.crd', out)
        listing = out%text()
    end function listing_of

end program test_listing
