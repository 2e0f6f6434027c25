!> Robust least squares.
program test_squares
    use audit_problem, only: new_problem, problem_type
    use audit_reading, only: line_type
    use audit_search, only: score_of
    use audit_squares, only: chart_at, improve
    use base_kinds, only: dp
    use support_audited_lines, only: parabola_line, spoil, whole
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type) :: line
    type(problem_type) :: problem
    real(dp) :: k(6), chart(6, 6), x0, y0, sx, sy
    logical :: chosen(20)

    line = parabola_line()
    call spoil(line, 6, '6.280')
    call spoil(line, 12, '36.250')
    problem = new_problem(line, line%scale, 1, whole(line))
    x0 = problem%frame%origin(1)
    y0 = problem%frame%origin(2)
    sx = problem%frame%size(1)
    sy = problem%frame%size(2)
    ! x**2/100 - y = 0 with x = x0 + sx X, y = y0 + sy Y, and a little off.
    k = [0.01_dp*sx*sx, 1.0e-4_dp, 0.0_dp, 0.02_dp*x0*sx, -sy, 0.01_dp*x0*x0 - y0 + 0.01_dp]
    k = k/norm2(k)
    chart = chart_at(problem, k)
    call tap%near(maxval(abs(matmul(k, chart(:, :5)))), 0.0_dp, 1.0e-15_dp, &
        'a conic changes at right angles to itself')
    chosen = .true.
    call improve(problem, chosen, [100.0_dp, 30.0_dp, 10.0_dp, 4.0_dp, 4.0_dp, 4.0_dp], k)
    chosen([6, 12]) = .false.
    call tap%ok(score_of(problem, chosen, k, 1.0_dp) < 1.0e-3_dp, &
        'two bad figures do not pull the parabola of the others')
    chosen(5:) = .false.
    x0 = k(1)
    call improve(problem, chosen, [4.0_dp], k)
    call tap%near(k(1), x0, 0.0_dp, 'fewer figures than fix a conic leave it as it is')
    call tap%finish()
end program test_squares
