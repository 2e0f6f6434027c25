!> Powers of ten in 126 bits against quadruple precision, and against whole numbers where exact.
program test_power
    use, intrinsic :: iso_fortran_env, only: real128
    use base_kinds, only: i128, i64
    use base_power, only: decade_of_binary, half_bits, power_of_ten, power_type, product_with
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_size()
    call check_whole()
    call check_decades()
    call check_product()
    call tap%finish()

contains

    !> Every power is what quadruple precision says.
    subroutine check_size()
        type(power_type) :: power
        real(real128) :: ratio
        integer :: k, wrong, short

        wrong = 0
        short = 0
        do k = -320, 351
            power = power_of_ten(k)
            ratio = (real(power%high, real128)*2.0_real128**half_bits + real(power%low, real128)) &
                *2.0_real128**power%binary/10.0_real128**k
            if (abs(ratio - 1.0_real128) > 1.0e-31_real128) wrong = wrong + 1
            if (power%high < 2_i64**62 .or. power%low < 0) short = short + 1
        end do
        call tap%ok(wrong == 0, 'powers of ten from -320 to 351 are right in 103 bits')
        call tap%ok(short == 0, 'all fill their 126 bits')
    end subroutine check_size

    !> Powers up to 10**37, which 128 bits hold as they are.
    subroutine check_whole()
        type(power_type) :: power
        integer(i128) :: both, exact
        integer :: k, wrong

        wrong = 0
        do k = 0, 37
            power = power_of_ten(k)
            both = shiftl(int(power%high, i128), half_bits) + int(power%low, i128)
            exact = 10_i128**int(k, i128)
            if (power%binary <= 0) then
                if (shiftl(shiftr(both, -power%binary), -power%binary) /= both) wrong = wrong + 1
                both = shiftr(both, -power%binary)
            end if
            if (both /= exact) wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, 'powers up to 10**37 are exact')
    end subroutine check_whole

    !> Decades of powers of two, by counting in quadruple precision.
    subroutine check_decades()
        real(real128) :: two
        integer :: e, wrong

        wrong = 0
        do e = -1100, 1100
            two = 2.0_real128**e
            if (decade_of_binary(e, .false.) /= decade(two)) wrong = wrong + 1
            if (decade_of_binary(e, .true.) /= decade(0.75_real128*two)) wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, 'decades of powers of two, and of three quarters of them')
    end subroutine check_decades

    !> The greatest k with 10**k at most a number.
    pure integer function decade(number) result(k)
        real(real128), intent(in) :: number !! positive
        k = nint(log10(number)) - 1
        do while (10.0_real128**(k + 1) <= number)
            k = k + 1
        end do
    end function decade

    !> A product by hand: 3 times 10**2 is 300.
    subroutine check_product()
        type(power_type) :: hundred
        hundred = power_of_ten(2)
        call tap%ok(product_with(hundred, 3_i64) == shiftl(300_i128, -hundred%binary - half_bits), &
            'three times a hundred')
    end subroutine check_product

end program test_power
