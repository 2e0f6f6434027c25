!> Gaps of sections, said of their cards.
program test_gap_faults
    use base_fault, only: fault_list_type
    use body_body, only: body_type
    use body_build, only: build_body
    use body_gap_faults, only: report_gaps, warn_of_turns
    use body_ledger, only: joint_type
    use deck_job, only: job_type
    use support_job_deck, only: job_of, words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call tap%same(gaps_of('4.'), '', 'a section without gaps')
    call tap%has(gaps_of('6.'), '10:9-10 error: no conic from STA 0. to 10.: ', &
        'a shoulder point outside of its triangle')
    call tap%same(gaps_of('.5'), '10:16-18 warning: the section turns by more than 180 degrees '// &
        'from STA 0. to 10.: its shoulder point and the intersection of its end tangents are '// &
        'on different sides of the chord|', 'a shoulder point beyond the chord')
    call tap%ok(count_of(gaps_of('6.', 'SYMMETRY,NO|', ',,,BOTH'), 'no conic') == 1, &
        'of a section of BOTH sides it is said once')
    call tap%ok(count_of(gaps_of('6.', 'SYMMETRY,NO|', ',,,PORT'), 'no conic') == 1, &
        'of one to port, too')
    call tap%ok(count_of(gaps_of('.5', 'SYMMETRY,NO|', ',,,BOTH'), 'turns by more') == 1, &
        'and once that it turns the long way round')
    call tap%finish()

contains

    !> What is wrong with a section whose shoulder point is at WL 4 and some BL; its corner is at 5.
    function gaps_of(breadth, before, sides) result(words)
        character(*), intent(in) :: breadth
        character(*), intent(in), optional :: before    !! cards
        character(*), intent(in), optional :: sides     !! fields behind S3
        character(:), allocatable :: words
        type(job_type) :: job
        type(body_type) :: body
        type(joint_type), allocatable :: joints(:)
        type(fault_list_type) :: faults
        character(:), allocatable :: first, behind
        first = ''
        behind = ''
        if (present(before)) first = before
        if (present(sides)) behind = sides
        call job_of(first// &
            'LINE,TOP,SIDE|STRAIGHT,0.,5.,10.,5.|LINE,SHL,SIDE|STRAIGHT,0.,4.,10.,4.|'// &
            'LINE,SHL,PLAN|STRAIGHT,0.,'//breadth//',10.,'//breadth//'|LINE,MHB,SIDE,0.|'// &
            'LINE,MHB,PLAN|STRAIGHT,0.,5.,10.,5.|SECTION,UP,TOP,SHL,MHB,0.,999.999'// &
            behind//'|STATION,1', job, faults)
        call build_body(job, 1, body, joints, faults)
        call report_gaps(job%body(1), body, faults)
        call warn_of_turns(job%body(1), body, faults)
        words = words_of(faults)
    end function gaps_of

    !> How often words stand in a text.
    pure integer function count_of(text, words) result(count)
        character(*), intent(in) :: text
        character(*), intent(in) :: words
        integer :: i
        count = 0
        do i = 1, len(text) - len(words) + 1
            if (text(i:i + len(words) - 1) == words) count = count + 1
        end do
    end function count_of

end program test_gap_faults
