!> Lengths said beforehand are those of the texts.
program test_length
    use, intrinsic :: ieee_arithmetic, only: ieee_negative_inf, ieee_positive_inf, ieee_quiet_nan, &
        ieee_value
    use base_kinds, only: dp, i64
    use base_length, only: compact_field, compact_length, places
    use base_text, only: compact, counted, to_text
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    real(dp), parameter :: number(*) = [0.0_dp, 7.0_dp, -0.001_dp, 12.5_dp, 3.0e20_dp, -1.0e-5_dp, &
        1234567.125_dp, -9999999.9_dp, 1.0e-300_dp]
    character(12), parameter :: text(*) = [character(12) :: '0.', '7.', '-0.001', '12.5', &
        '3.E+20', &
        '-1.E-05', '1234567.125', '-9999999.9', '1.E-300']
    integer :: i

    call tap%ok(all(places([0_i64, 9_i64, 10_i64, -1_i64, -10_i64]) == &
        [1_i64, 1_i64, 2_i64, 2_i64, 3_i64]) .and. &
        places(huge(1_i64)) == 19_i64, 'characters of whole numbers')
    call tap%ok(places(-huge(1_i64)) == 20_i64, 'of one far below zero')
    do i = 1, size(number)
        call tap%same(compact(number(i)), trim(text(i)), 'a sentence has '//trim(text(i)))
        call tap%ok(compact_length(number(i)) == len_trim(text(i), i64) .and. &
            compact_field(number(i)) == text(i), 'of that length')
    end do
    call tap%same(compact(ieee_value(0.0_dp, ieee_quiet_nan))//' '// &
        compact(ieee_value(0.0_dp, ieee_positive_inf))//' '// &
        compact(ieee_value(0.0_dp, ieee_negative_inf)), 'NaN Inf -Inf', &
        'what is no number is said as such')
    call tap%same(to_text(-120), '-120', 'a whole number')
    call tap%same(counted(1_i64, 'card'), '1 card', 'one')
    call tap%same(counted(12_i64, 'card'), '12 cards', 'many')
    call tap%finish()
end program test_length
