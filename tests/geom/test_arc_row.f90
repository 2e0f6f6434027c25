!> Points, tangents and curvatures of arcs in a row: a circle in closed form, and figure for figure
!> those of one place after another.
program test_arc_row
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, end_type, line_between
    use geom_arc_point, only: curvature, point, tangent
    use geom_arc_row, only: arc_row_type, place_of_row, place_row, place_row_type, repeated_arc, &
        row_curvatures, row_points
    use geom_place, only: at_finish, at_start, place_at, place_type
    use geom_twofold_short, only: width
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(random_type) :: random
    type(arc_type) :: arc
    type(arc_row_type) :: row
    type(place_type) :: places(width)
    type(place_row_type) :: place
    type(error_type), allocatable :: error
    real(dp) :: at(width, 2), along(width, 2), bend(width)
    integer :: i, k, arcs, wrong(3)

    places = place_at([(real(i - 1, dp)/real(width - 1, dp), i=1, width)])
    places(1) = at_start
    places(width) = at_finish
    call arc_through(end_type([5.0_dp, 0.0_dp], [0.0_dp, 1.0_dp]), [3.0_dp, 4.0_dp], &
        end_type([0.0_dp, 5.0_dp], [1.0_dp, 0.0_dp]), arc, error)
    call draw()
    call tap%near(maxval(abs(sqrt(at(:, 1)**2 + at(:, 2)**2) - 5.0_dp)), 0.0_dp, 1.0e-15_dp, &
        'points of a circle')
    call tap%near(maxval(abs(at(:, 1)*along(:, 1) + at(:, 2)*along(:, 2))), 0.0_dp, 1.0e-14_dp, &
        'tangents are across the radius')
    call tap%near(maxval(abs(bend - 0.2_dp)), 0.0_dp, 1.0e-16_dp, 'and turn left by 1/5')
    arc = line_between([1.0_dp, 2.0_dp], [4.0_dp, 6.0_dp])
    call draw()
    call tap%ok(all(along(:, 1) == arc%start_tangent(1)) .and. all(bend == 0.0_dp), 'a line')
    wrong = 0
    arcs = 0
    do k = 1, 400
        call arc_through(end_type([random%unit(), random%unit()], [random%unit(), 1.0_dp]), &
            [random%between(0.5_dp, 2.0_dp), random%between(1.0_dp, 3.0_dp)], &
            end_type([random%between(3.0_dp, 4.0_dp), random%between(1.0_dp, 3.0_dp)], &
            [1.0_dp, random%between(-0.5_dp, 0.5_dp)]), arc, error)
        if (allocated(error)) cycle
        arcs = arcs + 1
        call draw()
        do i = 1, width
            if (any(at(i, :) /= point(arc, places(i)))) wrong(1) = wrong(1) + 1
            if (any(along(i, :) /= tangent(arc, places(i)))) wrong(2) = wrong(2) + 1
            if (bend(i) /= curvature(arc, places(i))) wrong(3) = wrong(3) + 1
        end do
    end do
    call tap%ok(arcs > 50, 'there are many arcs')
    call tap%ok(wrong(1) == 0, 'points are those of one after another')
    call tap%ok(wrong(2) == 0, 'tangents, too')
    call tap%ok(wrong(3) == 0, 'curvatures, too')
    places(1) = place_of_row(place, 5)
    call tap%ok(places(1)%beta%high == places(5)%beta%high, 'a place of a row')
    call tap%finish()

contains

    !> All of the arc at the places.
    subroutine draw()
        call repeated_arc(arc, row)
        call place_row(places, place)
        call row_points(row, place, at, along)
        call row_curvatures(row, place, bend)
    end subroutine draw

end program test_arc_row
