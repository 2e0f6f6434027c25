!> Ways of printing, and what a figure tells of its value.
program test_printing
    use audit_figure, only: form, scale_type
    use audit_printing, only: allowed, printed_units, printing, printing_name
    use base_kinds, only: dp, i64
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(scale_type), parameter :: three = scale_type(form%decimal, 3)
    type(scale_type), parameter :: eighths = scale_type(form%eighths, 0)
    integer :: way, i
    real(dp) :: between(2), value
    logical :: holds

    call tap%ok(printed_units(0.1405_dp, three, printing%rounded) == 141 .and. &
        printed_units(-0.1405_dp, three, printing%rounded) == -141, &
        'a half is rounded away from zero')
    call tap%ok(printed_units(0.1405_dp, three, printing%half_even) == 140 .and. &
        printed_units(0.1415_dp, three, printing%half_even) == 142, 'or to the even figure')
    call tap%ok(printed_units(2.9999_dp, three, printing%truncated) == 2999 .and. &
        printed_units(-2.9999_dp, three, printing%truncated) == -2999, &
        'truncation cuts off towards zero')
    call tap%ok(printed_units(0.003_dp, three, printing%truncated) == 3, &
        'a decimal that binary can''t hold is not cut off one unit short')
    call tap%ok(printed_units(11.9_dp, three, printing%of_1970) == 11901 .and. &
        printed_units(-16.719_dp, three, printing%of_1970) == -16719, &
        'the program of 1970 adds .0005 to all and rounds')
    call tap%ok(printed_units(55.43_dp, eighths, printing%rounded) == 443, 'eighths are rounded')
    call tap%ok(printed_units(1.0e30_dp, three, printing%rounded) > 0, 'no value is too large')

    ! What is printed of a value must be a figure that allows it.
    do way = printing%rounded, printing%half_even
        holds = .true.
        do i = -400, 400
            value = real(i, dp)*0.00017_dp
            between = allowed(printed_units(value, three, way), three, way)
            holds = holds .and. between(1) <= value + 1.0e-12_dp .and. &
                value <= between(2) + 1.0e-12_dp
            between = allowed(printed_units(1000.0_dp*value, eighths, way), eighths, way)
            if (way /= printing%of_1970) holds = holds .and. &
                between(1) <= 1000.0_dp*value + 1.0e-9_dp .and. &
                1000.0_dp*value <= between(2) + 1.0e-9_dp
        end do
        call tap%ok(holds, 'a printed figure allows its value: '//printing_name(way))
    end do
    between = allowed(-7_i64, three, printing%truncated)
    call tap%near(between(1), -0.008_dp, 1.0e-15_dp, 'a truncated negative figure allows less')
    call tap%near(between(2), -0.007_dp, 1.0e-15_dp, '... and not more')
    between = allowed(0_i64, three, printing%truncated)
    call tap%near(between(2) - between(1), 0.002_dp, 1.0e-15_dp, 'a truncated zero allows both')
    call tap%finish()
end program test_printing
