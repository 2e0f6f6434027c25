!> Control lines from LINE cards: views of their own, constant, taken over, in a circle, apart.
program test_build_lines
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_build_lines, only: build_lines
    use body_ledger, only: joint_type
    use body_line, only: line_type
    use deck_job, only: job_type
    use geom_chain, only: chain_value
    use support_job_deck, only: job_of, words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type), allocatable :: lines(:)
    type(joint_type), allocatable :: joints(:)
    type(fault_list_type) :: faults

    call build('LINE,USH,SIDE|STRAIGHT,0.,4.,10.,5.|LINE,LSH,SIDE,-3.|LINE,LSH,PLAN|'// &
        'STRAIGHT,0.,1.,8.,2.|LINE,USH,PLAN,LSH|LINE,CL,SIDE,7.5|LINE,A,ANGLE,95.|LINE,B,SIDE,CL')
    call tap%same(words_of(faults), '', 'lines of all kinds are built')
    call tap%ok(size(lines) == 5 .and. lines(1)%name == 'USH' .and. lines(5)%name == 'B', &
        'in their order')
    call tap%ok(lines(1)%has_plan .and. chain_value(lines(1)%plan, 4.0_dp) == 1.5_dp, &
        'a plan is taken over from another line')
    call tap%ok(lines(1)%from == 0.0_dp .and. lines(1)%to == 8.0_dp, 'and limits the line')
    call tap%ok(chain_value(lines(2)%side, 4.0_dp) == -3.0_dp, 'a constant is one')
    call tap%ok(lines(2)%from == 0.0_dp .and. lines(2)%to == 8.0_dp, 'without limit')
    call tap%ok(.not. lines(3)%has_plan .and. chain_value(lines(3)%plan, 99.0_dp) == 0.0_dp, &
        'a centre line is at BL 0')
    call tap%ok(lines(4)%has_angle .and. .not. lines(4)%has_side .and. &
        chain_value(lines(4)%angle, 1.0_dp) == 95.0_dp, 'an angle is in degrees and may pass 90')
    call tap%ok(chain_value(lines(5)%side, 1.0_dp) == 7.5_dp, 'a constant is taken over')

    call build('LINE,A,PLAN,3.|LINE,B,PLAN,4.|LINE,C,SIDE|STRAIGHT,0.,4.,10.,5.|'// &
        'LINE,B,SIDE,C|LINE,A,SIDE,B')
    call tap%ok(lines(1)%has_side .and. lines(1)%to == 10.0_dp, 'a view is taken over twice')
    call build('LINE,A,SIDE,B|LINE,D,SIDE,0.')
    call tap%ok(faults%count == 0 .and. .not. lines(1)%has_side .and. lines(2)%has_side, &
        'from a line that is not there nothing is; that was said when the deck was read')
    call build('LINE,A,SIDE|STRAIGHT,0.,4.,10.,5.|LINE,A,PLAN|STRAIGHT,11.,4.,20.,5.')
    call tap%same(words_of(faults), &
        '3:6-6 error: the side view of A is from 0. to 10., its plan view '// &
        'from 11. to 20.; they have no station in common|', 'views apart are an error')
    call tap%ok(.not. lines(1)%has_side, 'and no line')
    call build('LINE,A,SIDE|STRAIGHT,0.,4.,0.,5.|LINE,B,SIDE,A')
    call tap%ok(faults%count == 1 .and. .not. (lines(1)%has_side .or. lines(2)%has_side), &
        'a view in error is said once, and not taken over')
    call tap%finish()

contains

    !> Builds the lines of a deck.
    subroutine build(deck)
        character(*), intent(in) :: deck
        type(job_type) :: job
        type(fault_list_type) :: read_faults, none
        call job_of(deck, job, read_faults)
        faults = none
        if (allocated(joints)) deallocate (joints)
        allocate (joints(0))
        call build_lines(job%body(1), 0.001_dp, lines, joints, faults)
    end subroutine build

end program test_build_lines
