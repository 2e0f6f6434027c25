!> Between what values a quantity may lie: y = c x**2 with exact ends of a pencil has one degree of
!> freedom, and its intervals are worked by hand.
program test_bounds
    use audit_agreement, only: agree
    use audit_bounds, only: find_bounds
    use audit_curve, only: quantity_type
    use audit_problem, only: hold, new_problem, problem_type
    use audit_reading, only: add, line_type, meaning, new_reading, sort
    use audit_search, only: find_conic
    use base_kinds, only: dp
    use support_audited_lines, only: parabola_line, whole
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type) :: line, rows
    type(problem_type) :: problem
    real(dp) :: k(6), between(2), depth, by_hand
    logical, allocatable :: member(:), counts(:)
    logical :: found, is_limited

    ! Conics with tangent y = 0 at the origin and y = 2 x - 100 at (100, 100), through (50, y):
    ! (y - 2 x + 100) y = t (x - y)**2; the figure 25.000 allows y from 24.9995 to 25.0005 there.
    rows = parabola_line()
    call add(line, rows%reading(11))
    call add(line, new_reading(sort%ordinate, 0.0_dp, '0', meaning%exact))
    call add(line, new_reading(sort%ordinate, 100.0_dp, '100', meaning%exact))
    call add(line, new_reading(sort%slope, 0.0_dp, '0', meaning%exact))
    call add(line, new_reading(sort%slope, 100.0_dp, '2', meaning%exact))
    line%scale = rows%scale
    problem = new_problem(line, line%scale, 1, whole(line))
    call hold(problem, problem%is_exact)
    counts = .not. problem%is_held
    allocate (member(size(counts)))
    call find_conic(problem, counts, k, found)
    call agree(problem, counts, k, member, depth)
    call find_bounds(problem, member, k, quantity_type(sort%ordinate, along=50.0_dp, &
        near=25.0_dp), between, is_limited)
    call tap%ok(is_limited .and. all(abs(between - [24.9995_dp, 25.0005_dp]) < 1.0e-8_dp), &
        'the only figure bounds its own ordinate by its rounding')
    call find_bounds(problem, member, k, quantity_type(sort%ordinate, along=20.0_dp, &
        near=4.0_dp), between, is_limited)
    by_hand = ordinate(20.0_dp, 24.9995_dp)
    call tap%near(between(1), by_hand, 1.0e-8_dp, 'and bounds another ordinate, worked by hand')
    by_hand = ordinate(20.0_dp, 25.0005_dp)
    call tap%near(between(2), by_hand, 1.0e-8_dp, '... at both ends')
    call find_bounds(problem, member, k, quantity_type(sort%slope, along=100.0_dp, &
        near=100.0_dp), between, is_limited)
    call tap%near(between(2) - between(1), 0.0_dp, 1.0e-9_dp, 'an exact slope has no room')
    member = .false.
    call find_bounds(problem, member, k, quantity_type(sort%ordinate, along=50.0_dp, &
        near=25.0_dp), between, is_limited)
    call tap%ok(.not. is_limited, 'no figure bounds nothing')
    call tap%finish()

contains

    !> The ordinate at x of the conic of the pencil through (50, height).
    pure real(dp) function ordinate(x, height) result(y)
        real(dp), intent(in) :: x      !! abscissa
        real(dp), intent(in) :: height !! ordinate at 50
        real(dp) :: t, a, b, c
        t = (height - 2.0_dp*50.0_dp + 100.0_dp)*height/(50.0_dp - height)**2
        a = 1.0_dp - t
        b = 100.0_dp - 2.0_dp*x + 2.0_dp*t*x
        c = -t*x*x
        y = 2.0_dp*c/(-b - sqrt(b*b - 4.0_dp*a*c))
    end function ordinate

end program test_bounds
