!> Flat faces where the skin of a closed body is open at a stop: over its ends, and between the
!> outlines of two runs that differ.
!>
!> The open edges of the skin in the plane of a stop, taken the other way, bound the faces; those of
!> a starboard half are joined along BL 0. Each loop is filled; one that runs against the loop
!> around it is a hole.
module export_mesh_cap
    use base_digits, only: shortest
    use base_exact, only: is_equal, is_zero
    use base_kinds, only: dp
    use export_mesh, only: add_normal, add_triangle, mesh_part_type, mesh_type
    use export_mesh_edge, only: half_edge
    use export_mesh_fill, only: area_of, bridged, fill_polygon, is_within
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: add_caps

    !> A closed way along edges.
    type :: loop_type
        integer, allocatable :: vertex(:)   !! in the mesh, in order
        real(dp) :: area = 0.0_dp           !! twice its area, WL over BL; above zero: faces aft
        integer :: outer = 0                !! of a hole: the loop it is in
    end type loop_type

contains

    !> Closes the mesh at all stops; each gets one part.
    pure subroutine add_caps(mesh, twin, stops, is_half)
        type(mesh_type), intent(inout) :: mesh  !! gets the faces
        integer, intent(in) :: twin(:)          !! of `find_twins`
        real(dp), intent(in) :: stops(:)        !! stations, deck units
        logical, intent(in) :: is_half          !! it is the starboard half: nothing is in BL 0
        integer, allocatable :: edges(:, :)
        type(loop_type), allocatable :: loops(:)
        type(mesh_part_type) :: part
        integer :: i, k

        do i = 1, size(stops)
            edges = open_edges(mesh, twin, stops(i), is_half)
            if (is_half) call join_centre(mesh, edges)
            loops = loops_of(mesh, edges)
            call find_holes(mesh, loops)
            part%name = 'CAP STA '//shortest(stops(i))
            part%first = mesh%triangle_count + 1
            part%last = mesh%triangle_count
            mesh%parts = [mesh%parts, part]
            do k = 1, size(loops)
                if (loops(k)%outer == 0) call fill_loop(loops, k, mesh)
            end do
            if (mesh%parts(size(mesh%parts))%last < part%first) &
                mesh%parts = mesh%parts(:size(mesh%parts) - 1)
        end do
    end subroutine add_caps

    !> The open edges in the plane of a stop, as a face beside them runs: from, to, and 1 where they
    !> bound the skin fore of it, -1 where aft.
    pure function open_edges(mesh, twin, sta, is_half) result(edges)
        type(mesh_type), intent(in) :: mesh     !! any
        integer, intent(in) :: twin(:)          !! of `find_twins`
        real(dp), intent(in) :: sta             !! deck units
        logical, intent(in) :: is_half          !! edges in BL 0 are not open
        integer, allocatable :: edges(:, :), found(:)
        integer :: i, ends(2), side

        allocate (found(0))
        do i = 1, size(twin)
            if (twin(i) > 0) cycle
            ends = half_edge(mesh, i)
            if (.not. all(is_equal(mesh%vertices(1, ends), sta))) cycle
            if (is_half .and. all(is_zero(mesh%vertices(2, ends)))) cycle
            side = 1
            if (any(mesh%vertices(1, mesh%triangles(:, (i - 1)/3 + 1)) > sta)) side = -1
            found = [found, ends(2), ends(1), side]
        end do
        edges = reshape(found, [3, size(found)/3])
    end function open_edges

    !> Joins ends of chains of edges at BL 0, from the lowest to the next and so on.
    pure subroutine join_centre(mesh, edges)
        type(mesh_type), intent(in) :: mesh                 !! any
        integer, allocatable, intent(inout) :: edges(:, :)  !! gets the edges in BL 0
        integer, allocatable :: ends(:)
        integer :: i, k, v, excess

        allocate (ends(0))
        do i = 1, 2*size(edges, 2)
            v = edges(2 - mod(i, 2), (i + 1)/2)
            excess = count(edges(2, :) == v) - count(edges(1, :) == v)
            if (excess == 0 .or. any(abs(ends) == v)) cycle
            if (.not. is_zero(mesh%vertices(2, v))) cycle
            ends = [ends, sign(v, excess)]
        end do
        do i = 2, size(ends)
            do k = i, 2, -1
                if (mesh%vertices(3, abs(ends(k))) >= mesh%vertices(3, abs(ends(k - 1)))) exit
                ends([k - 1, k]) = ends([k, k - 1])
            end do
        end do
        do i = 1, size(ends) - 1, 2
            if (ends(i) > 0 .eqv. ends(i + 1) > 0) cycle
            edges = reshape([edges, max(ends(i), ends(i + 1)), -min(ends(i), ends(i + 1)), 0], &
                [3, size(edges, 2) + 1])
        end do
    end subroutine join_centre

    !> The loops that edges make; edges that lead nowhere are left out.
    pure function loops_of(mesh, edges) result(loops)
        type(mesh_type), intent(in) :: mesh     !! any
        integer, intent(in) :: edges(:, :)      !! of `open_edges`; shape (3, edges)
        type(loop_type), allocatable :: loops(:)
        type(loop_type) :: loop
        integer :: way(size(edges, 2)), i, n, next
        logical :: is_free(size(edges, 2))

        allocate (loops(0))
        is_free = .true.
        do i = 1, size(edges, 2)
            if (.not. is_free(i)) cycle
            n = 0
            next = i
            do while (next > 0)
                n = n + 1
                way(n) = next
                is_free(next) = .false.
                if (edges(2, next) == edges(1, i)) exit
                next = next_edge(mesh, edges, is_free, next)
            end do
            if (next == 0) cycle
            loop%vertex = edges(1, way(:n))
            loop%area = area_of(mesh%vertices(2:, loop%vertex))
            if (n > 2) loops = [loops, loop]
        end do
    end function loops_of

    !> The free edge that goes on from another, or 0. Of several it is one that bounds the other
    !> side, because there the outlines of both sides cross or touch; else the one that keeps
    !> nearest to the face.
    pure integer function next_edge(mesh, edges, is_free, edge) result(next)
        type(mesh_type), intent(in) :: mesh     !! any
        integer, intent(in) :: edges(:, :)      !! of `open_edges`
        logical, intent(in) :: is_free(:)       !! not in a loop yet
        integer, intent(in) :: edge             !! the one that is gone on from
        real(dp) :: ahead(2), way(2), turn, most
        real(dp), parameter :: any_turn = 10.0_dp
        integer :: i

        next = 0
        most = -huge(most)
        ahead = mesh%vertices(2:, edges(2, edge)) - mesh%vertices(2:, edges(1, edge))
        do i = 1, size(edges, 2)
            if (.not. is_free(i) .or. edges(1, i) /= edges(2, edge)) cycle
            way = mesh%vertices(2:, edges(2, i)) - mesh%vertices(2:, edges(1, i))
            turn = real(edges(3, edge), dp)*atan2(cross(ahead, way), dot_product(ahead, way))
            if (edges(3, i) /= edges(3, edge)) turn = turn + any_turn
            if (turn <= most) cycle
            most = turn
            next = i
        end do
    end function next_edge

    !> Finds which loops are holes: those inside of a loop that runs the other way, with none
    !> between.
    pure subroutine find_holes(mesh, loops)
        type(mesh_type), intent(in) :: mesh             !! any
        type(loop_type), intent(inout) :: loops(:)      !! of one stop
        integer :: i, k, around

        do i = 1, size(loops)
            around = 0
            do k = 1, size(loops)
                if (k == i .or. abs(loops(k)%area) <= abs(loops(i)%area)) cycle
                if (.not. is_within(mesh%vertices(2:, loops(i)%vertex(1)), &
                    mesh%vertices(2:, loops(k)%vertex))) cycle
                if (around == 0) around = k
                if (abs(loops(k)%area) < abs(loops(around)%area)) around = k
            end do
            if (around == 0) cycle
            if (loops(around)%area*loops(i)%area < 0.0_dp) loops(i)%outer = around
        end do
    end subroutine find_holes

    !> Fills a loop around its holes.
    pure subroutine fill_loop(loops, number, mesh)
        type(loop_type), intent(in) :: loops(:)     !! of one stop
        integer, intent(in) :: number               !! which to fill
        type(mesh_type), intent(inout) :: mesh      !! gets the triangles
        integer, allocatable :: corner(:), triangles(:, :)
        real(dp) :: facing
        integer :: i, order(3)

        facing = sign(1.0_dp, loops(number)%area)
        allocate (corner(0))
        corner = turned(loops(number)%vertex)
        do i = 1, size(loops)
            if (loops(i)%outer == number) &
                corner = bridged(mesh%vertices(2:, :), corner, turned(loops(i)%vertex))
        end do
        allocate (triangles, source=fill_polygon(mesh%vertices(2:, corner)))
        call add_normal(mesh, [facing, 0.0_dp, 0.0_dp])
        order = [1, 2, 3]
        if (facing < 0.0_dp) order = [1, 3, 2]
        do i = 1, size(triangles, 2)
            call add_triangle(mesh, corner(triangles(order, i)), &
                [mesh%normal_count, mesh%normal_count, mesh%normal_count])
        end do
    contains
        !> Corners in the order that makes the loop run counter-clockwise.
        pure function turned(vertex)
            integer, intent(in) :: vertex(:) !! in order
            integer :: turned(size(vertex))
            turned = vertex
            if (facing < 0.0_dp) turned = vertex(size(vertex):1:-1)
        end function turned
    end subroutine fill_loop

end module export_mesh_cap
