!> Rows side by side against the same rows alone: every bit is the same.
program test_arc_rows
    use base_decimal, only: decimal_type, grid_type, new_grid
    use base_error, only: error_type
    use base_kinds, only: dp, i64
    use geom_arc, only: arc_type
    use geom_arc_point, only: point
    use geom_arc_rows, only: arc_rows_type, coordinates, find_arc_rows, place_of_row, places_type, &
        terms_of
    use geom_contour, only: contour_point_type, contour_type, new_contour
    use geom_place, only: place_at, place_type
    use geom_twofold_same, only: exact_difference, rows_at_once
    use support_random, only: random_type
    use support_random_arcs, only: next_arc
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(random_type) :: random
    integer :: i, rows = 0, wrong = 0, places = 0

    do i = 1, 2000
        call check_arc(1 + mod(i, 2))
    end do
    call tap%ok(rows > 20000 .and. wrong == 0, 'rows of 2000 random arcs have the same bits')
    call tap%ok(places == 0, 'so have their points at places')
    call tap%finish()

contains

    !> Compares rows and points of a random arc.
    subroutine check_arc(axis)
        integer, intent(in) :: axis !! 1: x is stepped, 2: y
        type(arc_type) :: arc
        type(grid_type) :: grid
        type(contour_type) :: contour
        type(error_type), allocatable :: error
        integer :: i

        call next_arc(random, arc)
        call check_places(arc)
        call new_grid(decimal_type(nint(1000.0_dp*arc%start(axis), i64), -3), &
            decimal_type(1 + nint(abs(arc%finish(axis) - arc%start(axis))*80.0_dp, i64), -3), &
            grid, error)
        call new_contour(arc, axis, grid, contour, error)
        if (allocated(error) .or. arc%is_line) return
        do i = 1, size(contour%stretch)
            call check_stretch(contour, i)
        end do
    end subroutine check_arc

    !> Compares the first rows of a stretch.
    subroutine check_stretch(contour, i)
        type(contour_type), intent(in) :: contour !! the table
        integer, intent(in) :: i                  !! which stretch
        type(arc_rows_type) :: found
        type(contour_point_type) :: row
        real(dp) :: ordinate(rows_at_once)
        type(place_type) :: alone
        integer :: k, count

        count = int(min(contour%stretch(i)%count, int(rows_at_once, i64)))
        if (count == 0) return
        row = contour%row(i, 1_i64)
        ordinate = merge(row%x, row%y, contour%axis == 1)
        do k = 1, count
            row = contour%row(i, int(k, i64))
            ordinate(k) = merge(row%x, row%y, contour%axis == 1)
        end do
        call find_arc_rows(contour%arc, contour%axis, ordinate, contour%stretch(i)%rising, found)
        do k = 1, count
            row = contour%row(i, int(k, i64))
            rows = rows + 1
            alone = place_of_row(found%places, k)
            if (.not. (is_same(found%x(k), row%x) .and. is_same(found%y(k), row%y) .and. &
                is_same(found%slope(k)%value, row%slope%value) .and. &
                (found%slope(k)%is_vertical .eqv. row%slope%is_vertical) .and. &
                is_same(found%curvature(k), row%curvature) .and. &
                is_same(alone%alpha%low, row%place%alpha%low) .and. &
                is_same(alone%beta%high, row%place%beta%high))) wrong = wrong + 1
        end do
    end subroutine check_stretch

    !> Compares points at equal steps of the parameter.
    subroutine check_places(arc)
        type(arc_type), intent(in) :: arc !! any arc
        type(places_type) :: at
        type(place_type) :: place
        real(dp), dimension(rows_at_once) :: t, x, y, one, zero
        real(dp) :: alone(2)
        integer :: i

        one = 1.0_dp
        zero = 0.0_dp
        t = [(real(i, dp)/real(rows_at_once + 1, dp), i=1, rows_at_once)]
        at%alpha = exact_difference(one, t)
        at%beta = exact_difference(t, zero)
        x = coordinates(arc, 1, terms_of(arc, at))
        y = coordinates(arc, 2, terms_of(arc, at))
        do i = 1, rows_at_once
            place = place_at(t(i))
            alone = point(arc, place)
            if (.not. (is_same(alone(1), x(i)) .and. is_same(alone(2), y(i)))) places = places + 1
        end do
    end subroutine check_places

    !> True for the same bits.
    pure logical function is_same(a, b)
        real(dp), intent(in) :: a !! a number
        real(dp), intent(in) :: b !! another
        is_same = transfer(a, 0_i64) == transfer(b, 0_i64)
    end function is_same

end program test_arc_rows
