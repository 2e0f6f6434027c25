!> Arcs by rho and by the intersection of the end tangents: against the shoulder point that the
!> definition of rho names, against quadruple precision, and what is refused.
program test_arc_by_rho
    use, intrinsic :: iso_fortran_env, only: real128
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_type, end_type, rho, turns_past_180, weight
    use geom_arc_by_rho, only: arc_by_corner, arc_by_corner_rho, arc_by_rho
    use geom_arc_point, only: point
    use geom_place, only: at_shoulder, place_at
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    integer, parameter :: qp = real128
    type(tap_type) :: tap
    type(arc_type) :: arc
    type(error_type), allocatable :: error
    real(dp), parameter :: flat(2) = [1.0_dp, 0.0_dp], up(2) = [0.0_dp, 1.0_dp]
    real(dp), parameter :: o(2) = [0.0_dp, 0.0_dp], e(2) = [4.0_dp, 0.0_dp]

    call check_shapes()
    call check_refusals()
    call check_random()
    call tap%finish()

contains

    !> Shapes whose shoulder and weight are known.
    subroutine check_shapes()
        call by_rho(o, [1.0_dp, 1.0_dp], 0.5_dp, e, [1.0_dp, -1.0_dp])
        call tap%near(weight(arc), 1.0_dp, 0.0_dp, 'rho .5 is a parabola')
        call tap%ok(all(point(arc, at_shoulder) == [2.0_dp, 1.0_dp]), &
            'whose shoulder is half way to the intersection of the tangents')
        call by_rho(o, [1.0_dp, 1.0_dp], 0.75_dp, e, [-1.0_dp, 1.0_dp])
        call tap%near(weight(arc), 3.0_dp, 0.0_dp, 'rho .75 has weight 3')
        call tap%near(rho(arc), 0.75_dp, 0.0_dp, 'and gives its rho back')
        call tap%ok(all(point(arc, at_shoulder) == [2.0_dp, 1.5_dp]), &
            'its shoulder is 3/4 of the way')
        call tap%ok(all(arc%start_tangent*[1.0_dp, 1.0_dp] > 0.0_dp) .and. &
            arc%finish_tangent(1) > 0.0_dp .and. arc%finish_tangent(2) < 0.0_dp, &
            'tangents given backwards are turned about')
        call arc_by_corner_rho(o, [1.0_dp, 3.0_dp], 0.25_dp, e, arc, error)
        call tap%ok(all(point(arc, at_shoulder) == [1.75_dp, 0.75_dp]), &
            'so it is where the intersection is given')
        call arc_by_corner([1.0_dp, 0.0_dp], [1.0_dp, 1.0_dp], [0.6_dp, 0.8_dp], [0.0_dp, 1.0_dp], &
            arc, error)
        call tap%near(weight(arc), sqrt(0.5_dp), 2.0e-16_dp, &
            'a corner of a square and the shoulder (.6, .8) are a quarter circle')
        call tap%ok(all(arc%start_tangent == 0.5_dp*up .or. arc%start_tangent == up), &
            'which starts upright')
        call arc_by_corner([1.0_dp, 0.0_dp], [1.0_dp, 1.0_dp], [-0.6_dp, -0.8_dp], &
            [0.0_dp, 1.0_dp], arc, error)
        call tap%ok(.not. allocated(error), 'the other three quarters are an arc too')
        if (.not. allocated(error)) call tap%ok(turns_past_180(arc), 'past 180 degrees')

        call by_rho(o, [3.0_dp, 1.0_dp], 0.4_dp, [3.0_dp, 1.0_dp], [3.0_dp, 1.0_dp])
        call tap%ok(.not. allocated(error) .and. arc%is_line, 'slopes along the chord make a line')
        call arc_by_corner_rho(o, [0.1_dp, 0.3_dp], 0.4_dp, [0.2_dp, 0.6_dp], arc, error)
        call tap%ok(.not. allocated(error) .and. arc%is_line, &
            'so does an intersection on the chord')
        call arc_by_corner(o, [0.1_dp, 0.3_dp], [0.3_dp, 0.9_dp], [0.7_dp, 2.1_dp], arc, error)
        call tap%ok(.not. allocated(error) .and. arc%is_line, 'and a shoulder there too')
    end subroutine check_shapes

    !> What is refused, and near misses.
    subroutine check_refusals()
        call by_rho(o, up, 1.0_dp, e, [1.0_dp, -1.0_dp])
        call tap%ok(refused(cause%no_arc, 'rho is 1.; it must be above 0'), 'rho 1')
        call by_rho(o, up, 0.0_dp, e, [1.0_dp, -1.0_dp])
        call tap%ok(refused(cause%no_arc, 'rho is 0.; it must be above 0'), 'rho 0')
        call by_rho(o, up, 0.999_dp, e, [1.0_dp, -1.0_dp])
        call tap%ok(.not. allocated(error), 'rho .999 is an arc')
        call by_rho(o, up, 0.4_dp, e, up)
        call tap%ok(refused(cause%no_arc, 'end tangents are parallel'), 'parallel end tangents')
        call by_rho(o, up, 0.4_dp, e, [0.001_dp, 1.0_dp])
        call tap%ok(.not. allocated(error), 'tangents that nearly are')
        call by_rho(o, flat, 0.4_dp, e, up)
        call tap%ok(refused(cause%tangent_on_chord, 'runs along the chord'), &
            'a tangent along the chord')
        call by_rho(o, [1.0_dp, 0.001_dp], 0.4_dp, e, up)
        call tap%ok(.not. allocated(error), 'one beside it')
        call by_rho(o, up, 0.4_dp, o, flat)
        call tap%ok(refused(cause%points_coincide, 'points 1 and 3'), 'both ends in one point')
        call arc_by_corner_rho(o, e, 0.4_dp, e, arc, error)
        call tap%ok(refused(cause%points_coincide, 'points T and 3'), &
            'the tangents meeting in an end')
        call arc_by_corner_rho(o, [5.0_dp, 0.0_dp], 0.4_dp, e, arc, error)
        call tap%ok(refused(cause%tangent_on_chord, '(5., 0.) is in line'), 'and beyond an end')
        call arc_by_corner(o, [2.0_dp, 0.0_dp], [2.0_dp, 1.0_dp], e, arc, error)
        call tap%ok(refused(cause%tangent_on_chord, '(2., 0.) is in line'), &
            'an intersection on the chord and a shoulder off it')
        call arc_by_corner(o, [2.0_dp, 4.0_dp], [2.0_dp, 0.0_dp], e, arc, error)
        call tap%ok(refused(cause%shoulder_outside, 'inside the triangle'), &
            'a shoulder on the chord')
        call arc_by_corner(o, [2.0_dp, 4.0_dp], [1.0_dp, 2.0_dp], e, arc, error)
        call tap%ok(refused(cause%shoulder_outside, 'tangents at (2., 4.)'), 'one on a tangent')
        call arc_by_corner(o, [2.0_dp, 4.0_dp], [1.01_dp, 2.0_dp], e, arc, error)
        call tap%ok(.not. allocated(error), 'one just inside makes an arc')
        call arc_by_corner(o, [2.0_dp, 4.0_dp], [24.0_dp, -40.0_dp], e, arc, error)
        call tap%ok(refused(cause%shoulder_outside, '(24., -40.)'), 'one on the other branch')
        call arc_by_corner(o, [2.0_dp, 4.0_dp], o, e, arc, error)
        call tap%ok(refused(cause%points_coincide, 'points 1 and 2'), 'one at an end')
    end subroutine check_refusals

    !> Random arcs by corner and rho: points against the rational form in quadruple precision.
    subroutine check_random()
        type(random_type) :: random
        real(dp) :: p(2, 3), ratio, at(2), worst, unit
        real(qp) :: q(2, 3), w, a, b
        integer :: i, j

        worst = 0.0_dp
        do i = 1, 20000
            p = reshape([(random%between(-50.0_dp, 50.0_dp), j = 1, 6)], [2, 3])
            ratio = random%between(0.01_dp, 0.99_dp)
            call arc_by_corner_rho(p(:, 1), p(:, 2), ratio, p(:, 3), arc, error)
            if (allocated(error)) cycle
            q = real(p, qp)
            w = real(ratio, qp)/(1 - real(ratio, qp))
            do j = 0, 8
                at = point(arc, place_at(0.125_dp*real(j, dp)))
                b = 0.125_qp*real(j, qp)
                a = 1 - b
                unit = spacing(maxval(abs(p(:, [1, 3]))))
                worst = max(worst, real(norm2(real(at, qp) - (a**2*q(:, 1) + 2*a*b*w*q(:, 2) &
                    + b**2*q(:, 3))/(a**2 + 2*a*b*w + b**2)), dp)/max(unit, &
                    spacing(maxval(abs(at)))))
            end do
        end do
        call tap%near(worst, 0.0_dp, 0.75_dp, 'points of arcs by corner and rho are within .75 ulp')
        print '(a, f8.3)', '# worst, in ulp of the largest coordinate:', worst
    end subroutine check_random

    !> The arc of two ends with their tangents and rho.
    subroutine by_rho(p1, t1, ratio, p3, t3)
        real(dp), intent(in) :: p1(2), t1(2), ratio, p3(2), t3(2)
        call arc_by_rho(end_type(p1, t1), ratio, end_type(p3, t3), arc, error)
    end subroutine by_rho

    !> True where an error of a cause is met whose message has some words.
    logical function refused(why, words)
        integer, intent(in) :: why
        character(*), intent(in) :: words
        refused = .false.
        if (.not. allocated(error)) return
        refused = error%cause == why .and. index(error%message, words) > 0
        if (.not. refused) call tap%note(error%message)
    end function refused

end program test_arc_by_rho
