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
    use base_constants, only: degrees, pi
    use base_digits, only: fixed
    use base_exact, only: is_zero
    use base_figures, only: put_units
    use base_kinds, only: dp, i64
    use base_output, only: output_type
    use base_text, only: right
    use geom_arc_point, only: slope_type
    use geom_contour, only: contour_point, contour_point_type, contour_type
    use geom_place, only: at_finish, at_start
    use geom_quick, only: find_rows, new_quick, quick_rows_type, quick_type
    use geom_twofold_rows, only: rows_at_once
    implicit none (type, external)
    private

    public :: put_rows, row_text, row_heads

    !> Columns of a row.
    integer, parameter, public :: row_columns = 76
    !> The five figures of a row.
    integer, parameter :: figures = 5
    !> Their last columns, and their decimals.
    integer, parameter :: last_column(figures) = [14, 28, 42, 54, row_columns]
    integer, parameter :: decimals(figures) = [4, 4, 6, 4, 4]
    !> A row without its figures.
    character(*), parameter :: empty_row = repeat(' ', row_columns)//achar(10)

    !> Rows as whole numbers of their last decimals.
    type :: settled_type
        integer(i64) :: units(rows_at_once, figures) = 0          !! magnitudes
        logical :: is_negative(rows_at_once, figures) = .false.   !! a minus stands before them
        logical :: is_sure(rows_at_once) = .false.                !! false: they may be off
    end type settled_type

contains

    !> The line above a table.
    pure function row_heads() result(text)
        character(row_columns) :: text
        text = right('X', 14)//right('Y', 14)//right('SLOPE', 14)//right('ANGLE', 12)// &
            right('RADIUS OF CURVATURE', 22)
    end function row_heads

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
        character(len(empty_row)) :: lines(rows_at_once)
        type(quick_rows_type) :: rows
        type(settled_type) :: settled
        integer(i64) :: first, last, k
        integer :: j

        first = merge(0_i64, 1_i64, i == 1)
        last = contour%stretch(i)%count
        if (contour%stretch(i)%touches) last = last + 1
        if (i == size(contour%stretch)) last = last + 1
        do while (first <= last)
            if (quick%is_usable) then
                call put_ordinates(contour, i, first, rows%stepped)
                call find_rows(quick, contour%stretch(i)%rising, rows)
                call settle(rows, contour%axis, settled)
                if (contour%stretch(i)%touches) then
                    k = contour%stretch(i)%count + 1 - first
                    if (k < rows_at_once) settled%is_sure(k + 1) = .false.
                end if
            end if
            do j = 1, int(min(last - first + 1, int(rows_at_once, i64)))
                if (settled%is_sure(j)) then
                    call put_row(settled, j, lines(j))
                else
                    lines(j) = row_text(contour%row(i, first + int(j - 1, i64)))//new_line('a')
                end if
            end do
            call put_lines(lines, j - 1, out)
            first = first + rows_at_once
        end do
    end subroutine put_stretch

    !> Puts lines of equal length.
    subroutine put_lines(lines, count, out)
        character(*), intent(in) :: lines(:)    !! line feeds included
        integer, intent(in) :: count            !! how many
        type(output_type), intent(inout) :: out !! gets them
        integer :: i
        do i = 1, count
            call out%put(lines(i))
        end do
    end subroutine put_lines

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

    !> Rounds rows to their decimals.
    pure subroutine settle(rows, axis, settled)
        type(quick_rows_type), intent(in) :: rows   !! the rows
        integer, intent(in) :: axis                 !! 1: x is stepped, 2: y
        type(settled_type), intent(inout) :: settled !! gets their decimals
        real(dp) :: worst(rows_at_once), known(rows_at_once)

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
    end subroutine settle

    !> Rounds one figure of all rows. Each row keeps how near to a half, with all that it may be
    !> off, the worst of its figures is; a number too large to be sure of counts as half.
    pure subroutine round_figures(value, doubt, figure, settled, worst)
        real(dp), intent(in) :: value(rows_at_once)     !! the figure
        real(dp), intent(in) :: doubt(rows_at_once)     !! how far it may be off
        integer, intent(in) :: figure                   !! which of the row
        type(settled_type), intent(inout) :: settled    !! gets its decimals
        real(dp), intent(inout) :: worst(rows_at_once)  !! see above
        real(dp), parameter :: whole_only = 2.0_dp**52, most = 1.0e12_dp
        real(dp) :: scaled, whole(rows_at_once), ten
        integer :: i

        ten = 10.0_dp**decimals(figure)
        do i = 1, rows_at_once
            scaled = abs(value(i))*ten
            ! Adding a number without bits behind the point rounds.
            whole(i) = (min(scaled, most) + whole_only) - whole_only
            worst(i) = max(worst(i), scaled*(0.5_dp/most), &
                abs(scaled - whole(i)) + doubt(i)*ten + 2.0_dp*epsilon(scaled)*scaled)
        end do
        do i = 1, rows_at_once
            settled%units(i, figure) = int(whole(i), i64)
            settled%is_negative(i, figure) = value(i) < 0.0_dp .and. whole(i) > 0.0_dp
        end do
    end subroutine round_figures

    !> Writes a row, from its end: the columns before a figure are the room of the one before it.
    pure subroutine put_row(settled, i, line)
        type(settled_type), intent(in) :: settled       !! the rows
        integer, intent(in) :: i                        !! which
        character(len(empty_row)), intent(out) :: line  !! gets it
        integer :: figure

        line = empty_row
        do figure = figures, 1, -1
            call put_units(settled%units(i, figure), settled%is_negative(i, figure), &
                decimals(figure), line, last_column(figure))
        end do
    end subroutine put_row

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
