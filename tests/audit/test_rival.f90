!> Which of two figures is the bad one, where the line may go through either.
program test_rival
    use audit_agreement, only: deepen
    use audit_climb, only: most_unknowns
    use audit_finding, only: finding_type, verdict
    use audit_fit, only: fit_readings, fit_type
    use audit_judge, only: judge_readings
    use audit_printing, only: printing
    use audit_reading, only: add, line_type, meaning, new_reading, sort
    use audit_rival, only: settle_rivals
    use base_kinds, only: dp
    use support_audited_lines, only: whole
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type) :: line
    type(fit_type) :: fit
    type(finding_type) :: finding(6)
    integer :: against(most_unknowns), side

    ! y = x**2/100 with both ends and their slopes: one figure fixes it, 16.008 is misread.
    line%scale%decimals = 3
    line%printing = printing%rounded
    call add(line, new_reading(sort%ordinate, 40.0_dp, '16.008'))
    call add(line, new_reading(sort%ordinate, 80.0_dp, '64.000'))
    call add(line, new_reading(sort%ordinate, 0.0_dp, '0', meaning%exact))
    call add(line, new_reading(sort%ordinate, 100.0_dp, '100', meaning%exact))
    call add(line, new_reading(sort%slope, 0.0_dp, '0', meaning%exact))
    call add(line, new_reading(sort%slope, 100.0_dp, '2', meaning%exact))
    line%reading(3:)%is_sure = .true.
    call fit_readings(line, line%scale, whole(line), fit)
    call tap%ok(fit%met == 5, 'one of two figures is met')
    do side = 1, 2
        fit%member(:2) = [side == 1, side == 2]
        call deepen(fit%problem, fit%member, fit%k, fit%depth, against)
        call judge_readings(line, line%scale, whole(line), fit, finding)
        call tap%ok(finding(3 - side)%verdict == verdict%suspect, 'the line may go through either')
        call settle_rivals(line, line%scale, whole(line), fit, finding)
        call tap%ok(fit%member(2) .and. finding(1)%verdict == verdict%suspect .and. &
            finding(2)%verdict == verdict%agrees, 'the one whose slip is likelier is suspect')
        call tap%same(trim(finding(1)%likely), '16.000', 'and put right')
        call tap%ok(finding(1)%rival == 2, 'its rival is named')
    end do
    call tap%finish()
end program test_rival
