!> `make soak`: fixed decimals of 10**8 random numbers against the runtime's own, on all threads:
!> magnitudes of all fields, every count of decimals, ties and their neighbours among them.
program digits
    use base_kinds, only: dp, i64
    use base_rounding, only: units_of
    use support_tap, only: tap_type
    implicit none (type, external)

    integer, parameter :: blocks = 1000, numbers = 100000, most_decimals = 12
    type(tap_type) :: tap
    integer :: block, wrong

    wrong = 0
    !$omp parallel do default(none) reduction(+:wrong) schedule(dynamic, 1)
    do block = 1, blocks
        wrong = wrong + wrong_of(block)
    end do
    !$omp end parallel do
    call tap%ok(wrong == 0, '10**8 random numbers are rounded as the runtime rounds them')
    call tap%finish()

contains

    !> How many numbers of a block are rounded otherwise than by the runtime.
    integer function wrong_of(block)
        integer, intent(in) :: block !! from 1
        integer(i64) :: state
        real(dp) :: value
        integer :: i, decimals

        wrong_of = 0
        state = 88172645463325252_i64 + 1000003_i64*int(block, i64)
        do i = 1, numbers
            decimals = mod(i, most_decimals + 1)
            value = 10.0_dp**(-decimals - 2 + int(18.0_dp*next(state)))*next(state)
            select case (mod(i/64, 4))
            case (0)
                value = anint(value*2.0_dp**decimals) + 0.5_dp
                value = value/2.0_dp**decimals
            case (1)
                value = (aint(value*10.0_dp**decimals) + 0.5_dp)/10.0_dp**decimals
            end select
            if (value >= 1.0e17_dp/10.0_dp**decimals) cycle
            if (units_of(value, decimals) /= by_runtime(value, decimals)) wrong_of = wrong_of + 1
        end do
    end function wrong_of

    !> A random number below 1 (G. Marsaglia, "Xorshift RNGs", J. Stat. Software 8, 14, 2003).
    real(dp) function next(state)
        integer(i64), intent(inout) :: state !! of the stream, not zero
        state = ieor(state, ishft(state, 13))
        state = ieor(state, ishft(state, -7))
        state = ieor(state, ishft(state, 17))
        next = real(ishft(state, -11), dp)/2.0_dp**53
    end function next

    !> A number in units of its last decimal, as F prints it.
    integer(i64) function by_runtime(value, decimals) result(units)
        real(dp), intent(in) :: value   !! not negative
        integer, intent(in) :: decimals !! 0 to 12
        character(8), parameter :: form(0:most_decimals) = ['(f40.0) ', '(f40.1) ', '(f40.2) ', &
            '(f40.3) ', '(f40.4) ', '(f40.5) ', '(f40.6) ', '(f40.7) ', '(f40.8) ', '(f40.9) ', &
            '(f40.10)', '(f40.11)', '(f40.12)']
        character(40) :: line
        integer :: i

        write (line, form(decimals)) value
        units = 0
        do i = 1, len(line)
            if (line(i:i) >= '0' .and. line(i:i) <= '9') &
                units = 10*units + int(iachar(line(i:i)) - iachar('0'), i64)
        end do
    end function by_runtime

end program digits
