!> The rows of a listed table: quick or exact, the same characters.
program test_row_text
    use base_decimal, only: decimal_type, grid_type, new_grid
    use base_error, only: error_type
    use base_kinds, only: dp, i64
    use base_output, only: output_type
    use geom_arc, only: arc_type, line_between
    use geom_contour, only: contour_point_type, contour_type, new_contour
    use report_row_text, only: put_rows, row_columns, row_heads, row_text
    use support_random, only: random_type
    use support_random_arcs, only: next_arc
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(random_type) :: random
    type(arc_type) :: arc
    integer :: i, rows = 0, wrong = 0
    character(row_columns) :: heads

    do i = 1, 3000
        call next_arc(random, arc)
        call check_arc(arc, 1 + mod(i, 2), -3)
        if (mod(i, 10) == 0) call check_arc(arc, 1 + mod(i, 2), -5)
    end do
    call check_arc(line_between([0.0_dp, 0.0_dp], [8.0_dp, 4.0_dp]), 1, -3)
    call check_arc(line_between([1.0_dp, 0.0_dp], [1.0_dp, 4.0_dp]), 1, -3)
    call tap%ok(rows > 50000, 'many rows of random arcs')
    call tap%ok(wrong == 0, 'each has the characters of its exact row')
    heads = row_heads
    call tap%same(heads(row_columns:), 'E', 'the heads end where the rows do')
    call tap%finish()

contains

    !> Compares the lines of a table with the exact rows, one by one.
    subroutine check_arc(arc, axis, power)
        type(arc_type), intent(in) :: arc !! any arc
        integer, intent(in) :: axis       !! 1: x is stepped, 2: y
        integer, intent(in) :: power      !! power of ten of the steps
        type(grid_type) :: grid
        type(contour_type) :: contour
        type(contour_point_type), allocatable :: exact(:)
        type(error_type), allocatable :: error
        type(output_type) :: out
        character(:), allocatable :: text
        integer :: i, first

        call new_grid(decimal_type(nint(arc%start(axis)/10.0_dp**power, i64), power), &
            decimal_type(5 + nint(abs(arc%finish(axis) - arc%start(axis)) &
            /10.0_dp**power/20.0_dp, i64), power), grid, error)
        call new_contour(arc, axis, grid, contour, error)
        if (allocated(error)) return
        call contour%make_rows(exact)
        call put_rows(contour, out)
        text = out%text()
        if (len(text) /= size(exact)*(row_columns + 1)) wrong = wrong + 1
        do i = 1, min(size(exact), len(text)/(row_columns + 1))
            first = (i - 1)*(row_columns + 1) + 1
            rows = rows + 1
            if (text(first:first + row_columns) == row_text(exact(i))//new_line('a')) cycle
            wrong = wrong + 1
            if (wrong > 4) cycle
            call tap%note(text(first:first + row_columns - 1))
            call tap%note(row_text(exact(i)))
        end do
    end subroutine check_arc

end program test_row_text
