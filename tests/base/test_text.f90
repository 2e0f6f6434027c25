!> Small deeds on text, by hand-worked examples.
program test_text
    use, intrinsic :: ieee_arithmetic, only: ieee_negative_inf, ieee_positive_inf, ieee_quiet_nan, &
        ieee_value
    use base_kinds, only: dp, i64
    use base_text, only: characters, columns, compact, compact_length, counted, first_bytes, &
        limited, printable, right, row_of, to_text, upper, widest_compact
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character(*), parameter :: u_umlaut = char(195)//char(188), &
        inch_mark = char(226)//char(128)//char(179)

    call check_case()
    call check_columns()
    call check_numbers()
    call check_compact()
    call check_characters()
    call tap%same(printable('a'//achar(7)//'b'//achar(9)//achar(127)), 'a?b??', &
        'control bytes show as question marks')
    call tap%same(printable('Grüße'), 'Grüße', 'letters beyond ASCII stay')
    call tap%same(limited('A/b C', 'ABC ', '_'), 'A__ C', 'letters that may not be are another')
    call tap%finish()

contains

    !> Capitals.
    subroutine check_case()
        call tap%same(upper('Nose, sta. 5 [az]{}`@'), 'NOSE, STA. 5 [AZ]{}`@', &
            'letters become capitals')
        call tap%same(upper('abcdefghijklmnopqrstuvwxyz'), 'ABCDEFGHIJKLMNOPQRSTUVWXYZ', &
            'every letter does')
        call tap%same(upper(u_umlaut), u_umlaut, 'bytes beyond ASCII stay')
        call tap%same(upper(''), '', 'nothing stays nothing')
    end subroutine check_case

    !> Columns of a card image.
    subroutine check_columns()
        call tap%same(columns('ABCDEFGH', 3, 5), 'CDE', 'columns are cut out')
        call tap%same(columns('ABCD', 3, 8), 'CD    ', 'a short image has blanks behind it')
        call tap%same(columns('ABCD', 5, 8), '    ', 'columns past the image are blank')
        call tap%same(columns('', 1, 2), '  ', 'so are columns of nothing')
        call tap%same(columns('ABCD', 4, 4), 'D', 'one column is one character')
        call tap%same(columns('ABCD', 9, 4), '', 'no columns are no characters')

        call tap%same(row_of('^', 3), '^^^', 'a row of three')
        call tap%same(row_of('^', 0)//row_of('^', -5), '', 'a row of none, or less')
        call tap%same(right('-1.5', 8), '    -1.5', 'text moves to the right end')
        call tap%same(right('  -1.5  ', 6), '  -1.5', 'blanks around it do not count')
        call tap%same(right('12345', 3), '12345', 'text that needs more columns is whole')
    end subroutine check_columns

    !> Whole numbers and counts.
    subroutine check_numbers()
        integer(i64) :: least

        call tap%same(to_text(0), '0', 'zero')
        call tap%same(to_text(-huge(1)), '-2147483647', 'a whole number below zero')
        call tap%same(to_text(huge(1_i64)), '9223372036854775807', 'the largest long one')
        call tap%same(to_text(-huge(1_i64)), '-9223372036854775807', 'a long one below zero')
        least = -huge(least)
        call tap%same(to_text(least - 1_i64), '-9223372036854775808', 'the least one')
        call tap%same(counted(1_i64, 'card'), '1 card', 'one card')
        call tap%same(counted(0_i64, 'card'), '0 cards', 'no cards')
        call tap%same(counted(3000000000_i64, 'card'), '3000000000 cards', 'very many cards')
    end subroutine check_numbers

    !> Numbers in a sentence.
    subroutine check_compact()
        call tap%same(compact(12.5_dp), '12.5', 'zeros at the end are left out')
        call tap%same(compact(-0.001_dp), '-0.001', 'a zero stands before the point')
        call tap%same(compact(7.0_dp), '7.', 'a whole number keeps its point')
        call tap%same(compact(100.0_dp), '100.', 'zeros before the point stay')
        call tap%same(compact(0.0_dp), '0.', 'zero is a plain zero')
        call tap%same(compact(-0.0_dp), '0.', 'minus zero too')
        call tap%same(compact(0.1_dp + 0.2_dp), '0.3', 'round-off does not show')
        call tap%same(compact(9999999.5_dp), '9999999.5', &
            'seven figures before the point are plain')
        call tap%same(compact(0.0001_dp), '0.0001', 'the smallest plain number')
        call tap%same(compact(3.0e20_dp), '3.E+20', 'a large number has a power of ten')
        call tap%same(compact(-1.25e7_dp), '-1.25E+07', 'from ten million on')
        call tap%same(compact(0.00005_dp), '5.E-05', 'a small number has one')
        call tap%same(compact(huge(1.0_dp)), '1.79769E+308', 'the largest number')
        call tap%same(compact(tiny(1.0_dp)), '2.22507E-308', 'a very small one')
        call tap%same(compact(ieee_value(0.0_dp, ieee_quiet_nan))//' '// &
            compact(ieee_value(0.0_dp, ieee_positive_inf))//' '// &
            compact(ieee_value(0.0_dp, ieee_negative_inf)), 'NaN Inf -Inf', &
            'what is no number is said as such')
        call tap%same(compact(-9999999.5_dp), '-9999999.5', 'one far below zero')
        call tap%ok(all(compact_length([0.0_dp, -0.001_dp, -tiny(1.0_dp), -1234567.890625_dp]) == &
            [2_i64, 6_i64, 13_i64, 15_i64]), 'lengths are said beforehand')
        call tap%ok(compact_length(-1234567.890625_dp) < widest_compact, 'none is longer than said')
    end subroutine check_compact

    !> Characters and bytes of UTF-8.
    subroutine check_characters()
        call tap%ok(characters('') == 0 .and. characters('nose') == 4, &
            'ASCII has a byte a character')
        call tap%ok(characters(u_umlaut//'x'//inch_mark) == 3, 'longer characters count once')
        call tap%ok(first_bytes('nose', 3) == 3, 'three characters of ASCII are three bytes')
        call tap%ok(first_bytes(u_umlaut//'x'//inch_mark, 1) == 2, &
            'the first character may have two bytes')
        call tap%ok(first_bytes(u_umlaut//'x'//inch_mark, 3) == 6, 'three may have six')
        call tap%ok(first_bytes(u_umlaut//'x', 80) == 3, 'a text that has no more is taken whole')
        call tap%ok(first_bytes('', 5) == 0 .and. first_bytes('nose', 0) == 0, &
            'no characters, no bytes')
    end subroutine check_characters

end program test_text
