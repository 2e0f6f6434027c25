!> Conics as six coefficients in a frame: a circle and a hyperbola worked by hand.
program test_curve
    use audit_curve, only: frame_type, general_equation, gradient, monomials, quantity_at, &
        quantity_type, roots_of, side_of
    use audit_reading, only: sort
    use base_kinds, only: dp
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(frame_type), parameter :: plain = frame_type()
    type(frame_type), parameter :: moved = frame_type([1.0_dp, 2.0_dp], [2.0_dp, 4.0_dp])
    ! x**2 + y**2 = 25 in either frame: x = 1 + 2 X, y = 2 + 4 Y.
    real(dp), parameter :: circle(6) = [1.0_dp, 0.0_dp, 1.0_dp, 0.0_dp, 0.0_dp, -25.0_dp]
    real(dp), parameter :: same(6) = [4.0_dp, 0.0_dp, 16.0_dp, 4.0_dp, 16.0_dp, -20.0_dp]
    real(dp), parameter :: straight(6) = [0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, -2.0_dp, 3.0_dp]
    real(dp) :: roots(2), value, whole(6), step
    integer :: found
    logical :: exists

    call roots_of(circle, plain, 3.0_dp, 2, roots, found)
    call tap%ok(found == 2 .and. all(abs(roots - [-4.0_dp, 4.0_dp]) < 1.0e-14_dp), &
        'a circle of radius 5 has ordinates -4 and 4 at 3')
    call roots_of(same, moved, -4.0_dp, 1, roots, found)
    call tap%ok(found == 2 .and. all(abs(roots - [-3.0_dp, 3.0_dp]) < 1.0e-14_dp), &
        'and abscissae -3 and 3 at -4, in another frame')
    call roots_of(circle, plain, 6.0_dp, 2, roots, found)
    call tap%ok(found == 0, 'none at 6')
    call roots_of(circle, plain, 5.0_dp, 2, roots, found)
    call tap%ok(found == 2 .and. all(abs(roots) < 1.0e-7_dp), 'one twice at 5')
    call roots_of(straight, plain, 1.0_dp, 2, roots, found)
    call tap%ok(found == 1 .and. abs(roots(1) - 2.0_dp) < 1.0e-15_dp, 'a straight line has one')

    call quantity_at(same, moved, quantity_type(sort%ordinate, along=3.0_dp, near=3.9_dp), value, &
        exists)
    call tap%near(value, 4.0_dp, 1.0e-14_dp, 'the root nearest to what is printed is meant')
    call quantity_at(same, moved, quantity_type(sort%ordinate, along=3.0_dp, near=3.9_dp, &
        side=-1), value, exists)
    call tap%near(value, -4.0_dp, 1.0e-14_dp, 'or the one on the side that is known')
    call quantity_at(same, moved, quantity_type(sort%slope, along=3.0_dp, near=4.0_dp), value, &
        exists)
    call tap%near(value, -0.75_dp, 1.0e-14_dp, 'its slope at (3, 4) is -3/4')
    call quantity_at(circle, plain, quantity_type(sort%slope, along=5.0_dp), value, exists)
    call tap%ok(exists .and. abs(value) > 999.9_dp, 'a vertical slope is the largest there is')
    call quantity_at(same, moved, quantity_type(sort%ordinate, along=9.0_dp), value, exists)
    call tap%ok(.not. exists, 'where a conic does not reach it has no ordinate')
    call quantity_at(same, moved, quantity_type(sort%coefficient, letter=1), value, exists)
    call tap%near(value, -0.04_dp, 1.0e-15_dp, 'A of A xx + B xy + C yy + D x + E y = -1')
    ! About (-10, -10): (u - 10)**2 + (v - 10)**2 = 25, the constant term is 175.
    call quantity_at(same, moved, quantity_type(sort%coefficient, letter=4, shift=10.0_dp), &
        value, exists)
    call tap%near(value, -20.0_dp/175.0_dp, 1.0e-15_dp, 'D after 10 was added to x and y')
    whole = general_equation(same, moved, 0.0_dp)
    call tap%ok(all(abs(whole - circle) < 1.0e-13_dp), 'both frames have one equation')

    step = 1.0e-5_dp
    call tap%ok(all(abs((monomials(moved, 3.0_dp + step, 1.0_dp) - monomials(moved, 3.0_dp - step, &
        1.0_dp))/(2.0_dp*step) - gradient(moved, 3.0_dp, 1.0_dp, 1)) < 1.0e-9_dp) .and. &
        all(abs((monomials(moved, 3.0_dp, 1.0_dp + step) - monomials(moved, 3.0_dp, 1.0_dp - &
        step))/(2.0_dp*step) - gradient(moved, 3.0_dp, 1.0_dp, 2)) < 1.0e-9_dp), &
        'the gradient is the limit of differences')
    call tap%ok(side_of(circle, plain, quantity_type(sort%ordinate, along=3.0_dp, near=4.0_dp)) == &
        1 .and. side_of(circle, plain, quantity_type(sort%abscissa, along=3.0_dp, near=-4.0_dp)) &
        == -1, 'a circle has two sides')
    call tap%ok(side_of(straight, plain, quantity_type(sort%ordinate, along=3.0_dp)) == 0, &
        'a straight line has none')
    call tap%finish()
end program test_curve
