!> Conics that many figures agree on.
program test_search
    use audit_problem, only: hold, new_problem, problem_type
    use audit_reading, only: add, line_type, meaning, new_reading, sort
    use audit_search, only: draw, find_conic, score_of
    use base_kinds, only: dp, i64
    use support_audited_lines, only: circle_line, parabola_line, spoil, whole
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type) :: line
    type(problem_type) :: problem
    real(dp) :: k(6)
    integer(i64) :: state
    logical, allocatable :: chosen(:)
    logical :: found
    integer :: i

    line = circle_line()
    chosen = whole(line)
    do i = 2, 36, 2
        call spoil(line, i, line%reading(modulo(7*i, 39) + 1)%figure%text)
        if (i > 32) cycle
        chosen(i) = .false.
    end do
    problem = new_problem(line, line%scale, 1, whole(line))
    call find_conic(problem, whole(line), k, found)
    call tap%ok(found, 'a conic is found where 4 figures of 10 are bad')
    call tap%ok(score_of(problem, chosen, k, 1.0_dp) < 4.0_dp, 'which the good ones are on')

    line = parabola_line()
    call add(line, new_reading(sort%ordinate, 0.0_dp, '0', meaning%exact))
    call add(line, new_reading(sort%slope, 0.0_dp, '0', meaning%exact))
    problem = new_problem(line, line%scale, 1, whole(line))
    call hold(problem, problem%is_exact)
    state = 1
    call draw(problem, [3, 6, 9, 12, 15, 18], .true., state, k)
    call tap%ok(score_of(problem, problem%condition%reading <= 20, k, 1.0_dp) < 0.5_dp, &
        'a conic drawn through a few figures passes by the others')
    call find_conic(problem, problem%condition%reading < 3, k, found)
    call tap%ok(.not. found, 'two figures are too few for three degrees of freedom')
    call tap%finish()
end program test_search
