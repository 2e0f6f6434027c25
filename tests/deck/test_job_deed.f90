!> Cards by their words, and what is not there at the end of a deck.
program test_job_deed
    use base_fault, only: fault_list_type
    use deck_job, only: job_type
    use support_job_deck, only: body_text, faults_of, job_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(job_type) :: job
    type(fault_list_type) :: faults

    call words()
    call endings()
    call survivors()
    call tap%finish()

contains

    !> What is found wrong with cards from line 7 on.
    subroutine same(cards, found, name)
        character(*), intent(in) :: cards
        character(*), intent(in) :: found
        character(*), intent(in) :: name
        call tap%same(faults_of(body_text//'STATION,1|'//cards), found, name)
    end subroutine same

    subroutine words()
        call same('SATTION,1', &
            '8:1-7 error: SATTION begins no card (see loft help cards); did you mean '// &
            'STATION?|', 'a word misspelt')
        call same('TILTE   A', &
            '8:1-8 error: TILTE begins no card (see loft help cards); did you mean '// &
            'TITLE?|', 'TITLE misspelt')
        call same('FUSELAGE', '8:1-8 error: FUSELAGE begins no card (see loft help cards)|', &
            'a word that is near to none')
        call same('STATION 5', '', 'a card by columns')
        call same('LINE A SIDE', &
            '8:1-8 error: more than the word in the first field; the next field '// &
            'begins in column 9, or put commas between all fields|', &
            'fields with one blank between')
        call same('LINE X SIDE|STRAIGHT,0,0,1,1|RHO 1.', &
            '8:1-8 error: more than the word in the first field; the next field begins in '// &
            'column 9, or put commas between all fields|'// &
            '10:1-8 error: more than the word in the first field; the next field begins in '// &
            'column 9, or put commas between all fields|', &
            'a LINE card so written still has the data cards behind it')
        call same('LINE,X,SIDE|STRAIGHT0.      0,5     1.      2.', &
            '9:1-17 error: more than the word in the first field; on a card with a comma all '// &
            'fields are between commas: a comma ends a field, and decimals have a point: 22.5|', &
            'a decimal comma on a card by columns, and its line is not said to be without data')
        call same('LINE;X;SIDE', &
            '8:1-8 error: more than the word in the first field; fields end with their '// &
            'columns or with a comma, not with a semicolon|', 'semicolons')
        call same('LIEN,X,SIDE|STRAIGHT,0,0,1,1', &
            '8:1-4 error: LIEN begins no card (see loft help cards); did you mean LINE?|', &
            'a LINE card misspelt, too')
        call same('CHECK,BALL,1', '8:7-10 error: CHECK is followed by POINT, SPHERE or BOX|', &
            'a second word that is none')
        call same('CHECK,BOXX', &
            '8:7-10 error: CHECK is followed by POINT, SPHERE or BOX; did you mean '// &
            'BOX?|', 'a second word misspelt')
        call same('1.,2.', &
            '8:1-2 error: a data card outside a LINE; a LINE card comes first, its data '// &
            'cards right behind it|', 'numbers outside a LINE')
        call same('STRAIGHT,0,0,1,1', &
            '8:1-8 error: a data card outside a LINE; a LINE card comes first, '// &
            'its data cards right behind it|', 'a data card outside a LINE')
        call same('LINE,X,SIDE|STRAIGHT,0,0,1,1|STATION,1|STRAIGHT,1,1,2,2', &
            '11:1-8 error: a data card '// &
            'outside a LINE; a LINE card comes first, its data cards right behind it|', &
            'another card closes a line')
    end subroutine words

    subroutine endings()
        call tap%same(faults_of(body_text//'STATION,1|END'), '', 'a whole deck has no fault')
        call tap%same(faults_of(body_text//'END'), &
            '0:0-0 warning: the deck asks for no cut; STATION, '// &
            'BUTTOCK, WATERLN, OBLIQUE and PLANE do|', 'a deck without cuts is warned of')
        call tap%same(faults_of('STATION,1'), &
            '0:0-0 warning: the deck has no SECTION card: there is no '// &
            'body to cut|', 'a deck without sections is warned of')
        call job_of('END', job, faults)
        call tap%ok(size(job%body) == 1 .and. size(job%body(1)%line) == 0, &
            'an empty job has one empty body')
    end subroutine endings

    subroutine survivors()
        call job_of('LINE,TOP,SIDE,5|LINE,SHL,SIDE,X Y|LINE,MHB,SIDE,0|LINE,SHX,SIDE,1|'// &
            'LINE,SHX,PLAN,1|'// &
            'SECTION,A,TOP,SHL,MHB,0,0|SECTION,B,TOP,SHX,MHB,0,0|STATION,A|STATION,1|NONSENSE|'// &
            'STATION,2', &
            job, faults)
        call tap%ok(faults%count == 4, 'each bad card is one fault')
        associate (body => job%body(1))
            call tap%ok(size(body%line) == 3 .and. size(body%cut) == 2, 'bad cards are left out')
            call tap%ok(size(body%section) == 2, 'sections stay')
            call tap%ok(.not. body%section(1)%is_sound .and. body%section(2)%is_sound, &
                'those of good lines are sound')
        end associate
    end subroutine survivors

end program test_job_deed
