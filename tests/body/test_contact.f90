!> Where curves in space come together: a circle and straight lines, by closed forms.
program test_contact
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_build, only: build_body
    use body_contact, only: contact_type, contacts_of, nearest_contact
    use body_ledger, only: joint_type
    use body_line, only: line_type
    use body_panel_side, only: arc_side, line_side, side_type
    use deck_job, only: job_type
    use geom_arc, only: arc_through, arc_type, end_type, line_between
    use support_job_deck, only: job_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(side_type) :: circle
    type(arc_type) :: arc
    type(error_type), allocatable :: error
    type(contact_type), allocatable :: found(:)
    type(contact_type) :: nearest

    call arc_through(end_type([0.0_dp, 5.0_dp], [1.0_dp, 0.0_dp]), [3.0_dp, 4.0_dp], &
        end_type([5.0_dp, 0.0_dp], [0.0_dp, -1.0_dp]), arc, error)
    circle = arc_side(arc, 10.0_dp)
    allocate (found(0))
    found = contacts_of(circle, straight([4.0_dp, -1.0_dp], [4.0_dp, 9.0_dp]), 1.0e-6_dp)
    call tap%ok(size(found) == 1, 'a line meets a quarter of a circle once')
    if (size(found) == 1) then
        call tap%near(norm2(found(1)%at - [10.0_dp, 4.0_dp, 3.0_dp]), 0.0_dp, 1.0e-14_dp, &
            'at the point of the 3-4-5 triangle')
        call tap%near(found(1)%t(2), 0.4_dp, 1.0e-14_dp, 'two fifths along the line')
    end if
    found = contacts_of(circle, straight([0.0_dp, 7.0_dp], [7.0_dp, 0.0_dp]), 1.0e-6_dp)
    call tap%ok(size(found) == 2, 'another line meets it twice')
    if (size(found) == 2) call tap%near(max(norm2(found(1)%at - [10.0_dp, 3.0_dp, 4.0_dp]), &
        norm2(found(2)%at - [10.0_dp, 4.0_dp, 3.0_dp])), 0.0_dp, 1.0e-13_dp, &
        'in order of the circle')
    found = contacts_of(circle, straight([0.0_dp, 5.0_dp], [0.0_dp, 9.0_dp]), 1.0e-6_dp)
    call tap%ok(size(found) == 1, 'a line that begins where the circle does')
    if (size(found) == 1) call tap%ok(all(abs(found(1)%t) <= 0.0_dp), &
        'meets it at the ends of both, exactly')
    found = contacts_of(circle, straight([6.0_dp, 0.0_dp], [6.0_dp, 8.0_dp]), 1.0e-6_dp)
    call tap%ok(size(found) == 0, 'a line beside it does not meet it')
    nearest = nearest_contact(circle, straight([6.0_dp, 0.0_dp], [6.0_dp, 8.0_dp]))
    call tap%near(nearest%gap, 1.0_dp, 1.0e-14_dp, 'and is one away')
    call tap%near(nearest%t(1), 1.0_dp, 0.0_dp, 'from the end of the circle')
    ! A line along STA through (BL 6, WL 6) is that far from the circle.
    nearest = nearest_contact(circle, along_sta())
    call tap%near(nearest%gap, sqrt(2.0_dp)*6.0_dp - 5.0_dp, 1.0e-14_dp, 'a skew line')
    call tap%finish()

contains

    !> A straight side at station 10.
    function straight(from, to) result(side)
        real(dp), intent(in) :: from(2) !! BL, WL
        real(dp), intent(in) :: to(2)   !! BL, WL
        type(side_type) :: side
        side = arc_side(line_between(from, to), 10.0_dp)
    end function straight

    !> A line from station 0 to 20 at BL 6, WL 6.
    function along_sta() result(side)
        type(side_type) :: side
        type(job_type) :: job
        type(body_type) :: body
        type(joint_type), allocatable :: joints(:)
        type(fault_list_type) :: faults
        type(line_type) :: line
        call job_of('LINE,L,SIDE|STRAIGHT,0,6,20,6|LINE,L,PLAN|STRAIGHT,0,6,20,6', job, faults)
        call build_body(job, 1, body, joints, faults)
        line = body%lines(1)
        side = line_side(line, 0.0_dp, 20.0_dp)
    end function along_sta

end program test_contact
