!> Cards checked against their layout: what is missing, wrong, too much.
program test_body_check
    use base_fault, only: fault_list_type
    use base_kinds, only: i64
    use deck_body_card, only: new_card
    use deck_body_check, only: check_card, has_option
    use deck_body_layout, only: body_card
    use deck_source, only: line_type
    use support_job_deck, only: words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call same(body_card%line, 'LINE    MHB     SIDE', '', 'a sound card has no fault')
    call same(body_card%section, 'SECTION,UP,A,B,C,0.,999.999', '', 'optional fields may be blank')
    call same(body_card%section, 'SECTION,UP,A,B,C,90.,11.43', &
        '1:18-20 warning: S1 is dWL/dBL, not degrees: 90. is a direction of 89.363 degrees; '// &
        'a vertical one is 999.999|', &
        'a slope that looks like degrees is warned of, a steep one is not')
    call same(body_card%rho, 'RHO,0.,0.,-10.,5.,8.,999.,.5', '1:11-14 warning: S1 is dy/dx, '// &
        'not degrees: -10. is a direction of -84.289 degrees; a vertical one is 999.999|'// &
        '1:22-25 warning: S3 is dy/dx, not degrees: 999. is a direction of 89.943 degrees; '// &
        'a vertical one is 999.999|', 'so is one of a line, and one that is not quite vertical')
    call same(body_card%point, '0.,0.,20.', '', 'a weight of 20 is none')
    call missing()
    call wrong()
    call too_much()
    call options()
    call tap%finish()

contains

    !> What is found wrong with a card.
    subroutine same(kind, text, words, name)
        integer, intent(in) :: kind
        character(*), intent(in) :: text
        character(*), intent(in) :: words
        character(*), intent(in) :: name
        type(fault_list_type) :: faults
        call check_card(new_card(line_of(text)), kind, faults)
        call tap%same(words_of(faults), words, name)
    end subroutine same

    !> A line of a deck.
    type(line_type) function line_of(text)
        character(*), intent(in) :: text
        line_of = line_type(text, 1_i64, len(text, i64), len_trim(text))
    end function line_of

    subroutine missing()
        call same(body_card%line, 'LINE    MHB', &
            '1:17-24 error: VIEW is missing: WL over STA, BL over STA, or degrees over STA; '// &
            'SIDE, PLAN or ANGLE|', 'a missing field is named with its columns')
        call same(body_card%conic, '0.      0.      0.      1.', &
            '1:33-64 error: Y2 X3 Y3 S3 are missing (zero is written 0.)|', &
            'fields missing side by side are one fault')
        call same(body_card%straight, 'STRAIGHT,1.,,2.,', &
            '1:13-13 error: Y1 is missing: first point '// &
            '(zero is written 0.)|1:17-17 error: Y3 is missing: last point (zero is written 0.)|', &
            'fields missing apart are two')
        call same(body_card%stations, 'STATION LIST', &
            '1:17-24 error: STA is missing: the stations, '// &
            'in this field and all that follow (zero is written 0.)|', 'a list has something in it')
    end subroutine missing

    subroutine wrong()
        call same(body_card%line, 'LINE    5.      SIDE', &
            '1:9-16 error: NAME: a number where a name '// &
            'is expected; a name begins with a letter|', 'a number where a name is expected')
        call same(body_card%toler, 'TOLER   SMALL', &
            '1:9-16 error: T is a number, not the word SMALL|', 'a word where a number is expected')
        call same(body_card%toler, 'TOLER   O.5', &
            '1:9-9 error: T: the letter O in a number; the figure is 0|', 'a slip in a number')
        call same(body_card%toler, 'TOLER     1 5', &
            '1:12-12 error: T: a blank inside a number; a '// &
            'field ends with its columns or with a comma|', 'a blank inside a number')
        call same(body_card%digits, 'DIGITS  2.', '1:10-10 error: N: a point in a whole number|', &
            'a point in a whole number')
        call same(body_card%flange, 'FLANGE  AFTER', &
            '1:9-16 error: SIDE is AFT or FWD, not AFTER; did '// &
            'you mean AFT?|', 'a word that is none of those it may be')
        call same(body_card%section, 'SECTION,UP,A,B,C,0.X,A*B', &
            '1:20-20 error: S1: ''X'' in a number; '// &
            'figures, a sign, a point and an exponent are read|1:22-24 error: S3: a name has '// &
            'letters, '// &
            'figures and the signs - _ . /|', 'number or name, and neither')
        call same(body_card%line, 'LINE,ABCDEFGHI,SIDE', &
            '1:6-14 error: NAME: a name has at most 8 characters|', 'a name that is too long')
    end subroutine wrong

    subroutine too_much()
        call same(body_card%close, 'CLOSE   YES', &
            '1:9-16 error: text behind the last field of the '// &
            'card, which is field 1|', 'text behind the last field')
        call same(body_card%skin, 'SKIN,1.,,A', &
            '1:10-10 error: text behind the last field of the '// &
            'card, which is field 2|', 'text behind an empty field')
        call same(body_card%straight, 'STRAIGHT0.      1.      2.      3.      4.      5.', &
            '1:41-48 error: a number behind the last field of the card, which is field 5|', &
            'numbers behind the last field are one fault')
        call same(body_card%straight, 'STRAIGHT,0,0,5,1,0,0,5', &
            '1:18-18 error: a number behind the last field of the card, which is field 5; '// &
            'a comma ends a field, and decimals have a point: 22.5|', 'decimal commas')
        call same(body_card%stations, 'STATION,LIST,1.,,2.,X', &
            '1:21-21 error: STA: ''X'' in a number; '// &
            'figures, a sign, a point and an exponent are read|', &
            'all fields of a list are looked at')
    end subroutine too_much

    subroutine options()
        call same(body_card%straight, 'STRAIGHT,0,0,1,1,,KNUCKLE', '', &
            'an option may stand anywhere behind')
        call same(body_card%straight, 'STRAIGHT,0,0,1,1,MATCH', &
            '1:18-22 error: MATCH is no option of '// &
            'this card; options are KNUCKLE|', 'an option of other cards')
        call same(body_card%straight, 'STRAIGHT,0,0,1,1,KNUCKEL', &
            '1:18-24 error: KNUCKEL is no option '// &
            'of this card; options are KNUCKLE; did you mean KNUCKLE?|', 'an option misspelt')
        call same(body_card%straight, 'STRAIGHT,0,0,1,1,KNUCKLE,KNUCKLE', &
            '1:26-32 error: KNUCKLE twice|', 'an option twice')
        call same(body_card%rho, 'RHO,0,0,1,1,1,0,,MATCH', '', 'MATCH needs no rho')
        call same(body_card%rho, 'RHO,0,0,1,1,1,0,.5,MATCH', &
            '1:17-18 warning: RHO is not used: MATCH '//'finds it|', 'MATCH does not use a rho')
        call same(body_card%conic, '0,0,1,,,1,1,0,DXDY,MATCH', '', 'MATCH needs no shoulder point')
        call tap%ok(has_option(new_card(line_of('0,0,1,,,1,1,0,DXDY,MATCH')), body_card%conic, &
            'DXDY'), 'an option is found in field 9')
        call tap%ok(has_option(new_card(line_of('0,0,1,,,1,1,0,DXDY,MATCH')), body_card%conic, &
            'MATCH'), 'and in field 10')
        call tap%ok(.not. has_option(new_card(line_of('RHO,0,0,1,1,1,0,.5')), body_card%rho, &
            'MATCH'), 'and not where it is not')
    end subroutine options

end program test_body_check
