!> The points of an arc at stepped ordinates, in order along the arc: the first point, every passage
!> of a stepped ordinate, the last point. Where the arc goes beyond its ends along the axis, so do
!> the steps, up to its extreme. A step that equals an end is that end, once; one that touches an
!> extreme is one point.
module geom_contour
    use base_decimal, only: grid_type
    use base_error, only: error_type
    use base_kinds, only: dp, i64
    use geom_arc, only: arc_type
    use geom_arc_point, only: curvature, point, slope, slope_type
    use geom_arc_rows, only: arc_rows_type, find_arc_rows, place_of_row
    use geom_crossing, only: crossing
    use geom_place, only: at_finish, at_start, place_type
    use geom_stretch, only: divide, stretch_type
    use geom_twofold_same, only: rows_at_once
    implicit none (type, external)
    private

    public :: contour_point_type, contour_type, contour_of, contour_point, new_contour

    !> One row of a table.
    type :: contour_point_type
        real(dp) :: x = 0.0_dp           !! deck units
        real(dp) :: y = 0.0_dp           !! deck units
        type(slope_type) :: slope        !! dy/dx, or vertical
        real(dp) :: curvature = 0.0_dp   !! 1/deck unit, positive where the arc turns left
        type(place_type) :: place        !! where on the arc
    end type contour_point_type


    !> A table that is asked for, none of its rows made yet.
    type :: contour_type
        integer :: axis = 1                             !! 1: steps of x, 2: steps of y
        type(arc_type) :: arc                           !! the arc
        type(grid_type) :: grid                         !! the stepped ordinates
        type(stretch_type), allocatable :: stretch(:)   !! in order along the arc
    contains
        procedure :: make_rows
        procedure :: row_count
        procedure :: row
    end type contour_type

    !> Rows that are worth working side by side.
    integer, parameter :: fewest_side_by_side = 3

contains

    !> The points of an arc at stepped ordinates.
    !>
    !> Fails with `cause%too_many` where there would be more than `largest_table` of them, and with
    !> `cause%increment` where the grid starts too many steps away from the arc.
    pure subroutine contour_of(arc, axis, grid, rows, error)
        type(arc_type), intent(in) :: arc                                !! any arc
        integer, intent(in) :: axis                                      !! 1: step x, 2: step y
        type(grid_type), intent(in) :: grid                              !! the stepped ordinates
        type(contour_point_type), allocatable, intent(out) :: rows(:)    !! in order along the arc
        type(error_type), allocatable, intent(out) :: error              !! see above
        type(contour_type) :: contour

        call new_contour(arc, axis, grid, contour, error)
        if (.not. allocated(error)) call contour%make_rows(rows)
    end subroutine contour_of

    !> Prepares the rows of an arc at stepped ordinates. Fails as `contour_of`.
    pure subroutine new_contour(arc, axis, grid, contour, error)
        type(arc_type), intent(in) :: arc                   !! any arc
        integer, intent(in) :: axis                         !! 1: step x, 2: step y
        type(grid_type), intent(in) :: grid                 !! the stepped ordinates
        type(contour_type), intent(out) :: contour          !! the table
        type(error_type), allocatable, intent(out) :: error !! see above
        contour%axis = axis
        contour%arc = arc
        contour%grid = grid
        call divide(arc, axis, grid, contour%stretch, error)
    end subroutine new_contour

    !> Makes all rows of a table.
    pure subroutine make_rows(contour, rows)
        class(contour_type), intent(in) :: contour                       !! the table
        type(contour_point_type), allocatable, intent(out) :: rows(:)    !! in order along the arc
        integer :: i, next, steps

        allocate (rows(contour%row_count()))
        rows(1) = contour_point(contour%arc, at_start)
        next = 2
        do i = 1, size(contour%stretch)
            steps = int(contour%stretch(i)%count)
            call make_steps(contour, i, rows(next:next + steps - 1))
            next = next + steps
            if (.not. contour%stretch(i)%touches) cycle
            rows(next) = contour%row(i, int(steps, i64) + 1_i64)
            next = next + 1
        end do
        rows(next) = contour_point(contour%arc, at_finish)
    end subroutine make_rows

    !> Makes the rows of the steps of a stretch, many side by side where there are many.
    pure subroutine make_steps(contour, i, rows)
        type(contour_type), intent(in) :: contour               !! the table
        integer, intent(in) :: i                                !! which stretch
        type(contour_point_type), intent(inout) :: rows(:)      !! gets them
        type(arc_rows_type) :: found
        real(dp) :: ordinate(rows_at_once)
        integer :: done, k, count

        done = 0
        do while (done < size(rows))
            count = min(rows_at_once, size(rows) - done)
            if (count < fewest_side_by_side .or. contour%arc%is_line) then
                do k = done + 1, done + count
                    rows(k) = contour%row(i, int(k, i64))
                end do
            else
                associate (it => contour%stretch(i))
                    call contour%grid%put_ordinates(it%first + int(done, i64)*it%stride, &
                        it%stride, ordinate(:count))
                    ordinate(count + 1:) = ordinate(count)
                    call find_arc_rows(contour%arc, contour%axis, ordinate, it%rising, found)
                end associate
                do k = 1, count
                    rows(done + k) = contour_point_type(found%x(k), found%y(k), found%slope(k), &
                        found%curvature(k), place_of_row(found%places, k))
                end do
            end if
            done = done + count
        end do
    end subroutine make_steps

    !> How many rows a table has.
    pure integer function row_count(contour)
        class(contour_type), intent(in) :: contour !! the table
        row_count = 2 + int(sum(contour%stretch%count)) + count(contour%stretch%touches)
    end function row_count

    !> A row of a stretch: those of its steps are 1 to `count`, and the next is the extreme that it
    !> touches. Row 0 is the first point of the arc, and the one behind the last stretch its last.
    pure type(contour_point_type) function row(contour, i, k)
        class(contour_type), intent(in) :: contour !! the table
        integer, intent(in) :: i                   !! which stretch
        integer(i64), intent(in) :: k              !! which of its rows

        associate (it => contour%stretch(i), grid => contour%grid)
            if (k == 0) then
                row = contour_point(contour%arc, at_start)
            else if (k <= it%count) then
                row = passage(contour%arc, contour%axis, &
                    grid%ordinate(it%first + (k - 1)*it%stride), it%rising)
            else if (it%touches .and. k == it%count + 1) then
                row = extreme(contour%arc, contour%axis, grid%ordinate(it%touched), it%finish)
            else
                row = contour_point(contour%arc, at_finish)
            end if
        end associate
    end function row

    !> The row of a place.
    pure type(contour_point_type) function contour_point(arc, place) result(row)
        type(arc_type), intent(in) :: arc     !! any arc
        type(place_type), intent(in) :: place !! where on it
        real(dp) :: at(2)
        at = point(arc, place)
        row%x = at(1)
        row%y = at(2)
        row%slope = slope(arc, place)
        row%curvature = curvature(arc, place)
        row%place = place
    end function contour_point

    !> The row where the arc passes a stepped ordinate, which stands in it as it is.
    pure type(contour_point_type) function passage(arc, axis, ordinate, rising) result(row)
        type(arc_type), intent(in) :: arc !! any arc
        integer, intent(in) :: axis       !! 1: x is stepped, 2: y
        real(dp), intent(in) :: ordinate  !! a stepped ordinate, deck units
        logical, intent(in) :: rising     !! the coordinate increases along the arc there
        row = contour_point(arc, crossing(arc, axis, ordinate, rising))
        if (axis == 1) row%x = ordinate
        if (axis == 2) row%y = ordinate
    end function passage

    !> The row of an extreme that a stepped ordinate touches; the tangent is across the axis.
    pure type(contour_point_type) function extreme(arc, axis, ordinate, place) result(row)
        type(arc_type), intent(in) :: arc     !! any arc
        integer, intent(in) :: axis           !! 1: x is stepped, 2: y
        real(dp), intent(in) :: ordinate      !! the stepped ordinate, deck units
        type(place_type), intent(in) :: place !! the extreme
        row = contour_point(arc, place)
        row%slope = slope_type(0.0_dp, axis == 1)
        if (axis == 1) row%x = ordinate
        if (axis == 2) row%y = ordinate
    end function extreme









end module geom_contour
