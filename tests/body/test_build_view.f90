!> Composite views from their cards: gaps, breaks, turns, cards that run fore.
program test_build_view
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_build_view, only: build_view
    use body_ledger, only: joint_type
    use deck_job, only: job_type, view
    use geom_chain, only: chain_from, chain_to, chain_type, chain_value
    use support_job_deck, only: job_of, words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(chain_type), allocatable :: chain
    type(joint_type), allocatable :: joints(:)
    type(fault_list_type) :: faults

    call build('0.,0.,999.999,.2,.6,1.,1.,0.|STRAIGHT,1.,1.,5.,1.|RADIUS,5.,1.,6.,0.,-1.', 0.001_dp)
    call tap%same(words_of(faults), '', 'a nose, a straight piece and a tail make a line')
    call tap%ok(size(joints) == 2, 'with two joints')
    call tap%ok(all(joints%sta == [1.0_dp, 5.0_dp]) .and. all(joints%view == view%side) .and. &
        all(joints%line == 'A'), 'that know where they are')
    call tap%ok(chain_from(chain) == 0.0_dp .and. chain_to(chain) == 6.0_dp, 'from end to end')
    call tap%near(chain_value(chain, 5.6_dp), 0.8_dp, 4.0e-16_dp, 'through the tail')

    call build('RADIUS,6.,0.,5.,1.,1.|STRAIGHT,5.,1.,1.,1.|1.,1.,0.,.2,.6,0.,0.,999.999', 0.001_dp)
    call tap%same(words_of(faults), '', 'so do cards from aft to fore')
    call tap%ok(all(joints%sta == [1.0_dp, 5.0_dp]), 'joints stand fore to aft all the same')
    call build('RADIUS,6.,0.,5.,1.,1.|STRAIGHT,1.,1.,5.,1.|1.,1.,0.,.2,.6,0.,0.,999.999', 0.001_dp)
    call tap%same(words_of(faults), '', 'also where one card runs aft')

    call build('STRAIGHT,0.,0.,1.,0.|STRAIGHT,1.,0.,2.,1.', 0.001_dp)
    call tap%same(words_of(faults), '3:10-11 warning: the slope breaks by 45. degrees at 1.; '// &
        'correct an end slope, or say KNUCKLE where it is meant to|', 'a slope break is warned of')
    call tap%ok(allocated(chain), 'and built')
    call build('STRAIGHT,0.,0.,1.,0.|STRAIGHT,1.,0.,2.,1.,KNUCKLE', 0.001_dp)
    call tap%same(words_of(faults), '', 'a KNUCKLE is not')
    call tap%ok(joints(1)%is_knuckle, 'it is one in the ledger')
    call build('STRAIGHT,2.,1.,1.,0.|STRAIGHT,1.,0.,0.,0.,KNUCKLE|STRAIGHT,0.,0.,-1.,0.', 0.001_dp)
    call tap%ok(all(joints%is_knuckle .eqv. [.false., .true.]), &
        'at its joint, also where cards run fore')

    call build('STRAIGHT,0.,0.,1.,0.|STRAIGHT,1.,.5,2.,.5', 0.001_dp)
    call tap%same(words_of(faults), &
        '3:10-20 error: the line goes on at (1., 0.5), but the card before '// &
        'ends at (1., 0.), 0.5 away; make it the same point (TOLER allows 0.001)|', &
        'a gap is an error')
    call tap%ok(.not. allocated(chain) .and. size(joints) == 0, 'and nothing is built')
    call build('STRAIGHT,0.,0.,1.,0.|STRAIGHT,1.,.0009,2.,.0009', 0.001_dp)
    call tap%same(words_of(faults), '', 'within TOLER it is not')
    call tap%near(joints(1)%jump%gap, 0.0009_dp, 0.0_dp, 'but told')
    call build('STRAIGHT,0.,0.,1.,0.|STRAIGHT,0.,0.,-1.,0.', 0.001_dp)
    call tap%same(words_of(faults), &
        '3:10-21 error: the line goes on at (-1., 0.), but the card before '// &
        'ends at (1., 0.), 2. away; make it the same point (TOLER allows 0.001)|', &
        'cards out of order are a gap')

    call build('0.,0.,999.999,.2,.6,1.,1.,0.|CIRCLE,1.,1.,2.,0.,1.6,-.8', 0.001_dp)
    call tap%ok(faults%count == 1 .and. &
        index(words_of(faults), '3:8-26 error: the arc from (1., 1.) '// &
        'to (1.6, -0.8) turns past the vertical at (2., ') == 1, &
        'an arc back is an error on its card')
    call build('STRAIGHT,0.,0.,0.,1.', 0.001_dp)
    call tap%same(words_of(faults), &
        '2:10-20 error: the arc begins and ends at 0.; it must lead from '// &
        'one station to another|', 'so is an upright line')
    call build('STRAIGHT,0.,0.,1.,1.|1.,1.,0.,3.,3.,2.,2.,0.|STRAIGHT,2.,2.,3.,3.', 0.001_dp)
    call tap%ok(faults%count == 1 .and. faults%item(1)%line == 3, &
        'a card without an arc is blamed once')
    call build('STRAIGHT,0.,0.,5.,0.|5.,0.,0.,,,10.,-5.,999.999,MATCH', 0.001_dp)
    call tap%same(words_of(faults), '3:1-26 error: the neighbour is straight at the joint, '// &
        'and a conic is straight nowhere; only a straight line matches its curvature 0|', &
        'a MATCH that has none is said why')
    call tap%finish()

contains

    !> Builds the side view of line A from cards, the first on line 2.
    subroutine build(cards, gap)
        character(*), intent(in) :: cards
        real(dp), intent(in) :: gap
        type(job_type) :: job
        type(fault_list_type) :: read_faults, none
        call job_of('LINE,A,SIDE|'//cards//'|LINE,B,SIDE,0.', job, read_faults)
        faults = none
        if (allocated(joints)) deallocate (joints)
        allocate (joints(0))
        call build_view(job%body(1)%line(1), view%side, gap, chain, joints, faults)
    end subroutine build

end program test_build_view
