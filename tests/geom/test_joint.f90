!> Jumps between arcs, and arcs that begin or end with a given curvature.
program test_joint
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, end_type, line_between, weight
    use geom_arc_by_circle, only: circle_by_radius
    use geom_arc_point, only: curvature, point
    use geom_joint, only: jump_between, jump_type, match_finish, match_start
    use geom_place, only: at_finish, at_shoulder, at_start
    use geom_span, only: new_span, span_by_corner
    use geom_stroke, only: conic_stroke
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(arc_type) :: arc, before
    type(jump_type) :: jump
    type(error_type), allocatable :: error
    real(dp), parameter :: flat(2) = [1.0_dp, 0.0_dp], up(2) = [0.0_dp, 1.0_dp]

    call check_jumps()
    call check_matches()
    call check_refusals()
    call check_random()
    call tap%finish()

contains

    !> Jumps known in closed form.
    subroutine check_jumps()
        jump = jump_between(conic_stroke(line_between([0.0_dp, 0.0_dp], [1.0_dp, 1.0_dp])), &
            conic_stroke(line_between([1.0_dp, 1.0_dp], [2.0_dp, 2.0_dp])))
        call tap%ok(jump%gap == 0.0_dp .and. jump%direction == 0.0_dp .and. &
            jump%curvature == 0.0_dp, &
            'a line goes on in a line without a jump')
        jump = jump_between(conic_stroke(line_between([0.0_dp, 0.0_dp], [1.0_dp, 0.0_dp])), &
            conic_stroke(line_between([1.25_dp, -1.0_dp], [2.25_dp, 0.0_dp])))
        call tap%ok(all(jump%position == [0.25_dp, -1.0_dp]), &
            'the jump of position is from end to start')
        call tap%near(jump%gap, sqrt(17.0_dp)/4.0_dp, 3.0e-16_dp, 'the gap is its length')
        call tap%near(jump%direction, 45.0_dp, 1.0e-14_dp, 'a break to the left is positive')
        jump = jump_between(conic_stroke(line_between([0.0_dp, 0.0_dp], [1.0_dp, 0.0_dp])), &
            conic_stroke(line_between([1.0_dp, 0.0_dp], [0.0_dp, -1.0_dp])))
        call tap%near(jump%direction, -135.0_dp, 1.0e-13_dp, &
            'one to the right negative, past 90 too')
        call circle_by_radius([0.0_dp, 0.0_dp], [5.0_dp, 5.0_dp], -5.0_dp, before, error)
        call circle_by_radius([5.0_dp, 5.0_dp], [7.0_dp, 3.0_dp], -2.0_dp, arc, error)
        jump = jump_between(conic_stroke(before), conic_stroke(arc))
        call tap%near(jump%direction, 0.0_dp, 1.0e-14_dp, &
            'quarter circles of 5 and 2 meet smoothly')
        call tap%near(jump%curvature, -0.3_dp, 2.0e-16_dp, &
            'and their curvature jumps by -1/2 + 1/5')
    end subroutine check_jumps

    !> Arcs whose shape the match must find again.
    subroutine check_matches()
        call match_start(new_span(end_type([0.0_dp, 0.0_dp], flat), &
            end_type([2.0_dp, 4.0_dp], [1.0_dp, 4.0_dp])), 2.0_dp, arc, error)
        call tap%near(weight(arc), 1.0_dp, 2.0e-16_dp, &
            'curvature 2 at 0 makes a parabola of y = x**2')
        call tap%near(curvature(arc, at_start), 2.0_dp, 5.0e-16_dp, 'which has it')
        call match_finish(new_span(end_type([5.0_dp, 0.0_dp], up), &
            end_type([0.0_dp, 5.0_dp], flat)), &
            0.2_dp, arc, error)
        call tap%near(weight(arc), sqrt(0.5_dp), 2.0e-16_dp, &
            'curvature 1/5 at the end makes a circle of 5')
        call match_start(new_span(end_type([-3.0_dp, 0.0_dp], up), &
            end_type([3.0_dp, 0.0_dp], up)), &
            -3.0_dp/4.0_dp, arc, error)
        call tap%near(weight(arc), 0.0_dp, 0.0_dp, 'between parallel tangents the weight is 0')
        call tap%ok(all(abs(point(arc, at_shoulder) - [0.0_dp, 2.0_dp]) < 1.0e-15_dp), &
            'and the height that of the ellipse: a/b**2 = 3/4')
        call tap%ok(arc%start_tangent(2) > 0.0_dp .and. arc%finish_tangent(2) < 0.0_dp, &
            'over the top')
        call match_finish(new_span(end_type([-3.0_dp, 0.0_dp], up), &
            end_type([3.0_dp, 0.0_dp], up)), &
            3.0_dp/4.0_dp, arc, error)
        call tap%ok(all(abs(point(arc, at_shoulder) - [0.0_dp, -2.0_dp]) < 1.0e-15_dp), &
            'a left turn goes below')
        call match_start(span_by_corner([0.0_dp, 0.0_dp], [0.0_dp, 4.0_dp], [4.0_dp, 4.0_dp]), &
            -0.25_dp, arc, error)
        call tap%near(weight(arc), sqrt(0.5_dp), 2.0e-16_dp, 'a corner does as well as two slopes')
        call tap%near(curvature(arc, at_finish), -0.25_dp, 1.0e-16_dp, &
            'the circle has it everywhere')
    end subroutine check_matches

    !> What no arc matches, and near misses.
    subroutine check_refusals()
        call match_start(new_span(end_type([0.0_dp, 0.0_dp], flat), &
            end_type([2.0_dp, 4.0_dp], [1.0_dp, 4.0_dp])), -2.0_dp, arc, error)
        call tap%ok(refused('the neighbour turns right at the joint (curvature -2.), '// &
            'but between its end slopes this arc turns left'), 'the wrong side')
        call match_finish(new_span(end_type([0.0_dp, 0.0_dp], flat), &
            end_type([2.0_dp, 4.0_dp], [1.0_dp, 4.0_dp])), -0.1_dp, arc, error)
        call tap%ok(refused('this arc turns left'), 'the wrong side at the end')
        call match_start(new_span(end_type([0.0_dp, 0.0_dp], flat), &
            end_type([2.0_dp, 4.0_dp], [1.0_dp, 4.0_dp])), 0.0_dp, arc, error)
        call tap%ok(refused('the neighbour is straight'), 'a straight neighbour')
        call match_start(new_span(end_type([0.0_dp, 0.0_dp], flat), &
            end_type([2.0_dp, 4.0_dp], [1.0_dp, 4.0_dp])), 1.0e-9_dp, arc, error)
        call tap%ok(.not. allocated(error), 'one nearly straight has a sharp match')
        if (.not. allocated(error)) call tap%near(curvature(arc, at_start), 1.0e-9_dp, 1.0e-24_dp, &
            'as good')
        call match_start(new_span(end_type([0.0_dp, 0.0_dp], flat), &
            end_type([2.0_dp, 0.0_dp], up)), &
            1.0_dp, arc, error)
        call tap%ok(refused('runs along the chord'), 'a tangent along the chord')
    end subroutine check_refusals

    !> Random cards: the match of the curvature of an arc has its weight.
    subroutine check_random()
        type(random_type) :: random
        type(end_type) :: start, finish
        real(dp) :: corner(2), k, worst(2), share
        integer :: i, j

        worst = 0.0_dp
        do i = 1, 20000
            start%point = [(random%between(-50.0_dp, 50.0_dp), j = 1, 2)]
            corner = [(random%between(-50.0_dp, 50.0_dp), j = 1, 2)]
            finish%point = [(random%between(-50.0_dp, 50.0_dp), j = 1, 2)]
            start%tangent = corner - start%point
            finish%tangent = corner - finish%point
            share = random%between(0.05_dp, 0.95_dp)
            call arc_through(start, 0.5_dp*(1.0_dp - share)*(start%point + finish%point) &
                + share*corner, finish, before, error)
            if (allocated(error)) cycle
            k = curvature(before, at_start)
            call match_start(new_span(start, finish), k, arc, error)
            if (allocated(error)) call tap%ok(.false., error%message)
            worst(1) = max(worst(1), abs(weight(arc)/weight(before) - 1.0_dp))
            worst(2) = max(worst(2), abs(curvature(arc, at_start)/k - 1.0_dp))
            k = curvature(before, at_finish)
            call match_finish(new_span(start, finish), k, arc, error)
            if (allocated(error)) call tap%ok(.false., error%message)
            worst(1) = max(worst(1), abs(weight(arc)/weight(before) - 1.0_dp))
            worst(2) = max(worst(2), abs(curvature(arc, at_finish)/k - 1.0_dp))
        end do
        worst = worst/epsilon(1.0_dp)
        call tap%near(worst(1), 0.0_dp, 1.5_dp, &
            'the weight of an arc is found again from its curvature')
        call tap%near(worst(2), 0.0_dp, 1.0_dp, 'and the curvature matches within an ulp')
        print '(a, 2f8.3)', '# worst, in ulp of themselves: weight, curvature', worst
    end subroutine check_random

    !> True where the match is refused in some words.
    logical function refused(words)
        character(*), intent(in) :: words
        refused = .false.
        if (.not. allocated(error)) return
        refused = error%cause == cause%no_match .and. index(error%message, words) > 0
        if (.not. refused) call tap%note(error%message)
    end function refused

end program test_joint
