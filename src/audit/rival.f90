!> Which of two figures is the bad one, where the line may go through either: the one whose slip is
!> the likelier.
!>
!> A figure left out that is near the line contradicts a few others; where leaving out one of these
!> instead lets it in, the two are rivals. As many figures are met either way; what decides is how
!> likely all that are not met are read as they are (`audit_slip`).
module audit_rival
    use audit_agreement, only: conflicts, deepen
    use audit_climb, only: most_unknowns
    use audit_condition, only: residual
    use audit_figure, only: scale_type
    use audit_finding, only: finding_type, verdict
    use audit_fit, only: fit_type, room_of_1970
    use audit_judge, only: judge_readings
    use audit_reading, only: line_type
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: settle_rivals

    !> Figures no further out of their bounds than this, in units of the last place, have rivals.
    real(dp), parameter :: near = 12.0_dp
    !> How much likelier the other explanation must be: odds of 3 to 1, as a logarithm.
    real(dp), parameter :: clear = 1.1_dp

contains

    !> Exchanges figures left out for rivals that are likelier to be bad. `finding` is of the conic
    !> given, then of the one returned; rivals that remain are named in it.
    pure subroutine settle_rivals(line, scale, chosen, fit, finding)
        type(line_type), intent(in) :: line             !! the line
        type(scale_type), intent(in) :: scale           !! of its table
        logical, intent(in) :: chosen(:)                !! readings of this conic
        type(fit_type), intent(inout) :: fit            !! the conic
        type(finding_type), intent(inout) :: finding(:) !! one a reading
        integer :: against(most_unknowns), i, j, reading
        real(dp) :: off, excess
        logical :: exists

        do i = 1, size(fit%member)
            if (fit%member(i) .or. fit%problem%is_held(i) .or. fit%given_up(i)) cycle
            reading = fit%problem%condition(i)%reading
            call residual(fit%problem%condition(i), fit%k, fit%problem%frame, off, excess, exists)
            if (.not. exists .or. excess > near) cycle
            call conflicts(fit%problem, fit%member, i, fit%k, against)
            do j = 1, count(against > 0)
                if (against(j) == i) cycle
                call try_rival(line, scale, chosen, [i, against(j)], fit, finding)
                if (fit%member(i)) exit
            end do
        end do
    end subroutine settle_rivals

    !> Tries a figure instead of its rival, and leaves it so where that is clearly the likelier.
    pure subroutine try_rival(line, scale, chosen, pair, fit, finding)
        type(line_type), intent(in) :: line             !! the line
        type(scale_type), intent(in) :: scale           !! of its table
        logical, intent(in) :: chosen(:)                !! readings of this conic
        integer, intent(in) :: pair(2)                  !! condition left out, its rival
        type(fit_type), intent(inout) :: fit            !! the conic
        type(finding_type), intent(inout) :: finding(:) !! one a reading
        type(fit_type) :: other
        type(finding_type) :: found(size(finding))
        integer :: against(most_unknowns), reading(2), i
        real(dp) :: off, excess
        logical :: exists

        other = fit
        other%member(pair(1)) = .true.
        other%member(pair(2)) = .false.
        call deepen(other%problem, other%member, other%k, other%depth, against)
        if (other%depth < 0.0_dp) return
        do i = 1, size(other%member)
            if (.not. other%member(i)) cycle
            call residual(other%problem%condition(i), other%k, other%problem%frame, off, excess, &
                exists)
            if (.not. exists .or. excess > room_of_1970) return
        end do
        reading = fit%problem%condition(pair)%reading
        found = finding
        call judge_readings(line, scale, chosen, other, found)
        if (surprise(found, chosen) < surprise(finding, chosen) - clear) then
            fit = other
            finding = found
            reading = reading([2, 1])
        end if
        finding(reading(1))%rival = reading(2)
    end subroutine try_rival

    !> How unlikely the figures that are not met are read as they are: minus the logarithm.
    pure real(dp) function surprise(finding, chosen)
        type(finding_type), intent(in) :: finding(:) !! one a reading
        logical, intent(in) :: chosen(:)             !! readings of this conic
        integer :: i
        surprise = 0.0_dp
        do i = 1, size(finding)
            if (.not. chosen(i)) cycle
            if (finding(i)%verdict == verdict%suspect .or. &
                finding(i)%verdict == verdict%rounding) &
                surprise = surprise - log(max(finding(i)%evidence, tiny(1.0_dp)))
        end do
    end function surprise

end module audit_rival
