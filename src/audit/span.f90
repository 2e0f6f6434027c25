!> What a few linear equations leave free: an orthonormal basis of the vectors that solve them all.
module audit_span
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: free_basis

    !> An equation that adds less than this to those before it, relative, says nothing new.
    real(dp), parameter :: nothing_new = 1.0e-9_dp

contains

    !> An orthonormal basis of the vectors at right angles to all rows: `basis(:, :free)`.
    pure subroutine free_basis(rows, basis, free)
        real(dp), intent(in) :: rows(:, :)                         !! a column an equation
        real(dp), intent(out) :: basis(size(rows, 1), size(rows, 1)) !! see above
        integer, intent(out) :: free                               !! how many vectors
        real(dp), dimension(size(rows, 1), size(rows, 1)) :: taken
        real(dp) :: v(size(rows, 1)), best(size(rows, 1)), long
        integer :: n, i, j, rank

        n = size(rows, 1)
        rank = 0
        do i = 1, size(rows, 2)
            if (rank == n) exit
            v = rest(rows(:, i), taken(:, :rank))
            if (norm2(v) <= nothing_new*norm2(rows(:, i))) cycle
            rank = rank + 1
            taken(:, rank) = v/norm2(v)
        end do
        basis = 0.0_dp
        free = n - rank
        do i = 1, free
            long = 0.0_dp
            do j = 1, n
                v = 0.0_dp
                v(j) = 1.0_dp
                v = rest(v, taken(:, :rank + i - 1))
                if (norm2(v) <= long + 1.0e-6_dp) cycle
                long = norm2(v)
                best = v/long
            end do
            taken(:, rank + i) = best
            basis(:, i) = best
        end do
    end subroutine free_basis

    !> What is left of a vector beside orthonormal ones.
    pure function rest(v, taken) result(left)
        real(dp), intent(in) :: v(:)        !! any vector
        real(dp), intent(in) :: taken(:, :) !! orthonormal columns
        real(dp) :: left(size(v))
        integer :: i, again
        left = v
        do again = 1, 2
            do i = 1, size(taken, 2)
                left = left - dot_product(taken(:, i), left)*taken(:, i)
            end do
        end do
    end function rest

end module audit_span
