!> A ring folded flat: places of its points such that the matrix of neighbours around it is a band.
module geom_ring_band
    implicit none (type, external)
    private

    public :: folded

contains

    !> Places of the points of a ring such that neighbours are never more than two places apart:
    !> 1, 3, 5 ... 6, 4, 2.
    pure function folded(n) result(place)
        integer, intent(in) :: n    !! points
        integer :: place(n)
        integer :: i
        do i = 1, n
            place(i) = merge(2*i - 1, 2*(n - i + 1), 2*i - 1 <= n)
        end do
    end function folded

end module geom_ring_band
