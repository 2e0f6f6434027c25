!> Parts of arcs against the arc itself, and of a circle against the circle.
program test_subarc
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, end_type, weight
    use geom_arc_point, only: curvature, point
    use geom_place, only: at_finish, at_start, place_at
    use geom_subarc, only: part_of, place_between, place_of_part
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(arc_type) :: circle, part
    type(error_type), allocatable :: error
    real(dp) :: at(2), miss, bend
    integer :: i

    call arc_through(end_type([5.0_dp, 0.0_dp], [0.0_dp, 1.0_dp]), [3.0_dp, 4.0_dp], &
        end_type([0.0_dp, 5.0_dp], [1.0_dp, 0.0_dp]), circle, error)
    call tap%ok(.not. allocated(error), 'a quarter of a circle of radius 5')
    at = point(circle, place_between(circle, at_start, at_finish))
    call tap%near(norm2(at - 5.0_dp*sqrt(0.5_dp)), 0.0_dp, 1.0e-15_dp, &
        'has its shoulder at 45 degrees')
    part = part_of(circle, place_at(0.1_dp), place_at(0.6_dp))
    miss = 0.0_dp
    bend = 0.0_dp
    do i = 0, 20
        at = point(part, place_at(real(i, dp)/20.0_dp))
        miss = max(miss, abs(norm2(at) - 5.0_dp))
        bend = max(bend, abs(curvature(part, place_at(real(i, dp)/20.0_dp)) - 0.2_dp))
    end do
    call tap%near(miss, 0.0_dp, 2.0e-15_dp, 'a part of it is on the circle')
    call tap%near(bend, 0.0_dp, 1.0e-13_dp, 'and as round')
    call tap%ok(all(part%start == point(circle, place_at(0.1_dp))), 'it begins where it is to')
    call tap%ok(all(part%finish == point(circle, place_at(0.6_dp))), 'it ends where it is to')
    call tap%ok(weight(part) < 1.0_dp .and. weight(part) > weight(circle), 'it turns by less')
    miss = 0.0_dp
    do i = 0, 20
        at = point(part, place_at(real(i, dp)/20.0_dp)) - point(circle, place_of_part(circle, &
            place_at(0.1_dp), place_at(0.6_dp), place_at(real(i, dp)/20.0_dp)))
        miss = max(miss, norm2(at))
    end do
    call tap%near(miss, 0.0_dp, 4.0e-15_dp, 'a place of the part is a place of the arc')
    part = part_of(circle, at_start, at_finish)
    call tap%ok(all(part%start == circle%start) .and. weight(part) == weight(circle), &
        'the whole is the arc itself')
    part = part_of(circle, place_at(0.5_dp), place_at(0.5_dp + 1.0e-15_dp))
    call tap%ok(part%is_line, 'a part that doubles can''t bend is a line')
    call tap%finish()
end program test_subarc
