!> Tables of an arc at stepped ordinates: which rows, in which order, and their figures.
program test_contour
    use base_constants, only: largest_table
    use base_decimal, only: decimal_type, grid_type, new_grid
    use base_error, only: cause, error_type
    use base_kinds, only: dp, i64
    use geom_arc, only: arc_through, arc_type, end_type, line_between
    use geom_contour, only: contour_of, contour_point_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(arc_type) :: arc
    type(contour_point_type), allocatable :: rows(:)
    type(error_type), allocatable :: error
    real(dp), parameter :: up(2) = [0.0_dp, 1.0_dp], flat(2) = [1.0_dp, 0.0_dp]
    real(dp), parameter :: h = sqrt(0.75_dp)

    ! The first line of the nose; its printed ordinates, SAE 700202 table 2, at three decimals.
    arc = card([-30.0_dp, -10.0_dp], [1.0_dp, 0.114_dp], [0.0_dp, -7.1_dp], [50.0_dp, -4.0_dp], &
        [1.0_dp, 0.0523_dp])
    call step(1, -300_i64, 100_i64)
    call expect_x([-30.0_dp, -20.0_dp, -10.0_dp, 0.0_dp, 10.0_dp, 20.0_dp, 30.0_dp, 40.0_dp, &
        50.0_dp], &
        'the nose has both ends and every step, once')
    call tap%near(rows(4)%y, -7.1_dp, 1.0e-15_dp, 'it passes the shoulder point')
    call tap%ok(rows(1)%slope%value == 0.114_dp .and. rows(9)%slope%value == 0.0523_dp, &
        'its end slopes are as given')
    call tap%ok(all(rows%curvature < 0.0_dp), 'it turns right all the way')
    call step(1, -300_i64, 300_i64)
    call expect_x([-30.0_dp, 0.0_dp, 30.0_dp, 50.0_dp], &
        'a step that misses point 3 still ends there')
    call step(1, -300_i64, 9000_i64)
    call expect_x([-30.0_dp, 50.0_dp], 'an increment beyond point 3 leaves the ends')
    call step(1, -1000_i64, 200_i64)
    call expect_x([-30.0_dp, -20.0_dp, 0.0_dp, 20.0_dp, 40.0_dp, 50.0_dp], &
        'steps may start elsewhere')
    call step(1, -300_i64, -200_i64)
    call expect_x([-30.0_dp, -10.0_dp, 10.0_dp, 30.0_dp, 50.0_dp], 'and go either way')
    arc = card([50.0_dp, -4.0_dp], [1.0_dp, 0.0523_dp], [0.0_dp, -7.1_dp], [-30.0_dp, &
        -10.0_dp], [1.0_dp, 0.114_dp])
    call step(1, 500_i64, -200_i64)
    call expect_x([50.0_dp, 30.0_dp, 10.0_dp, -10.0_dp, -30.0_dp], &
        'decreasing X decreases in the table')
    call tap%ok(all(rows%curvature > 0.0_dp), 'and the arc turns left that way')

    ! Three quarters of the unit circle from (1, 0) over (0, 1) and (-1, 0) to (0, -1).
    arc = card([1.0_dp, 0.0_dp], up, [-1.0_dp, 0.0_dp], [0.0_dp, -1.0_dp], flat)
    call step(1, 10_i64, -5_i64)
    call expect_x([1.0_dp, 0.5_dp, 0.0_dp, -0.5_dp, -1.0_dp, -0.5_dp, 0.0_dp], &
        'beyond X3 the steps go on to the extreme, which is one row, and back')
    call tap%near(maxval(abs(rows%y - [0.0_dp, h, 1.0_dp, h, 0.0_dp, -h, -1.0_dp])), 0.0_dp, &
        1.0e-15_dp, &
        'with the ordinates of the circle')
    call tap%ok(rows(1)%slope%is_vertical .and. rows(5)%slope%is_vertical, &
        'vertical at the start and the extreme')
    call tap%ok(count(rows%slope%is_vertical) == 2, 'and nowhere else')
    call step(2, 0_i64, 5_i64)
    call tap%near(maxval(abs(rows%y - [0.0_dp, 0.5_dp, 1.0_dp, 0.5_dp, 0.0_dp, -0.5_dp, &
        -1.0_dp])), 0.0_dp, &
        0.0_dp, 'stepped in Y it passes 0 again, which is a row of its own')
    call tap%near(maxval(abs(rows%x - [1.0_dp, h, 0.0_dp, -h, -1.0_dp, -h, 0.0_dp])), 0.0_dp, &
        1.0e-15_dp, &
        'with the abscissae of the circle')
    call tap%ok(rows(3)%slope%value == 0.0_dp, 'and it is level on top')
    call step(1, 10_i64, -7_i64)
    call expect_x([1.0_dp, 0.3_dp, -0.4_dp, -0.4_dp, 0.0_dp], 'an extreme between steps is no row')

    ! A decimal extreme: the circle of radius .3 about (.4, 0) reaches x = .7 and .1.
    arc = card([0.4_dp, -0.3_dp], flat, [0.7_dp, 0.0_dp], [0.4_dp, 0.3_dp], flat)
    call step(1, 4_i64, 1_i64)
    call expect_x([0.4_dp, 0.5_dp, 0.6_dp, 0.7_dp, 0.6_dp, 0.5_dp, 0.4_dp], &
        'a vertical chord bulging to the right; decimals touch the extreme once')
    arc = card([5000.4_dp, -0.3_dp], flat, [5000.1_dp, 0.0_dp], [5000.4_dp, 0.3_dp], flat)
    call step(1, 50004_i64, 1_i64)
    call expect_x([5000.4_dp, 5000.3_dp, 5000.2_dp, 5000.1_dp, 5000.2_dp, 5000.3_dp, 5000.4_dp], &
        'and to the left, far from the datum')
    ! An ellipse leaving nearly vertically passes X1 once more just after the start.
    arc = card([1.0_dp, 0.0_dp], [0.28_dp, 0.96_dp], [0.0_dp, 1.2_dp], [-1.0_dp, 0.0_dp], &
        [0.28_dp, -0.96_dp])
    call step(1, 10_i64, -10_i64)
    call expect_x([1.0_dp, 1.0_dp, 0.0_dp, -1.0_dp, -1.0_dp], &
        'an arc that passes X1 again has that row too')
    call tap%ok(rows(2)%y > 0.1_dp .and. rows(4)%y > 0.1_dp, 'above the ends')

    arc = line_between([0.0_dp, 0.0_dp], [0.2_dp, 0.6_dp])
    call step(2, 0_i64, 1_i64)
    call tap%near(maxval(abs(rows%y - [0.0_dp, 0.1_dp, 0.2_dp, 0.3_dp, 0.4_dp, 0.5_dp, &
        0.6_dp])), 0.0_dp, 0.0_dp, 'a line is stepped like any arc')
    call tap%near(maxval(abs(rows%x - rows%y/3.0_dp)), 0.0_dp, 1.0e-16_dp, &
        'and has points of the line')
    arc = line_between([0.3_dp, 0.0_dp], [0.3_dp, 0.6_dp])
    call step(1, 3_i64, 1_i64)
    call expect_x([0.3_dp, 0.3_dp], 'a line across the axis has its two ends')
    call tap%ok(all(rows%slope%is_vertical), 'which are vertical')

    arc = line_between([-4.0e-57_dp, 0.0_dp], [3.0e-57_dp, 1.0e-57_dp])
    call step(1, -40_i64, 3_i64)
    call expect_x([-4.0e-57_dp, 3.0e-57_dp], 'an arc too small for the steps has its ends')

    arc = line_between([0.0_dp, 0.0_dp], [9999.8_dp, 1.0_dp])
    call step(1, 0_i64, 1_i64)
    call tap%ok(.not. allocated(error) .and. size(rows) == largest_table - 1, &
        'a table may have 100000 rows')
    arc = line_between([0.0_dp, 0.0_dp], [10000.0_dp, 1.0_dp])
    call step(1, 0_i64, 1_i64)
    call expect_error(cause%too_many, '100001 rows', 'one more is refused')
    arc = line_between([0.0_dp, 0.0_dp], [1.0e9_dp, 1.0_dp])
    call step(1, 0_i64, 1_i64)
    call expect_error(cause%too_many, 'at most 100000', 'and so are many more')
    arc = line_between([0.0_dp, 0.0_dp], [1.0e250_dp, 1.0_dp])
    call step(1, 0_i64, 1_i64)
    call expect_error(cause%too_many, 'more rows than can be counted', 'or uncountably many')
    arc = line_between([-30.0_dp, 0.0_dp], [50.0_dp, 1.0_dp])
    call step(1, -300_i64, 1_i64, -8)
    call expect_error(cause%too_many, 'an increment of 1.E-08 over 80. makes 8000000001 rows', &
        'a step small beside the first ordinate is told and counted as it is')
    arc = line_between([1.0e9_dp, 0.0_dp], [1.0e9_dp + 10.0_dp, 1.0_dp])
    call step(1, 0_i64, 1_i64)
    call expect_error(cause%increment, 'start the steps nearer', &
        'steps that start too far away are refused')
    call tap%finish()

contains

    !> The arc of a card that has one.
    type(arc_type) function card(p1, t1, p2, p3, t3) result(arc)
        real(dp), intent(in) :: p1(2), t1(2), p2(2), p3(2), t3(2)
        type(error_type), allocatable :: error
        call arc_through(end_type(p1, t1), p2, end_type(p3, t3), arc, error)
        if (allocated(error)) call tap%ok(.false., error%message)
    end function card

    !> The rows of the current arc, start in tenths, step too unless its power of ten is given.
    subroutine step(axis, start, increment, power)
        integer, intent(in) :: axis
        integer(i64), intent(in) :: start, increment
        integer, intent(in), optional :: power
        type(grid_type) :: grid
        integer :: of_step
        of_step = -1
        if (present(power)) of_step = power
        call new_grid(decimal_type(start, -1), decimal_type(increment, of_step), grid, error)
        call contour_of(arc, axis, grid, rows, error)
    end subroutine step

    !> Checks the x of all rows, exactly.
    subroutine expect_x(x, name)
        real(dp), intent(in) :: x(:)
        character(*), intent(in) :: name
        character(300) :: text
        logical :: same
        same = .false.
        if (.not. allocated(error)) same = size(rows) == size(x)
        if (same) same = all(rows%x == x)
        call tap%ok(same, name)
        if (same) return
        write (text, '(*(g0,1x))') rows%x
        call tap%note(trim(text))
    end subroutine expect_x

    !> Checks that the table was refused.
    subroutine expect_error(why, words, name)
        integer, intent(in) :: why
        character(*), intent(in) :: words, name
        logical :: right
        right = .false.
        if (allocated(error)) right = error%cause == why .and. index(error%message, words) > 0
        call tap%ok(right, name)
        if (allocated(error) .and. .not. right) call tap%note(error%message)
    end subroutine expect_error

end program test_contour
