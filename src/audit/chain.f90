!> Which readings are of which conic of a chain, its joints anywhere.
!>
!> Conics that stretches of the table agree on, short and long ones from all over it, are the
!> candidates; dynamic programming then finds the candidates, one after the other, that meet most
!> figures. The conics of the stretches found so are new candidates, until nothing changes.
!>
!> Source: R. Bellman, R. Roth, "Curve fitting by segmented straight lines", J. Amer. Stat. Assoc.
!> 64 (1969), pp. 1079-1084, for conics instead of straight lines and a bounded cost a figure.
module audit_chain
    use audit_agreement, only: agree
    use audit_condition, only: residual
    use audit_figure, only: scale_type
    use audit_problem, only: is_point, new_problem, problem_type
    use audit_reading, only: line_type, meaning, sort
    use audit_search, only: find_conic
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: split_line

    !> Figures of the shortest stretch, and candidates of a line at the most.
    integer, parameter :: shortest = 8, most_candidates = 160
    !> Conics drawn for a candidate: a stretch across a joint has none, and need not be searched.
    integer, parameter :: most_draws = 60
    !> Rounds of new candidates at the most.
    integer, parameter :: most_rounds = 6
    !> Units of the last place beyond which a figure is not of a conic.
    real(dp), parameter :: bound = 3.0_dp

contains

    !> Deals out the readings of a line to its conics: `chosen(:, i)` are those of the i-th. The
    !> rows of the table stand in order along the line; what else is known goes to the nearest rows.
    !> Rows too few for any conic go to the first; there are too few for the others then.
    pure subroutine split_line(line, scale, chosen)
        type(line_type), intent(in) :: line                !! the line
        type(scale_type), intent(in) :: scale              !! of its table
        logical, allocatable, intent(out) :: chosen(:, :)  !! see above
        type(problem_type) :: problem
        integer, allocatable :: row(:), piece(:), before(:)
        real(dp), allocatable :: cost(:, :)
        integer :: candidates, round, i

        allocate (chosen(size(line%reading), max(line%conics, 1)))
        chosen = .true.
        if (line%conics <= 1) return
        problem = new_problem(line, scale, line%printing, chosen(:, 1))
        row = pack([(i, i = 1, size(problem%condition))], is_point(problem%condition) .and. &
            .not. problem%is_exact)
        allocate (cost(size(row), most_candidates), piece(size(row)), before(size(row)))
        candidates = 0
        if (size(row) >= line%conics) call gather(problem, row, line%conics, cost, candidates)
        if (candidates == 0) then
            chosen(:, 2:) = .false.
            return
        end if
        before = 0
        do round = 1, most_rounds
            call split_rows(cost(:, :candidates), line%conics, piece)
            if (all(piece == before)) exit
            before = piece
            do i = 1, line%conics
                call add_candidate(problem, row, piece == i, cost, candidates)
            end do
        end do
        call deal_out(line, problem%condition(row)%reading, piece, chosen)
    end subroutine split_line

    !> Candidates from stretches of two lengths, each half over the one before.
    pure subroutine gather(problem, row, conics, cost, candidates)
        type(problem_type), intent(in) :: problem  !! the readings
        integer, intent(in) :: row(:)              !! conditions that are rows
        integer, intent(in) :: conics              !! of the chain
        real(dp), intent(inout) :: cost(:, :)      !! of each row by each candidate
        integer, intent(inout) :: candidates       !! how many there are
        logical :: within(size(row))
        integer :: long, first, share

        do share = 1, 2
            long = min(max(size(row)/(share*conics), shortest), size(row))
            first = 1
            do
                within = .false.
                within(first:first + long - 1) = .true.
                call add_candidate(problem, row, within, cost, candidates)
                if (first + long > size(row)) exit
                first = min(first + max(long/3, 1), size(row) - long + 1)
            end do
        end do
    end subroutine gather

    !> The conic that some rows agree on, as one more candidate.
    pure subroutine add_candidate(problem, row, within, cost, candidates)
        type(problem_type), intent(in) :: problem  !! the readings
        integer, intent(in) :: row(:)              !! conditions that are rows
        logical, intent(in) :: within(:)           !! those to agree
        real(dp), intent(inout) :: cost(:, :)      !! of each row by each candidate
        integer, intent(inout) :: candidates       !! how many there are
        logical :: counts(size(problem%condition)), member(size(problem%condition))
        logical :: found, exists
        real(dp) :: k(6), depth, off, excess
        integer :: i

        if (candidates == size(cost, 2)) return
        counts = .false.
        counts(pack(row, within)) = .true.
        call find_conic(problem, counts, k, found, most_draws)
        if (.not. found) return
        call agree(problem, counts, k, member, depth)
        candidates = candidates + 1
        do i = 1, size(row)
            call residual(problem%condition(row(i)), k, problem%frame, off, excess, exists)
            cost(i, candidates) = 1.0_dp
            if (exists .and. abs(off) < bound) cost(i, candidates) = (off/bound)**2
        end do
    end subroutine add_candidate

    !> The stretches of least cost: `piece` is the conic of each row, 1 to `conics` in order.
    pure subroutine split_rows(cost, conics, piece)
        real(dp), intent(in) :: cost(:, :)    !! of each row by each candidate
        integer, intent(in) :: conics         !! of the chain
        integer, intent(out) :: piece(:)      !! one a row
        real(dp) :: best(size(cost, 2), conics), last(size(cost, 2), conics), across(0:conics)
        integer :: from(size(piece), size(cost, 2), conics), via(0:conics), i, j, k

        last = huge(last)/4.0_dp
        last(:, 1) = cost(1, :)
        from = 0
        across(0) = huge(across)
        via(0) = 0
        do i = 2, size(piece)
            across(1:) = minval(last, dim=1)
            via(1:) = minloc(last, dim=1)
            do j = 1, conics
                do k = 1, size(cost, 2)
                    best(k, j) = last(k, j)
                    if (across(j - 1) < best(k, j)) then
                        best(k, j) = across(j - 1)
                        from(i, k, j) = via(j - 1)
                    end if
                    best(k, j) = best(k, j) + cost(i, k)
                end do
            end do
            last = best
        end do
        j = conics
        k = minloc(last(:, conics), dim=1)
        do i = size(piece), 1, -1
            piece(i) = j
            if (from(i, k, j) == 0) cycle
            k = from(i, k, j)
            j = j - 1
        end do
    end subroutine split_rows

    !> Deals out all readings: those of rows as found, others of the table with the row before them,
    !> what else is known with the row of the nearest abscissa.
    pure subroutine deal_out(line, reading, piece, chosen)
        type(line_type), intent(in) :: line     !! the line
        integer, intent(in) :: reading(:)       !! of each row
        integer, intent(in) :: piece(:)         !! of each row
        logical, intent(inout) :: chosen(:, :)  !! one a reading and conic
        integer :: i, at

        chosen = .false.
        do i = 1, size(line%reading)
            if (line%reading(i)%meaning == meaning%printed .and. &
                line%reading(i)%sort <= sort%abscissa) then
                at = maxloc(reading, dim=1, mask=reading <= i)
                if (at == 0) at = 1
            else
                at = minloc(abs(line%reading(reading)%along - line%reading(i)%along), dim=1)
            end if
            chosen(i, piece(at)) = .true.
        end do
    end subroutine deal_out

end module audit_chain
