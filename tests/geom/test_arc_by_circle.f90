!> Arcs of circles: all points at one distance of the centre, the way they turn, what is refused.
program test_arc_by_circle
    use, intrinsic :: iso_fortran_env, only: real128
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_type, turns_past_180, weight
    use geom_arc_by_circle, only: circle_by_points, circle_by_radius
    use geom_arc_point, only: curvature, point
    use geom_conic, only: conic_kind, conic_of, conic_type
    use geom_place, only: at_finish, at_shoulder, at_start, place_at
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    integer, parameter :: qp = real128
    type(tap_type) :: tap
    type(arc_type) :: arc
    type(conic_type) :: conic
    type(error_type), allocatable :: error

    call check_shapes()
    call check_refusals()
    call check_random()
    call tap%finish()

contains

    !> Circles of whole numbers.
    subroutine check_shapes()
        call by_points([real(dp) :: 5, 0, 4, 3, 0, 5])
        call tap%near(weight(arc), sqrt(0.5_dp), 2.0e-16_dp, 'a quarter circle has weight cos 45')
        call tap%ok(arc%start_tangent(1) == 0.0_dp .and. arc%finish_tangent(2) == 0.0_dp, &
            'starts upright and ends level, exactly')
        conic = conic_of(arc)
        call tap%ok(conic%kind == conic_kind%circle, 'and is a circle')
        call tap%near(curvature(arc, at_start), 0.2_dp, 1.0e-16_dp, 'of radius 5, turning left')
        call by_points([real(dp) :: 5, 0, -4, -3, 0, 5])
        call tap%near(curvature(arc, at_shoulder), -0.2_dp, 1.0e-16_dp, &
            'the other way round it turns right')
        call tap%ok(turns_past_180(arc), 'and by more than 180 degrees')
        call by_points([real(dp) :: 5, 0, 3, 4, -5, 0])
        call tap%near(weight(arc), 0.0_dp, 0.0_dp, 'a semicircle has weight 0')
        call by_points([0.0_dp, 0.0_dp, 0.1_dp, 0.3_dp, 0.2_dp, 0.6_dp])
        call tap%ok(arc%is_line .and. .not. allocated(error), 'decimals in line make a line')

        call circle_by_radius([5.0_dp, 0.0_dp], [0.0_dp, 5.0_dp], 5.0_dp, arc, error)
        call tap%near(curvature(arc, at_finish), 0.2_dp, 1.0e-16_dp, 'a positive radius turns left')
        call tap%near(weight(arc), sqrt(0.5_dp), 2.0e-16_dp, 'by 90 degrees here')
        call circle_by_radius([0.0_dp, 5.0_dp], [5.0_dp, 0.0_dp], -5.0_dp, arc, error)
        call tap%near(curvature(arc, at_finish), -0.2_dp, 1.0e-16_dp, 'a negative radius right')
        call circle_by_radius([0.0_dp, 5.0_dp], [6.0_dp, 5.0_dp], -5.0_dp, arc, error)
        call tap%ok(all(point(arc, at_shoulder) == [3.0_dp, 6.0_dp]), &
            'of two arcs it is the lesser')
        call circle_by_radius([0.0_dp, 5.0_dp], [6.0_dp, 5.0_dp], 3.0_dp, arc, error)
        call tap%ok(all(point(arc, at_shoulder) == [3.0_dp, 2.0_dp]), &
            'of half the distance it is a semicircle')
        call tap%ok(arc%start_tangent(1) == 0.0_dp .and. arc%start_tangent(2) < 0.0_dp, &
            'which starts straight down')
        call circle_by_radius([0.0_dp, 0.0_dp], [0.2_dp, 0.4_dp], sqrt(0.05_dp), arc, error)
        call tap%ok(.not. allocated(error), 'so it is within the last decimals')
    end subroutine check_shapes

    !> What is refused, and near misses.
    subroutine check_refusals()
        call by_points([real(dp) :: 0, 0, 2, 2, 1, 1])
        call tap%ok(refused(cause%no_arc, 'not between the others'), 'points in line out of order')
        call by_points([real(dp) :: 0, 0, 2, 2, 2, 2])
        call tap%ok(refused(cause%points_coincide, 'points 2 and 3 are both (2., 2.)'), &
            'a point given twice')
        call by_points([0.0_dp, 0.0_dp, 2.0_dp, 2.0_dp, 1.0_dp, 1.000001_dp])
        call tap%ok(.not. allocated(error), 'points all but in line make nearly a whole circle')
        call circle_by_radius([0.0_dp, 0.0_dp], [6.0_dp, 0.0_dp], 2.999_dp, arc, error)
        call tap%ok(refused(cause%no_arc, 'must be 3. or more'), 'too small a radius')
        call circle_by_radius([0.0_dp, 0.0_dp], [6.0_dp, 0.0_dp], 0.0_dp, arc, error)
        call tap%ok(refused(cause%no_arc, 'the radius is 0.'), 'none')
        call circle_by_radius([6.0_dp, 0.0_dp], [6.0_dp, 0.0_dp], 2.0_dp, arc, error)
        call tap%ok(refused(cause%points_coincide, 'points 1 and 3'), 'one point')
    end subroutine check_refusals

    !> Random circles: the distance of their points from the circle in quadruple precision.
    subroutine check_random()
        type(random_type) :: random
        real(dp) :: p(2, 3), r, at(2), worst(2), span
        real(qp) :: q(2, 3), c(2), d(2, 2), area
        integer :: i, j

        worst = 0.0_dp
        do i = 1, 20000
            p = reshape([(random%between(-50.0_dp, 50.0_dp), j = 1, 6)], [2, 3])
            q = real(p, qp)
            d(:, 1) = q(:, 2) - q(:, 1)
            d(:, 2) = q(:, 3) - q(:, 1)
            area = 2*(d(1, 1)*d(2, 2) - d(2, 1)*d(1, 2))
            c = q(:, 1) + [d(2, 2)*sum(d(:, 1)**2) - d(2, 1)*sum(d(:, 2)**2), &
                d(1, 1)*sum(d(:, 2)**2) - d(1, 2)*sum(d(:, 1)**2)]/area
            call circle_by_points(p(:, 1), p(:, 2), p(:, 3), arc, error)
            if (allocated(error)) call tap%ok(.false., error%message)
            do j = 1, 7
                at = point(arc, place_at(0.125_dp*real(j, dp)))
                worst(1) = max(worst(1), off(at, c, norm2(c - q(:, 1)))/ &
                    spacing(max(maxval(abs(p)), maxval(abs(at)))))
            end do
            span = norm2(p(:, 3) - p(:, 1))
            r = random%sign()*span*random%between(0.5001_dp, 4.0_dp)
            call circle_by_radius(p(:, 1), p(:, 3), r, arc, error)
            d(:, 1) = 0.5_qp*d(:, 2)
            c = q(:, 1) + d(:, 1) + sign(1.0_qp, &
                real(r, qp))*sqrt(real(r, qp)**2/sum(d(:, 1)**2) - 1) &
                *[-d(2, 1), d(1, 1)]
            do j = 1, 7
                at = point(arc, place_at(0.125_dp*real(j, dp)))
                worst(2) = max(worst(2), off(at, c, abs(real(r, qp)))/ &
                    spacing(max(maxval(abs(p)), maxval(abs(at)))))
            end do
        end do
        call tap%near(worst(1), 0.0_dp, 0.75_dp, 'circles by three points are within .75 ulp')
        call tap%near(worst(2), 0.0_dp, 0.75_dp, 'circles by radius are within .75 ulp')
        print '(a, 2f8.3)', '# worst, in ulp of the largest coordinate:', worst
    end subroutine check_random

    !> How far a point is off a circle.
    pure real(dp) function off(at, centre, radius)
        real(dp), intent(in) :: at(2)
        real(qp), intent(in) :: centre(2), radius
        off = real(abs(norm2(real(at, qp) - centre) - radius), dp)
    end function off

    !> The arc through three points, x and y in turn.
    subroutine by_points(p)
        real(dp), intent(in) :: p(6)
        call circle_by_points(p(1:2), p(3:4), p(5:6), arc, error)
    end subroutine by_points

    !> True where an error of a cause is met whose message has some words.
    logical function refused(why, words)
        integer, intent(in) :: why
        character(*), intent(in) :: words
        refused = .false.
        if (.not. allocated(error)) return
        refused = error%cause == why .and. index(error%message, words) > 0
        if (.not. refused) call tap%note(error%message)
    end function refused

end program test_arc_by_circle
