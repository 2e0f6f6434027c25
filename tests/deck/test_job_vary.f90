!> VARY cards: the field right before them, by name or count; what is wrong with them.
program test_job_vary
    use base_decimal, only: to_real
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use deck_body_layout, only: body_card
    use deck_job, only: job_type
    use deck_job_vary, only: is_vary
    use support_job_deck, only: body_text, faults_of, job_of, words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    character(*), parameter :: line = 'LINE,A,SIDE|0,0,.1,5,1,10,1.5,0|'
    type(tap_type) :: tap

    call sound()
    call bad_fields()
    call bad_values()
    call blamed_once()
    call tap%ok(is_vary(body_card%vary) .and. is_vary(body_card%vary_tied) .and. &
        .not. is_vary(body_card%sweep) .and. .not. is_vary(body_card%check_box), 'which cards vary')
    call tap%finish()

contains

    subroutine sound()
        type(job_type) :: job
        type(fault_list_type) :: faults
        call job_of(body_text//'LINE,A,SIDE|* a '// &
            'remark|0,0,.1,5,1,10,1.5,0|VARY,Y2,HIGH,.5,1.5,3|'// &
            '|* another|VARY,8,END,-.1,.1|10,1.5,0,15,1,20,0,-.1|VARY,TIED,Y1,HIGH,2.,.25|'// &
            'VARY,TIED,S1,END|NOSE,1.|VARY,LIST,R,ROUND,1.,.5,2.|STATION,LIST,1.,2.,3.|'// &
            'VARY,5,STA,2.,4.,2', job, faults)
        call tap%same(words_of(faults), '', 'remarks and blank cards stand between')
        associate (sweep => job%sweep)
            call tap%ok(size(sweep%variable) == 4 .and. size(sweep%target) == 6, &
                'four variables in six fields')
            call tap%ok(all(sweep%variable%name == [character(8) :: 'HIGH', 'END', 'ROUND', &
                'STA']), &
                'in the order of the cards')
            call tap%ok(all(sweep%variable%count == [3, 0, 3, 2]), 'with their counts')
            call tap%ok(all(sweep%target%field == [5, 8, 2, 3, 2, 5]), &
                'fields by name and by count')
            call tap%ok(all(sweep%target%variable == [1, 2, 1, 2, 3, 4]), 'and their variables')
            call tap%near(to_real(sweep%target(3)%factor), 2.0_dp, 0.0_dp, 'a factor')
            call tap%near(to_real(sweep%target(3)%add), 0.25_dp, 0.0_dp, 'what is added')
            call tap%near(to_real(sweep%target(4)%factor), 1.0_dp, 0.0_dp, 'none is one')
            call tap%ok(sweep%variable(3)%is_list .and. &
                all(abs(to_real(sweep%variable(3)%value) - [1.0_dp, 0.5_dp, 2.0_dp]) <= 0.0_dp), &
                'a list')
            call tap%ok(size(job%body(1)%line(4)%view(1)%piece) == 2, &
                'data cards go on behind a VARY card')
        end associate
    end subroutine sound

    !> What is found wrong with cards from line 7 on.
    subroutine same(cards, found, name)
        character(*), intent(in) :: cards, found, name
        call tap%same(faults_of(body_text//'STATION,1|'//cards), found, name)
    end subroutine same

    !> Fields that can't vary.
    subroutine bad_fields()
        character(*), parameter :: numbers_of_line = &
            '; a number is in X1, Y1, S1, X2, Y2, X3, Y3 or S3'
        call tap%has(faults_of('VARY,X,A,1.,2.,2|'//body_text//'STATION,1'), &
            '1:1-4 error: VARY without a card before it', 'no card before it')
        call same(line//'VARY,Y4,A,1.,2.,2', '10:6-7 error: the card before has no field Y4'// &
            numbers_of_line//'; did you mean Y1?|', 'another field')
        call same(line//'VARY,11,A,1.,2.,2', '10:6-7 error: the card before has no field 11'// &
            numbers_of_line//'|', 'a field beyond the last')
        call same(line//'VARY,0,A,1.,2.,2', '10:6-6 error: the card before has no field 0'// &
            numbers_of_line//'|', 'field 0')
        call same(line//'VARY,2.5,A,1.,2.,2', '10:6-8 error: the card before has no field 2.5'// &
            numbers_of_line//'|', 'half a field')
        call same(line//'VARY,1E30,A,1.,2.,2', '10:6-9 error: the card before has no field '// &
            '1E30'//numbers_of_line//'|', 'a field beyond counting')
        call same('NOSE,1.|VARY,1,A,1.,2.,2', '9:6-6 error: the card before has no field 1; a '// &
            'number is in R|', 'the word of a card')
        call same('DIGITS,3|VARY,R,A,1.,2.,2', '9:6-6 error: the card before has no field R|', &
            'a card without numbers')
        call same('LINE,A,SIDE,MHB|VARY,FROM,A,1.,2.,2', '9:6-9 error: field FROM of the card '// &
            'before holds no number; put one there, which loft run takes|', 'a name')
        call same('SECTION,S,TOP,SHL,MHB,0.,0.|VARY,LINE1,A,1.,2.,2', &
            '9:6-10 error: field LINE1 '// &
            'of the card before is not for a number that can be varied|', 'a field for names')
        call same('DIGITS,3|VARY,N,A,1.,2.,2', '9:6-6 error: field N of the card before is not '// &
            'for a number that can be varied|', 'a whole number')
        call same('BUTTOCK,1.,0.,5.,1.|VARY,NAME,A,1.,2.,2', '9:6-9 error: field NAME of the '// &
            'card '// &
            'before is not for a number that can be varied|', 'a name that may be blank')
        call same(line//'OBJECT,VOLUME,MAX|VARY,WHAT,A,1.,2.,2', &
            '11:6-9 error: field WHAT of the '// &
            'card before is not for a number that can be varied|', 'a card of the sweep itself')
        call same(line//'OBJECT,VOLUME,NEAR,5.|VARY,VALUE,A,1.,2.,2', '11:6-10 error: the '// &
            'value to come near to does not vary: all variants are compared by it|', &
            'what is wanted')
    end subroutine bad_fields

    !> Ranges, lists and names.
    subroutine bad_values()
        call same(line//'VARY,Y2,A,2.,1.,2', &
            '10:11-12 error: FROM is above TO; the least value stands first|', 'from above to')
        call same(line//'VARY,Y2,A,2.,2.,2', '10:14-15 error: FROM and TO are the same; VARY '// &
            'LIST takes a single value|', 'nothing between')
        call same(line//'VARY,Y2,A,1.,2.,0', &
            '10:17-17 error: COUNT is 2 or more: FROM and TO are among the values|', 'no values')
        call same(line//'VARY,Y2,A,1.,2.,1000001', '10:17-23 error: COUNT is at most 1000000|', &
            'too many values')
        call same(line//'VARY,Y2,A,1.,2.,2.5', '10:18-18 error: COUNT: a point in a whole '// &
            'number|', &
            'half a value')
        call same(line//'VARY,Y2,A,1.', '10:13-13 error: TO is missing: greatest value (zero '// &
            'is '// &
            'written 0.)|', 'half a range')
        call same(line//'VARY,Y2,A,1.,2.,2|VARY,Y2,B,1.,2.,2', &
            '11:6-7 error: a second VARY of field Y2|', 'a field twice')
        call same(line//'VARY,Y2,A,1.,2.,2|VARY,Y3,A,1.,2.,2', &
            '11:9-9 error: a second variable '// &
            'A; VARY TIED lets this field go with the first|', 'a variable twice')
        call same(line//'VARY,TIED,Y2,A|VARY,Y3,A,1.,2.,2', &
            '10:14-14 error: no VARY card before '// &
            'has a variable A, with which this field could go|', 'tied to nothing')
        call same('VARY,LIST,FROM,A', '8:17-17 error: VALUE is missing: the values, in this '// &
            'field '// &
            'and all that follow (zero is written 0.)|', 'an empty list')
        call tap%has(faults_of('1. 2. 3. 4. 5. 6. 7. 8.|VARY,X1,A,1.,2.,2'), 'error', &
            'no VARY in a deck of 1970')
    end subroutine bad_values

    !> A card in error is blamed once, and nobody for going with it.
    subroutine blamed_once()
        call same(line//'VARY,Y2,A,2.,1.,2|VARY,TIED,Y3,A', '10:11-12 error: FROM is above TO; '// &
            'the least value stands first|', 'tied to a range in error, which alone is blamed')
        call same(line//'VARY,Y2,A,ten,2.|VARY,TIED,Y3,A', &
            '10:11-13 error: FROM is a number, not the word TEN|', 'tied to a card in error')
        call same('NOSE,1.5.|VARY,R,A,1.,2.|NOSE,2.|VARY,TIED,R,A', &
            '8:9-9 error: R: a second point in the number|', 'tied to one behind a card in error')
        call same('NOSE,1.5.|VARY,R,A,1.,2.,2', &
            '8:9-9 error: R: a second point in the number|', 'a card in error is not blamed twice')
    end subroutine blamed_once

end program test_job_vary
