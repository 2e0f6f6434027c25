!> Whole numbers as figures, against the runtime's own I format.
program test_figures
    use base_figures, only: figure_count, most_decimals, put_text, put_units, put_whole
    use base_kinds, only: dp, i64
    use base_text, only: row_of
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    !> Columns of the lines that are compared.
    integer, parameter :: columns = 32

    type(tap_type) :: tap

    call check_by_hand()
    call check_all_of_eight()
    call check_units()
    call check_whole()
    call tap%finish()

contains

    !> Lines by hand.
    subroutine check_by_hand()
        character(15) :: line
        integer :: next

        line = '**************#'
        call put_units(123456_i64, .true., 4, line, 14)
        call tap%same(line, '*     -12.3456#', 'a number fills eight columns before its point')
        line = ''
        call put_units(0_i64, .false., 4, line, 13)
        call tap%same(line, '       0.0000  ', 'a zero stands before the point')
        call put_units(123456789012_i64, .true., 4, line, 14)
        call tap%same(line, '-12345678.9012 ', 'a minus before eight figures')
        line = 'ab'
        next = 3
        call put_whole(70_i64, line, next)
        call put_text('cd', line, next)
        call tap%same(line(:next), 'ab70cd ', 'a number between letters')
    end subroutine check_by_hand

    !> Numbers of eight figures: each figure in each place, with each neighbour.
    subroutine check_all_of_eight()
        character(20) :: line
        character(8) :: expected
        integer(i64) :: number
        integer :: wrong

        wrong = 0
        do number = 0, 99999999, 997
            call put_units(100000000_i64*number + 99999999_i64 - number, .false., 8, line, 20)
            write (expected, '(i8)') number
            if (line(4:11) /= expected) wrong = wrong + 1
            write (expected, '(i8.8)') 99999999_i64 - number
            if (line(13:20) /= expected) wrong = wrong + 1
        end do
        do number = 0, 9999
            call put_units(10000_i64*number + number, .false., 4, line, 20)
            write (expected, '(i8)') number
            if (line(8:15) /= expected) wrong = wrong + 1
            write (expected, '(i4.4)') number
            if (line(17:20) /= expected(:4)) wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, 'eight figures before the point and eight behind it')
    end subroutine check_all_of_eight

    !> Random numbers of all lengths with all counts of decimals.
    subroutine check_units()
        type(random_type) :: random
        character(columns) :: line, expected
        integer(i64) :: units
        integer :: i, decimals, wrong

        wrong = 0
        do i = 1, 20000
            units = int(10.0_dp**random%between(0.0_dp, 18.0_dp), i64)
            if (random%one_in(4)) then
                units = 10_i64**int(figure_count(units/10), i64)
                if (random%one_in(2)) units = units - 1_i64
            end if
            decimals = mod(i, most_decimals + 1)
            line = ''
            call put_units(units, mod(i, 2) == 0, decimals, line, columns)
            write (expected, '(i0)') units
            expected = row_of('0', decimals + 1 - len_trim(expected))//expected
            associate (point => len_trim(expected) - decimals)
                expected = expected(:point)//'.'//expected(point + 1:)
            end associate
            if (mod(i, 2) == 0) expected = '-'//expected(:columns - 1)
            if (adjustl(line) /= expected) wrong = wrong + 1
            if (line(columns:) == ' ') wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, '20000 numbers of up to 18 figures with up to 12 decimals')
    end subroutine check_units

    !> Random whole numbers.
    subroutine check_whole()
        type(random_type) :: random
        character(columns) :: line, expected
        integer(i64) :: number
        integer :: i, next, wrong

        wrong = 0
        do i = 0, 20000
            number = int(10.0_dp**random%between(0.0_dp, 18.9_dp), i64)
            if (i <= 18) number = 10_i64**int(i, i64)
            if (i > 18 .and. i <= 36) number = 10_i64**int(i - 18, i64) - 1_i64
            if (i == 37) number = 0
            if (i == 38) number = huge(number)
            line = ''
            next = 1
            call put_whole(number, line, next)
            write (expected, '(i0)') number
            if (line /= expected .or. next /= len_trim(expected) + 1) wrong = wrong + 1
            if (figure_count(number) /= len_trim(expected)) wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, 'whole numbers take the columns they need')
    end subroutine check_whole

end program test_figures
