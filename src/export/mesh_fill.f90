!> Triangles of a flat polygon, also of one that is not convex or has holes, by cutting off ears: of
!> all corners that can be cut off the one of the best shape goes first.
!>
!> Source: G. H. Meisters, "Polygons have ears", American Mathematical Monthly 82 (1975), 648-651;
!> holes as D. Eberly, "Triangulation by ear clipping", Geometric Tools 2002.
module export_mesh_fill
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: fill_polygon, area_of, is_within, bridged

    !> The shape of a corner that is no ear.
    real(dp), parameter :: no_ear = -1.0_dp

    !> What is known of a corner of a polygon while its ears are cut off.
    type :: corner_type
        logical :: is_left = .true.     !! not cut off yet
        integer :: before = 0           !! the corner before it
        integer :: behind = 0           !! the corner behind it
        real(dp) :: shape = no_ear      !! of its ear
        integer :: blocker = 0          !! a corner that was found inside of its ear
    end type corner_type

contains

    !> Twice the area of a polygon, positive where it runs counter-clockwise.
    pure real(dp) function area_of(at) result(area)
        real(dp), intent(in) :: at(:, :) !! its corners; shape (2, corners)
        integer :: i
        area = 0.0_dp
        do i = 2, size(at, 2) - 1
            area = area + cross(at(:, i) - at(:, 1), at(:, i + 1) - at(:, 1))
        end do
    end function area_of

    !> True where a point is within a polygon, by the sides that a ray crosses.
    pure logical function is_within(point, at)
        real(dp), intent(in) :: point(2)    !! any
        real(dp), intent(in) :: at(:, :)    !! corners of the polygon; shape (2, corners)
        integer :: i, k
        real(dp) :: side

        is_within = .false.
        k = size(at, 2)
        do i = 1, size(at, 2)
            if ((at(2, i) > point(2)) .neqv. (at(2, k) > point(2))) then
                side = cross(at(:, i) - at(:, k), point - at(:, k))
                if ((side > 0.0_dp) .eqv. (at(2, i) > at(2, k))) is_within = .not. is_within
            end if
            k = i
        end do
    end function is_within

    !> The triangles of a polygon that runs counter-clockwise: always two fewer than it has corners,
    !> also where it has no area.
    pure function fill_polygon(at) result(triangles)
        real(dp), intent(in) :: at(:, :)        !! its corners; shape (2, corners)
        integer, allocatable :: triangles(:, :) !! corners; shape (3, corners - 2)
        type(corner_type) :: corner(size(at, 2))
        integer :: n, i, k, ear

        n = size(at, 2)
        corner%before = [n, (i, i=1, n - 1)]
        corner%behind = [(i, i=2, n), 1]
        do i = 1, n
            corner(i)%shape = ear_shape(at(:, [corner(i)%before, i, corner(i)%behind]))
        end do
        allocate (triangles(3, max(0, n - 2)))
        do k = 1, n - 2
            call find_ear(at, corner, ear)
            associate (before => corner(ear)%before, behind => corner(ear)%behind)
                triangles(:, k) = [before, ear, behind]
                corner(ear)%is_left = .false.
                corner(before)%behind = behind
                corner(behind)%before = before
                do i = 1, n
                    if (corner(i)%blocker /= ear .and. i /= before .and. i /= behind) cycle
                    corner(i)%blocker = 0
                    corner(i)%shape = ear_shape(at(:, [corner(i)%before, i, corner(i)%behind]))
                end do
            end associate
        end do
    end function fill_polygon

    !> A corner that is inside of an ear or on its sides, or 0. One in the same point as a corner of
    !> the ear, at the other side of a bridge, is none.
    pure integer function blocker_of(at, corner, ear) result(blocker)
        real(dp), intent(in) :: at(:, :)                !! corners of the polygon
        type(corner_type), intent(in) :: corner(:)      !! what is known of them
        integer, intent(in) :: ear(3)                   !! corners of the ear
        real(dp) :: low(2), high(2)
        integer :: i, k

        low = minval(at(:, ear), dim=2)
        high = maxval(at(:, ear), dim=2)
        do blocker = 1, size(at, 2)
            if (.not. corner(blocker)%is_left) cycle
            if (any(at(:, blocker) < low) .or. any(at(:, blocker) > high)) cycle
            if (any([(all(is_equal(at(:, blocker), at(:, ear(i)))), i=1, 3)])) cycle
            k = count([(cross(at(:, ear(mod(i, 3) + 1)) - at(:, ear(i)), &
                at(:, blocker) - at(:, ear(i))) >= 0.0_dp, i=1, 3)])
            if (k == 3) return
        end do
        blocker = 0
    end function blocker_of

    !> Finds the corner to cut off next: the best-shaped ear; where rounding leaves none, the corner
    !> that is most convex.
    pure subroutine find_ear(at, corner, ear)
        real(dp), intent(in) :: at(:, :)                !! corners of the polygon
        type(corner_type), intent(inout) :: corner(:)   !! what is known of them
        integer, intent(out) :: ear                     !! which corner
        integer :: i

        do
            ear = maxloc(corner%shape, dim=1, mask=corner%is_left)
            associate (it => corner(ear))
                if (.not. it%shape > 0.0_dp) exit
                it%blocker = blocker_of(at, corner, [it%before, ear, it%behind])
                if (it%blocker == 0) return
                it%shape = no_ear
            end associate
        end do
        ear = maxloc([(cross(at(:, i) - at(:, corner(i)%before), &
            at(:, corner(i)%behind) - at(:, i)), i=1, size(at, 2))], dim=1, mask=corner%is_left)
    end subroutine find_ear

    !> The shape of a triangle: its area in that of the square on its longest side; `no_ear` where
    !> it is not convex.
    pure real(dp) function ear_shape(at)
        real(dp), intent(in) :: at(2, 3) !! its corners by columns
        real(dp) :: area, longest

        ear_shape = no_ear
        area = cross(at(:, 2) - at(:, 1), at(:, 3) - at(:, 1))
        if (.not. area > 0.0_dp) return
        longest = max(norm2(at(:, 2) - at(:, 1)), norm2(at(:, 3) - at(:, 2)), &
            norm2(at(:, 1) - at(:, 3)))
        ear_shape = area/longest**2
    end function ear_shape

    !> A loop with a hole joined to it by a bridge that is run through both ways: the shortest one
    !> from the hole's last corner along the first axis that crosses no side.
    pure function bridged(at, loop, hole) result(joined)
        real(dp), intent(in) :: at(:, :)    !! points; shape (2, points)
        integer, intent(in) :: loop(:)      !! counter-clockwise
        integer, intent(in) :: hole(:)      !! clockwise, inside of it
        integer, allocatable :: joined(:)
        logical :: is_open(size(loop))
        integer :: i, p, q

        q = maxloc(at(1, hole), dim=1)
        is_open = .true.
        do
            p = minloc([(norm2(at(:, loop(i)) - at(:, hole(q))), i=1, size(loop))], dim=1, &
                mask=is_open)
            is_open(p) = .false.
            if (.not. any(is_open)) exit
            if (crosses(at, [loop(p), hole(q)], loop)) cycle
            if (.not. crosses(at, [loop(p), hole(q)], hole)) exit
        end do
        joined = [loop(:p), hole(q:), hole(:q), loop(p:)]
    end function bridged

    !> True where a line crosses a side of a loop that does not end at it.
    pure logical function crosses(at, line, loop)
        real(dp), intent(in) :: at(:, :)    !! points; shape (2, points)
        integer, intent(in) :: line(2)      !! its ends
        integer, intent(in) :: loop(:)      !! corners in order
        real(dp) :: turns(4)
        integer :: i, ends(2)

        crosses = .true.
        do i = 1, size(loop)
            ends = loop([i, mod(i, size(loop)) + 1])
            if (any(ends == line(1)) .or. any(ends == line(2))) cycle
            turns = [turn(line(1), line(2), ends(1)), turn(line(1), line(2), ends(2)), &
                turn(ends(1), ends(2), line(1)), turn(ends(1), ends(2), line(2))]
            if (turns(1)*turns(2) <= 0.0_dp .and. turns(3)*turns(4) <= 0.0_dp) return
        end do
        crosses = .false.
    contains
        !> The sense in which three points are run through: 1, 0 or -1.
        pure real(dp) function turn(i, j, k)
            integer, intent(in) :: i !! a point
            integer, intent(in) :: j !! another
            integer, intent(in) :: k !! another
            real(dp) :: area
            area = cross(at(:, j) - at(:, i), at(:, k) - at(:, i))
            turn = merge(sign(1.0_dp, area), 0.0_dp, abs(area) > 0.0_dp)
        end function turn
    end function crosses

end module export_mesh_fill
