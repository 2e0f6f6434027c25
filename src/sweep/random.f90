!> Chance that is the same on every machine: the combined generator of L'Ecuyer, in whole numbers
!> that no product overflows.
!>
!> Source: P. L'Ecuyer, "Efficient and portable combined random number generators", Communications
!> of the ACM 31 (1988), pp. 742-749 and 774: s1 = 40014 s1 mod 2147483563, s2 = 40692 s2 mod
!> 2147483399, z = s1 - s2; its period is 2.3E18.
module sweep_random
    use base_kinds, only: dp, i64
    implicit none (type, external)
    private

    public :: random_type, new_random, next_share, shuffled

    !> Moduli and factors of the two sequences.
    integer(i64), parameter :: modulus(2) = [2147483563_i64, 2147483399_i64], &
        factor(2) = [40014_i64, 40692_i64]
    !> Numbers that are passed over at the start, so that seeds side by side part.
    integer, parameter :: run_in = 20

    !> A generator: where its two sequences are.
    type :: random_type
        integer(i64) :: state(2) = 1 !! each from 1 to its modulus less 1
    end type random_type

contains

    !> A generator; two with another seed or stream give other numbers.
    pure type(random_type) function new_random(seed, stream) result(random)
        integer, intent(in) :: seed     !! not negative
        integer, intent(in) :: stream   !! not negative
        real(dp) :: ignored
        integer :: i

        random%state(1) = 1_i64 + modulo(int(seed, i64), modulus(1) - 1_i64)
        random%state(2) = 1_i64 + modulo(int(stream, i64)*69069_i64 + int(seed, i64), &
            modulus(2) - 1_i64)
        do i = 1, run_in
            call next_share(random, ignored)
        end do
    end function new_random

    !> The next number, above 0 and below 1, evenly spread.
    pure subroutine next_share(random, share)
        type(random_type), intent(inout) :: random  !! the generator
        real(dp), intent(out) :: share              !! the number
        integer(i64) :: z

        random%state = modulo(factor*random%state, modulus)
        z = random%state(1) - random%state(2)
        if (z < 1_i64) z = z + modulus(1) - 1_i64
        share = real(z, dp)/real(modulus(1), dp)
    end subroutine next_share

    !> The numbers from 1 to a count in an order by chance (Fisher and Yates).
    pure subroutine shuffled(random, order)
        type(random_type), intent(inout) :: random  !! the generator
        integer, intent(out) :: order(:)            !! 1 to its size, each once
        real(dp) :: share
        integer :: i, k

        order = [(i, i = 1, size(order))]
        do i = size(order), 2, -1
            call next_share(random, share)
            k = 1 + min(i - 1, int(share*real(i, dp)))
            order([i, k]) = order([k, i])
        end do
    end subroutine shuffled

end module sweep_random
