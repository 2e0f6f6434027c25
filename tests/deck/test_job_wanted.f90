!> SWEEP, OBJECT and LIMIT of a measure; LIMIT of an axis stays what it was.
program test_job_wanted
    use base_decimal, only: to_real
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use deck_body_layout, only: measure_words
    use deck_body_word, only: words_in
    use deck_job, only: job_type
    use deck_job_wanted, only: is_measure
    use deck_sweep, only: goal, measure, method
    use support_job_deck, only: body_text, faults_of, job_of, words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call sound()
    call refusals()
    call more_refusals()
    call tap%ok(is_measure('VOLUME') .and. is_measure('VOLUM') .and. .not. is_measure('STA') .and. &
        .not. is_measure('NONE') .and. .not. is_measure(''), 'measures are known, also misspelt')
    call tap%ok(size(words_in(measure_words)) == measure%break, 'each has its word')
    call tap%finish()

contains

    subroutine sound()
        type(job_type) :: job
        type(fault_list_type) :: faults
        call job_of('BODY,FIRST|'//body_text//'SWEEP,LATIN,50,7|CHECK,POINT,1.,2.,3.,0.,SEAT|'// &
            'OBJECT,VOLUME,MAX|OBJECT,CLEAR,NEAR,2.,SEAT,,ROOM|LIMIT,BL,1.,2.|STATION,1|'// &
            'BODY,OTHER|'//body_text//'LIMIT,WIDTH,4.,,10.,-3.|OBJECTIVE,JUMP,MIN,,SHL|STATION,1', &
            job, faults)
        call tap%same(words_of(faults), '', 'cards of two bodies')
        associate (sweep => job%sweep)
            call tap%ok(sweep%method == method%latin .and. sweep%count == 50 .and. sweep%seed == &
                7, &
                'how variants are made')
            call tap%ok(size(sweep%wanted) == 4, 'LIMIT of an axis is no measure')
            call tap%ok(job%body(1)%cut(1)%limit(2)%has_from, 'it limits the cuts')
            call tap%ok(all(sweep%wanted%body == [1, 1, 2, 2]), &
                'a measure is of the body it stands in')
            call tap%ok(all(sweep%wanted%measure == [measure%volume, measure%clear, measure%width, &
                measure%jump]), 'which measures')
            call tap%ok(all(sweep%wanted%goal == [goal%most, goal%near, goal%range, goal%least]), &
                'what is wanted of them')
            call tap%ok(all(sweep%wanted%name == [character(8) :: 'VOLUME', 'ROOM', 'WIDTH', &
                'JUMP']), &
                'names of columns')
            call tap%near(to_real(sweep%wanted(2)%value), 2.0_dp, 0.0_dp, 'the value to be near to')
            call tap%ok(sweep%wanted(2)%of == 'SEAT' .and. sweep%wanted(4)%of == 'SHL', &
                'components and lines')
            call tap%near(to_real(sweep%wanted(3)%sta), 10.0_dp, 0.0_dp, 'a station')
            call tap%near(to_real(sweep%wanted(3)%at), -3.0_dp, 0.0_dp, 'a waterline')
            call tap%ok(sweep%wanted(3)%has_from .and. .not. sweep%wanted(3)%has_to, 'one limit')
        end associate
    end subroutine sound

    !> What is found wrong with cards from line 7 on.
    subroutine same(cards, found, name)
        character(*), intent(in) :: cards, found, name
        call tap%same(faults_of(body_text//'STATION,1|'//cards), found, name)
    end subroutine same

    subroutine refusals()
        call same('LIMIT,VOLUM,1.', '8:7-11 error: WHAT is VOLUME, WETTED, CENTROID, AREA, '// &
            'GIRTH, '// &
            'WIDTH, HEIGHT, CLEAR, JUMP or BREAK, not VOLUM; did you mean VOLUME?|', &
            'a measure misspelt')
        call same('LIMIT,XYZ,1.', '8:7-9 error: AXIS is STA, BL, WL or NONE, not XYZ|', &
            'neither axis nor measure')
        call same('OBJECT,VOLUME,LARGE', '8:15-19 error: GOAL is MIN, MAX, NEAR or SHOW, not '// &
            'LARGE|', &
            'another goal')
        call same('OBJECT,VOLUME,NEAR', '8:19-19 error: VALUE goes with NEAR, and NEAR with '// &
            'VALUE: '// &
            'the value to come near to|', 'near to what')
        call same('OBJECT,VOLUME,MAX,1.', '8:19-20 error: VALUE goes with NEAR, and NEAR with '// &
            'VALUE: the value to come near to|', 'a value without NEAR')
        call same('OBJECT,AREA,MAX', '8:16-16 error: AREA is of a section; OF is its station|', &
            'an area of nothing')
        call same('OBJECT,VOLUME,MAX,,1.', '8:20-21 error: VOLUME is of the body; OF is blank|', &
            'a volume at a station')
        call same('OBJECT,WIDTH,MAX,,1.', &
            '8:21-21 error: AT is the waterline of a WIDTH, the butt line of a HEIGHT|', &
            'a width anywhere')
        call same('OBJECT,AREA,MAX,,1.,2.', &
            '8:21-22 error: AT is the waterline of a WIDTH, the butt line of a HEIGHT|', &
            'an area on a waterline')
        call same('OBJECT,CLEAR,MAX,,SEAT', &
            '8:19-22 error: no CHECK card before has the component SEAT|', 'no such component')
        call same('OBJECT,JUMP,MIN,,SHX', '8:18-20 error: there is no LINE SHX before; did you '// &
            'mean SHL?|', 'no such line')
        call same('OBJECT,JUMP,MIN,,1.', '8:18-19 error: OF of JUMP is a name, or blank: all|', &
            'a line by number')
    end subroutine refusals

    subroutine more_refusals()
        call same('LIMIT,VOLUME', '8:13-13 error: FROM and TO are missing; one of them at '// &
            'least is '// &
            'a limit|', 'no limit')
        call same('LIMIT,VOLUME,2.,1.', '8:14-15 error: FROM is above TO; nothing is between '// &
            'them|', &
            'limits crossed')
        call same('OBJECT,AREA,MAX,,1.|OBJECT,AREA,MAX,,2.', '9:20-20 error: another measure '// &
            'has '// &
            'the column AREA; NAME gives this one its own|', 'two columns of one name')
        call same('OBJECT,AREA,MAX,,1.|LIMIT,AREA,1.,,1.', '', 'one measure, one column')
        call same('OBJECT,VOLUME,MAX|OBJECT,VOLUME,MIN', '9:15-17 error: VOLUME has an aim '// &
            'already, MAX; a measure has one|', 'aims of opposite sense')
        call same('OBJECT,AREA,MIN,,1.,,A|OBJECT,AREA,NEAR,5.,1.,,B', '9:13-16 error: A has an '// &
            'aim already, MIN; a measure has one|', 'two aims under two names')
        call same('OBJECT,VOLUME,MAX|OBJECT,VOLUME,SHOW|LIMIT,VOLUME,1.', '', &
            'one aim, shown and limited')
        call same('OBJECT,AREA,MAX,,1.,,A|OBJECT,AREA,MIN,,2.,,B', '', 'aims of two measures')
        call same('NOSE,1.|VARY,R,VOLUME,1.,2.,2|OBJECT,VOLUME,MAX', &
            '10:18-18 error: VOLUME is '// &
            'the name of a variable; columns have different names|', 'a column and a variable')
        call same('OBJECT,VOLUME,MAX|NOSE,1.|VARY,R,VOLUME,1.,2.,2', &
            '10:8-13 error: VOLUME is the '// &
            'name of a measure; columns have different names|', 'a variable and a column')
        call same('SWEEP,LATIN', '8:12-12 error: COUNT is missing: a Latin hypercube of how '// &
            'many '// &
            'variants|', 'how many')
        call same('SWEEP,LATIN,0', '8:13-13 error: the number of variants is from 1 to 1000000|', &
            'none')
        call same('SWEEP,GRID,5', '8:12-12 error: COUNT and SEED are for SWEEP LATIN; values '// &
            'are '// &
            'counted on VARY cards|', 'a grid of five')
        call same('SWEEP,LATIN,5,-1', '8:15-16 error: SEED is from 0 to 2147483647|', 'a bad seed')
        call same('SWEEP,GRID|SWEEP,LIST', '9:1-5 error: a second SWEEP card; a deck has one|', &
            'two ways')
        call same('SWEEP,FULL', '8:7-10 error: METHOD is GRID, LATIN or LIST, not FULL|', &
            'another way')
    end subroutine more_refusals

end program test_job_wanted
