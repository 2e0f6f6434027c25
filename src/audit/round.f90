!> Round numbers: those with the fewest decimals between two values. What was punched on a card was
!> one of them, as a rule.
module audit_round
    use audit_figure, only: figure_length, form, print_figure, scale_type
    use base_kinds, only: dp, i64
    implicit none (type, external)
    private

    public :: round_numbers, numbers_between

    !> Decimals that are still called round, and numbers of a list.
    integer, parameter :: most_decimals = 12, most_numbers = 99

contains

    !> All numbers with the fewest decimals that have one from `low` to `high`, as texts in order.
    !> None where even `most_decimals` are too few, or where there are more than `most_numbers`.
    pure function round_numbers(low, high) result(texts)
        real(dp), intent(in) :: low  !! least value
        real(dp), intent(in) :: high !! greatest value
        character(figure_length), allocatable :: texts(:)
        integer :: decimals

        allocate (texts(0))
        do decimals = 0, most_decimals
            texts = numbers_between(low, high, decimals)
            if (size(texts) > 0) return
        end do
    end function round_numbers

    !> All numbers with so many decimals from `low` to `high`, as texts in order; none where they
    !> are more than `most_numbers`. An end that is such a number but for rounding counts.
    pure function numbers_between(low, high, decimals) result(texts)
        real(dp), intent(in) :: low      !! least value
        real(dp), intent(in) :: high     !! greatest value
        integer, intent(in) :: decimals  !! how many
        character(figure_length), allocatable :: texts(:)
        real(dp), parameter :: noise = 1.0e-6_dp, most = 1.0e15_dp
        integer(i64) :: first, last
        integer :: i

        allocate (texts(0))
        if (max(abs(low), abs(high))*10.0_dp**decimals > most) return
        first = ceiling(low*10.0_dp**decimals - noise, i64)
        last = floor(high*10.0_dp**decimals + noise, i64)
        if (last < first .or. last - first >= most_numbers) return
        deallocate (texts)
        allocate (texts(last - first + 1))
        do i = 1, size(texts)
            texts(i) = print_figure(first + int(i - 1, i64), scale_type(form%decimal, decimals))
        end do
    end function numbers_between

end module audit_round
