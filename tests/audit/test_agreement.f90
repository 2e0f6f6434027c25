!> Figures that one conic can meet all at once.
program test_agreement
    use audit_agreement, only: agree, conflicts, deepen
    use audit_climb, only: most_unknowns
    use audit_condition, only: residual
    use audit_problem, only: new_problem, problem_type
    use audit_reading, only: line_type
    use audit_search, only: find_conic
    use base_kinds, only: dp
    use support_audited_lines, only: circle_line, spoil, whole
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type) :: line
    type(problem_type) :: problem
    real(dp) :: k(6), depth, off, excess
    logical, allocatable :: member(:)
    logical :: found, exists, holds
    integer :: against(most_unknowns), i

    line = circle_line()
    problem = new_problem(line, line%scale, 1, whole(line))
    allocate (member(size(problem%condition)))
    call find_conic(problem, whole(line), k, found)
    call agree(problem, whole(line), k, member, depth)
    call tap%ok(all(member), 'the rounded figures of a circle all agree')
    call tap%ok(depth > 0.0_dp .and. depth < 0.5_dp, 'their conic is inside of all bounds')
    holds = .true.
    do i = 1, size(member)
        call residual(problem%condition(i), k, problem%frame, off, excess, exists)
        holds = holds .and. exists .and. excess < 1.0e-6_dp
    end do
    call tap%ok(holds, 'as its ordinates prove')

    call spoil(line, 20, '100.001')
    call spoil(line, 7, '76.038')
    problem = new_problem(line, line%scale, 1, whole(line))
    call find_conic(problem, whole(line), k, found)
    call agree(problem, whole(line), k, member, depth)
    call tap%ok(count(member) == size(member) - 2 .and. .not. member(20) .and. .not. member(7), &
        'one unit too many at the top of a circle of 41 figures is left out, and only that')
    call conflicts(problem, member, 20, k, against)
    call tap%ok(any(against == 20), 'it contradicts others')
    member(20) = .true.
    call deepen(problem, member, k, depth, against)
    call tap%ok(depth < 0.0_dp, 'with it there is no conic')
    call tap%finish()
end program test_agreement
