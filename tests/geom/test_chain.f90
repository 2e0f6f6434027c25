!> Chains of arcs: ordinates and derivatives of shapes known in closed form, order, joints, and what
!> is refused.
program test_chain
    use, intrinsic :: iso_fortran_env, only: real128
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, end_type, line_between, reversed
    use geom_chain, only: chain_from, chain_has, chain_jet, chain_joints, chain_to, chain_type, &
        chain_value, constant_chain, new_chain
    use geom_jet, only: jet_type
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    integer, parameter :: qp = real128
    real(dp), parameter :: up(2) = [0.0_dp, 1.0_dp], flat(2) = [1.0_dp, 0.0_dp]
    type(tap_type) :: tap
    type(arc_type) :: parabola, quarter, tail
    type(chain_type) :: chain, back
    type(jet_type) :: jet
    type(error_type), allocatable :: error
    logical :: is_vertical

    parabola = made([1.0_dp, 1.0_dp], [1.0_dp, 2.0_dp], [2.0_dp, 4.0_dp], [3.0_dp, 9.0_dp], &
        [1.0_dp, 6.0_dp])
    quarter = made([0.0_dp, 0.0_dp], up, [0.2_dp, 0.6_dp], [1.0_dp, 1.0_dp], flat)
    tail = line_between([3.0_dp, 9.0_dp], [5.0_dp, 8.0_dp])

    call new_chain([quarter, parabola, tail], chain, error)
    call tap%ok(.not. allocated(error), 'a quarter circle, a parabola and a line make a chain')
    call tap%ok(chain_from(chain) == 0.0_dp .and. chain_to(chain) == 5.0_dp, 'its range is theirs')
    call tap%ok(all(chain_joints(chain) == [1.0_dp, 3.0_dp]), 'its joints are where they meet')
    call tap%ok(chain_has(chain, 0.0_dp) .and. chain_has(chain, 5.0_dp), 'it has both its ends')
    call tap%ok(.not. (chain_has(chain, nearest(0.0_dp, -1.0_dp)) .or. &
        chain_has(chain, nearest(5.0_dp, 1.0_dp))), 'and nothing beyond them')
    call tap%ok(chain_value(chain, 0.0_dp) == 0.0_dp .and. chain_value(chain, 5.0_dp) == 8.0_dp, &
        'its ends are exact')
    call tap%near(chain_value(chain, 0.4_dp), 0.8_dp, 1.2e-16_dp, 'a circle at .4 is at .8')
    call tap%near(chain_value(chain, 2.5_dp), 6.25_dp, 0.0_dp, 'x**2 at 2.5 is 6.25')
    call tap%near(chain_value(chain, 4.5_dp), 8.25_dp, 0.0_dp, 'the line at 4.5 is 8.25')

    call chain_jet(chain, 0.0_dp, jet, is_vertical)
    call tap%ok(is_vertical .and. jet%first == 0.0_dp .and. jet%second == 0.0_dp, &
        'at its start the circle is vertical, and has no derivatives')
    call chain_jet(chain, 0.4_dp, jet, is_vertical)
    call tap%ok(.not. is_vertical, 'and nowhere else')
    call tap%near(jet%value, 0.8_dp, 1.2e-16_dp, 'the jet has the ordinate')
    call tap%near(jet%first, 0.75_dp, 2.0e-16_dp, 'the slope of the circle at (.4, .8) is 3/4')
    call tap%near(jet%second, -1.953125_dp, 1.0e-15_dp, 'and its second derivative -(5/4)**3')
    call chain_jet(chain, 1.0_dp, jet, is_vertical)
    call tap%ok(jet%first == 2.0_dp, 'at a joint the slope is that after it')
    call tap%near(jet%second, 2.0_dp, 9.0e-16_dp, 'so is the second derivative')
    call chain_jet(chain, 2.5_dp, jet, is_vertical)
    call tap%near(jet%first, 5.0_dp, 0.0_dp, 'the slope of x**2 is 2 x')
    call tap%near(jet%second, 2.0_dp, 9.0e-16_dp, 'and its second derivative 2')
    call chain_jet(chain, 5.0_dp, jet, is_vertical)
    call tap%ok(jet%value == 8.0_dp .and. jet%first == -0.5_dp .and. jet%second == 0.0_dp, &
        'at the end of the chain the derivatives are those before it')

    call new_chain([reversed(tail), reversed(parabola), reversed(quarter)], back, error)
    call tap%ok(.not. allocated(error), 'cards from aft to fore make a chain')
    call tap%ok(same(chain, back), 'which is the same')
    call new_chain([reversed(quarter), parabola, reversed(tail)], back, error)
    call tap%ok(same(chain, back), 'so is that of arcs of any direction')

    call constant_chain(-7.25_dp, chain)
    call tap%ok(chain_from(chain) == -huge(1.0_dp) .and. chain_to(chain) == huge(1.0_dp), &
        'a constant is everywhere')
    call tap%ok(chain_has(chain, -1.0e300_dp) .and. size(chain_joints(chain)) == 0, &
        'without joints')
    call tap%ok(chain_value(chain, 12.0_dp) == -7.25_dp, 'with its value')
    call chain_jet(chain, 3.0_dp, jet, is_vertical)
    call tap%ok(jet%value == -7.25_dp .and. jet%first == 0.0_dp .and. jet%second == 0.0_dp .and. &
        .not. is_vertical, 'and level')

    call check_refusals()
    call check_accuracy()
    call tap%finish()

contains

    !> What is no chain, and its near misses.
    subroutine check_refusals()
        type(arc_type) :: arc

        arc = made([0.0_dp, 0.0_dp], up, [1.0_dp, 1.0_dp], [1.8_dp, 0.6_dp], &
            [-0.6_dp, -0.8_dp]*[-1.0_dp, 1.0_dp])
        call new_chain([arc], chain, error)
        call tap%ok(.not. allocated(error), 'an arc down to 1.8 of a circle to 2 is single-valued')
        arc = made([1.0_dp, 2.0_dp], flat, [2.0_dp, 1.0_dp], [1.6_dp, 0.2_dp], [0.8_dp, 0.6_dp])
        call new_chain([parabola, arc], chain, error)
        call tap%ok(refused(cause%not_single_valued), 'past 2 it is not')
        if (allocated(error)) call tap%same(error%message, &
            'the arc from (1., 2.) to (1.6, 0.2) turns '// &
            'past the vertical at (2., 1.) and has two ordinates there; '// &
            'end it where it is vertical', &
            'and the message names the arc and where it turns')
        arc = made([1.0_dp, 1.0_dp], flat, [1.6_dp, 0.8_dp], [2.0_dp, 0.0_dp], up)
        call new_chain([arc], chain, error)
        call tap%ok(.not. allocated(error), 'up to 2 it is')
        call new_chain([line_between([3.0_dp, 9.0_dp], [3.0_dp, 10.0_dp])], chain, error)
        call tap%ok(refused(cause%not_single_valued), 'a vertical line is not single-valued')
        call new_chain([line_between([3.0_dp, 9.0_dp], [3.0001_dp, 10.0_dp])], chain, error)
        call tap%ok(.not. allocated(error), 'a line that leans is')
        arc = made([-1.0_dp, 0.0_dp], up, [0.0_dp, 1.0_dp], [1.0_dp, 0.0_dp], up)
        call new_chain([arc], chain, error)
        call tap%ok(.not. allocated(error), 'a semicircle is single-valued')

        call new_chain([parabola, line_between([3.001_dp, 9.0_dp], [5.0_dp, 8.0_dp])], chain, error)
        call tap%ok(refused(cause%joint_gap), 'arcs .001 apart do not meet')
        call new_chain([parabola, line_between([3.001_dp, 9.0_dp], [5.0_dp, 8.0_dp])], 0.002_dp, &
            chain, error)
        call tap%ok(.not. allocated(error), 'but do where .002 is allowed')
        call tap%ok(chain_value(chain, 3.0005_dp) == 9.0_dp, &
            'and between them the last ordinate stays')
        call new_chain([parabola, line_between([2.999_dp, 9.0_dp], [5.0_dp, 8.0_dp])], 0.002_dp, &
            chain, error)
        call tap%ok(chain_value(chain, 2.999_dp) == 9.0_dp, 'of an overlap the later arc counts')
        call new_chain([parabola, line_between([2.0_dp, 9.0_dp], [5.0_dp, 8.0_dp])], chain, error)
        call tap%ok(refused(cause%joint_gap), 'arcs that overlap do not meet')
        call new_chain([parabola, tail, quarter], chain, error)
        call tap%ok(refused(cause%joint_gap), 'arcs out of order do not meet')
        call new_chain([line_between([0.1_dp + 0.2_dp, 0.0_dp], [0.7_dp, 1.0_dp]), &
            line_between([0.0_dp, 0.0_dp], [0.3_dp, 0.0_dp])], chain, error)
        call tap%ok(.not. allocated(error), &
            'decimals that binary holds differently meet, aft to fore')
    end subroutine check_refusals

    !> Random arcs against Liming's equation of the doubles as read, in quadruple precision:
    !>
    !>     F(p) = C(p)**2 - k L1(p) L3(p),     k = C(s)**2/(L1(s) L3(s))
    !>
    !> of which y, dy/dx and d2y/dx2 follow. Ordinates in ulp of the largest coordinate, normal to
    !> the curve; derivatives relative, in ulp, where they are not nearly zero.
    subroutine check_accuracy()
        type(random_type) :: random
        type(end_type) :: ends(2)
        real(dp) :: corner(2), shoulder(2), worst(3), x
        integer :: i, tried

        worst = 0.0_dp
        tried = 0
        do i = 1, 20000
            ends(1)%point = [random%between(-100.0_dp, 100.0_dp), random%between(-50.0_dp, 50.0_dp)]
            corner = ends(1)%point + [random%between(0.0_dp, 40.0_dp), &
                random%between(-40.0_dp, 40.0_dp)]
            ends(2)%point = corner + [random%between(0.0_dp, 40.0_dp), &
                random%between(-40.0_dp, 40.0_dp)]
            ends(1)%tangent = corner - ends(1)%point
            ends(2)%tangent = ends(2)%point - corner
            x = random%between(0.05_dp, 0.95_dp)
            shoulder = 0.5_dp*(1.0_dp - x)*(ends(1)%point + ends(2)%point) + x*corner
            call new_chain([made(ends(1)%point, ends(1)%tangent, shoulder, ends(2)%point, &
                ends(2)%tangent)], chain, error)
            if (allocated(error)) cycle
            tried = tried + 1
            x = random%between(ends(1)%point(1), ends(2)%point(1))
            worst = max(worst, errors_at(ends, shoulder, x))
        end do
        call tap%ok(tried > 19000, 'almost all random arcs make a chain')
        call tap%near(worst(1), 0.0_dp, 0.51_dp, &
            'ordinates are within .51 ulp, normal to the curve')
        call tap%near(worst(2), 0.0_dp, 2.0_dp, 'slopes are within 2 ulp of themselves')
        call tap%near(worst(3), 0.0_dp, 8.0_dp, 'second derivatives are within 8 ulp of themselves')
        call tap%note('worst: ordinate, slope, second derivative in ulp')
        print '(a, 3f8.3)', '#', worst
    end subroutine check_accuracy

    !> The errors of the ordinate, slope and second derivative of `chain` at x, in ulp.
    function errors_at(ends, shoulder, x) result(errors)
        type(end_type), intent(in) :: ends(2)
        real(dp), intent(in) :: shoulder(2), x
        real(dp) :: errors(3)
        real(qp) :: ratio, y, c(2), f, fx, fy, fxx, fxy, fyy, first, second
        type(jet_type) :: jet
        logical :: is_up
        integer :: i

        call chain_jet(chain, x, jet, is_up)
        errors = 0.0_dp
        if (is_up) return
        c = real(ends(2)%point, qp) - real(ends(1)%point, qp)
        associate (p => real(shoulder, qp), p1 => ends(1)%point, p3 => ends(2)%point)
            ratio = area(p, p1, c)**2/(area(p, p1, real(ends(1)%tangent, qp))* &
                area(p, p3, real(ends(2)%tangent, qp)))
        end associate
        y = real(jet%value, qp)
        do i = 1, 3
            associate (u => c, v => real(ends(1)%tangent, qp), w => real(ends(2)%tangent, qp), &
                p => [real(x, qp), y])
                associate (cu => area(p, ends(1)%point, u), cv => area(p, ends(1)%point, v), &
                    cw => area(p, ends(2)%point, w))
                    f = cu**2 - ratio*cv*cw
                    fx = 2*cu*u(2) - ratio*(v(2)*cw + cv*w(2))
                    fy = -2*cu*u(1) + ratio*(v(1)*cw + cv*w(1))
                    fxx = 2*u(2)**2 - 2*ratio*v(2)*w(2)
                    fxy = -2*u(1)*u(2) + ratio*(v(2)*w(1) + v(1)*w(2))
                    fyy = 2*u(1)**2 - 2*ratio*v(1)*w(1)
                end associate
            end associate
            if (i == 1) errors(1) = real(abs(f)/sqrt(fx**2 + fy**2), dp)/ &
                spacing(max(maxval(abs(ends(1)%point)), maxval(abs(ends(2)%point)), abs(jet%value)))
            y = y - f/fy
        end do
        first = -fx/fy
        second = -(fxx + first*(2*fxy + first*fyy))/fy
        errors(2) = real(abs(real(jet%first, qp) - first)/abs(first), dp)/epsilon(x)
        errors(3) = real(abs(real(jet%second, qp) - second)/abs(second), dp)/epsilon(x)
    end function errors_at

    !> The product of the way from a point to p with a vector.
    pure real(qp) function area(p, from, v)
        real(qp), intent(in) :: p(2), v(2)
        real(dp), intent(in) :: from(2)
        area = (p(1) - real(from(1), qp))*v(2) - (p(2) - real(from(2), qp))*v(1)
    end function area

    !> True where an error of a cause is met.
    logical function refused(why)
        integer, intent(in) :: why
        refused = .false.
        if (allocated(error)) refused = error%cause == why
    end function refused

    !> True where two chains have the same values and jets.
    logical function same(first, second)
        type(chain_type), intent(in) :: first, second
        type(jet_type) :: one, two
        logical :: up_one, up_two
        integer :: i
        same = .true.
        do i = 0, 100
            call chain_jet(first, 0.05_dp*real(i, dp), one, up_one)
            call chain_jet(second, 0.05_dp*real(i, dp), two, up_two)
            same = same .and. one%value == two%value .and. one%first == two%first .and. &
                one%second == two%second .and. (up_one .eqv. up_two)
        end do
    end function same

    !> The arc of a card that has one.
    type(arc_type) function made(p1, t1, p2, p3, t3) result(arc)
        real(dp), intent(in) :: p1(2), t1(2), p2(2), p3(2), t3(2)
        type(error_type), allocatable :: fault
        call arc_through(end_type(p1, t1), p2, end_type(p3, t3), arc, fault)
        if (allocated(fault)) call tap%ok(.false., fault%message)
    end function made

end program test_chain
