!> Which figures are of which conic of a chain.
program test_chain
    use audit_audit, only: audit_type, make_audit
    use audit_chain, only: split_line
    use audit_figure, only: form, print_figure, scale_type
    use audit_finding, only: verdict
    use audit_reading, only: add, line_type, meaning, new_reading, sort
    use base_error, only: error_type
    use base_kinds, only: dp, i64
    use support_audited_lines, only: parabola_line, spoil
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type) :: line
    type(audit_type) :: audit
    type(error_type), allocatable :: error
    logical, allocatable :: chosen(:, :)
    integer :: i

    line = parabola_line()
    call split_line(line, line%scale, chosen)
    call tap%ok(size(chosen, 2) == 1 .and. all(chosen), 'a line of one conic is not split')

    ! Three parabolas with common tangents at 60 and 120: 40 rows, the first from 0 to 57.
    line = line_type(name='three', scale=scale_type(form%decimal, 3), conics=3)
    do i = 0, 59
        call add(line, new_reading(sort%ordinate, 3.0_dp*real(i, dp), print_figure( &
            height(3*i), line%scale)))
    end do
    call add(line, new_reading(sort%ordinate, 180.0_dp, '48', meaning%exact))
    call spoil(line, 5, '')
    call spoil(line, 20, '32.4?0')
    call spoil(line, 30, '66.616')
    call split_line(line, line%scale, chosen)
    call tap%ok(all(count(chosen, dim=2) == 1), 'each reading is of one conic')
    call tap%ok(all(chosen(:20, 1)) .and. all(chosen(22:40, 2)) .and. all(chosen(42:, 3)), &
        'the joints are found between the right rows')
    call make_audit(line, audit, error)
    call tap%ok(.not. allocated(error) .and. size(audit%piece) == 3, 'a chain is audited')
    call tap%near(audit%piece(2)%first, 60.0_dp, 3.0_dp, 'the first joint is near 60')
    call tap%near(audit%piece(3)%first, 120.0_dp, 3.0_dp, 'the second near 120')
    call tap%ok(count(audit%finding%verdict == verdict%agrees) == 58 .and. &
        audit%finding(30)%verdict == verdict%suspect, 'all sound figures agree')
    call tap%same(trim(audit%finding(5)%likely)//' '//trim(audit%finding(20)%likely), &
        '1.440 32.490', 'what is missing is filled in')
    call tap%finish()

contains

    !> Ordinates of three parabolas, in thousandths: x**2/100 to 60, then slope 1.2 falls to 0 at
    !> 120 and to -1.2 * 2 at 180.
    pure integer(i64) function height(x) result(thousandths)
        integer, intent(in) :: x !! abscissa
        integer :: t
        if (x <= 60) then
            thousandths = int(10*x*x, i64)
        else if (x <= 120) then
            t = x - 60
            thousandths = int(36000 + 1200*t - 10*t*t, i64)
        else
            t = x - 120
            thousandths = int(72000, i64) - int((20*t*t)/3, i64)
        end if
    end function height

end program test_chain
