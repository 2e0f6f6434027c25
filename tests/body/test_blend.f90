!> BLEND cards in lines: what is cut off, how joints go on, and what is refused, on which columns.
program test_blend
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_build_view, only: build_view
    use body_ledger, only: bends_on, is_broken, joint_type
    use deck_job, only: job_type, view
    use geom_chain, only: chain_from, chain_to, chain_type
    use geom_place, only: at_finish, at_start
    use geom_stroke, only: is_straight, stroke_curvature, stroke_kind
    use support_job_deck, only: job_of, words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    !> A level line at 10 and a circle of radius 5 about (20, 4): 6 apart.
    character(*), parameter :: level = 'STRAIGHT,0.,10.,15.,10.', &
        falling = 'RADIUS,23.,8.,25.,4.,-5.'
    type(tap_type) :: tap
    type(chain_type), allocatable :: chain
    type(joint_type), allocatable :: joints(:)
    type(fault_list_type) :: faults

    call check_line()
    call check_circles()
    call check_refused()
    call tap%finish()

contains

    !> Line to circle, circle to line, both, and run fore.
    subroutine check_line()
        call build(level//'|BLEND|'//falling)
        call tap%same(words_of(faults), '', 'a line is joined to a circle')
        call look('line to circle', 3)
        if (.not. allocated(chain)) return
        call tap%ok(is_straight(chain%stroke(1)) .and. &
            chain%stroke(2)%kind == stroke_kind%cyclic, 'by a C-Bezier curve')
        call tap%ok(all(chain%stroke(1)%finish == chain%stroke(2)%start) .and. &
            chain%stroke(1)%finish(2) == 10.0_dp, 'that begins on the line, which ends there')
        call tap%near(norm2(chain%stroke(3)%start - [20.0_dp, 4.0_dp]), 5.0_dp, 1.0e-14_dp, &
            'and ends on the circle')
        call tap%near(stroke_curvature(chain%stroke(3), at_start), -0.2_dp, 1.0e-14_dp, &
            'which is the same')
        call tap%ok(chain%stroke(2)%alpha > 1.047_dp .and. chain%stroke(2)%alpha < 1.048_dp, &
            'ALPHA is 60 where the card does not say it')
        call build(level//'|BLEND,90.|'//falling)
        call look('with ALPHA 90', 3)
        call build('RADIUS,15.,4.,17.,8.,-5.|BLEND|STRAIGHT,22.,10.,40.,10.')
        call look('circle to line', 3)
        call build('STRAIGHT,0.,6.,10.,8.|BLEND|RADIUS,15.5,9.084,19.5,9.084,-12.|BLEND|'// &
            'STRAIGHT,25.,8.,40.,5.')
        call look('line, circle, line', 5)
        call build('STRAIGHT,40.,5.,25.,8.|BLEND|RADIUS,15.5,9.084,19.5,9.084,-12.|BLEND|'// &
            'STRAIGHT,10.,8.,0.,6.')
        call look('the same run fore', 5)
        call build('STRAIGHT,0.,0.,10.,0.|BLEND|10.,1.,0.,13.,2.,14.,5.,999.999')
        call tap%ok(index(words_of(faults), 'neither a straight line nor a circular arc') > 0, &
            'an ellipse is no circle')
        call build('STRAIGHT,0.,-1.,10.,-1.|BLEND|10.,0.,0.,13.,1.,15.,5.,999.999')
        call look('a conic card that is a circle', 3)
    end subroutine check_line

    !> S and C.
    subroutine check_circles()
        call build('RADIUS,-4.,3.,0.,5.,-5.|BLEND|RADIUS,9.,3.,15.,3.,5.')
        call look('S between circles', 3)
        call build('RADIUS,-10.,0.,-8.,6.,-10.|BLEND|RADIUS,8.727,14.564,16.727,14.564,-30.')
        call look('C between circles', 3)
        call build('RADIUS,-4.,3.,0.,5.,-5.|BLEND,60.,20.|RADIUS,9.,3.,15.,3.,5.')
        call look('S of a given THETA', 3)
    end subroutine check_circles

    !> Checks that a line has so many strokes, and that slope and curvature go on at all joints.
    subroutine look(name, strokes)
        character(*), intent(in) :: name    !! of the line
        integer, intent(in) :: strokes      !! wanted
        integer :: i
        logical :: goes_on

        call tap%same(words_of(faults), '', name//': nothing is wrong')
        call tap%ok(allocated(chain), name//': a line is built')
        if (.not. allocated(chain)) return
        call tap%ok(size(chain%stroke) == strokes .and. size(joints) == strokes - 1, &
            name//': of all strokes')
        goes_on = .true.
        do i = 1, size(joints)
            goes_on = goes_on .and. bends_on(joints(i)) .and. .not. is_broken(joints(i)) .and. &
                joints(i)%jump%gap <= 0.0_dp .and. abs(joints(i)%jump%direction) < 1.0e-11_dp &
                .and. abs(joints(i)%jump%curvature) < 1.0e-13_dp
        end do
        call tap%ok(goes_on, name//': slope and curvature go on')
        call tap%ok(chain_from(chain) < chain_to(chain) .and. &
            abs(stroke_curvature(chain%stroke(2), at_start) &
            - stroke_curvature(chain%stroke(1), at_finish)) < 1.0e-13_dp, name//': fore to aft')
    end subroutine look

    !> What is wrong is said on the BLEND card.
    subroutine check_refused()
        call build('STRAIGHT,0.,8.,15.,8.|BLEND|'//falling)
        call tap%same(words_of(faults), '3:1-8 error: the circle of radius 5. about (20., 4.) '// &
            'crosses or touches the line, which is 4. from its centre; a spiral needs it '// &
            'further off than the radius|', 'a circle that crosses the line')
        call build('STRAIGHT,19.,10.,20.,10.|BLEND|'//falling)
        call refuse('leaves nothing of the card before it', 'a spiral that begins before the line')
        call build(level//'|BLEND|RADIUS,19.,9.,20.,9.,-5.')
        call refuse('leaves nothing of the card behind it', 'a spiral that ends beyond the arc')
        call build(level//'|BLEND|STRAIGHT,20.,9.,30.,5.')
        call refuse('both straight lines', 'two lines')
        call build(level//'|BLEND|CBEZIER,20.,9.,22.,9.,25.,8.,30.,5.,60.')
        call refuse('a card beside this one is neither', 'a C-Bezier curve')
        call build('RADIUS,-4.,3.,0.,5.,-5.|BLEND,60.,80.|RADIUS,9.,3.,15.,3.,5.')
        call refuse('leave THETA blank', 'a THETA too large')
    end subroutine check_refused

    !> Checks that there is one error, on the word BLEND of line 3, with some words.
    subroutine refuse(part, name)
        character(*), intent(in) :: part    !! of the message
        character(*), intent(in) :: name    !! the check as a phrase
        call tap%ok(index(words_of(faults), '3:1-') == 1 .and. faults%count == 1, &
            'refused on its card: '//name)
        call tap%has(words_of(faults), part, 'and said why: '//name)
        call tap%ok(.not. allocated(chain), 'and not built: '//name)
    end subroutine refuse

    !> Builds the side view of a line.
    subroutine build(cards)
        character(*), intent(in) :: cards !! its data cards
        type(job_type) :: job
        type(fault_list_type) :: read_faults

        call job_of('LINE,A,SIDE|'//cards, job, read_faults)
        if (.not. job%body(1)%line(1)%view(view%side)%is_sound) call tap%ok(.false., &
            words_of(read_faults))
        faults = fault_list_type()
        if (allocated(chain)) deallocate (chain)
        if (allocated(joints)) deallocate (joints)
        allocate (joints(0))
        call build_view(job%body(1)%line(1), view%side, 0.001_dp, chain, joints, faults)
    end subroutine build

end program test_blend
