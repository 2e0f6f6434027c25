!> How well an audit finds random damage of random tables.
module support_audit_rates
    use audit_agreement, only: deepen
    use audit_audit, only: audit_type, make_audit
    use audit_climb, only: most_unknowns
    use audit_figure, only: bare, figure_length, form, scale_type
    use audit_finding, only: verdict
    use audit_reading, only: line_type, new_reading, sort
    use audit_slip, only: slip
    use base_error, only: error_type
    use base_kinds, only: dp, i64
    use support_audited, only: damage, damage_type, plan_type, print_truth, random_truth, truth_type
    use support_random, only: random_type
    implicit none (type, external)
    private

    public :: trial_type, rates_type, measure_rates

    !> What is tried.
    type :: trial_type
        integer :: conics = 1              !! of each line
        integer :: lines = 100             !! how many
        integer :: known = -1              !! as in `plan_type`; -1: each in turn
        type(scale_type) :: scale = scale_type(1, 3) !! places of the figures
        real(dp) :: damaged = 0.15_dp      !! share of the figures
    end type trial_type

    !> What was counted. Slips are of two units of the last place or more unless said otherwise; a
    !> figure to other places than its table counts as one.
    type :: rates_type
        integer :: lines = 0               !! audited
        integer :: figures = 0             !! audited
        integer :: sound = 0               !! figures that were not damaged
        integer :: sound_accused = 0       !! of them, called suspect
        integer :: sound_rounding = 0      !! of them, called one unit off
        integer :: slips = 0               !! slips
        integer :: slips_found = 0         !! of them, called suspect
        integer :: characters = 0          !! slips of one character
        integer :: characters_restored = 0 !! of them, restored
        integer :: units = 0               !! slips of one unit
        integer :: units_found = 0         !! of them, not said to agree
        integer :: units_shown = 0         !! of them, those that all sound figures contradict
        real(dp) :: seconds = 0.0_dp       !! of audits
    contains
        procedure :: found
        procedure :: accused
        procedure :: restored
    end type rates_type

contains

    !> The share of slips found.
    pure real(dp) function found(rates)
        class(rates_type), intent(in) :: rates !! what was counted
        found = real(rates%slips_found, dp)/real(max(rates%slips, 1), dp)
    end function found

    !> The share of sound figures accused.
    pure real(dp) function accused(rates)
        class(rates_type), intent(in) :: rates !! what was counted
        accused = real(rates%sound_accused, dp)/real(max(rates%sound, 1), dp)
    end function accused

    !> The share of slips of one character that are restored.
    pure real(dp) function restored(rates)
        class(rates_type), intent(in) :: rates !! what was counted
        restored = real(rates%characters_restored, dp)/real(max(rates%characters, 1), dp)
    end function restored

    !> Audits random tables with random damage: 15 to 29 rows of each conic, three decimals, printed
    !> in any way, which is told for every other line.
    subroutine measure_rates(trial, rates)
        type(trial_type), intent(in) :: trial  !! what is tried
        type(rates_type), intent(out) :: rates !! what was counted
        type(random_type) :: random
        type(truth_type) :: truth(trial%conics)
        type(plan_type) :: plan
        type(line_type) :: line
        type(audit_type) :: audit
        type(damage_type), allocatable :: table(:)
        type(error_type), allocatable :: error
        character(figure_length) :: text
        real(dp) :: start, finish
        integer :: turn, i

        do turn = 1, trial%lines
            call random_chain(random, truth)
            plan%rows = 15 + int(15.0_dp*random%unit())
            plan%known = trial%known
            if (trial%known < 0) plan%known = modulo(turn, 4)
            plan%printing = 1 + int(3.0_dp*random%unit())
            if (trial%scale%form == form%eighths) plan%printing = 1 + modulo(turn, 2)
            plan%scale = trial%scale
            call print_truth(truth, plan, line, table)
            if (modulo(turn, 8) < 4) line%printing = plan%printing
            do i = 1, size(table)
                if (random%unit() >= trial%damaged) cycle
                call damage(random, table, i, text)
                line%reading(i) = new_reading(sort%ordinate, line%reading(i)%along, &
                    text, form_of=plan%scale%form)
            end do
            call cpu_time(start)
            call make_audit(line, audit, error)
            call cpu_time(finish)
            rates%seconds = rates%seconds + (finish - start)
            rates%lines = rates%lines + 1
            rates%figures = rates%figures + size(line%reading)
            if (allocated(error)) cycle
            call tally(table, audit, rates)
        end do
    end subroutine measure_rates

    !> A random chain that goes on smoothly from conic to conic.
    subroutine random_chain(random, truth)
        type(random_type), intent(inout) :: random !! where the numbers come from
        type(truth_type), intent(out) :: truth(:)  !! cards in order
        integer :: i
        truth(1) = random_truth(random, anint(random%between(-50.0_dp, 50.0_dp)), &
            anint(random%between(-30.0_dp, 30.0_dp)), &
            anint(random%between(-600.0_dp, 600.0_dp))/1000.0_dp)
        do i = 2, size(truth)
            truth(i) = random_truth(random, truth(i - 1)%x(3), truth(i - 1)%y(3), &
                truth(i - 1)%slope(2))
        end do
    end subroutine random_chain

    !> Counts what an audit found of a table.
    subroutine tally(table, audit, rates)
        type(damage_type), intent(in) :: table(:)  !! its true figures, and what was done to them
        type(audit_type), intent(in) :: audit      !! what was found
        type(rates_type), intent(inout) :: rates   !! so far
        integer(i64) :: off
        integer :: i

        do i = 1, size(table)
            associate (it => audit%finding(i), figure => audit%line%reading(i)%figure)
                if (table(i)%kind == slip%none) then
                    rates%sound = rates%sound + 1
                    if (it%verdict == verdict%suspect) rates%sound_accused = rates%sound_accused + 1
                    if (it%verdict == verdict%rounding) &
                        rates%sound_rounding = rates%sound_rounding + 1
                    cycle
                end if
                off = 2
                if (figure%is_sound .and. figure%scale%decimals == audit%scale%decimals) &
                    off = abs(figure%units - table(i)%units)
                if (off < 2) then
                    rates%units = rates%units + 1
                    if (it%verdict /= verdict%agrees) rates%units_found = rates%units_found + 1
                    if (is_shown(table, audit, i)) rates%units_shown = rates%units_shown + 1
                    cycle
                end if
                rates%slips = rates%slips + 1
                if (it%verdict == verdict%suspect) rates%slips_found = rates%slips_found + 1
                if (table(i)%kind > slip%point) cycle
                rates%characters = rates%characters + 1
                if (bare(it%likely) == bare(table(i)%true)) &
                    rates%characters_restored = rates%characters_restored + 1
            end associate
        end do
    end subroutine tally

    !> True where a damaged figure contradicts all sound ones of its conic together: where it can be
    !> found out at all.
    logical function is_shown(table, audit, which)
        type(damage_type), intent(in) :: table(:)  !! what was done to figures
        type(audit_type), intent(in) :: audit      !! what was found
        integer, intent(in) :: which               !! the figure
        logical, allocatable :: member(:)
        real(dp) :: k(6), depth
        integer :: against(most_unknowns), i, n

        associate (fit => audit%piece(max(audit%finding(which)%piece, 1))%fit)
            allocate (member(size(fit%member)))
            member = .not. (fit%problem%is_held .or. fit%given_up)
            do i = 1, size(member)
                n = fit%problem%condition(i)%reading
                if (n > size(table)) cycle
                if (table(n)%kind /= slip%none .and. n /= which) member(i) = .false.
            end do
            k = fit%k
            call deepen(fit%problem, member, k, depth, against)
        end associate
        is_shown = depth < 0.0_dp
    end function is_shown

end module support_audit_rates
