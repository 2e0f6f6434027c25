!> BLEND among the data cards of a line.
program test_job_blend
    use base_exact, only: is_equal
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use deck_job, only: job_type, piece, piece_real, view
    use support_job_deck, only: faults_of, job_of
    use support_tap, only: tap_type
    implicit none (type, external)

    !> A line and a circle.
    character(*), parameter :: first = 'LINE,A,SIDE|STRAIGHT,0.,0.,1.,0.|', &
        second = '|RADIUS,2.,1.,3.,2.,9.'
    type(tap_type) :: tap
    type(job_type) :: job
    type(fault_list_type) :: faults

    call job_of(first//'BLEND'//second//'|BLEND,45.,20.|STRAIGHT,4.,4.,5.,5.', job, faults)
    call tap%ok(.not. faults%has_errors(0), 'BLEND cards are read')
    associate (side => job%body(1)%line(1)%view(view%side))
        call tap%ok(side%is_sound .and. all(side%piece%kind == [piece%straight, piece%blend, &
            piece%radius, piece%blend, piece%straight]), 'as pieces of their line')
        call tap%ok(is_equal(piece_real(side%piece(4), 1), 45.0_dp) .and. &
            is_equal(piece_real(side%piece(4), 2), 20.0_dp), 'with ALPHA and THETA')
        call tap%ok(is_equal(piece_real(side%piece(2), 1), 0.0_dp), 'ALPHA is 0 where blank')
    end associate
    call said('LINE,A,SIDE|BLEND|STRAIGHT,0.,0.,1.,0.', '2:1-8 error: a BLEND before', 'first')
    call said(first//'BLEND', '3:1-8 error: a BLEND behind the data cards', 'last')
    call said(first//'BLEND|BLEND'//second, '4:1-8 error: a BLEND behind a BLEND', 'twice')
    call said(first//'BLEND,0.'//second, &
        '3:7-8 error: ALPHA of a BLEND is above 0 and not above 90. degrees', 'no ALPHA')
    call said(first//'BLEND,91.'//second, '3:7-9 error: ALPHA', 'too much ALPHA')
    call said(first//'BLEND,,-1.'//second, &
        '3:8-10 error: THETA of a BLEND is above 0 and not above 80. degrees', 'no THETA')
    call said(first//'BLEND,,81.'//second, '3:8-10 error: THETA', 'too much THETA')
    call said(first//'BLEND|0.,0.,0.,,,1.,1.,1.,MATCH', '4:1-2 error: MATCH behind a BLEND', &
        'MATCH')
    call said(first//'BLEND,60.,KNUCKLE'//second, 'error: THETA is a number', 'a word')
    call said('LINE,A,SIDE,SPLINE|0.,0.|BLEND|1.,1.', 'error: a conic under a LINE by points', &
        'under a SPLINE')
    call tap%finish()

contains

    !> Checks what is said of a deck.
    subroutine said(deck, part, name)
        character(*), intent(in) :: deck    !! its lines with `|` between them
        character(*), intent(in) :: part    !! of what is said
        character(*), intent(in) :: name    !! the check as a phrase
        call tap%has(faults_of(deck), part, 'said of a BLEND: '//name)
    end subroutine said

end program test_job_blend
