!> Conics that many figures agree on, however bad the others are: conics through as few figures as
!> fix one, drawn from all over the table, are tried against all figures; the best are improved.
!>
!> Source: M. A. Fischler, R. C. Bolles, "Random sample consensus", CACM 24 (1981), pp. 381-395;
!> the draws here are the same in every run. The score is that of P. Torr, A. Zisserman, "MLESAC",
!> Computer Vision and Image Understanding 78 (2000), pp. 138-156, with a bound of its own.
module audit_search
    use audit_condition, only: exact_row, residual
    use audit_problem, only: is_point, problem_type
    use audit_span, only: free_basis
    use audit_squares, only: improve
    use base_kinds, only: dp, i64
    implicit none (type, external)
    private

    public :: find_conic, score_of, draw

    !> Units of the last place beyond which a figure says nothing of a conic drawn through others.
    real(dp), parameter :: bound = 3.0_dp
    !> Bounds of the rounds that improve a good draw.
    real(dp), parameter :: rounds(4) = [24.0_dp, 12.0_dp, 6.0_dp, 3.0_dp]
    !> Draws at the most, and what chance to have missed all good ones ends them.
    integer, parameter :: most_draws = 600
    real(dp), parameter :: missed = 1.0e-4_dp

contains

    !> The conic that most figures chosen agree on. `found` is false where they are too few.
    pure subroutine find_conic(problem, chosen, k, found, draws)
        type(problem_type), intent(in) :: problem !! the readings
        logical, intent(in) :: chosen(:)          !! figures that count, one a condition
        real(dp), intent(out) :: k(6)             !! the conic
        logical, intent(out) :: found             !! see above
        integer, intent(in), optional :: draws    !! at the most, else `most_draws`
        integer :: point(size(chosen)), n, turn, need
        integer(i64) :: state
        real(dp) :: tried(6), best, score

        point = 0
        n = 0
        do turn = 1, size(chosen)
            if (.not. chosen(turn) .or. .not. is_point(problem%condition(turn))) cycle
            n = n + 1
            point(n) = turn
        end do
        found = n >= problem%freedom
        k = problem%free_to(:, 1)
        if (.not. found .or. problem%freedom == 0) return
        state = 20250117_i64
        best = real(size(chosen) + 1, dp)
        need = min(most_draws, 4*ways_to_draw(n, problem%freedom))
        if (present(draws)) need = min(need, draws)
        do turn = 1, most_draws
            if (turn > need) exit
            call draw(problem, point(:n), modulo(turn, 2) == 1, state, tried)
            score = score_of(problem, chosen, tried, 8.0_dp*bound)
            if (score > best*1.5_dp .and. turn > 8) cycle
            call improve(problem, chosen, rounds, tried)
            score = score_of(problem, chosen, tried, bound)
            if (score >= best) cycle
            best = score
            k = tried
            need = min(need, draws_for(real(n, dp) - best, n, problem%freedom))
        end do
    end subroutine find_conic

    !> How many different draws there are, or more than are made.
    pure integer function ways_to_draw(all, needed) result(ways)
        integer, intent(in) :: all    !! figures
        integer, intent(in) :: needed !! figures of a draw
        integer :: i
        ways = 1
        do i = 1, needed
            ways = min(ways*(all - i + 1)/i, most_draws)
        end do
    end function ways_to_draw

    !> Draws that miss all good figures with a small chance only, when so many are good.
    pure integer function draws_for(good, all, needed) result(draws)
        real(dp), intent(in) :: good  !! figures that agree
        integer, intent(in) :: all    !! figures
        integer, intent(in) :: needed !! figures of a draw
        real(dp) :: share
        share = max(good/real(all, dp) - 0.05_dp, 0.1_dp)**needed
        draws = most_draws
        if (share < 1.0_dp) draws = 4 + int(min(log(missed)/log(1.0_dp - share), &
            real(most_draws, dp)))
        if (share >= 1.0_dp) draws = 4
    end function draws_for

    !> A conic through points drawn one from each stretch of the table, or from anywhere.
    pure subroutine draw(problem, point, is_spread, state, k)
        type(problem_type), intent(in) :: problem !! the readings
        integer, intent(in) :: point(:)           !! conditions that are points
        logical, intent(in) :: is_spread          !! one from each stretch
        integer(i64), intent(inout) :: state      !! of the draws
        real(dp), intent(out) :: k(6)             !! the conic
        real(dp) :: rows(problem%freedom + 1, problem%freedom), share
        real(dp) :: across(problem%freedom + 1, problem%freedom + 1)
        integer :: taken(problem%freedom), i, free

        i = 0
        do while (i < problem%freedom)
            state = mod(state*48271_i64, 2147483647_i64)
            share = real(state, dp)/2147483648.0_dp
            if (is_spread) share = (real(i, dp) + share)/real(problem%freedom, dp)
            taken(i + 1) = point(1 + int(share*real(size(point), dp)))
            if (any(taken(:i) == taken(i + 1))) cycle
            i = i + 1
            rows(:, i) = matmul(exact_row(problem%condition(taken(i)), problem%frame), &
                problem%free_to(:, :problem%freedom + 1))
        end do
        call free_basis(rows, across, free)
        k = matmul(problem%free_to(:, :problem%freedom + 1), across(:, 1))
        k = k/norm2(k)
    end subroutine draw

    !> How badly figures fit a conic: each from 0, met, to 1, `widest` units or more off.
    pure real(dp) function score_of(problem, chosen, k, widest) result(score)
        type(problem_type), intent(in) :: problem !! the readings
        logical, intent(in) :: chosen(:)          !! figures that count
        real(dp), intent(in) :: k(6)              !! the conic
        real(dp), intent(in) :: widest            !! units of the last place
        real(dp) :: off, excess
        integer :: i
        logical :: exists

        score = 0.0_dp
        do i = 1, size(chosen)
            if (.not. chosen(i)) cycle
            call residual(problem%condition(i), k, problem%frame, off, excess, exists)
            if (exists .and. abs(off) < widest) then
                score = score + (off/widest)**2
            else
                score = score + 1.0_dp
            end if
        end do
    end function score_of

end module audit_search
