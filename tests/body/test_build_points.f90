!> Lines by points: a spline that is a parabola, a Bezier curve, what is said of bad points.
program test_build_points
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_build_points, only: build_points
    use deck_job, only: job_type, view
    use geom_chain, only: chain_from, chain_jet, chain_joints, chain_to, chain_type, chain_value
    use geom_jet, only: jet_type
    use support_job_deck, only: job_of, words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(chain_type), allocatable :: chain
    type(fault_list_type) :: faults
    type(jet_type) :: jet
    logical :: is_vertical

    call build('SPLINE,UNIFORM|1,1,PARABOLA|2,4|3,9|4,16,PARABOLA')
    call tap%near(chain_value(chain, 2.5_dp), 6.25_dp, 1.0e-14_dp, 'x**2 through its points')
    call chain_jet(chain, 3.5_dp, jet, is_vertical)
    call tap%near(jet%first, 7.0_dp, 1.0e-14_dp, 'with its slope')
    call tap%near(jet%second, 2.0_dp, 1.0e-13_dp, 'and bend')
    call tap%ok(all(chain_joints(chain) == [2.0_dp, 3.0_dp]) .and. chain_from(chain) == 1.0_dp &
        .and. chain_to(chain) == 4.0_dp, 'it goes from point to point')
    call build('SPLINE|4,16,8.|3,9|2,4|1,1,2.')
    call chain_jet(chain, 1.0_dp, jet, is_vertical)
    call tap%near(jet%first, 2.0_dp, 1.0e-14_dp, 'points may run forward; slopes are kept')
    call chain_jet(chain, nearest(4.0_dp, -1.0_dp), jet, is_vertical)
    call tap%near(jet%first, 8.0_dp, 1.0e-13_dp, 'at both ends')
    call build('SPLINE|0,0,999.999|1,2|4,3')
    call chain_jet(chain, 0.0_dp, jet, is_vertical)
    call tap%ok(is_vertical, 'a spline may begin upright')
    call tap%ok(chain_value(chain, 1.0_dp) == 2.0_dp .and. chain_value(chain, 4.0_dp) == 3.0_dp, &
        'it is at its points')
    call build('BEZIER|1,1|2,3|3,9')
    call tap%near(chain_value(chain, 2.5_dp), 6.25_dp, 1.0e-15_dp, 'the parabola of three poles')
    call tap%ok(size(chain_joints(chain)) == 0, 'is one piece')

    call build('FAIR|0,1|1,3|2,5|3,7')
    call tap%near(chain_value(chain, 1.7_dp), 4.4_dp, 1.0e-14_dp, 'points in a line are fair')
    call build('FAIR|9,0|6,4|4,-4|0,0')
    call tap%ok(chain_from(chain) == 0.0_dp .and. chain_to(chain) == 9.0_dp .and. &
        chain_value(chain, 0.0_dp) == 0.0_dp .and. chain_value(chain, 9.0_dp) == 0.0_dp, &
        'a faired line is held at its first and last point')
    call tap%ok(size(chain_joints(chain)) == 2, '... a piece from point to point')
    call build('FAIR,1.E9|1,1|2,4|3,9|4,16')
    call tap%near(chain_value(chain, 2.0_dp), 4.0_dp, 1.0e-7_dp, 'heavy weights hold it anywhere')
    call build('FAIR|0,0|1,1.|2,0|3,1.|4,0|5,1.|6,0|7,1.|8,0|9,1.|10,0')
    call tap%near(chain_value(chain, 5.0_dp) - chain_value(chain, 4.0_dp), 0.0_dp, 0.04_dp, &
        'of a zigzag a thirtieth is left, and a little from the ends')
    call tap%ok(all(chain_joints(chain) == [1.0_dp, 2.0_dp, 3.0_dp, 4.0_dp, 5.0_dp, 6.0_dp, &
        7.0_dp, 8.0_dp, 9.0_dp]), 'even stations stay what they are to the bit')
    call build('FAIR|0,0|1,5,0|2,0,3.|3,0')
    call tap%near(chain_value(chain, 1.0_dp), 0.0_dp, 1.0e-14_dp, 'a point of weight 0 is none')

    call build('FAIR|1,1')
    call tap%same(words_of(faults), &
        '2:1-1 error: a faired curve near 1 points; it takes at least 2|', 'a faired point alone')
    call build('FAIR,1.E6|1,1|5,2|2,2|9,3')
    call tap%has(words_of(faults), 'turns past the vertical', 'a faired line that turns back')
    call build('SPLINE|1,1')
    call tap%same(words_of(faults), &
        '2:1-1 error: a spline through 1 points; it takes at least 2|', 'a point alone')
    call build('SPLINE|1,1|2,2|2,2|3,3')
    call tap%same(words_of(faults), '4:1-1 error: points 2 and 3 of the spline are one; leave '// &
        'one of them out|', 'a point twice')
    call build('SPLINE|1,1|2,2|1.5,3|3,3')
    call tap%ok(.not. allocated(chain), 'points that go back make no line')
    call tap%has(words_of(faults), 'turns past the vertical', 'why is said, and they')
    call tap%ok(index(words_of(faults), '3:1-3 error') == 1, &
        'are named where the spline turns')
    call build('SPLINE|1,1|1.1,9|9,9.1|9.05,1')
    call tap%ok(.not. allocated(chain), 'a spline that swings over the vertical between points')
    call build('BEZIER|1,1')
    call tap%same(words_of(faults), &
        '2:1-1 error: a Bezier curve of one pole; it takes at least 2|', 'a pole alone')
    call build('BEZIER'//repeat('|1,1|2,2', 14))
    call tap%same(words_of(faults), '28:1-1 error: more than 26 poles; take a SPLINE, which '// &
        'follows its points|', 'too many poles')
    call build('BEZIER|1,1|4,3|3,9')
    call tap%ok(index(words_of(faults), 'turns past the vertical') > 0, 'poles that turn back')
    call tap%finish()

contains

    !> Builds the side view of a line.
    subroutine build(cards)
        character(*), intent(in) :: cards !! from field 4 of its LINE card on
        type(job_type) :: job
        type(fault_list_type) :: read_faults, none
        call job_of('LINE,A,SIDE,'//cards, job, read_faults)
        faults = none
        if (allocated(chain)) deallocate (chain)
        call build_points(job%body(1)%line(1)%view(view%side), 1.0e-3_dp, chain, faults)
    end subroutine build

end program test_build_points
