!> Parts in rows: where each goes on a sheet, so that none touches another.
module export_pattern_rows
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: rows_type, rows_within, best_rows

    !> Where parts go.
    type :: rows_type
        real(dp), allocatable :: at(:, :)   !! lower left corners by columns, in
        real(dp) :: size(2) = 0.0_dp        !! width and height of all, in
    end type rows_type

    !> Between parts, in.
    real(dp), parameter :: gap = 0.75_dp

contains

    !> Sets parts in rows from the left, in their order, the first row at the top; in each row they
    !> stand on one line. A part wider than the width has a row of its own.
    pure type(rows_type) function rows_within(sizes, width) result(rows)
        real(dp), intent(in) :: sizes(:, :)     !! width and height by columns, in
        real(dp), intent(in) :: width           !! of the sheet, in
        real(dp) :: at(2), row
        integer :: i, first

        allocate (rows%at(2, size(sizes, 2)))
        at = 0.0_dp
        first = 1
        row = 0.0_dp
        do i = 1, size(sizes, 2)
            if (i > first .and. at(1) + sizes(1, i) > width) then
                rows%at(2, first:i - 1) = at(2) - row
                at = [0.0_dp, at(2) - row - gap]
                first = i
                row = 0.0_dp
            end if
            rows%at(1, i) = at(1)
            rows%size(1) = max(rows%size(1), at(1) + sizes(1, i))
            at(1) = at(1) + sizes(1, i) + gap
            row = max(row, sizes(2, i))
        end do
        rows%at(2, first:) = at(2) - row
        rows%size(2) = row - at(2)
        rows%at(2, :) = rows%at(2, :) + rows%size(2)
    end function rows_within

    !> Sets parts in rows so that the longer side of the sheet is the shortest.
    pure type(rows_type) function best_rows(sizes) result(best)
        real(dp), intent(in) :: sizes(:, :) !! width and height by columns, in
        type(rows_type) :: rows
        real(dp) :: width
        integer :: i

        best = rows_within(sizes, huge(width))
        width = 0.0_dp
        do i = 1, size(sizes, 2)
            width = width + sizes(1, i)
            if (i > 1) width = width + gap
            if (width < maxval(sizes(1, :))) cycle
            rows = rows_within(sizes, width)
            if (maxval(rows%size) < maxval(best%size)) best = rows
        end do
    end function best_rows

end module export_pattern_rows
