!> Arcs through points: shapes known in closed form, random conics in quadruple precision, refusals.
program test_arc_by_points
    use, intrinsic :: iso_fortran_env, only: real128
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_type, weight
    use geom_arc_by_points, only: arc_by_five_points, arc_by_four_points, line_by_points
    use geom_arc_point, only: point
    use geom_place, only: place_at
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    integer, parameter :: qp = real128
    type(tap_type) :: tap
    type(arc_type) :: arc
    type(error_type), allocatable :: error
    real(dp), parameter :: flat(2) = [1.0_dp, 0.0_dp], up(2) = [0.0_dp, 1.0_dp]

    call check_shapes()
    call check_lines()
    call check_refusals()
    call check_random()
    call tap%finish()

contains

    !> Shapes whose weights are known.
    subroutine check_shapes()
        call five([real(dp) :: 5, 0, 4, 3, 3, 4, 0, 5, -3, 4])
        call tap%ok(.not. allocated(error), 'five points of a circle make an arc')
        call tap%near(weight(arc), sqrt(0.2_dp), 2.0e-16_dp, 'with the weight of a circle')
        call tap%near(arc%start_tangent(1)/arc%start_tangent(2), 0.0_dp, 0.0_dp, &
            'upright where it starts')
        call tap%near(arc%finish_tangent(2)/arc%finish_tangent(1), 0.75_dp, 0.0_dp, &
            'and of slope 3/4 where it ends')
        call five([real(dp) :: -1, 1, 0, 0, 1, 1, 2, 4, 3, 9])
        call tap%near(weight(arc), 1.0_dp, 2.0e-16_dp, 'five points of y = x**2 make a parabola')
        call tap%near(arc%start_tangent(2)/arc%start_tangent(1), -2.0_dp, 4.0e-16_dp, &
            'of slope -2 at -1')
        call tap%near(arc%finish_tangent(2)/arc%finish_tangent(1), 6.0_dp, 1.0e-15_dp, 'and 6 at 3')
        call five([0.5_dp, 2.0_dp, 0.8_dp, 1.25_dp, 1.0_dp, 1.0_dp, 1.25_dp, 0.8_dp, 2.0_dp, &
            0.5_dp])
        call tap%near(weight(arc), 1.25_dp, 1.0e-14_dp, 'five points of y = 1/x make a hyperbola')
        call five([real(dp) :: 5, 0, 3, 4, -4, 3, -3, -4, 4, -3])
        call tap%ok(.not. allocated(error) .and. weight(arc) < 0.0_dp, &
            'an arc past 180 degrees runs through its points')
        call five([real(dp) :: 5, 0, 3, 4, 0, 5, -3, 4, -5, 0])
        call tap%near(weight(arc), 0.0_dp, 0.0_dp, 'a semicircle has weight 0')

        call four([0.0_dp, 0.0_dp], flat, [1.0_dp, 1.0_dp], [2.0_dp, 4.0_dp], [3.0_dp, 9.0_dp])
        call tap%near(weight(arc), 1.0_dp, 2.0e-16_dp, &
            'four points of y = x**2 and its slope make a parabola')
        call tap%near(arc%finish_tangent(2)/arc%finish_tangent(1), 6.0_dp, 1.0e-15_dp, &
            'of slope 6 at 3')
        call four([5.0_dp, 0.0_dp], up, [4.0_dp, 3.0_dp], [3.0_dp, 4.0_dp], [0.0_dp, 5.0_dp])
        call tap%near(weight(arc), sqrt(0.5_dp), 2.0e-16_dp, &
            'four points of a circle, upright, make a circle')
        call arc_by_four_points(reshape([real(dp) :: 3, 9, 2, 4, 1, 1, 0, 0], [2, 4]), flat, &
            .true., arc, error)
        call tap%near(weight(arc), 1.0_dp, 2.0e-16_dp, 'with the slope at the last point too')
        call tap%ok(all(arc%start == [3.0_dp, 9.0_dp]) .and. arc%start_tangent(1) < 0.0_dp, &
            'from first to last')
    end subroutine check_shapes

    !> Straight lines.
    subroutine check_lines()
        call line_by_points([1.0_dp, 2.0_dp], [4.0_dp, 3.0_dp], arc, error)
        call tap%ok(arc%is_line .and. all(arc%finish == [4.0_dp, 3.0_dp]), &
            'two points make a straight line')
        call line_by_points([1.0_dp, 2.0_dp], [1.0_dp, 2.0_dp], arc, error)
        call tap%ok(refused(cause%points_coincide, 'points 1 and 3 are both (1., 2.)'), &
            'one point does not')
        call five([0.0_dp, 0.0_dp, 0.1_dp, 0.3_dp, 0.2_dp, 0.6_dp, 0.3_dp, 0.9_dp, 0.7_dp, 2.1_dp])
        call tap%ok(.not. allocated(error) .and. arc%is_line, &
            'five decimal points in line make a line')
        call four([0.0_dp, 0.0_dp], [1.0_dp, 3.0_dp], [0.1_dp, 0.3_dp], [0.2_dp, 0.6_dp], &
            [0.7_dp, 2.1_dp])
        call tap%ok(.not. allocated(error) .and. arc%is_line, 'so do four, with their slope')
        call four([0.0_dp, 0.0_dp], [1.0_dp, 2.0_dp], [0.1_dp, 0.3_dp], [0.2_dp, 0.6_dp], &
            [0.7_dp, 2.1_dp])
        call tap%ok(refused(cause%no_arc, 'points 1, A and B are in line'), &
            'but not with another slope')
        call five([0.0_dp, 0.0_dp, 0.2_dp, 0.6_dp, 0.1_dp, 0.3_dp, 0.3_dp, 0.9_dp, 0.7_dp, 2.1_dp])
        call tap%ok(refused(cause%no_arc, 'in order for a straight line'), 'nor out of order')
    end subroutine check_lines

    !> What no arc passes, and near misses.
    subroutine check_refusals()
        call five([real(dp) :: 5, 0, 4, 3, 4, 3, 0, 5, -3, 4])
        call tap%ok(refused(cause%points_coincide, 'points A and B are both (4., 3.)'), &
            'a point given twice')
        call five([real(dp) :: 0, 0, 1, 1, 2, 2, 3, 4, 5, 4])
        call tap%ok(refused(cause%no_arc, 'points 1, A and B are in line'), 'three points in line')
        call five([real(dp) :: 5, 0, 3, 4, 4, 3, 0, 5, -3, 4])
        call tap%ok(refused(cause%no_arc, 'in the order 1, A, B, C, 3'), &
            'points of a circle out of order')
        call five([real(dp) :: 5, 0, 4, 3, 3, 4, 4, -3, -3, 4])
        call tap%ok(refused(cause%no_arc, 'in the order 1, A, B, C, 3'), &
            'points on both arcs of a circle')
        call five([0.5_dp, 2.0_dp, 0.8_dp, 1.25_dp, 1.0_dp, 1.0_dp, 1.25_dp, 0.8_dp, -2.0_dp, &
            -0.5_dp])
        call tap%ok(refused(cause%no_arc, 'both of its branches'), &
            'points on both branches of a hyperbola')
        call five([0.0_dp, 0.0_dp, 2.0_dp, 0.5_dp, 3.0_dp, 3.2_dp, 4.1_dp, 5.5_dp, 6.0_dp, 6.0_dp])
        call tap%ok(refused(cause%no_arc, 'both of its branches'), 'points of an S-curve')

        call four([5.0_dp, 0.0_dp], up, [3.0_dp, 4.0_dp], [4.0_dp, 3.0_dp], [0.0_dp, 5.0_dp])
        call tap%ok(refused(cause%no_arc, 'in the order 1, A, B, 3'), 'four points out of order')
        call four([0.0_dp, 0.0_dp], flat, [1.0_dp, 0.0_dp], [2.0_dp, 4.0_dp], [3.0_dp, 9.0_dp])
        call tap%ok(refused(cause%no_arc, 'the tangent at point 1 passes point A (1., 0.)'), &
            'a point on the tangent')
        call arc_by_four_points(reshape([real(dp) :: 3, 9, 2, 4, 1, 0, 0, 0], [2, 4]), flat, &
            .true., arc, error)
        call tap%ok(refused(cause%no_arc, 'the tangent at point 3 passes point B (1., 0.)'), &
            'or on that at the last')
        call four([0.0_dp, 0.0_dp], [1.0_dp, 0.5_dp], [1.0_dp, 1.0_dp], [2.0_dp, 4.0_dp], &
            [3.0_dp, 9.0_dp])
        call tap%ok(.not. allocated(error), 'another slope of four points makes another conic')
        call four([0.0_dp, 0.0_dp], [1.0_dp, 1.5_dp], [1.0_dp, 1.0_dp], [2.0_dp, 4.0_dp], &
            [3.0_dp, 9.0_dp])
        call tap%ok(refused(cause%no_arc, 'correct the slope'), &
            'one that leads between the points does not')
    end subroutine check_refusals

    !> Random five points near random conics: LOFT's arc against the conic through the five doubles,
    !> set up as pencil in quadruple precision, at places along the arc.
    subroutine check_random()
        type(random_type) :: random
        real(dp) :: p(2, 5), corner(2), w, a, at(2), worst(2), size
        real(dp), parameter :: share(5) = [0.0_dp, 0.25_dp, 0.5_dp, 0.75_dp, 1.0_dp]
        integer :: i, j, k, made

        worst = 0.0_dp
        made = 0
        do i = 1, 20000
            p(:, 1) = [random%between(-100.0_dp, 100.0_dp), random%between(-50.0_dp, 50.0_dp)]
            corner = p(:, 1) + [random%between(-40.0_dp, 40.0_dp), &
                random%between(-40.0_dp, 40.0_dp)]
            p(:, 5) = corner + [random%between(-40.0_dp, 40.0_dp), &
                random%between(-40.0_dp, 40.0_dp)]
            w = random%between(0.1_dp, 3.0_dp)
            do j = 2, 4
                a = share(j) + random%between(-0.1_dp, 0.1_dp)
                p(:, j) = ((1.0_dp - a)**2*p(:, 1) + 2.0_dp*a*(1.0_dp - a)*w*corner + a**2*p(:, &
                    5)) &
                    /((1.0_dp - a)**2 + 2.0_dp*a*(1.0_dp - a)*w + a**2)
            end do
            do k = 1, 2
                if (k == 1) then
                    call arc_by_five_points(p, arc, error)
                else
                    call arc_by_four_points(p(:, [1, 2, 4, 5]), corner - p(:, 1), .false., arc, &
                        error)
                end if
                if (allocated(error)) cycle
                made = made + 1
                do j = 1, 7
                    at = point(arc, place_at(0.125_dp*real(j, dp)))
                    size = spacing(max(maxval(abs(p)), maxval(abs(at))))
                    worst(k) = max(worst(k), distance(p, corner - p(:, 1), at, k)/size)
                end do
            end do
        end do
        call tap%ok(made > 39000, 'almost all points of random conics make an arc')
        call tap%near(worst(1), 0.0_dp, 1.0_dp, 'points of arcs by five points are within an ulp')
        call tap%near(worst(2), 0.0_dp, 1.0_dp, &
            'points of arcs by four points and a slope are within an ulp')
        print '(a, 2f8.3)', '# worst, in ulp of the largest coordinate:', worst
    end subroutine check_random

    !> The distance of a point from the conic through five points (k = 1), or through points 1, 2, 4
    !> and 5 with a tangent at 1 (k = 2), by |F|/|grad F|.
    real(dp) function distance(p, tangent, at, k)
        real(dp), intent(in) :: p(2, 5), tangent(2), at(2)
        integer, intent(in) :: k
        real(qp) :: q(2, 5), l, m, f, g(2), e1, e2, t(2)
        real(qp) :: x(2)
        integer :: b

        q = real(p, qp)
        t = real(tangent, qp)
        b = merge(3, 4, k == 1)
        if (k == 1) then
            l = side(q(:, 1), q(:, 3), q(:, 4))*side(q(:, 2), q(:, 5), q(:, 4))
            m = -side(q(:, 1), q(:, 2), q(:, 4))*side(q(:, 3), q(:, 5), q(:, 4))
        else
            e1 = (q(1, 2) - q(1, 1))*t(2) - (q(2, 2) - q(2, 1))*t(1)
            e2 = (q(1, 4) - q(1, 1))*t(2) - (q(2, 4) - q(2, 1))*t(1)
            l = e2*side(q(:, 2), q(:, 5), q(:, 1))
            m = -e1*side(q(:, 4), q(:, 5), q(:, 1))
        end if
        x = real(at, qp)
        f = l*side(q(:, 1), q(:, 2), x)*side(q(:, b), q(:, 5), x) &
            + m*side(q(:, 1), q(:, b), x)*side(q(:, 2), q(:, 5), x)
        g = l*(normal(q(:, 1), q(:, 2))*side(q(:, b), q(:, 5), x) + normal(q(:, b), &
            q(:, 5))*side(q(:, 1), q(:, 2), x)) &
            + m*(normal(q(:, 1), q(:, b))*side(q(:, 2), q(:, 5), x) + normal(q(:, 2), &
            q(:, 5))*side(q(:, 1), q(:, b), x))
        distance = real(abs(f)/norm2(g), dp)
    end function distance

    !> The equation of the line from u to v at x.
    pure real(qp) function side(u, v, x)
        real(qp), intent(in) :: u(2), v(2), x(2)
        side = (v(1) - u(1))*(x(2) - u(2)) - (v(2) - u(2))*(x(1) - u(1))
    end function side

    !> Its gradient.
    pure function normal(u, v)
        real(qp), intent(in) :: u(2), v(2)
        real(qp) :: normal(2)
        normal = [u(2) - v(2), v(1) - u(1)]
    end function normal

    !> The arc of five points, x and y in turn.
    subroutine five(coordinates)
        real(dp), intent(in) :: coordinates(10)
        call arc_by_five_points(reshape(coordinates, [2, 5]), arc, error)
    end subroutine five

    !> The arc of four points and a tangent.
    subroutine four(p1, t1, a, b, p3)
        real(dp), intent(in) :: p1(2), t1(2), a(2), b(2), p3(2)
        call arc_by_four_points(reshape([p1, a, b, p3], [2, 4]), t1, .false., arc, error)
    end subroutine four

    !> True where an error of a cause is met whose message has some words.
    logical function refused(why, words)
        integer, intent(in) :: why
        character(*), intent(in) :: words
        refused = .false.
        if (.not. allocated(error)) return
        refused = error%cause == why .and. index(error%message, words) > 0
        if (.not. refused) call tap%note(error%message)
    end function refused

end program test_arc_by_points
