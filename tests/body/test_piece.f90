!> The arc of every data card, from the card: shapes known in closed form.
program test_piece
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_piece, only: piece_stroke
    use deck_job, only: job_type, view
    use geom_arc, only: arc_type, line_between, rho, weight
    use geom_arc_by_circle, only: circle_by_radius
    use geom_arc_point, only: curvature, point
    use geom_place, only: at_finish, at_shoulder, at_start, place_at
    use geom_stroke, only: conic_stroke, stroke_kind, stroke_point, stroke_type
    use support_job_deck, only: job_of, words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(arc_type) :: arc, before
    type(stroke_type) :: stroke
    type(error_type), allocatable :: error

    call read('0.,0.,999.999,.2,.6,1.,1.,0.')
    call tap%near(weight(arc), sqrt(0.5_dp), 3.0e-16_dp, 'a conic card of a quarter circle')
    call read('0.,0.,0.,.2,.6,1.,1.,0.,DXDY1')
    call tap%ok(arc%start_tangent(1) == 0.0_dp .and. arc%finish_tangent(2) == 0.0_dp, &
        'dX/dY 0 is upright at the first point')
    call read('1.,1.,0.,.8,.4,0.,0.,0.,DXDY3')
    call tap%ok(arc%finish_tangent(1) == 0.0_dp .and. arc%start_tangent(2) == 0.0_dp, &
        'or at the last')
    call read('0.,0.,-.5,0.,2.,4.,4.,999.999,DXDY')
    call tap%ok(.not. allocated(error), 'or at both')
    call tap%ok(arc%finish_tangent(2) == 0.0_dp, 'dX/dY 999.999 is level')
    call tap%near(arc%start_tangent(2)/arc%start_tangent(1), -2.0_dp, 0.0_dp, &
        'dX/dY -.5 is slope -2')
    call read('RHO,0.,0.,1.,4.,0.,-1.,.75')
    call tap%ok(all(point(arc, at_shoulder) == [2.0_dp, 1.5_dp]), 'RHO .75 rises 3/4 of the way')
    call read('TANGENT,0.,0.,2.,2.,2.,1.5,4.,0.')
    call tap%near(rho(arc), 0.75_dp, 1.0e-16_dp, &
        'TANGENT with its shoulder point there has rho .75')
    call read('TANRHO,0.,0.,2.,2.,4.,0.,.75')
    call tap%ok(all(point(arc, at_shoulder) == [2.0_dp, 1.5_dp]), 'TANRHO does as RHO')
    call read('FOURPT,0.,0.,0.,1.,1.,2.,4.,3.,9.')
    call tap%near(weight(arc), 1.0_dp, 3.0e-16_dp, 'FOURPT of y = x**2 is a parabola')
    call read('FOURPT,0.,0.,6.,1.,1.,2.,4.,3.,9.,LAST')
    call tap%near(weight(arc), 1.0_dp, 3.0e-16_dp, 'also with its LAST slope')
    call tap%ok(all(arc%finish == [3.0_dp, 9.0_dp]), 'from point 1 to point 3')
    call tap%near(arc%start_tangent(2)/arc%start_tangent(1), 0.0_dp, 1.0e-15_dp, &
        'and level at point 1')
    call read('FIVEPT,-1.,1.,0.,0.,1.,1.,2.,4.,3.,9.')
    call tap%near(weight(arc), 1.0_dp, 3.0e-16_dp, 'FIVEPT of y = x**2 is a parabola')
    call read('STRAIGHT,-1.,1.,3.,9.')
    call tap%ok(arc%is_line .and. all(arc%finish == [3.0_dp, 9.0_dp]), 'STRAIGHT is a line')
    call read('CIRCLE,5.,0.,4.,3.,0.,5.')
    call tap%near(curvature(arc, at_start), 0.2_dp, 1.0e-16_dp, &
        'CIRCLE through (5, 0), (4, 3), (0, 5) is of radius 5')
    call read('RADIUS,0.,5.,5.,0.,-5.')
    call tap%near(curvature(arc, at_start), -0.2_dp, 1.0e-16_dp, 'RADIUS -5. turns right')
    call check_matches()
    call check_cyclic()
    call tap%finish()

contains

    !> MATCH on the cards that have it, behind a quarter circle of radius 5 up to (5, 5).
    subroutine check_matches()
        call circle_by_radius([0.0_dp, 0.0_dp], [5.0_dp, 5.0_dp], -5.0_dp, before, error)
        call read('5.,5.,0.,,,10.,0.,999.999,MATCH')
        call tap%near(weight(arc), sqrt(0.5_dp), 3.0e-16_dp, &
            'MATCH makes the next quarter a circle too')
        call read('RHO,5.,5.,0.,10.,0.,999.999,,MATCH')
        call tap%near(rho(arc), sqrt(2.0_dp) - 1.0_dp, 3.0e-16_dp, 'its rho is that of a circle')
        call read('TANGENT,5.,5.,10.,5.,,,10.,0.,MATCH')
        call tap%near(weight(arc), sqrt(0.5_dp), 3.0e-16_dp, 'TANGENT matches')
        call read('TANRHO,5.,5.,10.,5.,10.,0.,,MATCH')
        call tap%near(weight(arc), sqrt(0.5_dp), 3.0e-16_dp, 'TANRHO matches')
        call read('5.,5.,0.,,,9.,2.,-1.,MATCH')
        call tap%near(curvature(arc, at_start), -0.2_dp, 1.0e-16_dp, &
            'another end has the curvature too')
        call read('9.,2.,-1.,,,5.,5.,0.,MATCH')
        call tap%near(curvature(arc, at_finish), 0.2_dp, 1.0e-16_dp, &
            'and a card that runs the other way at its end')
        call read('5.,5.,0.,,,9.,8.,1.,MATCH')
        call tap%ok(allocated(error), 'an arc to the other side does not match')
        before = line_between([0.0_dp, 5.0_dp], [5.0_dp, 5.0_dp])
        call read('5.,5.,0.,,,9.,2.,-1.,MATCH')
        call tap%ok(allocated(error), 'nor does any after a line')
        call read('5.,5.,0.,,,5.,5.,-1.,MATCH')
        call tap%ok(allocated(error), 'nor between one point')
    end subroutine check_matches

    !> A quarter of the circle of radius 5 as a C-Bezier curve: its inner poles are K on.
    subroutine check_cyclic()
        real(dp) :: at(2), worst
        integer :: i

        call read('CBEZIER,-5.,0.,-5.,2.85398163397448,-2.85398163397448,5.,0.,5.,90.')
        call tap%ok(stroke%kind == stroke_kind%cyclic, 'CBEZIER')
        worst = 0.0_dp
        do i = 0, 10
            at = stroke_point(stroke, place_at(0.1_dp*real(i, dp)))
            worst = max(worst, abs(norm2(at) - 5.0_dp))
        end do
        call tap%near(worst, 0.0_dp, 1.0e-13_dp, 'holds a circle')
        call read('CBEZIER,-5.,0.,-5.,0.,-2.85,5.,0.,5.,90.')
        call tap%ok(allocated(error), 'poles that are one are refused')
    end subroutine check_cyclic

    !> The stroke of a card, which stands second in its line.
    subroutine read(card)
        character(*), intent(in) :: card
        type(job_type) :: job
        type(fault_list_type) :: faults
        call job_of('LINE,A,SIDE|STRAIGHT,-9.,0.,-8.,0.|'//card//'|LINE,B,SIDE,0.', job, faults)
        if (.not. job%body(1)%line(1)%view(view%side)%is_sound) call tap%ok(.false., &
            words_of(faults))
        call piece_stroke(job%body(1)%line(1)%view(view%side)%piece(2), conic_stroke(before), &
            stroke, error)
        arc = stroke%arc
    end subroutine read

end program test_piece
