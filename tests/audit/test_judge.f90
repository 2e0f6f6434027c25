!> Verdicts on figures, and what is likely right: a parabola spoilt in all ways.
program test_judge
    use audit_curve, only: quantity_type
    use audit_finding, only: finding_type, verdict
    use audit_fit, only: fit_readings, fit_type
    use audit_judge, only: judge_readings, quantity_of
    use audit_printing, only: printing
    use audit_reading, only: add, line_type, meaning, new_reading, sort
    use audit_slip, only: slip
    use base_kinds, only: dp
    use support_audited_lines, only: circle_line, parabola_line, spoil, whole
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type) :: line
    type(fit_type) :: fit
    type(finding_type), allocatable :: finding(:)
    type(quantity_type) :: quantity
    integer, allocatable :: of(:)
    integer :: i

    line = parabola_line()
    line%printing = printing%rounded
    call spoil(line, 4, '2.260')
    call spoil(line, 7, '9.00')
    call spoil(line, 9, '16.001')
    call spoil(line, 11, '2?.000')
    call spoil(line, 12, '')
    call spoil(line, 14, '54.250')
    call spoil(line, 16, '12.345')
    call add(line, new_reading(sort%ordinate, 0.0_dp, '0', meaning%exact))
    call add(line, new_reading(sort%ordinate, 100.0_dp, '100', meaning%exact))
    call add(line, new_reading(sort%slope, 0.0_dp, '0', meaning%exact))
    call add(line, new_reading(sort%slope, 100.0_dp, '2', meaning%exact))
    allocate (finding(24))
    call fit_readings(line, line%scale, whole(line), fit)
    call judge_readings(line, line%scale, whole(line), fit, finding)
    call tap%ok(all(finding([1, 2, 3, 5, 6, 8, 10, 13, 15, 17, 18, 19, 20])%verdict == &
        verdict%agrees), 'sound figures agree')
    call tap%ok(finding(4)%verdict == verdict%suspect .and. finding(4)%slip == slip%digit, &
        'a wrong digit is suspect')
    call tap%same(trim(finding(4)%likely), '2.250', 'and restored')
    call tap%near(finding(4)%residual, 10.0_dp, 1.0_dp, 'it is ten units off')
    call tap%ok(finding(4)%sure > 0.9_dp, 'that is rather sure')
    call tap%ok(finding(7)%verdict == verdict%suspect .and. finding(7)%slip == slip%missing .and. &
        finding(7)%likely == '9.000', 'a digit is missing')
    call tap%ok(finding(9)%verdict == verdict%rounding .and. finding(9)%computed_figure == &
        '16.000', 'one unit off is a matter of rounding')
    call tap%ok(finding(11)%verdict == verdict%unreadable .and. finding(11)%likely == '25.000', &
        'what can''t be read is filled in')
    call tap%ok(finding(12)%verdict == verdict%blank .and. finding(12)%likely == '30.250', &
        'so is a blank')
    call tap%ok(finding(14)%slip == slip%foot .and. finding(14)%likely == '42.250', &
        'twelve inches more are a foot')
    call tap%ok(finding(16)%slip == slip%none .and. finding(16)%likely == '56.250', &
        'where no slip explains a figure the line tells it')
    call tap%ok(finding(4)%low <= 2.2505_dp .and. finding(4)%high >= 2.2495_dp .and. &
        finding(4)%high - finding(4)%low < 0.002_dp, 'the good figures bound the true value')

    line = parabola_line()
    do i = 7, 9
        call spoil(line, i, line%reading(i + 1)%figure%text)
    end do
    call fit_readings(line, line%scale, whole(line), fit)
    call judge_readings(line, line%scale, whole(line), fit, finding)
    call tap%ok(all(finding(7:9)%slip == slip%row .and. finding(7:9)%verdict == verdict%suspect), &
        'figures a row too early are known as such')

    line = circle_line()
    call spoil(line, 40, '95.394')
    call spoil(line, 20, '')
    call fit_readings(line, line%scale, whole(line), fit)
    allocate (of(41))
    of = [(i, i = 1, 19), 0, (i, i = 20, 40)]
    quantity = quantity_of(line, 20, of, fit)
    call tap%ok(quantity%side == 1, 'a blank is on the side on which its neighbours are')
    call tap%finish()
end program test_judge
