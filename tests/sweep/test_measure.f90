!> Measures that the closed forms of test_variant leave out: joints of lines, and why there is none.
program test_measure
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_build, only: build_body
    use deck_job, only: job_type
    use support_job_deck, only: body_text, job_of, words_of
    use support_tap, only: tap_type
    use sweep_measure, only: measure_of, measured_type, value_type
    implicit none (type, external)

    !> Quarter circles of radius 10 and 5 with a common tangent, then a knuckle; half a circle of
    !> radius 2 gives the second line a joint of its own.
    character(*), parameter :: lines = 'LINE,A,SIDE|CIRCLE,0.,0.,4.,8.,10.,10.|'// &
        'CIRCLE,10.,10.,14.,8.,15.,5.|STRAIGHT,15.,5.,20.,5.,KNUCKLE|'// &
        'LINE,B,SIDE|STRAIGHT,0.,0.,5.,0.|STRAIGHT,5.,0.,10.,5.|'
    type(tap_type) :: tap

    call joints('JUMP,MIN', 0.1_dp, 'the greatest jump, -1/10 to -1/5; no knuckle counts')
    call joints('JUMP,MIN,,A', 0.1_dp, 'that of a line')
    call joints('JUMP,MIN,,B', 0.0_dp, 'of straight lines there is none')
    call joints('JUMP,MIN,,TOP', 0.0_dp, 'nor of a line without joints')
    call joints('BREAK,MIN', 45.0_dp, 'the greatest break of slope')
    call joints('BREAK,MIN,,A', 0.0_dp, 'a knuckle is none')
    call none('VOLUME,MAX', 'the section is open at BL', 'an open body has no volume')
    call none('CENTROID,SHOW', 'the section is open at BL', 'and no centroid')
    call none('AREA,MAX,,1.', 'the section is open at BL', 'no area')
    call none('WIDTH,MAX,,1.,99.', 'does not meet waterline 99.', 'no width above it')
    call none('HEIGHT,MAX,,1.,1.', 'meets only once butt line 1.', 'no height of half a section')
    call none('GIRTH,MAX,,99.', 'no section at station 99.', 'no girth where it is not')
    call none('CLEAR,MAX', 'no CHECK card', 'no clearance of nothing')
    call tap%finish()

contains

    !> The value of a measure.
    subroutine take(card, value)
        character(*), intent(in) :: card
        type(value_type), intent(out) :: value
        type(job_type) :: job
        type(fault_list_type) :: faults
        type(measured_type) :: measured
        call job_of(body_text//'SECTION,LO,TOP,SHL,MHB,0.,999.999,0.,20.|'//lines// &
            'STATION,1|OBJECT,'//card, job, faults)
        if (faults%has_errors(0)) call tap%note(words_of(faults))
        job%body(1)%section = job%body(1)%section(2:)
        call build_body(job, 1, measured%body, measured%joints, faults)
        allocate (measured%clearances(0))
        call measure_of(measured, job%sweep%wanted(1), value)
    end subroutine take

    subroutine joints(card, expected, name)
        character(*), intent(in) :: card, name
        real(dp), intent(in) :: expected
        type(value_type) :: value
        call take(card, value)
        call tap%ok(.not. allocated(value%why), 'there is '//card)
        call tap%near(value%number, expected, 1.0e-12_dp, name)
    end subroutine joints

    subroutine none(card, why, name)
        character(*), intent(in) :: card, why, name
        type(value_type) :: value
        call take(card, value)
        call tap%ok(allocated(value%why), name)
        if (allocated(value%why)) call tap%has(value%why, why, 'it says why')
        call tap%near(value%number, 0.0_dp, 0.0_dp, 'it is zero')
    end subroutine none

end program test_measure
