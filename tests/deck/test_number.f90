!> Numbers of card fields: by the FORTRAN rules worked by hand, against the runtime's own read with
!> blanks as zeros, and everything that is no number.
program test_number
    use base_decimal, only: to_real
    use base_kinds, only: dp, i64
    use deck_number, only: number_type, read_number
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_plain()
    call check_blanks()
    call check_exponents()
    call check_whole()
    call check_slips()
    call check_strangers()
    call check_bad_exponents()
    call check_range()
    call check_against_runtime()
    call tap%finish()

contains

    !> Points, signs and implied decimals.
    subroutine check_plain()
        call value('-30.    ', 3, -30_i64, 0, 'a punched point wins')
        call value('  -30.00', 3, -3000_i64, -2, 'decimals are kept as punched')
        call value('.114', 3, 114_i64, -3, 'no figure before the point')
        call value('-.5', 3, -5_i64, -1, 'nor between sign and point')
        call value('+7.', 3, 7_i64, 0, 'a plus sign')
        call value('- 7.', 3, -7_i64, 0, 'a blank behind the sign is nothing')
        call value('     -30', 3, -30_i64, -3, &
            'without a point the last three columns are decimals')
        call value('   12345', 5, 12345_i64, -5, 'or the last five')
        call value('00001.50', 3, 150_i64, -2, 'zeros in front are nothing')
        call value('        ', 3, 0_i64, 0, 'a blank field is zero')
        call value('    -0.0', 3, 0_i64, 0, 'minus zero is zero')
        call value('', 3, 0_i64, 0, 'a field of no columns is zero')
        call tap%ok(is_blank('   ') .and. .not. is_blank(' 0 '), &
            'a blank field is told from a zero')
        call tap%ok(has_point('1.') .and. .not. has_point('1'), 'a punched point is seen')
        call value('999999999999999999', 0, 999999999999999999_i64, 0, 'eighteen figures are read')
        call value('000000000000000000000000012', 0, 12_i64, 0, 'zeros in front are no figures')
    end subroutine check_plain

    !> Blanks that count as zeros.
    subroutine check_blanks()
        call value('-30     ', 3, -3000000_i64, -3, 'a blank behind a figure is a zero')
        call value('1 2', 3, 102_i64, -3, 'also between figures')
        call value('1 .5', 3, 105_i64, -1, 'also before the point')
        call value('1. 5', 3, 105_i64, -2, 'also behind it')
        call value(' . 5', 3, 5_i64, -2, 'also where no figure is before it')
        call tap%ok(filled('5 ') .and. filled('1 2') .and. filled('1 .') .and. filled('1. 5') &
            .and. filled('. 5') .and. filled('1 E2') .and. filled('1.E2 '), &
            'blanks that change the number are seen')
        call tap%ok(.not. any([filled('5'), filled(' 5'), filled('5.  '), filled('- 5'), &
            filled('0 5'), &
            filled('1.  E2'), filled('1.E 2'), filled('1.E+ 2'), filled('0. ')]), &
            'blanks that do not are not')
    end subroutine check_blanks

    !> Exponents.
    subroutine check_exponents()
        call value('1.5E2', 3, 15_i64, 1, 'a letter E')
        call value('1.5d-2', 3, 15_i64, -3, 'a small letter d and a sign')
        call value('15.+1', 3, 15_i64, 1, 'a bare sign')
        call value('15-1', 3, 15_i64, -4, 'implied decimals and an exponent')
        call value('1.E+02', 3, 1_i64, 2, 'a sign and zeros')
        call value('1 E2', 3, 10_i64, -1, 'a blank before the letter is a zero')
        call value('1.E 2', 3, 1_i64, 2, 'a blank behind the letter is one in front')
        call value('1.E2 ', 3, 1_i64, 20, 'a blank behind the exponent is a zero')
        call value('0.E99999', 3, 0_i64, 0, 'zero has no size')
    end subroutine check_exponents

    !> The I format.
    subroutine check_whole()
        call value(' 1', -1, 1_i64, 0, 'a whole number')
        call value('1 ', -1, 10_i64, 0, 'with a blank behind it')
        call value('-1', -1, -1_i64, 0, 'with a sign')
        call refused('1.', -1, 2, 2, 'a point in a whole number')
        call refused('1E', -1, 2, 2, 'an exponent in a whole number')
        call refused('1+', -1, 2, 2, 'a sign inside the number')
        call refused(' -', -1, 2, 2, 'there is no figure in the number')
        call refused(' Y', -1, 2, 2, &
            '''Y'' in a number; figures, a sign, a point and an exponent are read')
    end subroutine check_whole

    !> Slips of the key.
    subroutine check_slips()
        call refused('  1.2.3 ', 3, 6, 6, 'a second point in the number')
        call refused('22.    .', 3, 8, 8, &
            'a second number in the field; each stands in columns of its own')
        call refused('3-0-1', 3, 4, 4, 'a sign inside the number')
        call refused('+-5.', 3, 2, 2, 'a sign inside the number')
        call refused('1--5', 3, 3, 3, 'a sign inside the number')
        call refused('  .     ', 3, 3, 3, 'there is no figure in the number')
        call refused('   - .  ', 3, 4, 6, 'there is no figure in the number')
        call refused('-', 3, 1, 1, 'there is no figure in the number')
        call refused('1234567890123456789', 3, 19, 19, 'the number has more than 18 figures')
        call refused('123456789012345678 ', 3, 19, 19, 'the number has more than 18 figures')
    end subroutine check_slips

    !> Characters that no number has.
    subroutine check_strangers()
        character(*), parameter :: others = '!"#$%&''()*:;<=>?@ABCFGHJKMNPQRSTUVWXYZ[\]^_`{|}~'
        integer :: i

        call refused('  O.5', 3, 3, 3, 'the letter O in a number; the figure is 0')
        call refused('  5o.', 3, 4, 4, 'the letter O in a number; the figure is 0')
        call refused('l0.', 3, 1, 1, 'the letter L in a number; the figure is 1')
        call refused('1I.', 3, 2, 2, 'the letter I in a number; the figure is 1')
        call refused('.04IN', 3, 4, 5, &
            '''IN'' in a number; figures, a sign, a point and an exponent are read')
        call refused('22 1/2', 3, 5, 5, &
            'a fraction in a number; it is written with decimals, 1/2 as .5')
        call refused('12,5', 3, 3, 3, &
            'a comma in a number; the point is a full stop and fields go by columns')
        do i = 1, len(others)
            call refused('1'//others(i:i), 3, 2, 2, ''''//others(i:i)// &
                ''' in a number; figures, a sign, a point and an exponent are read')
        end do
        call refused('12'//achar(9), 3, 3, 3, &
            'byte 09 (hexadecimal) in a number; only plain ASCII figures, signs and points '// &
            'are read')
        call refused(char(226)//char(136)//char(146)//'5.', 3, 1, 1, &
            'byte E2 (hexadecimal) in a number; only plain ASCII figures, signs and points '// &
            'are read')
        call refused('1'//achar(127), 3, 2, 2, &
            'byte 7F (hexadecimal) in a number; only plain ASCII figures, signs and points '// &
            'are read')
        call refused(char(255), 3, 1, 1, &
            'byte FF (hexadecimal) in a number; only plain ASCII figures, signs and points '// &
            'are read')
    end subroutine check_strangers

    !> Exponents that are none.
    subroutine check_bad_exponents()
        character(*), &
            parameter :: homeless = 'the exponent letter stands where no figure is before it'

        call refused('1.5E', 3, 4, 4, 'the exponent has no figures')
        call refused('1.5E    ', 3, 4, 4, 'the exponent has no figures')
        call refused('1.5E-   ', 3, 5, 5, 'the exponent has no figures')
        call refused('5-      ', 3, 2, 2, 'the exponent has no figures')
        call refused('  E5', 3, 3, 3, homeless)
        call refused('-E5', 3, 2, 2, homeless)
        call refused('.D5', 3, 2, 2, homeless)
        call refused('. E5', 3, 3, 3, homeless)
        call refused('1E5E5', 3, 4, 4, 'a second exponent letter in the number')
        call refused('1+E5', 3, 3, 3, 'a second exponent letter in the number')
        call refused('1E1.5', 3, 4, 4, 'a point in the exponent')
        call refused('1E--5', 3, 4, 4, 'a sign inside the number')
        call refused('1E5-', 3, 4, 4, 'a sign inside the number')
    end subroutine check_bad_exponents

    !> Sizes.
    subroutine check_range()
        call value('1.E80', 3, 1_i64, 80, 'the largest power of ten')
        call value('1.E-80', 3, 1_i64, -80, 'the smallest')
        call refused(' 1.E81', 3, 2, 6, 'the number is out of range')
        call refused('1.0E-80', 3, 1, 7, 'the number is out of range')
        call refused('1.E999999999999', 3, 1, 15, 'the number is out of range')
        call refused(' 1.E9   ', 3, 2, 5, &
            'the number is out of range; a blank behind its exponent is a zero')
    end subroutine check_range

    !> Random fields. What we read, the runtime reads, and as the same number.
    subroutine check_against_runtime()
        character(*), parameter :: alphabet = '0123456789012345678    ...-+E'
        type(random_type) :: random
        type(number_type) :: number
        character(8) :: field
        real(dp) :: expected
        integer :: i, j, k, status, sound, wrong

        sound = 0
        wrong = 0
        do i = 1, 200000
            do j = 1, 8
                k = 1 + int(random%unit()*len(alphabet))
                field(j:j) = alphabet(k:k)
            end do
            number = read_number(field, 3)
            ! The runtime knows no zero with a large exponent.
            if (number%first > 0 .or. number%value%digits == 0) cycle
            sound = sound + 1
            read (field, '(bz,f8.3)', iostat=status) expected
            if (status /= 0 .or. to_real(number%value) /= expected) then
                wrong = wrong + 1
                if (wrong < 5) call tap%note('field ['//field//']')
            end if
        end do
        call tap%ok(wrong == 0 .and. sound > 50000, &
            'random fields are read as the runtime reads them')
    end subroutine check_against_runtime

    !> A field that is a number: digits and power of ten. Zeros may stand behind them.
    subroutine value(field, implied, digits, power, name)
        character(*), intent(in) :: field !! the field
        integer, intent(in) :: implied    !! implied decimals
        integer(i64), intent(in) :: digits !! digits expected
        integer, intent(in) :: power      !! power expected
        character(*), intent(in) :: name  !! the check as a phrase
        type(number_type) :: number
        integer :: finer
        number = read_number(field, implied)
        finer = max(0, power - number%value%power)
        call tap%ok(number%first == 0 .and. number%value%power + finer == power .and. &
            number%value%digits == digits*10_i64**int(finer, i64), name//' ['//field//']')
    end subroutine value

    !> A field that is no number: which characters are at fault and what is said. Without words any
    !> fault will do.
    subroutine refused(field, implied, first, last, words)
        character(*), intent(in) :: field !! the field
        integer, intent(in) :: implied    !! implied decimals
        integer, intent(in) :: first      !! first character at fault
        integer, intent(in) :: last       !! last character at fault
        character(*), intent(in) :: words !! the trouble
        type(number_type) :: number
        number = read_number(field, implied)
        if (number%first == 0) then
            call tap%ok(.false., 'no number: ['//field//']')
            return
        end if
        call tap%ok((first == 0 .or. number%first == first .and. number%last == last) &
            .and. number%value%digits == 0 .and. number%value%power == 0, &
            'no number: ['//field//']')
        if (words /= '') call tap%same(number%trouble, words, 'what is said of ['//field//']')
    end subroutine refused

    !> True where a blank of the field counts as a zero that changes the number.
    logical function filled(field)
        character(*), intent(in) :: field !! the field
        type(number_type) :: number
        number = read_number(field, 3)
        filled = number%has_filled_blank .and. number%first == 0
    end function filled

    !> True for a field with nothing punched.
    logical function is_blank(field)
        character(*), intent(in) :: field !! the field
        type(number_type) :: number
        number = read_number(field, 3)
        is_blank = number%is_blank
    end function is_blank

    !> True for a field with a point.
    logical function has_point(field)
        character(*), intent(in) :: field !! the field
        type(number_type) :: number
        number = read_number(field, 3)
        has_point = number%has_point
    end function has_point

end program test_number
