!> What of a page lies in a box: whether an item does, and the piece of it that is drawn there.
module export_pattern_clip
    use base_kinds, only: dp
    use export_pattern_page, only: item_kind, item_type, label_corners, page_type
    use export_pattern_part, only: bezier_points
    use export_pattern_room, only: meets_box, meets_corners
    use export_pattern_style, only: look_of, look_type
    implicit none (type, external)
    private

    public :: touches, anything_in, add_within

    !> Straight pieces that stand for a Bezier arc.
    integer, parameter :: pieces = 12

contains

    !> True where any item of a part touches a box.
    pure logical function anything_in(page, box)
        type(page_type), intent(in) :: page     !! any
        real(dp), intent(in) :: box(4)          !! left, bottom, right, top, in
        integer :: i

        anything_in = .true.
        do i = 1, page%count
            if (touches(page%items(i), box)) return
        end do
        anything_in = .false.
    end function anything_in

    !> True where an item touches a box.
    pure logical function touches(item, box)
        type(item_type), intent(in) :: item     !! any
        real(dp), intent(in) :: box(4)          !! left, bottom, right, top, in
        integer :: i

        touches = .false.
        select case (item%kind)
        case (item_kind%words)
            touches = covers(label_corners(item%at(:, 1), item%label), box)
        case (item_kind%lines)
            touches = path_touches(item%at, box) .or. (item%is_closed .and. &
                meets_box([item%at(:, size(item%at, 2)), item%at(:, 1)], box))
        case (item_kind%curves)
            if (.not. may_touch(item%at, box)) return
            do i = 4, size(item%at, 2), 3
                if (may_touch(item%at(:, i - 3:i), box)) &
                    touches = path_touches(bezier_points(item%at(:, i - 3:i), pieces), box)
                if (touches) return
            end do
        end select
    end function touches

    !> True where the box around points touches another.
    pure logical function may_touch(points, box)
        real(dp), intent(in) :: points(:, :)    !! by columns, in
        real(dp), intent(in) :: box(4)          !! left, bottom, right, top, in
        may_touch = all(maxval(points, dim=2) >= box(:2)) .and. &
            all(minval(points, dim=2) <= box(3:))
    end function may_touch

    !> True where any line from point to point touches a box.
    pure logical function path_touches(points, box) result(touches)
        real(dp), intent(in) :: points(:, :)    !! by columns, in
        real(dp), intent(in) :: box(4)          !! left, bottom, right, top, in
        integer :: i

        touches = .false.
        do i = 2, size(points, 2)
            touches = meets_box([points(:, i - 1), points(:, i)], box)
            if (touches) return
        end do
    end function path_touches

    !> True where a rectangle and a box have a point in common.
    pure logical function covers(corners, box)
        real(dp), intent(in) :: corners(2, 4)   !! of the rectangle, in order, in
        real(dp), intent(in) :: box(4)          !! left, bottom, right, top, in
        integer :: i

        covers = meets_corners([box(:2), box(:2)], corners)
        do i = 1, 4
            if (covers) return
            covers = meets_box([corners(:, i), corners(:, mod(i, 4) + 1)], box)
        end do
    end function covers

    !> Adds to a page what of an item lies in a box, moved. Of unbroken curves these are the arcs
    !> that come near the box; all else stays whole, so that dashes meet.
    pure subroutine add_within(page, item, box, shift)
        type(page_type), intent(inout) :: page  !! gets it
        type(item_type), intent(in) :: item     !! any
        real(dp), intent(in) :: box(4)          !! left, bottom, right, top, in
        real(dp), intent(in) :: shift(2)        !! to the right and up, in
        type(item_type) :: piece
        type(look_type) :: look
        integer :: i, first

        if (.not. touches(item, box)) return
        look = look_of(item%style)
        if (item%kind /= item_kind%curves .or. look%dash(1) > 0.0_dp) then
            call add_points(page, item, item%at, shift)
            return
        end if
        piece = item
        piece%is_closed = .false.
        first = 0
        do i = 1, size(item%at, 2) - 1, 3
            if (may_touch(item%at(:, i:i + 3), box)) then
                if (first == 0) first = i
            else if (first > 0) then
                call add_points(page, piece, item%at(:, first:i), shift)
                first = 0
            end if
        end do
        if (first == 1) piece%is_closed = item%is_closed
        if (first > 0) call add_points(page, piece, item%at(:, first:), shift)
    end subroutine add_within

    !> Adds an item with other points, moved.
    pure subroutine add_points(page, item, points, shift)
        type(page_type), intent(inout) :: page  !! gets it
        type(item_type), intent(in) :: item     !! the item
        real(dp), intent(in) :: points(:, :)    !! its points, by columns, in
        real(dp), intent(in) :: shift(2)        !! to the right and up, in
        type(item_type) :: moved

        moved = item
        moved%at = points + spread(shift, 2, size(points, 2))
        call page%add(moved)
    end subroutine add_points

end module export_pattern_clip
