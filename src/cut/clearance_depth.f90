!> The depth of points and boxes below the surface of a body: the distance from it, positive inside.
!> The depth of a box is the least of all its points.
!>
!> A point is inside where it is on the inner side of the skin at the nearest point; where its
!> station's section closes this section decides (`cut_clearance_inside`), and it is told where the
!> two disagree. A box that is clear of the skin is as near to it as the skin is to the box, faces
!> and edges included. Of a box that the skin passes, or that is outside, the point farthest beyond
!> the skin is looked for on its surface.
module cut_clearance_depth
    use base_kinds, only: dp
    use base_order, only: order_of
    use base_tolerances, only: decimal_noise, ulp
    use body_body, only: body_type
    use cut_clearance_inside, only: test_inside
    use cut_clearance_map, only: map_type
    use cut_clearance_nearest, only: box_type, foot_type, nearest_to, reach_of
    implicit none (type, external)
    private

    public :: depth_type, depth_of

    !> A point of a component with its depth below the surface.
    type :: depth_type
        real(dp) :: depth = 0.0_dp          !! deck units, negative outside
        type(foot_type) :: foot             !! the nearest point
        logical :: is_certain = .true.      !! normal and section do not disagree
    end type depth_type

    !> Samples along each edge of a box that pierces the skin, parts; and the best of them that are
    !> followed.
    integer, parameter :: box_parts = 8, box_starts = 4
    !> Halvings of the step on the way to the point of a box that is deepest beyond the skin.
    integer, parameter :: most_halvings = 44
    !> Part of its size by which a distance may be off.
    real(dp), parameter :: doubt = 1.0e-12_dp

contains

    !> The least depth of a box or a point below the surface.
    pure recursive type(depth_type) function depth_of(body, map, box) result(found)
        type(body_type), intent(in) :: body     !! finished
        type(map_type), intent(in) :: map       !! its samples
        type(box_type), intent(in) :: box       !! a box or a point
        logical :: is_inside

        found%foot = nearest_of_whole(body, map, box)
        if (.not. found%foot%exists) return
        call decide_side(body, found, is_inside)
        found%depth = sign(found%foot%distance, merge(1.0_dp, -1.0_dp, is_inside))
        if (is_inside .and. found%foot%distance > 0.0_dp) return
        if (all(box%upper <= box%lower)) return
        found = deepest(body, map, box)
    end function depth_of

    !> The nearest point of the whole skin: of a symmetric body also its port half.
    pure type(foot_type) function nearest_of_whole(body, map, box) result(foot)
        type(body_type), intent(in) :: body     !! finished
        type(map_type), intent(in) :: map       !! its samples
        type(box_type), intent(in) :: box       !! a box or a point
        type(box_type) :: image
        type(foot_type) :: other

        call nearest_to(body, map, box, foot)
        if (.not. body%is_symmetric .or. box%lower(2) >= 0.0_dp) return
        image = box
        image%lower(2) = -box%upper(2)
        image%upper(2) = -box%lower(2)
        call nearest_to(body, map, image, other)
        if (other%distance >= foot%distance) return
        foot = other
        foot%at(2) = -other%at(2)
        foot%touching(2) = -other%touching(2)
        foot%normal(2) = -other%normal(2)
    end function nearest_of_whole

    !> Decides whether the nearest point of a component is inside.
    pure subroutine decide_side(body, found, is_inside)
        type(body_type), intent(in) :: body         !! finished
        type(depth_type), intent(inout) :: found    !! has its foot; gets how certain it is
        logical, intent(out) :: is_inside           !! of the body
        logical :: is_known, is_within
        real(dp) :: height

        height = dot_product(found%foot%touching - found%foot%at, found%foot%normal)
        is_inside = height < 0.0_dp
        call test_inside(body, found%foot%touching, is_known, is_within)
        if (.not. is_known) return
        found%is_certain = (is_within .eqv. is_inside) .or. .not. found%foot%has_normal &
            .or. found%foot%distance <= decimal_noise*ulp*maxval(abs(found%foot%at))
        is_inside = is_within
    end subroutine decide_side

    !> The point of a box that is farthest beyond the skin. From the best samples of its surface the
    !> deepest point is followed in ever smaller steps along the axes, within the box.
    pure recursive type(depth_type) function deepest(body, map, box) result(found)
        type(body_type), intent(in) :: body     !! finished
        type(map_type), intent(in) :: map       !! its samples
        type(box_type), intent(in) :: box       !! a box
        type(depth_type) :: tries(box_starts), try
        real(dp) :: points(3, (box_parts + 1)**3)
        integer :: i, j, k, count

        count = 0
        do i = 0, box_parts
            do j = 0, box_parts
                do k = 0, box_parts
                    if (all([i, j, k] > 0 .and. [i, j, k] < box_parts)) cycle
                    count = count + 1
                    points(:, count) = mixed(box, real([i, j, k], dp)/real(box_parts, dp))
                end do
            end do
        end do
        tries = deepest_of(body, map, points(:, :count))
        found%depth = huge(1.0_dp)
        do i = 1, box_starts
            try = tries(i)
            call follow(body, map, box, try)
            if (try%depth < found%depth) found = try
        end do
    end function deepest

    !> The deepest of some points beyond the skin, deepest first; of equal ones the first. Those
    !> that can't be among them are not measured.
    pure recursive function deepest_of(body, map, points) result(best)
        type(body_type), intent(in) :: body     !! finished
        type(map_type), intent(in) :: map       !! its samples
        real(dp), intent(in) :: points(:, :)    !! STA, BL, WL, deck units, shape (3, number)
        type(depth_type) :: best(box_starts)
        type(depth_type) :: tries(size(points, 2))
        real(dp) :: least(size(points, 2)), limit
        integer :: order(size(points, 2)), i, k

        do i = 1, size(points, 2)
            least(i) = -farthest(body, map, points(:, i))
        end do
        order = order_of(least)
        tries%depth = huge(1.0_dp)
        limit = huge(1.0_dp)
        do i = 1, size(order)
            if (least(order(i)) > limit) exit
            if (limit < 0.0_dp .and. is_within(body, points(:, order(i)))) cycle
            tries(order(i)) = depth_at(body, map, points(:, order(i)))
            limit = least_but(tries%depth, box_starts)
        end do
        do i = 1, box_starts
            k = minloc(tries%depth, dim=1)
            best(i) = tries(k)
            tries(k)%depth = huge(1.0_dp)
        end do
    end function deepest_of

    !> The number of a list of which so many are least, itself counted.
    pure real(dp) function least_but(numbers, rank) result(number)
        real(dp), intent(in) :: numbers(:)  !! at least so many
        integer, intent(in) :: rank         !! how many
        integer :: order(size(numbers))
        order = order_of(numbers)
        number = numbers(order(rank))
    end function least_but

    !> How far a point can be from the skin at most.
    pure real(dp) function farthest(body, map, point)
        type(body_type), intent(in) :: body     !! finished
        type(map_type), intent(in) :: map       !! its samples
        real(dp), intent(in) :: point(3)        !! STA, BL, WL, deck units
        farthest = reach_of(body, map, point)
        if (farthest < huge(1.0_dp)*doubt) &
            farthest = farthest + doubt*(farthest + maxval(abs(point)))
    end function farthest

    !> True where the section of a point's station closes and has it inside.
    pure logical function is_within(body, point)
        type(body_type), intent(in) :: body     !! finished
        real(dp), intent(in) :: point(3)        !! STA, BL, WL, deck units
        logical :: is_known
        call test_inside(body, point, is_known, is_within)
        is_within = is_known .and. is_within
    end function is_within

    !> The point of a box at parts of its edges; exactly a corner at 0 and 1.
    pure function mixed(box, part) result(point)
        type(box_type), intent(in) :: box   !! a box
        real(dp), intent(in) :: part(3)     !! 0 at the lower, 1 at the upper corner
        real(dp) :: point(3)
        point = (1.0_dp - part)*box%lower + part*box%upper
    end function mixed

    !> The depth of a point.
    pure recursive type(depth_type) function depth_at(body, map, point) result(found)
        type(body_type), intent(in) :: body     !! finished
        type(map_type), intent(in) :: map       !! its samples
        real(dp), intent(in) :: point(3)        !! STA, BL, WL, deck units
        found = depth_of(body, map, box_type(point, point))
    end function depth_at

    !> Follows the depth down within a box, by steps along the axes that are halved where none leads
    !> further.
    pure recursive subroutine follow(body, map, box, try)
        type(body_type), intent(in) :: body         !! finished
        type(map_type), intent(in) :: map           !! its samples
        type(box_type), intent(in) :: box           !! a box
        type(depth_type), intent(inout) :: try      !! where to begin, and what is found
        type(depth_type) :: next
        real(dp) :: step(3), way(3)
        integer :: axis, halvings, side
        logical :: was_better

        step = (box%upper - box%lower)/real(box_parts, dp)
        do halvings = 1, most_halvings
            was_better = .true.
            do while (was_better)
                was_better = .false.
                do axis = 1, 3
                    do side = -1, 1, 2
                        way = 0.0_dp
                        way(axis) = real(side, dp)*step(axis)
                        way = min(max(try%foot%touching + way, box%lower), box%upper)
                        if (norm2(way - try%foot%touching) <= 0.0_dp) cycle
                        if (-farthest(body, map, way) > try%depth) cycle
                        if (try%depth < 0.0_dp .and. is_within(body, way)) cycle
                        next = depth_at(body, map, way)
                        if (.not. next%depth < try%depth) cycle
                        try = next
                        was_better = .true.
                    end do
                end do
            end do
            step = 0.5_dp*step
        end do
    end subroutine follow

end module cut_clearance_depth
