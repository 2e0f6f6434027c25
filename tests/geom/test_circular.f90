!> Circular arcs by a start with its direction and an end.
program test_circular
    use base_constants, only: pi
    use base_kinds, only: dp
    use geom_circular, only: circular_between, circular_type, direction_to, distance_from, &
        leaving, parted_circular, reversed_circular, wrapped
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(random_type) :: random
    type(circular_type) :: arc, back, parts(5)
    real(dp) :: worst(5), start(2), finish(2), direction
    integer :: i

    arc = circular_between([0.0_dp, 0.0_dp], 0.0_dp, [0.0_dp, 2.0_dp])
    call tap%near(norm2(arc%centre - [0.0_dp, 1.0_dp]), 0.0_dp, 1.0e-15_dp, &
        'half a turn to the left')
    call tap%near(arc%radius, 1.0_dp, 1.0e-15_dp, 'has a positive radius')
    call tap%near(leaving(arc), pi, 1.0e-15_dp, 'and comes back the other way')
    arc = circular_between([0.0_dp, 0.0_dp], 0.0_dp, [1.0_dp, -1.0_dp])
    call tap%near(arc%radius, -1.0_dp, 1.0e-15_dp, 'to the right it is negative')
    call tap%near(arc%turn, -0.5_dp*pi, 1.0e-15_dp, 'as the turn is')
    arc = circular_between([1.0_dp, 2.0_dp], atan2(3.0_dp, 4.0_dp), [9.0_dp, 8.0_dp])
    call tap%ok(arc%is_line, 'straight ahead is a line')
    call tap%near(distance_from(arc, [5.0_dp - 0.6_dp, 5.0_dp + 0.8_dp]), 1.0_dp, 1.0e-15_dp, &
        'from which a point has a distance')
    worst = 0.0_dp
    do i = 1, 1000
        start = [random%between(-9.0_dp, 9.0_dp), random%between(-9.0_dp, 9.0_dp)]
        finish = [random%between(-9.0_dp, 9.0_dp), random%between(-9.0_dp, 9.0_dp)]
        direction = random%between(-3.0_dp, 3.0_dp)
        arc = circular_between(start, direction, finish)
        worst(1) = max(worst(1), distance_from(arc, finish)/max(1.0_dp, abs(arc%radius)))
        worst(2) = max(worst(2), abs(wrapped(leaving(arc) + direction &
            - 2.0_dp*direction_to(start, finish))))
        worst(3) = max(worst(3), norm2(arc%centre + arc%radius*[sin(leaving(arc)), &
            -cos(leaving(arc))] - finish)/max(1.0_dp, abs(arc%radius)))
        back = reversed_circular(arc)
        worst(4) = max(worst(4), norm2(back%centre + back%radius*[sin(leaving(back)), &
            -cos(leaving(back))] - start)/max(1.0_dp, abs(arc%radius)), &
            norm2(back%start - finish), abs(back%turn + arc%turn), abs(wrapped(leaving(back) &
            - direction - pi)))
        parts = parted_circular(arc, 5)
        worst(5) = max(worst(5), norm2(parts(5)%finish - finish), norm2(parts(1)%start - start), &
            norm2(parts(3)%start - parts(2)%finish), abs(parts(4)%turn - 0.2_dp*arc%turn), &
            abs(norm2(parts(4)%start - arc%centre)/abs(arc%radius) - 1.0_dp), &
            abs(wrapped(leaving(parts(2)) - parts(3)%direction)))
    end do
    call tap%near(worst(1), 0.0_dp, 1.0e-14_dp, 'the end is on the circle')
    call tap%near(worst(2), 0.0_dp, 1.0e-14_dp, 'directions are mirrored in the chord')
    call tap%near(worst(3), 0.0_dp, 1.0e-13_dp, 'the turn leads to the end')
    call tap%near(worst(4), 0.0_dp, 1.0e-13_dp, 'backwards it is the same arc')
    call tap%near(worst(5), 0.0_dp, 1.0e-12_dp, 'its parts are end to end on it')
    call tap%near(abs(wrapped(7.0_dp*pi)), pi, 1.0e-14_dp, 'angles go from -180 to 180 degrees')
    call tap%finish()
end program test_circular
