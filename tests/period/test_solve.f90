!> The five conditions solved for conics whose equation is known.
program test_solve
    use base_decimal, only: decimal_type
    use base_error, only: cause
    use base_kinds, only: dp, i64
    use period_convert, only: from_decimal
    use period_solve, only: array_of, conditions_type, solve_array
    use period_word, only: hex_type, to_real, whole
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_array()
    call check_circle()
    call check_ellipse()
    call check_hyperbola()
    call check_singular()
    call check_trap()
    call tap%finish()

contains

    !> Whole coordinates as conditions, the slopes in hundredths.
    type(conditions_type) function conditions(points, slopes) result(given)
        integer, intent(in) :: points(6), slopes(2)
        given%x1 = whole(points(1))
        given%y1 = whole(points(2))
        given%x2 = whole(points(3))
        given%y2 = whole(points(4))
        given%x3 = whole(points(5))
        given%y3 = whole(points(6))
        given%s1 = from_decimal(decimal_type(int(slopes(1), i64), -2))
        given%s3 = from_decimal(decimal_type(int(slopes(2), i64), -2))
    end function conditions

    !> Solves, and compares A to E.
    subroutine check_known(points, slopes, expected, name)
        integer, intent(in) :: points(6), slopes(2)
        real(dp), intent(in) :: expected(5)
        character(*), intent(in) :: name
        type(hex_type) :: w(5, 6)
        logical :: solved
        integer :: i

        w = array_of(conditions(points, slopes))
        call solve_array(w, solved)
        call tap%ok(solved .and. all(w%trap == 0), name//' is solved')
        do i = 1, 5
            call tap%near(to_real(w(i, 6)), expected(i), 1.0e-11_dp, &
                name//', coefficient '//'ABCDE'(i:i))
        end do
    end subroutine check_known

    !> The array for (2, 3), (4, 5), (6, 7) with slopes 10 and .5.
    subroutine check_array()
        type(hex_type) :: w(5, 6)
        real(dp) :: expected(5, 6)
        expected(1, :) = [4.0_dp, 6.0_dp, 9.0_dp, 2.0_dp, 3.0_dp, -1.0_dp]
        expected(2, :) = [16.0_dp, 20.0_dp, 25.0_dp, 4.0_dp, 5.0_dp, -1.0_dp]
        expected(3, :) = [36.0_dp, 42.0_dp, 49.0_dp, 6.0_dp, 7.0_dp, -1.0_dp]
        expected(4, :) = [4.0_dp, 3.0_dp + 20.0_dp, 60.0_dp, 1.0_dp, 10.0_dp, 0.0_dp]
        expected(5, :) = [12.0_dp, 7.0_dp + 3.0_dp, 7.0_dp, 1.0_dp, 0.5_dp, 0.0_dp]
        w = array_of(conditions([2, 3, 4, 5, 6, 7], [1000, 50]))
        call tap%near(maxval(abs(to_real(w) - expected)), 0.0_dp, 0.0_dp, &
            'three point rows and two slope rows stand in the array')
    end subroutine check_array

    !> (x - 10)**2 + (y - 10)**2 = 25, which is x**2 + y**2 - 20 x - 20 y = -175.
    subroutine check_circle()
        call check_known([7, 6, 10, 5, 13, 6], [-75, 75], &
            [1.0_dp, 0.0_dp, 1.0_dp, -20.0_dp, -20.0_dp]/175.0_dp, 'a circle')
        call check_known([10, 15, 15, 10, 10, 5], [0, 0], &
            [1.0_dp, 0.0_dp, 1.0_dp, -20.0_dp, -20.0_dp]/175.0_dp, 'its right half')
    end subroutine check_circle

    !> x**2 + x y + y**2 = 7 with slope -(2 x + y)/(x + 2 y): a slanting ellipse.
    subroutine check_ellipse()
        call check_known([1, 2, -1, 3, -3, 1], [-80, -500], &
            [-1.0_dp, -1.0_dp, -1.0_dp, 0.0_dp, 0.0_dp]/7.0_dp, 'an ellipse')
    end subroutine check_ellipse

    !> x y = 12 with slope -y/x.
    subroutine check_hyperbola()
        call check_known([2, 6, 3, 4, 4, 3], [-300, -75], &
            [0.0_dp, -1.0_dp, 0.0_dp, 0.0_dp, 0.0_dp]/12.0_dp, 'a hyperbola')
    end subroutine check_hyperbola

    !> No conic with -1 on its right side passes through the origin.
    subroutine check_singular()
        type(hex_type) :: w(5, 6)
        logical :: solved
        w = array_of(conditions([0, 0, 4, 4, 8, 0], [0, 100]))
        call solve_array(w, solved)
        call tap%ok(.not. solved .and. all(w%trap == 0), 'a point at the origin has no solution')
        w = array_of(conditions([0, 0, 0, 0, 0, 0], [0, 0]))
        call solve_array(w, solved)
        call tap%ok(.not. solved .and. all(w%trap == 0), &
            'a blank card without shift has no solution')
    end subroutine check_singular

    !> A trap in the array ends the solution and stays to be seen.
    subroutine check_trap()
        type(conditions_type) :: given
        type(hex_type) :: w(5, 6)
        logical :: solved
        given = conditions([7, 6, 10, 5, 13, 6], [-75, 75])
        given%x2 = from_decimal(decimal_type(1_i64, 40))
        w = array_of(given)
        call tap%ok(any(w%trap == cause%overflow), 'a square that overflows traps in the array')
        call solve_array(w, solved)
        call tap%ok(.not. solved .and. any(w%trap == cause%overflow), 'and is not solved')
        given%x2 = from_decimal(decimal_type(1_i64, -60))
        w = array_of(given)
        call tap%ok(any(w%trap == cause%underflow), 'a square that underflows traps in the array')
    end subroutine check_trap

end program test_solve
