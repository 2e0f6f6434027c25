!> `make bench`: how well and how fast printed tables are audited. Random tables, random damage, as
!> `support_audited` makes them: what share of the slips is found, what share of the sound figures
!> is accused, what share of the slips of one character is restored.
program audit
    use, intrinsic :: iso_fortran_env, only: output_unit
    use audit_figure, only: form, scale_type
    use base_digits, only: fixed
    use base_kinds, only: dp
    use base_text, only: to_text
    use support_audit_rates, only: measure_rates, rates_type, trial_type
    implicit none (type, external)

    integer, parameter :: lines = 60
    character(24), parameter :: names(0:3) = [character(24) :: 'nothing', 'end points', &
        'end points and slopes', 'a card but for S3']

    call say('## Audit: damaged tables back to their lines')
    call say('')
    call say('Random conics and smooth chains of them, 15 to 29 rows of each conic to three')
    call say('decimals, rounded, truncated or as in 1970 (told for every other line), damaged at')
    call say('random: digits taken for others (two of three look alike), one too many, missing,')
    call say('swapped, signs, rows shifted, two digits wrong. *Slips* are of two units of the last')
    call say('place or more. One unit: slips of one unit, those found, and those that all sound')
    call say('figures of the line together contradict.')
    call say('')
    call report('Share of the figures damaged, whatever is known of the line', [5, 15, 25, 40])
    call report_known()
    call report_eighths()
    call report_chains()

contains

    !> Prints a line.
    subroutine say(text)
        character(*), intent(in) :: text !! any
        write (output_unit, '(a)') text
    end subroutine say

    !> The head of a table of rates.
    subroutine head(title, first)
        character(*), intent(in) :: title !! of the table
        character(*), intent(in) :: first !! of its first column
        call say(title//':')
        call say('')
        call say('| '//first//' | slips found | sound accused | one character restored | '// &
            'one unit: found | of those that can be | figures a second |')
        call say('|---|---|---|---|---|---|---|')
    end subroutine head

    !> A row of rates.
    subroutine row(name, rates)
        character(*), intent(in) :: name      !! of the row
        type(rates_type), intent(in) :: rates !! what was counted
        call say('| '//name//' | '//percent(rates%found(), 2)//' | '// &
            percent(rates%accused(), 3)//' | '//percent(rates%restored(), 2)//' | '// &
            to_text(rates%units_found)//' of '//to_text(rates%units)//' | '// &
            to_text(rates%units_shown)//' | '// &
            to_text(nint(real(rates%figures, dp)/rates%seconds))//' |')
    end subroutine row

    !> A share as percent.
    function percent(share, decimals) result(text)
        real(dp), intent(in) :: share   !! 0 to 1
        integer, intent(in) :: decimals !! how many
        character(:), allocatable :: text
        text = trim(adjustl(fixed(100.0_dp*share, 9, decimals)))//' %'
    end function percent

    !> Rates by share of damage.
    subroutine report(title, damage)
        character(*), intent(in) :: title !! of the table
        integer, intent(in) :: damage(:)  !! percent of the figures
        type(rates_type) :: rates
        integer :: i
        call head(title, 'damaged')
        do i = 1, size(damage)
            call measure_rates(trial_type(conics=1, lines=4*lines, &
                damaged=0.01_dp*real(damage(i), dp)), rates)
            call row(to_text(damage(i))//' %', rates)
        end do
        call say('')
    end subroutine report

    !> Rates by what is known, at 15 percent damage.
    subroutine report_known()
        type(rates_type) :: rates
        integer :: known
        call head('15 % damaged, by what else is known of the line', 'known')
        do known = 0, 3
            call measure_rates(trial_type(lines=2*lines, known=known), rates)
            call row(trim(names(known)), rates)
        end do
        call say('')
    end subroutine report_known

    !> Rates of tables in feet, inches and eighths, at 15 percent damage.
    subroutine report_eighths()
        type(rates_type) :: rates
        integer :: known
        call head('15 % damaged, in feet, inches and eighths', 'known')
        do known = 0, 3
            call measure_rates(trial_type(lines=2*lines, known=known, &
                scale=scale_type(form%eighths, 0)), rates)
            call row(trim(names(known)), rates)
        end do
        call say('')
    end subroutine report_eighths

    !> Rates by length of chain, at 15 percent damage.
    subroutine report_chains()
        type(rates_type) :: rates
        integer :: conics
        call head('15 % damaged, chains with joints to be found', 'conics')
        do conics = 2, 4
            call measure_rates(trial_type(conics=conics, lines=lines), rates)
            call row(to_text(conics), rates)
        end do
        call say('')
    end subroutine report_chains

end program audit
