!> Numbers as figures: against the runtime's own formats, and the shortest figures against every
!> shorter one.
program test_digits
    use, intrinsic :: ieee_arithmetic, only: ieee_negative_inf, ieee_positive_inf, ieee_quiet_nan, &
        ieee_value
    use base_kinds, only: dp, i64
    use base_text, only: to_text
    use base_digits, only: fixed, put_fixed, scientific, shortest
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_fixed()
    call check_fixed_against_runtime()
    call check_scientific()
    call check_shortest()
    call check_shortest_form()
    call check_powers_of_two()
    call check_random_patterns()
    call check_extremes()
    call check_short_decimals()
    call check_no_numbers()
    call tap%finish()

contains

    !> What is no finite number is never printed as one.
    subroutine check_no_numbers()
        real(dp) :: value(3)
        integer :: i

        value = ieee_value(0.0_dp, [ieee_quiet_nan, ieee_positive_inf, ieee_negative_inf])
        do i = 1, 3
            call tap%same(fixed(value(i), 9, 3)//scientific(value(i), 9, 2)//shortest(value(i)), &
                '      NaN      NaNNaN', 'what is no number is said as such, '//to_text(i))
        end do
    end subroutine check_no_numbers

    !> Fixed decimals by hand.
    subroutine check_fixed()
        character(40) :: line
        integer :: next

        call tap%same(fixed(11.9_dp, 9, 3), '   11.900', 'a number stands at the right')
        call tap%same(fixed(-0.5_dp, 9, 3), '   -0.500', 'a zero stands before the point')
        call tap%same(fixed(0.0_dp, 9, 3), '    0.000', 'zero is a plain zero')
        call tap%same(fixed(-0.0_dp, 9, 3), '    0.000', 'minus zero too')
        call tap%same(fixed(-0.0004999_dp, 9, 3), '    0.000', 'so is what rounds to it')
        call tap%same(fixed(-0.0005001_dp, 9, 3), '   -0.001', 'but no more than that')
        call tap%same(fixed(-10.0_dp, 9, 0), '     -10.', 'no decimals leave the point')
        call tap%same(fixed(0.125_dp, 9, 2), '     0.12', &
            'a half goes to the even figure, as the runtime rounds')
        call tap%same(fixed(0.375_dp, 9, 2), '     0.38', 'up or down')
        call tap%same(fixed(99999.999_dp, 9, 3), '99999.999', 'a number may fill its columns')
        call tap%same(fixed(-9999.9999_dp, 9, 3), '  -1.E+04', &
            'one too wide after rounding has a power of ten')
        call tap%same(fixed(123456.789_dp, 9, 3), '   1.E+05', 'as few figures as fit')
        call tap%same(fixed(-123456.789_dp, 14, 9), '  -1.23457E+05', 'or as many')
        call tap%same(fixed(huge(1.0_dp), 12, 3), '  1.798E+308', 'the largest number fits')
        call tap%same(fixed(-huge(1.0_dp), 9, 3), ' -2.E+308', 'in any columns')
        line = 'ab'
        next = 3
        call put_fixed(-7.1_dp, 3, line, next)
        call put_fixed(0.5_dp, 0, line, next)
        call tap%same(line(:next), 'ab-7.1000. ', 'numbers one behind the other')
        next = 1
        call put_fixed(1.0e20_dp, 3, line, next)
        call tap%same(line(:next - 1), '1.0000000E+20', 'a long one has a power of ten')
    end subroutine check_fixed

    !> Random numbers against the F format with a zero before the point.
    subroutine check_fixed_against_runtime()
        type(random_type) :: random
        real(dp) :: x
        character(16) :: expected
        integer :: i, wrong

        wrong = 0
        do i = 1, 50000
            x = random%sign()*10.0_dp**random%between(-6.0_dp, 9.0_dp)
            if (random%one_in(3)) x = anint(x*16.0_dp)/16.0_dp
            write (expected, '(f16.3)') x
            if (verify(expected, ' -0.') == 0) expected = '           0.000'
            if (fixed(x, 16, 3) /= expected) wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, '50000 random numbers print as the runtime prints them')
    end subroutine check_fixed_against_runtime

    !> Figures with a power of ten.
    subroutine check_scientific()
        call tap%same(scientific(0.00000088_dp, 14, 6), '   8.80000E-07', 'six figures')
        call tap%same(scientific(-1234.5_dp, 14, 3), '     -1.23E+03', 'three figures')
        call tap%same(scientific(-0.0_dp, 12, 2), '     0.0E+00', 'minus zero is zero')
        call tap%same(scientific(9.9996_dp, 12, 4), '   1.000E+01', &
            'rounding up may move the point')
        call tap%same(scientific(9.9996e99_dp, 12, 4), '  1.000E+100', &
            'also into a power of three figures')
        call tap%same(scientific(9.9996e-100_dp, 12, 4), '   1.000E-99', 'and out of one')
        call tap%same(scientific(-huge(1.0_dp), 23, 16), '-1.797693134862316E+308', &
            'the columns may just do')
        call tap%same(scientific(transfer(1_i64, 0.0_dp), 10, 3), ' 4.94E-324', &
            'the smallest number')
    end subroutine check_scientific

    !> Shortest figures by hand.
    subroutine check_shortest()
        call tap%same(shortest(-30.0_dp), '-30', 'a whole number has no point')
        call tap%same(shortest(0.1_dp), '0.1', 'a tenth')
        call tap%same(shortest(0.1_dp + 0.2_dp), '0.30000000000000004', 'the sum of .1 and .2')
        call tap%same(shortest(1.0_dp/3.0_dp), '0.3333333333333333', 'a third')
        call tap%same(shortest(0.0_dp)//shortest(-0.0_dp), '00', 'zeros of either sign')
        call tap%same(shortest(9007199254740993.0_dp), '9007199254740992', '2**53')
        call tap%same(shortest(1.0e23_dp), '1e+23', 'a half way point whose last bit is even')
        call tap%same(shortest(5.0e-324_dp), '5e-324', 'the smallest number has one figure')
        call tap%same(shortest(huge(1.0_dp)), '1.7976931348623157e+308', &
            'the largest has seventeen')
        call tap%same(shortest(tiny(1.0_dp)), '2.2250738585072014e-308', &
            'so has the smallest normal one')
        call tap%same(shortest(2.0_dp**(-44)), '5.684341886080802e-14', &
            'beside a power of two the next decimal but one may do')
        call tap%same(shortest(2715349678845709.0_dp/4.0_dp), '678837419711427.2', &
            'of two as near the even one')
        call tap%same(shortest(-19.638_dp), '-19.638', 'a number of the book')
    end subroutine check_shortest

    !> Where the point stands and when a power of ten is written.
    subroutine check_shortest_form()
        call tap%same(shortest(1.0e15_dp), '1000000000000000', 'zeros in front of the point')
        call tap%same(shortest(-1.5e15_dp), '-1500000000000000', 'and behind figures')
        call tap%same(shortest(1.0e16_dp), '1e+16', &
            'seventeen figures before the point are too many')
        call tap%same(shortest(1.25e-5_dp), '0.0000125', 'four zeros behind the point are not')
        call tap%same(shortest(1.25e-6_dp), '1.25e-06', 'five are')
        call tap%same(shortest(123456789.125_dp), '123456789.125', 'a point between figures')
        call tap%same(shortest(-1.0e100_dp), '-1e+100', 'a power of three figures')
    end subroutine check_shortest_form

    !> All powers of two and their neighbours: the gap below is half of that above.
    subroutine check_powers_of_two()
        integer(i64) :: pattern
        integer :: e, wrong
        wrong = 0
        do e = 1, 2046
            pattern = ishft(int(e, i64), 52)
            if (.not. is_shortest(transfer(pattern, 0.0_dp))) wrong = wrong + 1
            if (.not. is_shortest(transfer(pattern - 1_i64, 0.0_dp))) wrong = wrong + 1
            if (.not. is_shortest(-transfer(pattern + 1_i64, 0.0_dp))) wrong = wrong + 1
        end do
        do e = 0, 51
            if (.not. is_shortest(transfer(ishft(1_i64, e), 0.0_dp))) wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, 'all powers of two and their neighbours are shortest')
    end subroutine check_powers_of_two

    !> Random bit patterns, of all sizes and of those that tables have.
    subroutine check_random_patterns()
        type(random_type) :: random
        real(dp) :: x
        integer :: i, wrong_any, wrong_usual, wrong_subnormal

        wrong_any = 0
        wrong_usual = 0
        wrong_subnormal = 0
        do i = 1, 5000
            x = transfer(int(random%unit()*2046.0_dp*2.0_dp**52, &
                i64) + nint(random%unit()*1023.0_dp, i64), 0.0_dp)
            if (.not. is_shortest(random%sign()*x)) wrong_any = wrong_any + 1
            x = random%sign()*random%unit()*10.0_dp**nint(random%between(-13.0_dp, 16.0_dp))
            if (.not. is_shortest(x)) wrong_usual = wrong_usual + 1
            x = transfer(int(2.0_dp**random%between(0.0_dp, 52.0_dp), i64), 0.0_dp)
            if (.not. is_shortest(x)) wrong_subnormal = wrong_subnormal + 1
        end do
        call tap%ok(wrong_any == 0, 'random numbers of all sizes are shortest')
        call tap%ok(wrong_usual == 0, 'random numbers of usual sizes are shortest')
        call tap%ok(wrong_subnormal == 0, 'random subnormal numbers are shortest')
    end subroutine check_random_patterns

    !> Powers of ten and their neighbours, where the count of figures changes.
    subroutine check_extremes()
        real(dp) :: x
        integer :: e, wrong
        wrong = 0
        do e = -300, 300
            x = 10.0_dp**e
            if (.not. is_shortest(x)) wrong = wrong + 1
            if (.not. is_shortest(nearest(x, 1.0_dp))) wrong = wrong + 1
            if (.not. is_shortest(nearest(x, -1.0_dp))) wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, 'powers of ten and their neighbours are shortest')
    end subroutine check_extremes

    !> Decimals of up to 15 figures come back as they were written.
    subroutine check_short_decimals()
        type(random_type) :: random
        character(:), allocatable :: text
        real(dp) :: x
        integer(i64) :: figures
        integer :: i, wrong

        wrong = 0
        do i = 1, 20000
            figures = int(10.0_dp**random%between(0.0_dp, 15.0_dp), i64)
            if (mod(figures, 10_i64) == 0) figures = figures + 1
            text = to_text(figures)
            if (len(text) > 1 .and. random%one_in(2)) text = text(:len(text)/2)//'.'// &
                text(len(text)/2 + 1:)
            read (text, *) x
            if (shortest(x) /= text) wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, '20000 decimals of up to 15 figures come back as written')
    end subroutine check_short_decimals

    !> True where the figures read back as the number, and no decimal with a figure less does:
    !> neither of the two around the number. Nor is any of as many figures nearer to it.
    logical function is_shortest(x)
        real(dp), intent(in) :: x !! the number
        character(:), allocatable :: text
        character(40) :: best
        integer :: count

        text = shortest(x)
        count = figures_of(text)
        is_shortest = transfer(read_back(text), 0_i64) == transfer(x, 0_i64)
        if (count > 1) is_shortest = is_shortest .and. .not. any_reads_back(x, count - 1)
        write (best, '(es40.'//to_text(count - 1)//'e3)') x
        if (transfer(read_back(best), 0_i64) == transfer(x, 0_i64)) is_shortest = is_shortest &
            .and. &
            same_decimal(text, best)
        if (.not. is_shortest) call tap%note('not shortest: '//text)
    end function is_shortest

    !> True where a decimal of so many figures reads as the number: that next below or above it.
    logical function any_reads_back(x, count)
        real(dp), intent(in) :: x    !! the number
        integer, intent(in) :: count !! figures
        character(40) :: below, above
        write (below, '(rd,es40.'//to_text(count - 1)//'e3)') x
        write (above, '(ru,es40.'//to_text(count - 1)//'e3)') x
        any_reads_back = transfer(read_back(below), 0_i64) == transfer(x, 0_i64) .or. &
            transfer(read_back(above), 0_i64) == transfer(x, 0_i64)
    end function any_reads_back

    !> The number that a text reads as. Beyond the largest number the runtime would stop: a
    !> decimal there reads as no number that is asked about.
    real(dp) function read_back(text)
        character(*), intent(in) :: text !! a decimal
        read_back = 0.0_dp
        if (index(text, 'E+308') > 0 .or. index(text, 'e+308') > 0) then
            if (llt('1.7976931348623158', adjustl(text)) .and. index(text, '-') == 0) return
            if (llt('-1.7976931348623158', adjustl(text)) .and. index(text, '-') > 0) return
        end if
        read (text, *) read_back
    end function read_back

    !> Figures of a decimal, zeros at its ends not counted.
    integer function figures_of(text)
        character(*), intent(in) :: text !! a decimal
        character(:), allocatable :: plain
        plain = figures_alone(text)
        figures_of = len(plain)
    end function figures_of

    !> True where two decimals of nearly the same size have the same figures.
    logical function same_decimal(a, b)
        character(*), intent(in) :: a !! a decimal
        character(*), intent(in) :: b !! another
        same_decimal = figures_alone(a) == figures_alone(b)
    end function same_decimal

    !> The figures of a decimal without sign, point, exponent and zeros at its ends.
    function figures_alone(text) result(plain)
        character(*), intent(in) :: text !! a decimal
        character(:), allocatable :: plain
        integer :: i
        plain = ''
        do i = 1, scan(text//'E', 'eE') - 1
            if (scan(text(i:i), '0123456789') > 0) plain = plain//text(i:i)
        end do
        plain = plain(verify(plain, '0'):verify(plain, '0', back=.true.))
    end function figures_alone

end program test_digits
