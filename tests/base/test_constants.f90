!> Constants against closed forms and the printed book.
program test_constants
    use, intrinsic :: iso_fortran_env, only: real128
    use base_constants, only: degrees, largest_table, pi, version, vertical_slope
    use base_kinds, only: dp
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    real(real128), parameter :: machin = &
        16*atan(1.0_real128/5) - 4*atan(1.0_real128/239)

    call tap%near(pi, real(machin, dp), 0.0_dp, 'pi is the double nearest to Machin''s formula')
    call tap%ok(abs(degrees - real(180/machin, dp)) <= spacing(degrees), &
        'a radian is 180/pi degrees')
    call tap%near(degrees*atan(1.0_dp), 45.0_dp, 1.0e-14_dp, 'the slope 1 is 45 degrees')
    call tap%near(vertical_slope, 999.99_dp, 0.0_dp, &
        'a vertical slope is 999.99, as the book has it')
    call tap%ok(999.999_dp >= vertical_slope, 'the largest slope that fits F8.3 counts as vertical')
    call tap%ok(largest_table >= 100000 .and. largest_table < 2**24, &
        'a long table can be counted')
    call tap%ok(verify(version, '0123456789.') == 0, 'the version is made of numbers and points')
    call tap%finish()
end program test_constants
