!> Strokes that turn back on their way, and such as only stand still.
program test_stroke_turn
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, end_type
    use geom_stroke, only: bezier_stroke, conic_stroke, cyclic_stroke
    use geom_stroke_turn, only: stroke_turn
    use base_error, only: error_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_conics(tap)
    call check_turns(tap)
    call check_cyclic(tap)
    call tap%finish()

contains

    !> A quarter and three quarters of a circle.
    subroutine check_conics(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(arc_type) :: arc
        type(error_type), allocatable :: error
        real(dp) :: at(2)
        logical :: turns

        call arc_through(end_type([0.0_dp, 0.0_dp], [0.0_dp, 1.0_dp]), [0.2_dp, 0.6_dp], &
            end_type([1.0_dp, 1.0_dp], [1.0_dp, 0.0_dp]), arc, error)
        call stroke_turn(conic_stroke(arc), turns, at)
        call tap%ok(.not. turns, 'a quarter that begins upright does not turn back')
        call arc_through(end_type([-3.0_dp, 4.0_dp], [4.0_dp, 3.0_dp]), [5.0_dp, 0.0_dp], &
            end_type([3.0_dp, -4.0_dp], [-4.0_dp, -3.0_dp]), arc, error)
        call stroke_turn(conic_stroke(arc), turns, at)
        call tap%ok(turns .and. norm2(at - [5.0_dp, 0.0_dp]) < 1.0e-14_dp, 'a half circle does')
    end subroutine check_conics

    !> Strokes that turn back.
    subroutine check_turns(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp) :: at(2)
        logical :: turns

        call stroke_turn(bezier_stroke(reshape([1.0_dp, 1.0_dp, 2.0_dp, 3.0_dp, 3.0_dp, 9.0_dp], &
            [2, 3])), turns, at)
        call tap%ok(.not. turns, 'a parabola over x does not turn back')
        ! x = 3 t - 3 t**2 + t**3 rises with x' = 3 (1 - t)**2, zero at the end.
        call stroke_turn(bezier_stroke(reshape([0.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, &
            1.0_dp, 2.0_dp], [2, 4])), turns, at)
        call tap%ok(.not. turns, 'nor does a curve that ends vertical')
        ! x' = 3 (2 t - 1)**2: it stands still in the middle.
        call stroke_turn(bezier_stroke(reshape([0.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, &
            1.0_dp, 2.0_dp], [2, 4])), turns, at)
        call tap%ok(.not. turns, 'nor one that is vertical in the middle')
        call stroke_turn(bezier_stroke(reshape([0.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, -0.01_dp, 1.0_dp, &
            1.0_dp, 2.0_dp], [2, 4])), turns, at)
        call tap%ok(turns .and. abs(at(2) - 0.75_dp) < 0.2_dp, 'a little more and it turns')
        call stroke_turn(bezier_stroke(reshape([0.0_dp, 0.0_dp, -1.0_dp, 1.0_dp, 1.0_dp, 2.0_dp], &
            [2, 3])), turns, at)
        call tap%ok(turns .and. norm2(at) <= 0.0_dp, 'a start the wrong way is a turn there')
        call stroke_turn(bezier_stroke(reshape([0.0_dp, 0.0_dp, 2.0_dp, 1.0_dp, 1.0_dp, 2.0_dp], &
            [2, 3])), turns, at)
        call tap%ok(turns, 'so is an end')
    end subroutine check_turns

    !> C-Bezier curves.
    subroutine check_cyclic(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        real(dp) :: at(2)
        logical :: turns

        call stroke_turn(cyclic_stroke(reshape([0.0_dp, 0.0_dp, 0.0_dp, 0.6_dp, 0.4_dp, 1.0_dp, &
            1.0_dp, 1.0_dp], [2, 4]), 1.5_dp), turns, at)
        call tap%ok(.not. turns, 'it does not turn back')
        call stroke_turn(cyclic_stroke(reshape([0.0_dp, 0.0_dp, 2.0_dp, 1.0_dp, -1.0_dp, 1.0_dp, &
            1.0_dp, 2.0_dp], [2, 4]), 1.0_dp), turns, at)
        call tap%ok(turns .and. abs(at(2) - 1.0_dp) < 0.3_dp, &
            'one that does is found in the middle')
        call stroke_turn(cyclic_stroke(reshape([0.0_dp, 0.0_dp, -0.1_dp, 1.0_dp, 1.0_dp, 1.0_dp, &
            1.5_dp, 2.0_dp], [2, 4]), 2.0_dp), turns, at)
        call tap%ok(turns, 'or at its start')
    end subroutine check_cyclic

end program test_stroke_turn
