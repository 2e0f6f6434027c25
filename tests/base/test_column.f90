!> Columns of numbers, against the runtime's own F format.
program test_column
    use base_column, only: put_column
    use base_figures, only: figure_count
    use base_kinds, only: dp, i64
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    !> Columns of a row, and the last that a number fills.
    integer, parameter :: width = 40, last = 36

    type(tap_type) :: tap

    call check_by_hand()
    call check_small()
    call check_random()
    call tap%finish()

contains

    !> Rows by hand.
    subroutine check_by_hand()
        character(3*15) :: text

        text = repeat('**************#', 3)
        call put_column([123456_i64, -123456_i64, 0_i64], 4, 14, 15, text)
        call tap%same(text, '*****  12.3456#***** -12.3456#*****   0.0000#', &
            'numbers stand under one another and fill four columns before the point')
        text = repeat('**************#', 3)
        call put_column([-99999999_i64, -12345678_i64, 123456789012_i64], 4, 14, 15, text)
        call tap%same(text, '****-9999.9999#****-1234.5678#*12345678.9012#', &
            'a minus and larger numbers take the columns they need')
    end subroutine check_by_hand

    !> All numbers of few figures, both signs, with all counts of decimals.
    subroutine check_small()
        integer(i64) :: number
        integer :: decimals, wrong

        wrong = 0
        do decimals = 4, 8
            do number = 0, 12000
                wrong = wrong + count_wrong(number, decimals)
                wrong = wrong + count_wrong(10_i64**int(decimals, i64)*number + 12000_i64 &
                    - number, decimals)
            end do
        end do
        call tap%ok(wrong == 0, 'all groups of four figures, before the point and behind it')
    end subroutine check_small

    !> Numbers of all lengths, and their neighbours of another length.
    subroutine check_random()
        type(random_type) :: random
        integer(i64) :: number
        integer :: i, wrong

        wrong = 0
        do i = 1, 20000
            number = int(10.0_dp**random%between(0.0_dp, 18.0_dp), i64)
            if (random%one_in(4)) then
                number = 10_i64**int(figure_count(number/10), i64)
                if (random%one_in(2)) number = number - 1_i64
            end if
            wrong = wrong + count_wrong(number, 4 + mod(i, 5))
        end do
        call tap%ok(wrong == 0, '20000 numbers of up to 18 figures with 4 to 8 decimals')
    end subroutine check_random

    !> How many of a number and its negative come out wrong: 0 to 2.
    integer function count_wrong(number, decimals) result(wrong)
        integer(i64), intent(in) :: number !! not negative
        integer, intent(in) :: decimals    !! 4 to 8
        character(2*width) :: text
        character(width) :: expected(2)
        integer :: i

        text = ''
        call put_column([number, -number], decimals, last, width, text)
        expected(1) = written(number, decimals)
        expected(2) = expected(1)
        if (number > 0) then
            i = verify(expected(1), ' ') - 1
            expected(2)(i:i) = '-'
        end if
        wrong = count([text(:width), text(width + 1:)] /= expected)
    end function count_wrong

    !> A number of units of its last decimal, by the runtime.
    function written(number, decimals) result(line)
        integer(i64), intent(in) :: number  !! not negative
        integer, intent(in) :: decimals     !! figures behind the point
        character(width) :: line
        character(32) :: figures
        character(8) :: format

        write (format, '(a,i0,a)') '(i0.', decimals + 1, ')'
        write (figures, format) number
        associate (point => len_trim(figures) - decimals)
            figures = figures(:point)//'.'//figures(point + 1:)
        end associate
        line = ''
        line(last - len_trim(figures) + 1:last) = trim(figures)
    end function written

end program test_column
