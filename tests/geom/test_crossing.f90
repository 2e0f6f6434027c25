!> Crossings of ordinates and extremes, on circles and a parabola.
program test_crossing
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, end_type, line_between
    use geom_arc_point, only: point
    use geom_crossing, only: crossing, turning_places
    use geom_place, only: at_shoulder, is_before, is_start
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(arc_type) :: arc
    real(dp), parameter :: up(2) = [0.0_dp, 1.0_dp], flat(2) = [1.0_dp, 0.0_dp]
    real(dp), parameter :: tiny_step = 2.0_dp**(-40)

    arc = card([1.0_dp, 0.0_dp], up, [-1.0_dp, 0.0_dp], [0.0_dp, -1.0_dp], flat)
    call near(1, 0.6_dp, .false., [0.6_dp, 0.8_dp], 'a circle passes x = .6 going left above')
    call near(1, -0.6_dp, .true., [-0.6_dp, -0.8_dp], 'and x = -.6 going right below')
    call near(2, 0.8_dp, .true., [0.6_dp, 0.8_dp], 'it passes y = .8 going up on the right')
    call near(2, 0.8_dp, .false., [-0.6_dp, 0.8_dp], 'and going down on the left')
    call near(1, -1.0_dp + tiny_step, .false., [-1.0_dp, sqrt(tiny_step*(2.0_dp - tiny_step))], &
        'a crossing just before the extreme keeps its figures')
    call near(1, -1.0_dp + tiny_step, .true., [-1.0_dp, -sqrt(tiny_step*(2.0_dp - tiny_step))], &
        'and so does the one just after')
    call near(1, 1.0_dp - tiny_step, .false., [1.0_dp, sqrt(tiny_step*(2.0_dp - tiny_step))], &
        'a crossing just after a vertical start keeps its figures')

    associate (turns => turning_places(arc, 1))
        call tap%ok(size(turns) == 1, 'three quarters of a circle from (1, 0) turn once in x')
        call tap%ok(all(abs(point(arc, turns(1)) - [-1.0_dp, 0.0_dp]) < 1.0e-15_dp), 'at (-1, 0)')
    end associate
    associate (turns => turning_places(arc, 2))
        call tap%ok(size(turns) == 1, 'and once in y')
        call tap%ok(all(abs(point(arc, turns(1)) - [0.0_dp, 1.0_dp]) < 1.0e-15_dp), 'at (0, 1)')
    end associate
    arc = card([-0.28_dp, 0.96_dp], [0.96_dp, 0.28_dp], [0.0_dp, -1.0_dp], [0.28_dp, 0.96_dp], &
        [0.96_dp, -0.28_dp])
    associate (turns => turning_places(arc, 1))
        call tap%ok(size(turns) == 2, 'a circle but for a notch above turns twice in x')
        call tap%ok(is_before(turns(1), turns(2)), 'in order along the arc')
        call tap%ok(all(abs(point(arc, turns(1)) - [-1.0_dp, 0.0_dp]) < 2.0e-15_dp), &
            'first at (-1, 0)')
        call tap%ok(all(abs(point(arc, turns(2)) - [1.0_dp, 0.0_dp]) < 2.0e-15_dp), &
            'then at (1, 0)')
    end associate

    arc = card([0.0_dp, 0.0_dp], flat, [1.0_dp, 1.0_dp], [2.0_dp, 4.0_dp], [1.0_dp, 4.0_dp])
    call near(1, 1.5_dp, .true., [1.5_dp, 2.25_dp], 'y = x**2 at x = 1.5')
    call near(2, 2.25_dp, .true., [1.5_dp, 2.25_dp], 'y = x**2 at y = 2.25')
    call tap%ok(size(turning_places(arc, 2)) == 0, &
        'an extreme that is the start is none between the ends')
    call tap%ok(is_start(crossing(arc, 1, 0.0_dp, .true.)), &
        'the ordinate of the start is passed there')
    arc = card([2.0_dp, 4.0_dp], [1.0_dp, 4.0_dp], [1.0_dp, 1.0_dp], [0.0_dp, 0.0_dp], flat)
    call near(1, 1.5_dp, .false., [1.5_dp, 2.25_dp], 'y = x**2 run through backwards')

    arc = line_between([1.0_dp, 2.0_dp], [3.0_dp, 8.0_dp])
    call near(1, 1.5_dp, .true., [1.5_dp, 3.5_dp], 'a line at x = 1.5')
    call tap%ok(size(turning_places(arc, 1)) == 0, 'a line does not turn')
    arc = line_between([1.0_dp, 2.0_dp], [1.0_dp, 8.0_dp])
    call tap%ok(size(turning_places(arc, 1)) == 0, 'a line across the axis does not either')
    call near(2, 5.0_dp, .true., point(arc, at_shoulder), 'a vertical line at half its height')
    call tap%finish()

contains

    !> The arc of a card that has one.
    type(arc_type) function card(p1, t1, p2, p3, t3) result(arc)
        real(dp), intent(in) :: p1(2), t1(2), p2(2), p3(2), t3(2)
        type(error_type), allocatable :: error
        call arc_through(end_type(p1, t1), p2, end_type(p3, t3), arc, error)
        if (allocated(error)) call tap%ok(.false., error%message)
    end function card

    !> Checks a crossing of the current arc: the ordinate itself and the other coordinate.
    subroutine near(axis, ordinate, rising, expected, name)
        integer, intent(in) :: axis
        real(dp), intent(in) :: ordinate, expected(2)
        logical, intent(in) :: rising
        character(*), intent(in) :: name
        real(dp) :: p(2)
        p = point(arc, crossing(arc, axis, ordinate, rising))
        call tap%ok(p(axis) == ordinate, name//': the ordinate comes back')
        call tap%near(p(3 - axis), expected(3 - axis), 1.0e-15_dp, name)
    end subroutine near

end program test_crossing
