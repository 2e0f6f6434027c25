!> FAIRED cards and the points under them.
program test_job_outline
    use base_decimal, only: to_real
    use base_exact, only: is_equal
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use deck_job, only: ending, job_type, piece_real
    use support_job_deck, only: faults_of, job_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(job_type) :: job
    type(fault_list_type) :: faults

    call job_of('FAIRED,IN,4.,100.,.25,1.18|1,0|0,1,7.|-1,0|FAIRED,OUT,5.|0,0|1,0|1,1|'// &
        'BODY,B|FAIRED,IN,4.|0,0|1,0|1,1', job, faults)
    call tap%ok(faults%count == 0, 'outlines are read, without a section too')
    call tap%ok(size(job%body) == 2 .and. size(job%body(1)%outline) == 2 .and. &
        size(job%body(2)%outline) == 1, 'they belong to bodies')
    associate (item => job%body(1)%outline)
        call tap%ok(item(1)%name == 'IN' .and. item(2)%name == 'OUT' .and. all(item%is_sound), &
            'each has its name')
        call tap%ok(all(is_equal(to_real([item(1)%sta, item(1)%weight, item(1)%beta, &
            item(1)%area]), [4.0_dp, 100.0_dp, 0.25_dp, 1.18_dp])) .and. item(1)%has_area, &
            'station, weight, beta and area')
        call tap%ok(all(is_equal(to_real([item(2)%weight, item(2)%beta]), [10.0_dp, 0.5_dp])) &
            .and. .not. item(2)%has_area, 'what they are where they are not said')
        call tap%ok(size(item(1)%piece) == 3 .and. item(1)%piece(2)%ending == ending%weight .and. &
            is_equal(piece_real(item(1)%piece(2), 3), 7.0_dp), 'points, one with its weight')
    end associate
    call tap%same(faults_of('FAIRED,A,0.,0.,1.1,-2.|0,0|1,0|0,1'), '1:13-14 error: WEIGHT is '// &
        'above zero|1:16-18 error: BETA is from 0 to 1|1:20-22 error: AREA is above zero, '// &
        'whichever way round the points run|', 'figures that can''t be')
    call tap%same(faults_of('FAIRED,A,0.|0,0|1,0|0,1|FAIRED,A,1.|0,0|1,0|0,1'), &
        '5:8-8 error: a second FAIRED A; give it another name|', 'a name twice')
    call tap%same(faults_of('FAIRED,A,0.|STATION,1.'), '1:8-8 error: a FAIRED outline without '// &
        'points; they follow, BL and WL, one on a card|', 'no points')
    call tap%same(faults_of('FAIRED,A|0,0|1,O|0,1'), '1:9-9 error: STA is missing: its station '// &
        '(zero is written 0.)|3:3-3 error: Y: the letter O in a number; the figure is 0|', &
        'points under a bad card')
    call tap%ok(index(faults_of('FAIRED,A,0.|0,0|RHO,1,1,1,2,2,1,.5'), '3:1-3 error: a conic') &
        == 1, 'a conic among the points')
    call tap%finish()

end program test_job_outline
