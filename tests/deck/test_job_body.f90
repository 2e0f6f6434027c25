!> SECTION, BODY and NOSE, and names put to lines.
program test_job_body
    use base_decimal, only: to_real
    use base_exact, only: is_equal
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use deck_job, only: job_type, side, view
    use support_job_deck, only: faults_of, job_of
    use support_tap, only: tap_type
    implicit none (type, external)

    character(*), &
        parameter :: lines = 'LINE,TOP,SIDE,5|LINE,SHL,SIDE,4|LINE,SHL,PLAN,4|LINE,MHB,SIDE,0|'// &
        'LINE,MHB,PLAN,5|LINE,MHB,ANGLE,88|'
    type(tap_type) :: tap
    type(job_type) :: job
    type(fault_list_type) :: faults

    call sections()
    call bad_sections()
    call sides()
    call bodies()
    call views()
    call tap%finish()

contains

    subroutine sections()
        call job_of(lines// &
            'SECTION,UP,TOP,SHL,MHB,-.5,MHB,10,20|SECTION,LOW,MHB,SHL,TOP,999.999,0,,30|'// &
            'STATION,1', job, faults)
        call tap%ok(faults%count == 0, 'sections are read')
        associate (up => job%body(1)%section(1), low => job%body(1)%section(2))
            call tap%ok(up%name == 'UP' .and. low%name == 'LOW', 'they have their names')
            call tap%ok(all(up%line == [1, 2, 3]) .and. all(low%line == [3, 2, 1]), &
                'and their lines')
            call tap%ok(.not. up%slope(1)%is_angle .and. is_equal(to_real(up%slope(1)%value), &
                -0.5_dp), 'a slope as a number')
            call tap%ok(up%slope(2)%is_angle .and. up%slope(2)%line == 3, 'a slope as an ANGLE')
            call tap%ok(is_equal(to_real(low%slope(1)%value), 999.999_dp), 'a vertical slope')
            call tap%ok(up%range%has_from .and. up%range%has_to .and. &
                up%range%from%digits == 10 .and. up%range%to%digits == 20, 'a range of stations')
            call tap%ok(.not. low%range%has_from .and. low%range%has_to, 'half a range')
            call tap%ok(up%is_sound .and. low%is_sound .and. up%side == side%starboard, &
                'they are sound')
        end associate
    end subroutine sections

    !> What is found wrong with a section on line 7, which is then not sound.
    subroutine same(card, words, name)
        character(*), intent(in) :: card
        character(*), intent(in) :: words
        character(*), intent(in) :: name
        call job_of(lines//card, job, faults)
        call tap%same(faults_of(lines//card), words, name)
        associate (section => job%body(1)%section)
            call tap%ok(.not. section(size(section))%is_sound, name//' makes no section')
        end associate
    end subroutine same

    subroutine bad_sections()
        call same('SECTION,UP,TOPP,SHL,MHB,0,0', &
            '7:12-15 error: there is no LINE TOPP; did you mean TOP?|', 'a line misspelt')
        call same('SECTION,UP,TOP,SHL,MHB,TOP,0', '7:24-26 error: LINE TOP has no ANGLE|', &
            'a slope from a line without ANGLE')
        call same('SECTION,UP,TOP,SHL,LATE,0,0|LINE,LATE,SIDE,1', &
            '7:20-23 error: SIDE of LATE is given '// &
            'only on line 8; it must be given before|', 'a line given later')
        call same('LINE,P,PLAN,1|SECTION,UP,TOP,SHL,P,0,0', '8:20-20 error: LINE P has no SIDE|', &
            'a line without SIDE')
        call same('SECTION,UP,TOP,SHL,MHB,0,0,5,5', '7:30-30 error: TO is not aft of FROM|', &
            'an empty range')
        call same('SECTION,UP,TOP,SHL,MHB,0,0|SECTION,UP,TOP,SHL,MHB,0,0', &
            '8:9-10 error: a second '//'SECTION UP; give it another name|', 'a name twice')
        call same('LINE,C,SIDE|CIRCLE,1|SECTION,UP,TOP,SHL,C,0,0', &
            '8:9-9 error: Y1 X2 Y2 X3 Y3 are '// &
            'missing (zero is written 0.)|', 'a line with a bad card')
        call job_of(lines//'SECTION,UP,TOP,TOP,MHB,0,0|STATION,1', job, faults)
        call tap%ok(faults%count == 1 .and. .not. faults%has_errors(0) .and. &
            job%body(1)%section(1)%is_sound, 'a shoulder line without PLAN is warned of, and taken')
    end subroutine bad_sections

    subroutine sides()
        call same('SECTION,UP,TOP,SHL,MHB,0,0,,,PORT', &
            '7:30-33 error: PORT in a symmetric body; SYMMETRY NO makes its sides different|', &
            'PORT in a symmetric body')
        call job_of(lines//'SECTION,A,TOP,SHL,MHB,0,0,,,PORT|SECTION,B,TOP,SHL,MHB,0,0,,,BOTH|'// &
            'SECTION,C,TOP,SHL,MHB,0,0,,,STBD|STATION,1|SYMMETRY,NO', job, faults)
        call tap%ok(faults%count == 0, 'SYMMETRY NO may come later')
        call tap%ok(all(job%body(1)%section%side == [side%port, side%both, side%starboard]), &
            'sections know their side')
    end subroutine sides

    subroutine bodies()
        call job_of('BODY,HULL|NOSE,.5|'//lines//'SECTION,A,TOP,SHL,MHB,0,0|STATION,1|'// &
            'BODY,BLISTER|NOSE,2|LINE,TOP,SIDE,1|STATION,1|STATION,2', job, faults)
        call tap%ok(faults%count == 0 .and. size(job%body) == 2, 'a BODY card begins a body')
        call tap%ok(job%body(1)%name == 'HULL' .and. job%body(2)%name == 'BLISTER', &
            'bodies have names')
        call tap%ok(all([size(job%body(1)%line), size(job%body(1)%section), &
            size(job%body(1)%cut)] == [3, 1, 1]), 'what stands before belongs to the first')
        call tap%ok(all([size(job%body(2)%line), size(job%body(2)%section), &
            size(job%body(2)%cut)] == [1, 0, 2]), 'what stands behind to the second')
        call tap%ok(job%body(1)%has_nose .and. is_equal(to_real(job%body(1)%nose_radius), 0.5_dp), &
            'NOSE')
        call tap%ok(job%body(2)%nose_card%sheet(1)%line == 12, 'each body has its own')
        call job_of('CHECK,POINT,0,0,0,1|BODY,B', job, faults)
        call tap%ok(size(job%body) == 2 .and. job%body(1)%name == '', &
            'cards before BODY are a body')
        call tap%same(faults_of('BODY,A|BODY,B|BODY,A'), '3:6-6 error: a second body A|', &
            'a body twice')
        call tap%same(faults_of('NOSE,1|NOSE,1'), &
            '2:1-4 error: a second NOSE card; a body has one|', 'two noses')
        call tap%same(faults_of('NOSE,0'), &
            '1:6-6 error: the radius of a rounded nose is above zero; '// &
            'without the card it is sharp|', 'a nose of no radius')
        call tap%same(faults_of(lines//'BODY,B|LINE,X,SIDE,TOP'), &
            '8:13-15 error: there is no LINE TOP in this body|', 'lines are of one body')
    end subroutine bodies

    subroutine views()
        call job_of(lines//'LINE,A,PLAN,MHB|LINE,B,PLAN,A|LINE,C,PLAN,B', job, faults)
        call tap%ok(job%body(1)%line(6)%view(view%plan)%line == 5, &
            'a view taken over may be taken over')
        call tap%ok(job%body(1)%line(6)%view(view%plan)%is_sound, 'and is sound')
        call job_of('LINE,A,PLAN|CIRCLE,1|LINE,B,PLAN,A|LINE,C,PLAN,B', job, faults)
        call tap%ok(.not. job%body(1)%line(3)%view(view%plan)%is_sound, 'unless its source is not')
        call tap%same(faults_of('LINE,A,PLAN,A'), &
            '1:13-13 error: PLAN of A is given only on line 1; it '// &
            'must be given before|', 'a line is not taken from itself')
    end subroutine views

end program test_job_body
