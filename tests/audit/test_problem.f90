!> Readings as conditions of one conic.
program test_problem
    use audit_curve, only: monomials
    use audit_problem, only: hold, is_point, new_problem, problem_type
    use audit_reading, only: add, line_type, meaning, new_reading, sort
    use base_kinds, only: dp
    use support_audited_lines, only: parabola_line, spoil, whole
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type) :: line
    type(problem_type) :: problem
    real(dp) :: row(6)

    line = parabola_line()
    call spoil(line, 3, '1.0000')
    call spoil(line, 4, '999999.000')
    call add(line, new_reading(sort%ordinate, 0.0_dp, '0', meaning%exact))
    call add(line, new_reading(sort%ordinate, 100.0_dp, '100', meaning%exact))
    call add(line, new_reading(sort%slope, 0.0_dp, '0', meaning%exact))
    call add(line, new_reading(sort%slope, 100.0_dp, '2', meaning%exact))
    call add(line, new_reading(sort%slope, 50.0_dp, '1', meaning%exact))
    problem = new_problem(line, line%scale, 1, whole(line))
    call tap%ok(size(problem%condition) == 24, 'a reading to other places is left out')
    call tap%ok(problem%condition(3)%reading == 4, 'each condition knows its reading')
    call tap%ok(count(problem%is_exact) == 5 .and. count(is_point(problem%condition)) == 21, &
        'numbers known exactly and points are told apart')
    call tap%ok(maxval(problem%frame%size) < 101.0_dp, 'one wild figure does not set the frame')
    call tap%ok(problem%freedom == 5, 'a conic has five degrees of freedom')
    call hold(problem, problem%is_exact)
    call tap%ok(problem%freedom == 1 .and. count(problem%is_held) == 4, &
        'two ends with their slopes leave one; a slope without its point is not held')
    row = monomials(problem%frame, 100.0_dp, 100.0_dp)
    call tap%near(maxval(abs(matmul(row, problem%free_to(:, :2)))), 0.0_dp, 1.0e-13_dp, &
        'what is left goes through the ends')
    call hold(problem, problem%is_exact .and. problem%condition%reading /= 22)
    call tap%ok(problem%freedom == 3, 'a slope goes with the point that is given up')
    call tap%finish()
end program test_problem
