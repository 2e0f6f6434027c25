!> Numbers in order, and rows of them in the order of a dictionary. Merging takes n log n steps,
!> whatever order they are in; equal ones keep their order.
!>
!> Source: D. E. Knuth, "The Art of Computer Programming", vol. 3, 2nd ed., 5.2.4 (merging of runs
!> of doubled lengths).
module base_order
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: order_of, ascending, rising, each_once

    !> The places of numbers, or of the columns of a table, in ascending order.
    interface order_of
        module procedure order_of_numbers, order_of_columns
    end interface order_of

contains

    !> The places of numbers in ascending order.
    pure function order_of_numbers(x) result(order)
        real(dp), intent(in) :: x(:) !! any numbers
        integer, allocatable :: order(:)
        allocate (order(size(x)))
        order = order_of_columns(reshape(x, [1, size(x)]))
    end function order_of_numbers

    !> The places of columns in the order of their first numbers, then of the next.
    pure function order_of_columns(x) result(order)
        real(dp), intent(in) :: x(:, :) !! any numbers, shape (numbers, columns)
        integer, allocatable :: order(:), merged(:)
        integer :: run, first, count, i

        count = size(x, 2)
        allocate (order(count), merged(count))
        order = [(i, i=1, count)]
        run = 1
        do while (run < count)
            do first = 1, count, 2*run
                associate (middle => min(first + run, count + 1), &
                        last => min(first + 2*run - 1, count))
                    call merge_runs(x, order(first:middle - 1), order(middle:last), &
                        merged(first:last))
                end associate
            end do
            order = merged
            run = 2*run
        end do
    end function order_of_columns

    !> Merges two runs that are in order.
    pure subroutine merge_runs(x, left, right, merged)
        real(dp), intent(in) :: x(:, :)     !! the columns
        integer, intent(in) :: left(:)      !! places of some, in order
        integer, intent(in) :: right(:)     !! places of others behind them, in order
        integer, intent(out) :: merged(:)   !! places of all, in order
        integer :: i, j, k

        i = 1
        j = 1
        do k = 1, size(merged)
            if (j > size(right)) then
                merged(k) = left(i)
                i = i + 1
            else if (i > size(left)) then
                merged(k) = right(j)
                j = j + 1
            else if (comes_first(x(:, right(j)), x(:, left(i)))) then
                merged(k) = right(j)
                j = j + 1
            else
                merged(k) = left(i)
                i = i + 1
            end if
        end do
    end subroutine merge_runs

    !> True where numbers come before others in the order of a dictionary.
    pure logical function comes_first(a, b)
        real(dp), intent(in) :: a(:) !! numbers
        real(dp), intent(in) :: b(:) !! as many
        integer :: i

        comes_first = .false.
        do i = 1, size(a)
            comes_first = a(i) < b(i)
            if (a(i) < b(i) .or. b(i) < a(i)) return
        end do
    end function comes_first

    !> Numbers in ascending order.
    pure function ascending(x) result(sorted)
        real(dp), intent(in) :: x(:) !! any numbers
        real(dp), allocatable :: sorted(:)
        allocate (sorted(size(x)))
        sorted = x(order_of(x))
    end function ascending

    !> Numbers in ascending order, each once.
    pure function rising(x) result(sorted)
        real(dp), intent(in) :: x(:) !! any numbers
        real(dp), allocatable :: sorted(:)
        integer :: i, count

        allocate (sorted(size(x)))
        sorted = ascending(x)
        count = min(1, size(x))
        do i = 2, size(x)
            if (.not. sorted(i) > sorted(count)) cycle
            count = count + 1
            sorted(count) = sorted(i)
        end do
        sorted = sorted(:count)
    end function rising

    !> Numbers in their order, each once: where it comes first.
    pure function each_once(x) result(kept)
        real(dp), intent(in) :: x(:) !! any numbers
        real(dp), allocatable :: kept(:)
        integer, allocatable :: order(:)
        logical, allocatable :: is_first(:)
        integer :: i

        allocate (order(size(x)), is_first(size(x)), kept(0))
        order = order_of(x)
        is_first = .true.
        do i = 2, size(x)
            is_first(order(i)) = x(order(i)) > x(order(i - 1))
        end do
        kept = pack(x, is_first)
    end function each_once

end module base_order
