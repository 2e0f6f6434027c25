!> What is taken on a page: lines, and the boxes of words. A label goes where it hides nothing.
module export_pattern_room
    use base_kinds, only: dp
    use export_pattern_page, only: label_corners, label_type
    implicit none (type, external)
    private

    public :: room_type, meets_box, meets_corners

    !> A step along an axis that is none, in.
    real(dp), parameter :: no_step = 1.0e-100_dp

    !> Taken room. Lists grow by doubling; `lines` and `words` say how much of them counts.
    type :: room_type
        real(dp), allocatable :: line(:, :)     !! both ends of a line by columns, in: (4, :)
        integer :: lines = 0                    !! how many there are
        real(dp), allocatable :: word(:, :, :)  !! corners of boxes, in: (2, 4, :)
        integer :: words = 0                    !! how many there are
    contains
        procedure :: take_line
        procedure :: take_label
        procedure :: is_free
    end type room_type

contains

    !> Takes the room of straight lines from point to point.
    pure subroutine take_line(room, points)
        class(room_type), intent(inout) :: room     !! grows
        real(dp), intent(in) :: points(:, :)        !! by columns, in
        real(dp), allocatable :: grown(:, :)
        integer :: i, more

        more = max(size(points, 2) - 1, 0)
        if (.not. allocated(room%line)) allocate (room%line(4, 64))
        if (room%lines + more > size(room%line, 2)) then
            allocate (grown(4, 2*(room%lines + more)))
            grown(:, :room%lines) = room%line(:, :room%lines)
            call move_alloc(grown, room%line)
        end if
        do i = 1, more
            room%line(:, room%lines + i) = [points(:, i), points(:, i + 1)]
        end do
        room%lines = room%lines + more
    end subroutine take_line

    !> Takes the room of a label.
    pure subroutine take_label(room, at, label)
        class(room_type), intent(inout) :: room     !! grows
        real(dp), intent(in) :: at(2)               !! where it stands, in
        type(label_type), intent(in) :: label       !! the words
        real(dp), allocatable :: grown(:, :, :)

        if (.not. allocated(room%word)) allocate (room%word(2, 4, 16))
        if (room%words == size(room%word, 3)) then
            allocate (grown(2, 4, 2*room%words))
            grown(:, :, :room%words) = room%word
            call move_alloc(grown, room%word)
        end if
        room%words = room%words + 1
        room%word(:, :, room%words) = label_corners(at, label)
    end subroutine take_label

    !> True where a label would hide nothing.
    pure logical function is_free(room, at, label)
        class(room_type), intent(in) :: room        !! what is taken
        real(dp), intent(in) :: at(2)               !! where it would stand, in
        type(label_type), intent(in) :: label       !! the words
        real(dp) :: corners(2, 4)
        integer :: i

        corners = label_corners(at, label)
        is_free = .false.
        do i = 1, room%lines
            if (meets_corners(room%line(:, i), corners)) return
        end do
        do i = 1, room%words
            if (.not. (is_apart(corners, room%word(:, :, i)) .or. &
                is_apart(room%word(:, :, i), corners))) return
        end do
        is_free = .true.
    end function is_free

    !> True where a side of the first box parts it from the second.
    pure logical function is_apart(first, second)
        real(dp), intent(in) :: first(2, 4)     !! corners of a rectangle in order, in
        real(dp), intent(in) :: second(2, 4)    !! corners of another, in
        real(dp) :: axis(2), reach, seen(4)
        integer :: k

        is_apart = .true.
        do k = 1, 2
            axis = first(:, k + 1) - first(:, k)
            reach = dot_product(axis, axis)
            seen = matmul(axis, second - spread(first(:, k), 2, 4))
            if (maxval(seen) <= 0.0_dp .or. minval(seen) >= reach) return
        end do
        is_apart = .false.
    end function is_apart

    !> True where a straight line meets a rectangle given by its corners.
    pure logical function meets_corners(line, corners) result(meets)
        real(dp), intent(in) :: line(4)         !! both ends, in
        real(dp), intent(in) :: corners(2, 4)   !! in order, in
        real(dp) :: along(2), up(2), ends(4)

        along = corners(:, 2) - corners(:, 1)
        up = corners(:, 4) - corners(:, 1)
        ends(1) = dot_product(along, line(:2) - corners(:, 1))
        ends(2) = dot_product(up, line(:2) - corners(:, 1))
        ends(3) = dot_product(along, line(3:) - corners(:, 1))
        ends(4) = dot_product(up, line(3:) - corners(:, 1))
        meets = meets_box(ends, [0.0_dp, 0.0_dp, dot_product(along, along), dot_product(up, up)])
    end function meets_corners

    !> True where a straight line meets a box; touching counts.
    !>
    !> Source: Y.-D. Liang and B. A. Barsky, ACM Transactions on Graphics 3 (1984) 1-22: the line is
    !> narrowed by the box's sides.
    pure logical function meets_box(line, box) result(meets)
        real(dp), intent(in) :: line(4)     !! both ends, in
        real(dp), intent(in) :: box(4)      !! left, bottom, right, top, in
        real(dp) :: from, to, step, entry, leave
        integer :: k

        meets = .false.
        from = 0.0_dp
        to = 1.0_dp
        do k = 1, 2
            if (max(line(k), line(k + 2)) < box(k)) return
            if (min(line(k), line(k + 2)) > box(k + 2)) return
            step = line(k + 2) - line(k)
            if (abs(step) < no_step) cycle
            entry = (box(k) - line(k))/step
            leave = (box(k + 2) - line(k))/step
            from = max(from, min(entry, leave))
            to = min(to, max(entry, leave))
        end do
        meets = from <= to
    end function meets_box

end module export_pattern_room
