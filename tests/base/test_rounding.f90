!> Rounding to decimals and to figures, against the runtime's own formats: ties, neighbours of ties,
!> numbers that round up to the next power of ten, the largest and the smallest.
program test_rounding
    use base_kinds, only: dp, i64
    use base_rounding, only: figures_of, shortest_figures, units_of
    use base_text, only: to_text
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    integer, parameter :: most_decimals = 12, most_figures = 17, random_numbers = 100000

    type(tap_type) :: tap

    call check_units_of_hard_cases()
    call check_units_of_random_numbers()
    call check_figures()
    call check_shortest()
    call tap%finish()

contains

    !> Ties of every count of decimals that doubles have, and their neighbours on both sides.
    subroutine check_units_of_hard_cases()
        real(dp) :: tie
        integer :: decimals, k, wrong

        wrong = 0
        do decimals = 0, most_decimals
            do k = 0, 999
                ! An odd multiple of a power of one half is a tie where the decimals end before it.
                tie = (real(k, dp) + 0.5_dp)/2.0_dp**decimals
                call count_wrong(tie, decimals, wrong)
                tie = (real(k, dp) + 0.5_dp)/10.0_dp**decimals
                call count_wrong(tie, decimals, wrong)
                tie = real(k + 1, dp)*10.0_dp**mod(k, 5) - 0.5_dp/10.0_dp**decimals
                call count_wrong(tie, decimals, wrong)
                tie = real(2*k + 1, dp)*2.0_dp**(40 - mod(k, 100))
                call count_wrong(tie, decimals, wrong)
            end do
            call count_wrong(9.9995_dp, decimals, wrong)
            call count_wrong(0.0_dp, decimals, wrong)
            call count_wrong(tiny(1.0_dp), decimals, wrong)
            call count_wrong(transfer(1_i64, 1.0_dp), decimals, wrong)
            call count_wrong(9.9e16_dp/10.0_dp**decimals, decimals, wrong)
        end do
        call tap%ok(wrong == 0, 'ties and their neighbours, at 0 to 12 decimals')
        call tap%ok(units_of(huge(1.0_dp), 0) == huge(1_i64) .and. &
            units_of(1.1e17_dp, 0) == huge(1_i64), 'what no field holds is the largest number')
    end subroutine check_units_of_hard_cases

    !> Counts a number and its two neighbours that do not round as the runtime rounds them.
    subroutine count_wrong(x, decimals, wrong)
        real(dp), intent(in) :: x           !! not negative, small enough for a field
        integer, intent(in) :: decimals     !! 0 to 12
        integer, intent(inout) :: wrong     !! the count
        real(dp) :: value
        integer :: side

        do side = -1, 1
            value = x
            if (side /= 0) value = nearest(x, real(side, dp))
            if (value < 0.0_dp .or. value >= 1.0e17_dp/10.0_dp**decimals) cycle
            if (units_of(value, decimals) == units_by_runtime(value, decimals)) cycle
            wrong = wrong + 1
            if (wrong < 5) call tap%note('wrong with '//to_text(decimals)//' decimals')
        end do
    end subroutine count_wrong

    !> A number in units of its last decimal, as F prints it.
    integer(i64) function units_by_runtime(value, decimals) result(units)
        real(dp), intent(in) :: value   !! not negative
        integer, intent(in) :: decimals !! 0 to 12
        character(40) :: line, digits
        integer :: point

        write (line, '(f40.'//to_text(decimals)//')') value
        line = adjustl(line)
        point = index(line, '.')
        digits = line(:point - 1)//line(point + 1:)
        read (digits, '(i40)') units
    end function units_by_runtime

    !> Random numbers of the sizes that tables have.
    subroutine check_units_of_random_numbers()
        type(random_type) :: random
        real(dp) :: x
        integer :: i, decimals, wrong

        wrong = 0
        do i = 1, random_numbers
            decimals = mod(i, most_decimals + 1)
            x = 10.0_dp**random%between(-real(decimals, dp) - 2.0_dp, 16.0_dp - real(decimals, dp))
            if (random%one_in(4)) x = anint(x*1024.0_dp)/1024.0_dp
            if (units_of(x, decimals) /= units_by_runtime(x, decimals)) wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, '100000 random numbers at 0 to 12 decimals')
    end subroutine check_units_of_random_numbers

    !> Counts of figures: random bit patterns, ties, and numbers of nines.
    subroutine check_figures()
        type(random_type) :: random
        real(dp) :: x
        integer :: i, wrong

        wrong = 0
        do i = 1, random_numbers
            x = transfer(int(random%unit()*2046.0_dp*2.0_dp**52, i64) + 1_i64, 0.0_dp)
            if (random%one_in(4)) x = real(1 + int(random%unit()*9999.0_dp), dp) + 0.5_dp
            if (random%one_in(8)) x = 10.0_dp**nint(random%between(-300.0_dp, 300.0_dp))
            if (random%one_in(16)) x = transfer(int(2.0_dp**random%between(0.0_dp, 52.0_dp), i64), &
                0.0_dp)
            if (.not. is_as_runtime(x, 1 + mod(i, most_figures))) wrong = wrong + 1
            if (.not. is_as_runtime(nearest(x, -1.0_dp), 1 + mod(i, most_figures))) &
                wrong = wrong + 1
        end do
        call tap%ok(wrong == 0, '200000 numbers of all sizes at 1 to 17 figures')
    end subroutine check_figures

    !> True where a number rounds to a count of figures as ES prints it.
    logical function is_as_runtime(value, count)
        real(dp), intent(in) :: value !! positive
        integer, intent(in) :: count  !! figures
        character(40) :: line, expected
        integer(i64) :: figures
        integer :: power

        is_as_runtime = .true.
        if (.not. value > 0.0_dp) return
        call figures_of(value, count, figures, power)
        write (expected, '(es40.'//to_text(count - 1)//'e4)') value
        write (line, '(i0)') figures
        line = line(:1)//'.'//line(2:)
        write (line(count + 2:), '(a,sp,i5.4)') 'E', power + count - 1
        is_as_runtime = line == adjustl(expected)
    end function is_as_runtime

    !> Shortest figures as whole numbers; `test_digits` has the proof that they are the shortest.
    subroutine check_shortest()
        integer(i64) :: figures
        integer :: power

        call shortest_figures(0.8_dp, figures, power)
        call tap%ok(figures == 8 .and. power == -1, 'eight tenths')
        call shortest_figures(9007199254740993.0_dp, figures, power)
        call tap%ok(figures == 9007199254740992_i64 .and. power == 0, '2**53')
        call shortest_figures(transfer(1_i64, 1.0_dp), figures, power)
        call tap%ok(figures == 5 .and. power == -324, 'the smallest number')
        call shortest_figures(1.2e23_dp, figures, power)
        call tap%ok(figures == 12 .and. power == 22, 'a number whose product is no tie')
    end subroutine check_shortest

end program test_rounding
