!> Cards that hold for the deck, and cards that hold for what follows.
program test_job_setting
    use base_decimal, only: to_real
    use base_exact, only: is_equal
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use deck_job, only: axis, job_type, rule
    use deck_job_setting, only: default_joint_gap
    use support_job_deck, only: body_text, faults_of, job_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(job_type) :: job
    type(fault_list_type) :: faults

    call settings()
    call bad_settings()
    call standing_orders()
    call bad_standing_orders()
    call tap%finish()

contains

    subroutine settings()
        call job_of(body_text// &
            'OUTPUT  FIE|DIGITS  4|PAGE    132     88|SYMMETRY NO|CLOSE|TOLER   .01|'// &
            'STATION 1.', job, faults)
        call tap%ok(faults%count == 0, 'settings may stand anywhere')
        call tap%ok(job%output == 'FIE' .and. job%digits == 4, 'OUTPUT and DIGITS')
        call tap%ok(job%page_columns == 132 .and. job%page_lines == 88, 'PAGE')
        call tap%ok(.not. job%is_symmetric .and. job%is_closed, 'SYMMETRY and CLOSE')
        call tap%ok(is_equal(to_real(job%joint_gap), 0.01_dp), 'TOLER')
        call job_of('UNITS   MM|SYMMETRY,YES|'//body_text//'STATION 1.', job, faults)
        call tap%ok(job%units == 'MM' .and. job%output == 'MM' .and. job%is_symmetric, &
            'without OUTPUT the listing has the unit of the deck')
        call tap%ok(is_equal(to_real(job%joint_gap), 0.025_dp), 'without TOLER a gap of .025 mm')
        call tap%ok(is_equal(to_real(default_joint_gap('INCHES')), 0.001_dp), 'or of .001 inches')
        call tap%ok(is_equal(to_real(default_joint_gap('FEET')), 0.0001_dp), 'or of .0001 feet')
    end subroutine settings

    subroutine bad_settings()
        call same('DIGITS  10', '7:9-16 error: the number is from 0 to 9|', 'too many decimals')
        call same('DIGITS  -1', '7:9-16 error: the number is from 0 to 9|', 'too few decimals')
        call same('PAGE    100     60', '7:9-16 error: a page has 80 or 132 columns|', &
            'a page too wide')
        call same('PAGE    80      19', '7:17-24 error: the number is from 20 to 999|', &
            'a page too short')
        call same('PAGE    80', &
            '7:17-24 error: LINES is missing: lines of a page, 20 to 999; without '// &
            'the card 60|', 'a page without lines')
        call same('TOLER   -1.', '7:9-16 error: the tolerance is negative|', 'a negative tolerance')
        call same('CLOSE|CLOSE', '8:1-8 error: a second CLOSE card; a deck has one|', &
            'a second CLOSE')
        call same('SYMMETRYMAYBE', '7:9-16 error: ANSWER is YES or NO, not MAYBE|', &
            'a word that is no answer')
    end subroutine bad_settings

    !> What is found wrong with a card on line 7.
    subroutine same(card, words, name)
        character(*), intent(in) :: card
        character(*), intent(in) :: words
        character(*), intent(in) :: name
        call tap%same(faults_of(body_text//card//'|STATION 1.'), words, name)
    end subroutine same

    subroutine standing_orders()
        integer :: i
        call job_of(body_text// &
            'WATERLN,0,0,9,1|FLANGE,FWD|SKIN,.5|ARCS,.01|POINTS,BL,2.|LIMIT,BL,1.,|WATERLN,0|'// &
            'BODY,B|WATERLN,0|CHECK,POINT,0,0,0,1|SKIN,0|FLANGE,AFT|POINTS,NUMBER,7|'// &
            'LIMIT,NONE|ARCS,0.|WATERLN,0|'// &
            'POINTS,LENGTH,.25|WATERLN,0|POINTS,CHORD,.01|WATERLN,0|POINTS,DEFAULT|STATION,0', &
            job, faults)
        call tap%ok(faults%count == 0, 'standing orders are read')
        associate (first => job%body(1)%cut, second => job%body(2)%cut)
            call tap%ok(.not. first(1)%is_flange_forward .and. first(1)%skin%digits == 0 .and. &
                .not. first(1)%limit(axis%bl)%has_from, 'they say nothing of cuts before')
            call tap%ok(first(2)%is_flange_forward .and. first(2)%skin%digits == 5, &
                'FLANGE and SKIN')
            call tap%ok(is_equal(to_real(first(2)%arcs), 0.01_dp) .and. &
                is_equal(to_real(first(1)%arcs), 0.0_dp) .and. &
                is_equal(to_real(second(1)%arcs), 0.01_dp) .and. &
                is_equal(to_real(second(2)%arcs), 0.0_dp), 'ARCS, from its card to the next')
            call tap%ok(first(2)%limit(axis%bl)%has_from .and. &
                .not. first(2)%limit(axis%bl)%has_to, 'LIMIT')
            call tap%ok(first(2)%points%kind == rule%step .and. &
                first(2)%points%axis == axis%bl .and. &
                is_equal(to_real(first(2)%points%step), 2.0_dp), 'POINTS by step of BL')
            call tap%ok(is_equal(to_real(first(2)%points%start), 1.0_dp), &
                'steps begin at the limit')
            call tap%ok(second(1)%is_flange_forward .and. second(1)%skin%digits == 5 .and. &
                second(1)%points%kind == rule%step, 'they go on into the next body')
            call tap%ok(is_equal(to_real(job%body(2)%check(1)%skin), 0.5_dp), &
                'SKIN holds for checks')
            call tap%ok(second(2)%points%kind == rule%number .and. second(2)%points%number == 7, &
                'NUMBER')
            call tap%ok(.not. second(2)%is_flange_forward .and. second(2)%skin%digits == 0 .and. &
                .not. any([(second(2)%limit(i)%has_from, i = 1, 3)]), 'each can be taken back')
            call tap%ok(second(3)%points%kind == rule%length .and. &
                is_equal(to_real(second(3)%points%step), 0.25_dp), 'LENGTH')
            call tap%ok(second(4)%points%kind == rule%chord .and. &
                is_equal(to_real(second(4)%points%step), 0.01_dp), 'CHORD')
            call tap%ok(second(5)%points%kind == rule%number .and. second(5)%points%number == 25, &
                'DEFAULT')
        end associate
    end subroutine standing_orders

    subroutine bad_standing_orders()
        call same('SKIN,-1', '7:6-7 error: the thickness is negative; 0. is no skin|', &
            'a negative skin')
        call same('ARCS,-.01', '7:6-9 error: the tolerance is negative; 0. ends the arcs|', &
            'a negative tolerance of arcs')
        call same('ARCS', '7:9-16 error: T is missing: how far they may be from the curves; 0. '// &
            'ends them (zero is written 0.)|', 'arcs without a tolerance')
        call same('POINTS,BL,0', '7:11-11 error: VALUE is above zero|', 'a step of zero')
        call same('POINTS,BL', &
            '7:10-10 error: VALUE is missing: step, number, arc length or tolerance|', &
            'a rule without its number')
        call same('POINTS,NUMBER,2.5', '7:15-17 error: the number of points is a whole number|', &
            'half a point')
        call same('POINTS,NUMBER,1', '7:15-15 error: the number is from 2 to 100000|', 'one point')
        call same('POINTS,DEFAULT,1', '7:16-16 error: POINTS DEFAULT has no number|', &
            'a default with number')
        call same('LIMIT,BL', &
            '7:9-9 error: FROM and TO are missing; one of them at least is a limit|', &
            'a limit without numbers')
        call same('LIMIT,NONE,,1.', '7:12-12 error: LIMIT NONE has no numbers|', &
            'no limit with numbers')
        call same('FLANGE,FORE', '7:8-11 error: SIDE is AFT or FWD, not FORE|', &
            'a flange on no side')
    end subroutine bad_standing_orders

end program test_job_setting
