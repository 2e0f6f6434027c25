!> Arcs from cards: shapes known in closed form, weights, the way they run, lines.
program test_arc
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, direction_of_slope, end_type, line_between, &
        reversed, rho, &
        turns_past_180, weight
    use geom_arc_point, only: point
    use geom_place, only: at_shoulder, mirrored, place_at, place_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(arc_type) :: arc, back
    real(dp), parameter :: up(2) = [0.0_dp, 1.0_dp], flat(2) = [1.0_dp, 0.0_dp]

    arc = card([1.0_dp, 0.0_dp], up, [0.6_dp, 0.8_dp], [0.0_dp, 1.0_dp], flat)
    call tap%near(weight(arc), sqrt(0.5_dp), 2.0e-16_dp, &
        'a quarter circle through (.6, .8) has weight cos 45')
    call tap%near(rho(arc), sqrt(2.0_dp) - 1.0_dp, 2.0e-16_dp, 'its rho is tan 22.5')
    call tap%ok(all(arc%start_tangent == up), 'its tangent at the start points up')
    call tap%ok(all(arc%finish_tangent == -flat), 'and at the finish to the left')
    call tap%ok(.not. turns_past_180(arc), 'it turns by less than 180 degrees')

    arc = card([0.0_dp, 0.0_dp], [1.0_dp, 0.0_dp], [1.0_dp, 1.0_dp], [2.0_dp, 4.0_dp], [1.0_dp, &
        4.0_dp])
    call tap%near(weight(arc), 1.0_dp, 0.0_dp, 'y = x**2 has weight 1')
    call tap%near(rho(arc), 0.5_dp, 0.0_dp, 'and rho .5')
    arc = card([0.5_dp, 2.0_dp], [1.0_dp, -4.0_dp], [1.0_dp, 1.0_dp], [2.0_dp, 0.5_dp], &
        [1.0_dp, -0.25_dp])
    call tap%near(weight(arc), 1.25_dp, 0.0_dp, 'y = 1/x from .5 to 2 has weight 5/4')

    arc = card([1.0_dp, 0.0_dp], up, [0.0_dp, 1.0_dp], [-1.0_dp, 0.0_dp], up)
    call tap%ok(weight(arc) == 0.0_dp .and. rho(arc) == 0.0_dp, 'a semicircle has weight and rho 0')
    call tap%ok(.not. turns_past_180(arc), 'and does not turn past 180 degrees')
    call tap%ok(all(arc%finish_tangent == -up), 'it comes down at the finish')
    arc = card([1.0_dp, 0.0_dp], up, [-1.0_dp, 0.0_dp], [0.0_dp, -1.0_dp], flat)
    call tap%near(weight(arc), -sqrt(0.5_dp), 2.0e-16_dp, &
        'three quarters of a circle have weight -cos 45')
    call tap%ok(turns_past_180(arc), 'and turn past 180 degrees')
    call tap%ok(all(arc%finish_tangent == flat), 'and arrive to the right')
    arc = card([0.28_dp, 0.96_dp], [1.0_dp, -0.28_dp/0.96_dp], [0.0_dp, -1.0_dp], [-0.28_dp, &
        0.96_dp], &
        [1.0_dp, 0.28_dp/0.96_dp])
    call tap%near(weight(arc), -0.96_dp, 1.0e-15_dp, 'an almost whole circle: weight -.96')
    call tap%ok(arc%start_tangent(1) > 0.0_dp .and. arc%finish_tangent(1) > 0.0_dp, &
        'it starts and ends to the right')

    arc = card([50.0_dp, -4.0_dp], [1.0_dp, 0.0523_dp], [0.0_dp, -7.1_dp], [-30.0_dp, -10.0_dp], &
        [1.0_dp, 0.114_dp])
    back = reversed(arc)
    call tap%ok(all(arc%start_tangent == [-1.0_dp, -0.0523_dp]), 'X may decrease')
    call tap%ok(same_points(arc, back), 'the reversed arc has the same points')
    back = card([-30.0_dp, -10.0_dp], [1.0_dp, 0.114_dp], [0.0_dp, -7.1_dp], [50.0_dp, -4.0_dp], &
        [1.0_dp, 0.0523_dp])
    call tap%ok(same_points(arc, back), 'so has the card with points 1 and 3 exchanged')

    arc = card([0.0_dp, 0.0_dp], [1.0_dp, 3.0_dp], [0.1_dp, 0.3_dp], [0.2_dp, 0.6_dp], [1.0_dp, &
        3.0_dp])
    call tap%ok(arc%is_line, 'decimals in line make a line')
    call tap%ok(all(arc%start_tangent == [1.0_dp, 3.0_dp]), 'with the slope given')
    call tap%ok(weight(arc) == 1.0_dp, 'and weight 1')
    arc = card([3.0_dp, 1.0_dp], [1.0_dp, 0.33333_dp], [1.5_dp, 0.5_dp], [0.0_dp, 0.0_dp], &
        [1.0_dp, 0.33333_dp])
    call tap%near(arc%start_tangent(2)/arc%start_tangent(1), 1.0_dp/3.0_dp, 1.0e-16_dp, &
        'a rounded slope gives way to that of the chord')
    call tap%ok(arc%start_tangent(1) < 0.0_dp, 'and points forward')
    arc = line_between([1.0_dp, 2.0_dp], [1.0_dp, 8.0_dp])
    call tap%ok(all(point(arc, at_shoulder) == [1.0_dp, 5.0_dp]), &
        'a vertical line has its middle at its middle')
    call tap%ok(all(point(arc, place_at(0.25_dp)) == [1.0_dp, 3.5_dp]), 'and is run through evenly')

    call tap%ok(all([direction_of_slope(999.99_dp), direction_of_slope(-999.999_dp)] == [up, up]), &
        'slopes from 999.99 on are vertical, of either sign')
    call tap%ok(all(direction_of_slope(999.98_dp) == [1.0_dp, 999.98_dp]), 'smaller ones are not')
    call tap%finish()

contains

    !> True where two arcs, run through in opposite directions, have the same points.
    pure logical function same_points(arc, back) result(same)
        type(arc_type), intent(in) :: arc, back
        type(place_type) :: place
        integer :: i
        same = .true.
        do i = 0, 8
            place = place_at(0.125_dp*real(i, dp))
            same = same .and. all(point(arc, place) == point(back, mirrored(place)))
        end do
    end function same_points

    !> The arc of a card that has one.
    type(arc_type) function card(p1, t1, p2, p3, t3) result(arc)
        real(dp), intent(in) :: p1(2), t1(2), p2(2), p3(2), t3(2)
        type(error_type), allocatable :: error
        call arc_through(end_type(p1, t1), p2, end_type(p3, t3), arc, error)
        if (allocated(error)) call tap%ok(.false., error%message)
    end function card

end program test_arc
