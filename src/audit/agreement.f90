!> The figures that one conic can meet all at once, each within the bounds its printing allows.
!>
!> How deep a conic lies inside of the bounds, in units of the last place, is a linear programme
!> once the conic is nearly known; where its greatest value is below zero the figures contradict
!> one another, and the bounds that stop the climb are of those that do. The one is left out without
!> which the others come furthest; then those left out are tried again.
!>
!> Source: J. W. Chinneck, "Feasibility and Infeasibility in Optimization", Springer 2008, ch. 7
!> (the most figures that agree, by leaving out what relieves most).
module audit_agreement
    use audit_climb, only: climb, most_unknowns
    use audit_condition, only: bound_rows, residual
    use audit_problem, only: problem_type
    use audit_squares, only: chart_at
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: agree, deepen, conflicts

    !> Figures further off than this, in units of the last place, are left out at once; those nearer
    !> than the second bound are tried again.
    real(dp), parameter :: far = 4.0_dp, near = 40.0_dp
    !> Figures no further out of their bounds than this are exchanged for others.
    real(dp), parameter :: exchangeable = 12.0_dp
    !> How far the conic may change in one programme, in coefficients of length 1.
    real(dp), parameter :: widest_step = 0.25_dp
    !> Programmes, each from where the last one ended; and what change of depth ends them.
    integer, parameter :: most_programmes = 4
    real(dp), parameter :: still = 1.0e-3_dp

contains

    !> From a conic near most figures to one that meets as many as any near it.
    pure subroutine agree(problem, chosen, k, member, depth)
        type(problem_type), intent(in) :: problem !! the readings
        logical, intent(in) :: chosen(:)          !! figures that count, one a condition
        real(dp), intent(inout) :: k(6)           !! the conic, then the deepest inside the bounds
        logical, intent(out) :: member(:)         !! figures that it meets
        real(dp), intent(out) :: depth            !! of the conic inside the bounds, in units
        real(dp) :: off(size(chosen)), excess(size(chosen))

        call measure(problem, k, off, excess)
        member = chosen .and. abs(off) <= far
        call leave_out(problem, k, member, depth)
        call take_in(problem, chosen, k, member, depth)
        call exchange(problem, chosen, k, member, depth)
    end subroutine agree

    !> Exchanges a figure left out for one that contradicts it, where that lets more in.
    pure subroutine exchange(problem, chosen, k, member, depth)
        type(problem_type), intent(in) :: problem !! the readings
        logical, intent(in) :: chosen(:)          !! figures that count
        real(dp), intent(inout) :: k(6)           !! the conic
        logical, intent(inout) :: member(:)       !! figures that agree
        real(dp), intent(inout) :: depth          !! of the conic, in units
        logical :: others(size(member))
        real(dp) :: off(size(member)), excess(size(member)), tried(6), deep
        integer :: against(most_unknowns), i, j

        call measure(problem, k, off, excess)
        do i = 1, size(member)
            if (.not. chosen(i) .or. member(i) .or. excess(i) > exchangeable) cycle
            call conflicts(problem, member, i, k, against)
            do j = 1, count(against > 0)
                if (against(j) == i) cycle
                others = member
                others(i) = .true.
                others(against(j)) = .false.
                tried = k
                call take_in(problem, chosen .and. .not. others, tried, others, deep)
                if (count(others) <= count(member)) cycle
                member = others
                k = tried
                depth = deep
                exit
            end do
        end do
    end subroutine exchange

    !> How far all figures are from a conic; a figure it does not reach is very far.
    pure subroutine measure(problem, k, off, excess)
        type(problem_type), intent(in) :: problem !! the readings
        real(dp), intent(in) :: k(6)              !! the conic
        real(dp), intent(out) :: off(:)           !! from the centre, in units
        real(dp), intent(out) :: excess(:)        !! outside of the bounds, in units
        logical :: exists
        integer :: i
        do i = 1, size(off)
            call residual(problem%condition(i), k, problem%frame, off(i), excess(i), exists)
            if (exists) cycle
            off(i) = huge(off)
            excess(i) = huge(off)
        end do
    end subroutine measure

    !> Leaves out figures until the others agree.
    pure subroutine leave_out(problem, k, member, depth)
        type(problem_type), intent(in) :: problem !! the readings
        real(dp), intent(inout) :: k(6)           !! the conic
        logical, intent(inout) :: member(:)       !! figures that are to agree, then do
        real(dp), intent(out) :: depth            !! of the conic, in units
        logical :: without(size(member))
        real(dp) :: tried(6), best(6), deep
        integer :: against(most_unknowns), other(most_unknowns), i, worst

        do
            call deepen(problem, member, k, depth, against)
            if (depth >= 0.0_dp) return
            worst = 0
            depth = -huge(depth)
            do i = 1, count(against > 0)
                without = member
                without(against(i)) = .false.
                tried = k
                call deepen(problem, without, tried, deep, other)
                if (deep <= depth) cycle
                depth = deep
                worst = against(i)
                best = tried
            end do
            if (worst == 0) return
            member(worst) = .false.
            k = best
            if (depth >= 0.0_dp) return
        end do
    end subroutine leave_out

    !> Takes in figures that agree with the others, the nearest first.
    pure subroutine take_in(problem, chosen, k, member, depth)
        type(problem_type), intent(in) :: problem !! the readings
        logical, intent(in) :: chosen(:)          !! figures that count
        real(dp), intent(inout) :: k(6)           !! the conic
        logical, intent(inout) :: member(:)       !! figures that agree
        real(dp), intent(out) :: depth            !! of the conic, in units
        logical :: untried(size(member)), with(size(member))
        real(dp) :: off(size(member)), excess(size(member)), tried(6), deep
        integer :: against(most_unknowns), next

        call deepen(problem, member, k, depth, against)
        if (depth < 0.0_dp) return
        call measure(problem, k, off, excess)
        untried = chosen .and. .not. member .and. excess < near
        do while (any(untried))
            next = minloc(excess, dim=1, mask=untried)
            untried(next) = .false.
            with = member
            with(next) = .true.
            tried = k
            call deepen(problem, with, tried, deep, against)
            if (deep < 0.0_dp) cycle
            member = with
            k = tried
            depth = deep
        end do
    end subroutine take_in

    !> Figures that contradict a further one: without any one of them it may agree with the rest.
    pure subroutine conflicts(problem, member, further, k, against)
        type(problem_type), intent(in) :: problem !! the readings
        logical, intent(in) :: member(:)          !! figures that agree
        integer, intent(in) :: further            !! one that does not
        real(dp), intent(in) :: k(6)              !! the conic
        integer, intent(out) :: against(:)        !! see above, zeros behind
        logical :: with(size(member))
        real(dp) :: tried(6), depth

        with = member
        with(further) = .true.
        tried = k
        call deepen(problem, with, tried, depth, against)
        if (depth >= 0.0_dp) against = 0
    end subroutine conflicts

    !> The conic deepest inside the bounds of some figures, from one near them. `against` lists the
    !> figures whose bounds stop it, zeros behind them.
    pure subroutine deepen(problem, member, k, depth, against)
        type(problem_type), intent(in) :: problem !! the readings
        logical, intent(in) :: member(:)          !! figures that count
        real(dp), intent(inout) :: k(6)           !! the conic
        real(dp), intent(out) :: depth            !! in units, negative: they contradict one another
        integer, intent(out) :: against(:)        !! see above, shape (`most_unknowns`)
        real(dp) :: before
        integer :: programme
        logical :: is_there

        depth = -huge(depth)
        do programme = 1, most_programmes
            before = depth
            call deepen_once(problem, member, k, depth, against, is_there)
            if (is_there .and. abs(depth - before) <= still) return
            if (problem%freedom == 0) return
        end do
    end subroutine deepen

    !> One programme of `deepen`, with bounds as they are near the conic given.
    pure subroutine deepen_once(problem, member, k, depth, against, is_there)
        type(problem_type), intent(in) :: problem !! the readings
        logical, intent(in) :: member(:)          !! figures that count
        real(dp), intent(inout) :: k(6)           !! the conic
        real(dp), intent(out) :: depth            !! in units
        integer, intent(out) :: against(:)        !! figures whose bounds stop it
        logical, intent(out) :: is_there          !! the widest step was not needed
        real(dp) :: a(problem%freedom + 1, 2*(size(member) + problem%freedom))
        real(dp) :: b(2*(size(member) + problem%freedom)), x(problem%freedom + 1)
        real(dp) :: up(problem%freedom + 1), chart(6, 6), rows(6, 2)
        integer :: of(2*(size(member) + problem%freedom)), stops(most_unknowns), d, i, n, side

        d = problem%freedom
        chart = chart_at(problem, k)
        n = 0
        do i = 1, size(member)
            if (.not. member(i)) cycle
            call bound_rows(problem%condition(i), k, problem%frame, rows)
            do side = 1, 2
                n = n + 1
                a(:d, n) = matmul(rows(:, side), chart(:, :d))
                a(d + 1, n) = -1.0_dp
                b(n) = -dot_product(rows(:, side), k)
                of(n) = i
            end do
        end do
        x = 0.0_dp
        x(d + 1) = 0.0_dp
        if (n > 0) x(d + 1) = -maxval(b(:n))
        do i = 1, d
            a(:, n + 1:n + 2) = 0.0_dp
            a(i, n + 1:n + 2) = [1.0_dp, -1.0_dp]
            b(n + 1:n + 2) = -widest_step
            of(n + 1:n + 2) = 0
            n = n + 2
        end do
        up = 0.0_dp
        up(d + 1) = 1.0_dp
        against = 0
        if (n > 2*d) call climb(up, a(:, :n), b(:n), x, stops)
        if (n == 2*d) stops = 0
        depth = x(d + 1)
        k = k + matmul(chart(:, :d), x(:d))
        k = k/norm2(k)
        is_there = .true.
        side = 0
        do i = 1, count(stops > 0)
            if (of(stops(i)) == 0) then
                is_there = .false.
            else if (.not. any(against == of(stops(i)))) then
                side = side + 1
                against(side) = of(stops(i))
            end if
        end do
    end subroutine deepen_once

end module audit_agreement
