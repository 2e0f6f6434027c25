!> The rows of a listed table as lines of text.
!>
!>              X             Y         SLOPE       ANGLE   RADIUS OF CURVATURE
!>       -30.0000      -10.0000      0.114000      6.5036            -1026.8748
!>     1           15            29            43          55                  76
!>
!> Most rows come from `geom_quick`, whose figures are printed where their bounds leave no doubt of
!> any decimal; the exact row is made for the others, some one in a million. The radius of curvature
!> is positive where the curve turns left on the way from point 1 to point 3.
module report_row_text
    use base_column, only: put_column
    use base_constants, only: degrees, pi
    use base_digits, only: fixed
    use base_exact, only: is_zero
    use base_kinds, only: dp, i64
    use base_output, only: output_type
    use base_text, only: right
    use geom_arc_point, only: slope_type
    use geom_contour, only: contour_point, contour_point_type, contour_type
    use geom_place, only: at_finish, at_start
    use geom_quick, only: find_rows, new_quick, quick_rows_type, quick_type
    use geom_twofold_same, only: rows_at_once
    implicit none (type, external)
    private

    public :: put_rows, row_text

    !> Columns of a row.
    integer, parameter, public :: row_columns = 76
    !> The line above a table.
    character(row_columns), parameter, public :: row_heads = repeat(' ', 13)//'X'// &
        repeat(' ', 13)//'Y'//repeat(' ', 9)//'SLOPE'//repeat(' ', 7)//'ANGLE'// &
        repeat(' ', 3)//'RADIUS OF CURVATURE'
    !> The five figures of a row.
    integer, parameter :: figures = 5
    !> Their last columns, and their decimals.
    integer, parameter :: last_column(figures) = [14, 28, 42, 54, row_columns]
    integer, parameter :: decimals(figures) = [4, 4, 6, 4, 4]
    real(dp), parameter :: tens(figures) = 10.0_dp**decimals
    !> A row without its figures.
    character(*), parameter :: empty_row = repeat(' ', row_columns)//achar(10)

    !> Rows as whole numbers of their last decimals.
    type :: settled_type
        integer(i64) :: units(rows_at_once, figures) = 0    !! signed
        logical :: is_sure(rows_at_once) = .false.          !! false: they may be off
    end type settled_type

contains

    !> Puts all rows of a table, each `row_columns` and a line feed.
    subroutine put_rows(contour, out)
        type(contour_type), intent(in) :: contour !! the table
        type(output_type), intent(inout) :: out   !! gets the lines
        type(quick_type) :: quick
        integer :: i

        quick = new_quick(contour%arc, contour%axis)
        do i = 1, size(contour%stretch)
            call put_stretch(contour, quick, i, out)
        end do
        if (size(contour%stretch) > 0) return
        call out%line(row_text(contour_point(contour%arc, at_start)))
        call out%line(row_text(contour_point(contour%arc, at_finish)))
    end subroutine put_rows

    !> Puts the rows of a stretch.
    subroutine put_stretch(contour, quick, i, out)
        type(contour_type), intent(in) :: contour !! the table
        type(quick_type), intent(in) :: quick     !! its arc
        integer, intent(in) :: i                  !! which stretch
        type(output_type), intent(inout) :: out   !! gets the lines
        character(rows_at_once*len(empty_row)) :: lines
        type(quick_rows_type) :: rows
        type(settled_type) :: settled
        integer(i64) :: first, last, k
        integer :: j, count

        first = merge(0_i64, 1_i64, i == 1)
        last = contour%stretch(i)%count
        if (contour%stretch(i)%touches) last = last + 1
        if (i == size(contour%stretch)) last = last + 1
        do while (first <= last)
            count = int(min(last - first + 1, int(rows_at_once, i64)))
            if (quick%is_usable) then
                call put_ordinates(contour, i, first, rows%stepped)
                call find_rows(quick, contour%stretch(i)%rising, rows)
                call settle(rows, contour%axis, settled)
                call put_settled(settled, count, lines)
                if (contour%stretch(i)%touches) then
                    k = contour%stretch(i)%count + 1 - first
                    if (k < rows_at_once) settled%is_sure(k + 1) = .false.
                end if
            end if
            do j = 1, count
                if (settled%is_sure(j)) cycle
                lines((j - 1)*len(empty_row) + 1:j*len(empty_row)) = &
                    row_text(contour%row(i, first + int(j - 1, i64)))//new_line('a')
            end do
            call out%put(lines(:count*len(empty_row)))
            first = first + rows_at_once
        end do
    end subroutine put_stretch

    !> The stepped ordinates of rows one after the other; beyond the last step, that of the finish.
    subroutine put_ordinates(contour, i, first, ordinate)
        type(contour_type), intent(in) :: contour           !! the table
        integer, intent(in) :: i                            !! which stretch
        integer(i64), intent(in) :: first                   !! which row of it stands first
        real(dp), intent(out) :: ordinate(rows_at_once)     !! deck units
        integer :: steps, from

        associate (it => contour%stretch(i), arc => contour%arc, axis => contour%axis)
            from = merge(2, 1, first == 0)
            steps = int(max(0_i64, min(it%count - first + 1, int(rows_at_once, i64))))
            ordinate = arc%finish(axis)
            if (first == 0) ordinate(1) = arc%start(axis)
            if (steps >= from) call contour%grid%put_ordinates( &
                it%first + (first + int(from - 2, i64))*it%stride, it%stride, ordinate(from:steps))
        end associate
    end subroutine put_ordinates

    !> Rounds rows to their decimals; rows that are not sure of them are zero.
    pure subroutine settle(rows, axis, settled)
        type(quick_rows_type), intent(in) :: rows   !! the rows
        integer, intent(in) :: axis                 !! 1: x is stepped, 2: y
        type(settled_type), intent(inout) :: settled !! gets their decimals
        real(dp) :: worst(rows_at_once), known(rows_at_once)
        integer :: i

        worst = 0.0_dp
        known = 0.0_dp
        if (axis == 1) then
            call round_figures(rows%stepped, known, 1, settled, worst)
            call round_figures(rows%other, rows%other_doubt, 2, settled, worst)
        else
            call round_figures(rows%other, rows%other_doubt, 1, settled, worst)
            call round_figures(rows%stepped, known, 2, settled, worst)
        end if
        call round_figures(rows%slope, rows%slope_doubt, 3, settled, worst)
        call round_figures(rows%angle, rows%angle_doubt, 4, settled, worst)
        call round_figures(rows%radius, rows%radius_doubt, 5, settled, worst)
        settled%is_sure = worst < 0.5_dp
        if (all(settled%is_sure)) return
        do i = 1, rows_at_once
            if (.not. settled%is_sure(i)) settled%units(i, :) = 0
        end do
    end subroutine settle

    !> Rounds one figure of all rows. Each row keeps how near to a half, with all that it may be
    !> off, the worst of its figures is; a number too large to be sure of counts as half.
    pure subroutine round_figures(value, doubt, figure, settled, worst)
        real(dp), intent(in) :: value(rows_at_once)     !! the figure
        real(dp), intent(in) :: doubt(rows_at_once)     !! how far it may be off
        integer, intent(in) :: figure                   !! which of the row
        type(settled_type), intent(inout) :: settled    !! gets its decimals
        real(dp), intent(inout) :: worst(rows_at_once)  !! see above
        real(dp), parameter :: whole_only = 1.5_dp*2.0_dp**52, most = 1.0e12_dp
        real(dp) :: scaled, rounded, ten
        integer :: i

        ten = tens(figure)
        do i = 1, rows_at_once
            scaled = min(max(value(i)*ten, -most), most)
            ! Adding a number without bits behind the point rounds; its last bits are the whole
            ! number then.
            rounded = scaled + whole_only
            settled%units(i, figure) = transfer(rounded, 1_i64) - transfer(whole_only, 1_i64)
            worst(i) = max(worst(i), abs(scaled)*(0.5_dp/most), &
                abs(scaled - (rounded - whole_only)) + doubt(i)*ten + &
                2.0_dp*epsilon(scaled)*abs(scaled))
        end do
    end subroutine round_figures

    !> Writes rows, from their ends: the columns before a figure are the room of the one before it.
    pure subroutine put_settled(settled, count, lines)
        type(settled_type), intent(in) :: settled       !! the rows
        integer, intent(in) :: count                    !! how many are wanted
        character(*), intent(inout) :: lines            !! gets them, one after the other
        character(*), parameter :: empty_rows = repeat(empty_row, rows_at_once)
        integer :: figure

        lines = empty_rows
        do figure = figures, 1, -1
            call put_column(settled%units(:count, figure), decimals(figure), last_column(figure), &
                len(empty_row), lines)
        end do
    end subroutine put_settled

    !> A row of exact figures.
    pure function row_text(row) result(text)
        type(contour_point_type), intent(in) :: row !! the point
        character(row_columns) :: text
        text(:14) = fixed(row%x, 14, decimals(1))
        text(15:28) = fixed(row%y, 14, decimals(2))
        text(29:42) = right('VERTICAL', 14)
        if (.not. row%slope%is_vertical) text(29:42) = fixed(row%slope%value, 14, decimals(3))
        text(43:54) = fixed(angle_of(row%slope), 12, decimals(4))
        text(55:) = right('STRAIGHT', 22)
        if (.not. is_zero(row%curvature)) text(55:) = fixed(1.0_dp/row%curvature, 22, decimals(5))
    end function row_text

    !> The angle of a slope, degrees above -90 and up to 90.
    pure real(dp) function angle_of(slope) result(angle)
        type(slope_type), intent(in) :: slope !! dy/dx
        angle = 0.5_dp*pi
        if (.not. slope%is_vertical) angle = atan(slope%value)
        angle = angle*degrees
    end function angle_of

end module report_row_text
