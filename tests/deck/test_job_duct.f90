!> DUCT cards: what is taken, and what is said of those that are wrong.
program test_job_duct
    use base_fault, only: fault_list_type
    use base_decimal, only: to_real
    use base_kinds, only: dp
    use deck_job, only: job_type
    use support_job_deck, only: body_text, faults_of, job_of
    use support_tap, only: tap_type
    implicit none (type, external)

    !> Three outlines, cards 1 to 12.
    character(*), parameter :: rings = 'FAIRED,A,0.|0,0|1,0|0,1|FAIRED,B,5.|0,0|1,0|0,1|'// &
        'FAIRED,C,9.|0,0|1,0|0,1|'
    type(tap_type) :: tap
    type(job_type) :: job
    type(fault_list_type) :: faults

    call job_of(rings//'DUCT,IN,A,B,C|DUCT,OUT,A|+,C|STATION,3.', job, faults)
    call tap%ok(faults%count == 0 .and. size(job%body(1)%duct) == 2, 'ducts are read')
    call tap%ok(job%body(1)%duct(1)%name == 'IN' .and. all(job%body(1)%duct(1)%outline == &
        [1, 2, 3]), 'with their outlines')
    call tap%ok(job%body(1)%duct(2)%name == 'OUT' .and. all(job%body(1)%duct(2)%outline == &
        [1, 3]), 'on several cards')
    call job_of('ARCS,.25|'//rings//'ARCS,0.|FAIRED,D,10.|0,0|1,0|0,1', job, faults)
    call tap%ok(abs(to_real(job%body(1)%outline(1)%arcs) - 0.25_dp) < 1.0e-9_dp .and. &
        abs(to_real(job%body(1)%outline(4)%arcs)) < 1.0e-9_dp, 'ARCS holds for outlines too')
    call wrong('DUCT,IN,A,BB,C', '13:11-12 error: there is no FAIRED BB before this card; did '// &
        'you mean B?|', 'a name misspelt')
    call wrong('DUCT,IN,A', '13:10-10 error: NEXT is missing: the next one aft, in this field '// &
        'and all that follow|', 'one outline')
    call wrong('DUCT,IN', '13:8-8 error: FROM NEXT are missing|', 'no outline')
    call wrong('DUCT,IN,A,C,B', '13:13-13 error: B stands forward of C; name the outlines from '// &
        'the foremost to the last|', 'outlines not in order')
    call wrong('DUCT,IN,A,B,B', '13:13-13 error: outline B twice|', 'an outline twice')
    call wrong('FAIRED,D,9.|0,0|1,0|0,1|DUCT,IN,A,C,D', '17:13-13 error: D stands at the '// &
        'station of C; a duct has one outline at a station|', 'two outlines at a station')
    call wrong('DUCT,IN,A,B|DUCT,IN,A,C', '14:6-7 error: a second DUCT IN; give it another '// &
        'name|', 'a second duct of a name')
    call wrong('DUCT,IN,A,,C', '13:11-11 error: a blank field between outlines; leave it out|', &
        'a blank field')
    call wrong('DUCT,IN,A,3.', '13:11-12 error: NEXT: a number where a name is expected; a '// &
        'name begins with a letter|', 'a number')
    call tap%same(faults_of(body_text//rings//'DUCT,UP,A,B|DUCT,IN,A,TOP|STATION,1'), &
        '19:6-7 error: there is a SECTION UP; give the duct another name|20:11-13 error: '// &
        'TOP is a LINE; a duct goes through FAIRED outlines, which are closed|', &
        'the name of a section; a line for an outline')
    call tap%same(faults_of(rings//'DUCT,IN,A,B|BODY,X|DUCT,IN,A,B'), '15:9-9 error: there is '// &
        'no FAIRED A before this card|15:11-11 error: there is no FAIRED B before this card|', &
        'outlines of another body')
    call tap%finish()

contains

    !> What is said of a card on line 13.
    subroutine wrong(card, words, name)
        character(*), intent(in) :: card    !! the card
        character(*), intent(in) :: words   !! all that is said
        character(*), intent(in) :: name    !! of the check
        call tap%same(faults_of(rings//card), words, name)
    end subroutine wrong

end program test_job_duct
