!> Warnings of skins that break and of rings that do not close, on the cards of their sections.
program test_ring_faults
    use api_ring_faults, only: warn_of_ring
    use base_fault, only: fault_list_type
    use base_text, only: columns
    use body_body, only: body_type
    use body_build, only: build_body
    use body_ledger, only: joint_type
    use body_ring, only: ring_of
    use deck_job, only: job_type
    use support_job_deck, only: job_of, words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    !> A round tube of radius 5, four lines.
    character(*), parameter :: tube = 'LINE,UCL,SIDE,5.|LINE,LCL,SIDE,-5.|LINE,MHB,SIDE,0.|'// &
        'LINE,MHB,PLAN,5.|LINE,USH,SIDE,4.|LINE,USH,PLAN,3.|LINE,LSH,SIDE,-4.|'// &
        'LINE,LSH,PLAN,3.|', upper = 'SECTION,UP,UCL,USH,MHB,0.,999.999,0.,80.'
    type(tap_type) :: tap

    call tap%same(warnings(tube//upper//'|SECTION,LO,LCL,LSH,MHB,0.,999.999,0.,80.'), '', &
        'a smooth tube is not warned of')
    call tap%same(warnings(tube//upper//'|SECTION,LO,LCL,LSH,MHB,0.,-1.,0.,80.'), &
        '10:9-10 warning: on MHB the skin breaks by up to 45. degrees, at station 0., between '// &
        'UP and LO; give both the same slope, or say CHINE on its LINE card where an edge '// &
        'is meant|', &
        'a break is, on the second section')
    call tap%same(warnings(tube//upper//'|SECTION,LO,LCL,LSH,MHB,.25,999.999,0.,80.'), &
        '10:9-10 warning: on LCL the skin breaks by up to 28.072487 degrees, at station 0., '// &
        'between LO and its mirror image; make its slope there 0., or say CHINE on its LINE '// &
        'card where an edge is meant|', &
        'so is a keel')
    call tap%same(warnings(tube//upper//'|SECTION,LO,LCL,LSH,MHB,.00005,999.999,0.,80.'), '', &
        'not one of .006 degrees')
    call tap%same(warnings(chined('MHB,PLAN,5.')//upper// &
        '|SECTION,LO,LCL,LSH,MHB,0.,-1.,0.,80.'), '', 'a break on a chine is not warned of')
    call tap%same(warnings(chined('LCL,SIDE,-5.')//upper// &
        '|SECTION,LO,LCL,LSH,MHB,.25,999.999,0.,80.'), '', 'nor a keel on one')
    call tap%same(warnings(chined('LCL,SIDE,-5.')//upper// &
        '|SECTION,LO,LCL,LSH,MHB,0.,-1.,0.,80.'), '10:9-10 warning: on MHB the skin breaks by '// &
        'up to 45. degrees, at station 0., between UP and LO; give both the same slope, or say '// &
        'CHINE on its LINE card where an edge is meant|2:6-8 warning: on LCL the skin does not '// &
        'break: no two sections meet there at an angle; CHINE says nothing|', &
        'breaks elsewhere are, and a chine that is none')
    call tap%same(warnings(tube//upper), '', 'an open body may be open')
    call tap%same(warnings('CLOSE|'//tube//upper), '10:9-10 warning: from station 0. to 80. '// &
        'section UP meets no other on MHB, so that the body is not closed; let two sections '// &
        'share the line, or take CLOSE out|', 'one to be closed may not')
    call tap%same(warnings('CLOSE|SYMMETRY,NO|'//tube//upper//',BOTH'), '11:9-10 warning: '// &
        'from station 0. to 80. section UP meets no other on MHB (UP P on MHB is up to 10. '// &
        'away, at station 0.), so that the body is not closed; let two sections share the '// &
        'line, or take CLOSE out|', 'of a section on both sides once')
    call tap%finish()

contains

    !> The tube with one of its lines a chine.
    pure function chined(line) result(deck)
        character(*), intent(in) :: line !! the line, as it is in the deck
        character(:), allocatable :: deck
        integer :: last
        last = index(tube, line//'|') + len(line) - 1
        deck = columns(tube, 1, last)//',,CHINE'//columns(tube, last + 1, len(tube))
    end function chined

    !> The warnings of a deck.
    function warnings(deck) result(words)
        character(*), intent(in) :: deck
        character(:), allocatable :: words
        type(job_type) :: job
        type(body_type) :: body
        type(joint_type), allocatable :: joints(:)
        type(fault_list_type) :: faults
        call job_of(deck//'|STATION,40.', job, faults)
        call build_body(job, 1, body, joints, faults)
        call warn_of_ring(job%body(1), body, ring_of(body), faults)
        words = words_of(faults)
    end function warnings

end program test_ring_faults
