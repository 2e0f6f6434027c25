!> Quick rows against exact ones: no figure is further off than it says, and few are in doubt.
program test_quick
    use base_constants, only: degrees
    use base_decimal, only: decimal_type, grid_type, new_grid
    use base_error, only: error_type
    use base_kinds, only: dp, i64
    use geom_arc, only: arc_type, line_between
    use geom_contour, only: contour_point_type, contour_type, new_contour
    use geom_quick, only: find_rows, new_quick, quick_rows_type, quick_type
    use geom_twofold_same, only: rows_at_once
    use support_random, only: random_type
    use support_random_arcs, only: next_arc
    use support_tap, only: tap_type
    implicit none (type, external)

    !> A figure counts as known where it is off by less than this.
    real(dp), parameter :: known = 1.0e-6_dp

    type(tap_type) :: tap
    type(random_type) :: random
    type(quick_type) :: line
    integer :: i, rows = 0, wrong = 0, vague = 0

    do i = 1, 4000
        call check_arc(1 + mod(i, 2))
    end do
    call tap%ok(rows > 40000, 'many rows of 4000 random arcs')
    call tap%ok(wrong == 0, 'no figure is further off than it says')
    call tap%ok(real(vague, dp) < 0.02_dp*real(rows, dp), 'one row in fifty or fewer is in doubt')
    line = new_quick(line_between([0.0_dp, 0.0_dp], [1.0_dp, 2.0_dp]), 1)
    call tap%ok(.not. line%is_usable, 'a straight line is left to the exact rows')
    call tap%finish()

contains

    !> Compares the rows of a random arc.
    subroutine check_arc(axis)
        integer, intent(in) :: axis !! 1: x is stepped, 2: y
        type(arc_type) :: arc
        type(grid_type) :: grid
        type(contour_type) :: contour
        type(error_type), allocatable :: error
        integer :: i

        call next_arc(random, arc)
        call new_grid(decimal_type(nint(1000.0_dp*arc%start(axis), i64), -3), &
            decimal_type(1 + nint(abs(arc%finish(axis) - arc%start(axis))*80.0_dp, i64), -3), &
            grid, error)
        call new_contour(arc, axis, grid, contour, error)
        if (allocated(error)) return
        do i = 1, size(contour%stretch)
            call check_stretch(contour, i)
        end do
    end subroutine check_arc

    !> Compares the first rows of a stretch.
    subroutine check_stretch(contour, i)
        type(contour_type), intent(in) :: contour !! the table
        integer, intent(in) :: i                  !! which stretch
        type(quick_type) :: quick
        type(quick_rows_type) :: found
        type(contour_point_type) :: row
        integer :: k, count

        quick = new_quick(contour%arc, contour%axis)
        count = int(min(contour%stretch(i)%count, int(rows_at_once, i64)))
        if (.not. quick%is_usable .or. count == 0) return
        row = contour%row(i, 1_i64)
        found%stepped = merge(row%x, row%y, contour%axis == 1)
        do k = 1, count
            row = contour%row(i, int(k, i64))
            found%stepped(k) = merge(row%x, row%y, contour%axis == 1)
        end do
        call find_rows(quick, contour%stretch(i)%rising, found)
        do k = 1, count
            call compare(contour%row(i, int(k, i64)), found, k, contour%axis)
        end do
    end subroutine check_stretch

    !> Compares one row.
    subroutine compare(row, found, k, axis)
        type(contour_point_type), intent(in) :: row !! exact
        type(quick_rows_type), intent(in) :: found  !! quick
        integer, intent(in) :: k                    !! which of them
        integer, intent(in) :: axis                 !! 1: x is stepped, 2: y

        rows = rows + 1
        if (abs(found%other(k) - merge(row%y, row%x, axis == 1)) > found%other_doubt(k)) &
            wrong = wrong + 1
        if (.not. row%slope%is_vertical) then
            if (abs(found%slope(k) - row%slope%value) > found%slope_doubt(k)) wrong = wrong + 1
            if (abs(found%angle(k) - atan(row%slope%value)*degrees) > found%angle_doubt(k)) &
                wrong = wrong + 1
        end if
        if (abs(found%radius(k) - 1.0_dp/row%curvature) > found%radius_doubt(k)) wrong = wrong + 1
        if (max(found%other_doubt(k), found%slope_doubt(k)/(1.0_dp + found%slope(k)**2), &
            found%angle_doubt(k), found%radius_doubt(k)/abs(found%radius(k))) > known) &
            vague = vague + 1
    end subroutine compare

end program test_quick
