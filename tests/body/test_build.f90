!> Bodies from decks: the nose of SAE 700202 against its printed lines, sections and their ranges.
program test_build
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_build, only: build_body
    use body_ledger, only: joint_type
    use deck_job, only: job_type
    use geom_chain, only: chain_value
    use support_job_deck, only: body_text, job_of, words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    !> Table 1 of SAE 700202.
    character(*), parameter :: nose = 'LINE,MHB,SIDE|-30.,-10.,.114,0.,-7.1,50.,-4.,.0523|'// &
        'LINE,MHB,PLAN|-30.,0.,.577,0.,11.9,50.,21.5,.1405|'// &
        'LINE,LSH,SIDE|-30.,-10.,-.268,0.,-16.,50.,-21.2,-.0697|'// &
        'LINE,LSH,PLAN|-30.,0.,.404,0.,9.,50.,18.2,.1316|'// &
        'LINE,LCL,SIDE|-30.,-10.,-.384,0.,-18.,50.,-24.1,-.0871|'
    !> What the program of 1970 added to an ordinate before it printed three decimals.
    real(dp), parameter :: half = 0.0005_dp
    type(tap_type) :: tap
    type(body_type) :: body
    type(joint_type), allocatable :: joints(:)
    type(fault_list_type) :: faults

    call build(nose//'SECTION,LOWER,LCL,LSH,MHB,0.,999.999')
    call tap%same(words_of(faults), '', 'the nose of SAE 700202 is built')
    call tap%ok(size(body%lines) == 3 .and. size(body%sections) == 1 .and. size(joints) == 0, &
        'of three lines and a section')
    call tap%near(chain_value(body%lines(1)%side, 10.0_dp) + half, -6.358_dp, half, &
        'MHB at station 10 is at WL -6.358')
    call tap%near(chain_value(body%lines(1)%plan, 10.0_dp) + half, 14.415_dp, half, &
        'and BL 14.415, as printed')
    call tap%near(chain_value(body%lines(3)%side, 20.0_dp) + half, -20.999_dp, half, &
        'LCL at station 20 is at WL -20.999')
    call tap%near(chain_value(body%lines(2)%plan, 30.0_dp) + half, 15.144_dp, half, &
        'LSH at station 30 is at BL 15.144')
    call tap%ok(body%sections(1)%from == -30.0_dp .and. body%sections(1)%to == 50.0_dp, &
        'the section is where they are')
    call tap%ok(all(body%sections(1)%line == [3, 2, 1]), 'on its lines')
    call tap%ok(all(body%sections(1)%slope(2)%direction == [0.0_dp, 1.0_dp]), '999.999 is upright')
    call tap%ok(body%is_symmetric .and. .not. (body%has_nose .or. body%is_closed), &
        'the body is as said')

    call build(nose//'SECTION,LOWER,LCL,LSH,MHB,0.,999.999,-10.,60.')
    call tap%ok(body%sections(1)%from == -10.0_dp .and. body%sections(1)%to == 50.0_dp, &
        'a section may be limited, and is by its lines')
    call build(nose//'SECTION,LOWER,LCL,LSH,MHB,0.,999.999,60.,70.')
    call tap%same(words_of(faults), &
        '11:9-13 error: section LOWER has no stretch of stations: LCL is '// &
        'from -30. to 50., LSH is from -30. to 50., MHB is from -30. to 50., '// &
        'drawn in to its own range '// &
        'and slopes nothing is left; lengthen a line, or correct FROM and TO|', &
        'but not to where they are not')
    call tap%ok(size(body%sections) == 0, 'then there is none')
    call build('NOSE,2.|CLOSE|SYMMETRY,NO|'//nose//'LINE,ANG,ANGLE|STRAIGHT,-20.,80.,40.,95.|'// &
        'SECTION,LOWER,LCL,LSH,MHB,0.,ANG,,,BOTH')
    call tap%ok(size(body%sections) == 2, 'a section of both sides is two')
    call tap%ok(all(body%sections%is_port .eqv. [.false., .true.]), 'one of them port')
    call tap%ok(body%sections(1)%from == -20.0_dp .and. body%sections(1)%to == 40.0_dp, &
        'its slope line limits it')
    call tap%ok(body%has_nose .and. body%nose_radius == 2.0_dp .and. body%is_closed .and. &
        .not. body%is_symmetric, 'nose, closure and symmetry are as said')

    call build(body_text)
    call tap%ok(faults%count == 1 .and. size(body%sections) == 0, &
        'a section of constants has no end')
    call build(body_text(:index(body_text, '|', back=.true.) - 1)//',0.,10.')
    call tap%ok(faults%count == 0 .and. body%sections(1)%to == 10.0_dp, &
        'unless it says FROM and TO')
    call build('LINE,LCL,SIDE|STRAIGHT,0.,0.,0.,1.|'// &
        nose(index(nose, '|LINE,LSH') + 1:index(nose, 'LINE,LCL') - 1)// &
        nose(:index(nose, '|LINE,LSH'))//'SECTION,LOWER,LCL,LSH,MHB,0.,999.999')
    call tap%ok(faults%count == 1 .and. size(body%sections) == 0 .and. size(body%lines) == 3, &
        'on a line in error there is no section, and no second fault')
    call tap%finish()

contains

    !> Builds the first body of a deck.
    subroutine build(deck)
        character(*), intent(in) :: deck
        type(job_type) :: job
        type(fault_list_type) :: read_faults, none
        call job_of(deck, job, read_faults)
        if (read_faults%has_errors(0)) call tap%note(words_of(read_faults))
        faults = none
        call build_body(job, 1, body, joints, faults)
    end subroutine build

end program test_build
