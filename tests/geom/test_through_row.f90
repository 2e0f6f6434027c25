!> Arcs in a row by their ends and shoulder points: those of one after another, and doubt where
!> there is a line or no arc.
program test_through_row
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, end_type
    use geom_arc_row, only: arc_row_type
    use geom_through_row, only: arcs_through, end_row_type
    use geom_twofold, only: operator(-), to_real
    use geom_twofold_short, only: number_of, width
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(random_type) :: random
    type(end_row_type) :: start, finish
    type(arc_row_type) :: row
    type(arc_type) :: arc
    type(error_type), allocatable :: error
    real(dp) :: shoulder(width, 2), worst
    logical :: is_sure(width)
    integer :: i, wrong, axis

    do i = 1, width
        start%point(i, :) = [random%unit(), -random%unit()]
        start%tangent(i, :) = [random%unit(), 1.0_dp]
        shoulder(i, :) = [random%between(0.5_dp, 2.0_dp), random%between(1.0_dp, 3.0_dp)]
        finish%point(i, :) = [random%between(3.0_dp, 4.0_dp), random%between(1.0_dp, 3.0_dp)]
        finish%tangent(i, :) = [-1.0_dp, random%between(-0.5_dp, 0.5_dp)]
    end do
    start%point(1, :) = [0.0_dp, 0.0_dp]
    start%tangent(1, :) = [1.0_dp, 1.0_dp]
    shoulder(1, :) = [1.0_dp, 1.0_dp]
    finish%point(1, :) = [2.0_dp, 2.0_dp]
    finish%tangent(1, :) = [1.0_dp, 1.0_dp]
    start%point(2, :) = [3.0_dp, 4.0_dp]
    shoulder(2, :) = [3.0_dp, 4.0_dp]
    finish%point(2, :) = [3.0_dp, 4.0_dp]
    call arcs_through(start, shoulder, finish, row, is_sure)
    call tap%ok(.not. is_sure(1), 'a straight line is left to others')
    call tap%ok(.not. is_sure(2), 'so is a point')
    call tap%ok(count(is_sure) > 10, 'there are many arcs')
    wrong = 0
    worst = 0.0_dp
    do i = 3, width
        call arc_through(end_type(start%point(i, :), start%tangent(i, :)), shoulder(i, :), &
            end_type(finish%point(i, :), finish%tangent(i, :)), arc, error)
        if (is_sure(i) .eqv. allocated(error)) wrong = wrong + 1
        if (.not. is_sure(i)) cycle
        if (any(row%finish_tangent(i, :) /= arc%finish_tangent)) wrong = wrong + 1
        if (row%size(i) /= arc%size) wrong = wrong + 1
        worst = max(worst, abs(to_real(number_of(row%fullness, i) - arc%fullness)))
        do axis = 1, 2
            worst = max(worst, abs(to_real(number_of(row%bulge(axis), i) - arc%bulge(axis))), &
                abs(to_real(number_of(row%leaving(axis), i) - arc%leaving(axis))), &
                abs(to_real(number_of(row%arriving(axis), i) - arc%arriving(axis))))
        end do
    end do
    call tap%ok(wrong == 0, 'there is an arc where one alone is found, the same way')
    call tap%near(worst, 0.0_dp, 1.0e-27_dp, 'and it is the same to 90 bits')
    call tap%finish()
end program test_through_row
