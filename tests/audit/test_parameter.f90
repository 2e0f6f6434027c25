!> The numbers of a card: the figures of a parabola with its ends known.
program test_parameter
    use audit_curve, only: quantity_type
    use audit_fit, only: fit_readings, fit_type
    use audit_parameter, only: bound_parameter, find_pairs, fix_parameter, pair_type, &
        parameter_type
    use audit_reading, only: add, line_type, meaning, new_reading, sort
    use base_kinds, only: dp
    use support_audited_lines, only: parabola_line, whole
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(line_type) :: line
    type(fit_type) :: fit, fixed
    type(parameter_type) :: s1, s3
    type(pair_type), allocatable :: pairs(:)
    logical :: is_allowed
    integer :: i

    line = parabola_line()
    call add(line, new_reading(sort%ordinate, 0.0_dp, '0', meaning%exact))
    call add(line, new_reading(sort%ordinate, 100.0_dp, '100', meaning%exact))
    call fit_readings(line, line%scale, whole(line), fit)
    s1 = bound_parameter(fit, 'S1', quantity_type(sort%slope, along=0.0_dp))
    s3 = bound_parameter(fit, 'S3', quantity_type(sort%slope, along=100.0_dp, near=100.0_dp))
    call tap%ok(s3%is_limited .and. s3%low < 2.0_dp .and. s3%high > 2.0_dp .and. &
        s3%high - s3%low < 1.0e-3_dp, 'the last slope of y = x**2/100 is 2')
    call tap%ok(size(s3%round) == 1 .and. size(s1%round) == 1, 'the round numbers are ...')
    call tap%same(trim(s1%round(1))//' '//trim(s3%round(1)), '0 2', '... 0 and 2')

    fixed = fit
    call fix_parameter(fixed, s3%quantity, 2.0_dp, is_allowed)
    call tap%ok(is_allowed, 'it may be 2')
    s1 = bound_parameter(fixed, 'S1', s1%quantity)
    call tap%ok(s1%high - s1%low < 1.0e-3_dp .and. s1%low <= 0.0_dp .and. s1%high >= 0.0_dp, &
        'which leaves the first slope less room')
    fixed = fit
    call fix_parameter(fixed, s3%quantity, 2.0_dp*s3%high - s3%low, is_allowed)
    call tap%ok(.not. is_allowed, 'it may not be outside of its bounds')

    allocate (pairs(0))
    pairs = find_pairs(fit, s1%quantity, s3%quantity, 4)
    call tap%ok(size(pairs) > 0, 'there are pairs of four decimals')
    call tap%ok(any([(pairs(i)%first == '0.0000' .and. pairs(i)%second == '2.0000', &
        i = 1, size(pairs))]), 'among them the true one')
    is_allowed = .true.
    do i = 1, size(pairs)
        is_allowed = is_allowed .and. number(pairs(i)%second) >= s3%low - 1.0e-9_dp .and. &
            number(pairs(i)%second) <= s3%high + 1.0e-9_dp
    end do
    call tap%ok(is_allowed, 'and all of them are within the bounds')
    call tap%finish()

contains

    !> The number of a text.
    real(dp) function number(text)
        character(*), intent(in) :: text !! a decimal number
        read (text, *) number
    end function number

end program test_parameter
