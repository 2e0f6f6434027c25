!> Random numbers for tests, the same on every machine.
!>
!> Source: S. K. Park, K. W. Miller, "Random number generators: good ones are hard to find",
!> CACM 31 (1988), pp. 1192-1201, with the multiplier 48271 of their later note; two draws a number.
module support_random
    use base_kinds, only: dp, i64
    implicit none (type, external)
    private

    public :: random_type

    !> A stream of random numbers.
    type :: random_type
        private
        integer(i64) :: state = 20250117_i64
    contains
        procedure :: unit
        procedure :: between
        procedure :: sign => random_sign
        procedure :: one_in
    end type random_type

    integer(i64), parameter :: modulus = 2147483647_i64

contains

    !> A number from 0 to 1, all 53 bits random.
    real(dp) function unit(random)
        class(random_type), intent(inout) :: random !! the stream
        integer :: i
        unit = 0.0_dp
        do i = 1, 2
            random%state = mod(random%state*48271_i64, modulus)
            unit = (unit + real(random%state, dp))/real(modulus, dp)
        end do
    end function unit

    !> A number between two others.
    real(dp) function between(random, low, high)
        class(random_type), intent(inout) :: random !! the stream
        real(dp), intent(in) :: low                 !! lower end
        real(dp), intent(in) :: high                !! upper end
        between = low + (high - low)*random%unit()
    end function between

    !> 1 or -1.
    real(dp) function random_sign(random)
        class(random_type), intent(inout) :: random !! the stream
        random_sign = sign(1.0_dp, random%unit() - 0.5_dp)
    end function random_sign

    !> True once in so many draws.
    logical function one_in(random, number)
        class(random_type), intent(inout) :: random !! the stream
        integer, intent(in) :: number               !! 2 or more
        one_in = random%unit()*real(number, dp) < 1.0_dp
    end function one_in

end module support_random
