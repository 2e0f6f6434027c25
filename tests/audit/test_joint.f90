!> Where two conics join.
program test_joint
    use audit_fit, only: fit_readings, fit_type
    use audit_joint, only: find_joint
    use audit_reading, only: add, line_type, new_reading, sort
    use audit_figure, only: form, print_figure, scale_type
    use base_kinds, only: dp, i64
    use support_audited_lines, only: parabola_line, whole
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type) :: line
    type(fit_type) :: before, after
    real(dp) :: joint
    integer :: i, t

    line = parabola_line()
    call fit_readings(line, line%scale, whole(line), before)
    ! From (95.2, 90.6304) on another parabola of another slope.
    line = line_type(scale=scale_type(form%decimal, 4))
    do i = 1, 15
        t = 50*i - 2
        call add(line, new_reading(sort%ordinate, 95.2_dp + 0.1_dp*real(t, dp), &
            print_figure(int(906304 + 500*t + 2*t*t, i64), line%scale)))
    end do
    call fit_readings(line, line%scale, whole(line), after)
    joint = find_joint(before, after, [95.0_dp, 100.0_dp], 90.0_dp, 0.001_dp)
    call tap%near(joint, 95.2_dp, 0.1_dp, 'conics that cross join there')
    joint = find_joint(before, before, [95.0_dp, 100.0_dp], 90.0_dp, 0.001_dp)
    call tap%near(joint, 95.0_dp, 1.0e-12_dp, 'where they do not differ a round number will do')
    call tap%finish()
end program test_joint
