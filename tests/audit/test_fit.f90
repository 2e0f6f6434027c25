!> One conic from readings of which some are bad.
program test_fit
    use audit_fit, only: fit_readings, fit_type
    use audit_printing, only: printing
    use audit_reading, only: add, line_type, meaning, new_reading, sort
    use base_kinds, only: dp
    use support_audited_lines, only: parabola_line, spoil, whole
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type) :: line
    type(fit_type) :: fit
    integer :: i

    line = parabola_line()
    call spoil(line, 6, '6.280')
    call add(line, new_reading(sort%ordinate, 0.0_dp, '0', meaning%exact))
    call add(line, new_reading(sort%ordinate, 100.0_dp, '100', meaning%exact))
    call add(line, new_reading(sort%ordinate, 40.0_dp, '16', meaning%exact))
    call fit_readings(line, line%scale, whole(line), fit)
    call tap%ok(fit%met == 22 .and. fit%problem%freedom == 2, &
        'three exact points are held and all figures but one are met')
    call tap%ok(.not. fit%member(6), 'which is the bad one')
    call tap%ok(all(fit%met_by(1:2) > 0) .and. fit%met_by(3) >= 0, &
        'every way of printing is tried where none is told')

    call spoil(line, 23, '61')
    call fit_readings(line, line%scale, whole(line), fit)
    call tap%ok(fit%given_up(23) .and. count(fit%given_up) == 1, &
        'an exact number that most figures contradict is given up')
    line%reading(23)%is_sure = .true.
    call fit_readings(line, line%scale, whole(line), fit)
    call tap%ok(.not. fit%given_up(23), 'unless it is beyond doubt')

    line = parabola_line()
    do i = 1, 20
        call spoil(line, i, cut(5.0_dp*real(i - 1, dp)))
    end do
    call add(line, new_reading(sort%ordinate, 0.0_dp, '0', meaning%exact))
    call add(line, new_reading(sort%slope, 0.0_dp, '.001', meaning%exact))
    call add(line, new_reading(sort%ordinate, 100.0_dp, '100.10', meaning%exact))
    call add(line, new_reading(sort%slope, 100.0_dp, '2.001', meaning%exact))
    line%scale%decimals = 1
    call fit_readings(line, line%scale, whole(line), fit)
    call tap%ok(fit%printing == printing%truncated .and. fit%met == 24, &
        'figures that were cut off are known as such where ends and slopes are')
    line%printing = printing%rounded
    call fit_readings(line, line%scale, whole(line), fit)
    call tap%ok(fit%met_by(2) == -1 .and. fit%met < 24, 'no other way is tried where one is told')

    deallocate (line%reading)
    call add(line, new_reading(sort%ordinate, 1.0_dp, '0.1'))
    call fit_readings(line, line%scale, whole(line), fit)
    call tap%ok(fit%met < 0, 'one figure is too few for a conic')
    call tap%finish()

contains

    !> x**2/100 + x/1000 cut off to one decimal.
    pure function cut(x) result(text)
        real(dp), intent(in) :: x !! abscissa, a whole number
        character(12) :: text
        integer :: tenths
        tenths = (10*nint(x)**2 + nint(x))/100
        write (text, '(i0,".",i1)') tenths/10, modulo(tenths, 10)
    end function cut

end program test_fit
