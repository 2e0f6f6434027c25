!> The vertices along the sides of a panel in a mesh: those that skin and other panels have there
!> already, so that triangles meet edge to edge, and its own between them.
module export_mesh_border
    use base_kinds, only: dp
    use base_order, only: ascending, order_of
    use body_panel, only: panel_type
    use body_panel_side, only: place_on
    use export_mesh, only: add_vertex, mesh_type
    use export_mesh_edge, only: half_edge
    use geom_bspline_surface, only: surface_jet, surface_point
    implicit none (type, external)
    private

    public :: border_type, lay_borders

    !> A side: its vertices from the corner where it begins to the one where it ends.
    type :: border_type
        integer, allocatable :: vertex(:)   !! in the mesh; of a side that is a point one
        real(dp), allocatable :: t(:)       !! 0 to 1 along the side, rising
    end type border_type

    !> A side of a panel and the open edges of the mesh.
    type :: track_type
        type(panel_type) :: panel           !! the panel
        integer :: number = 1               !! which side
        integer, allocatable :: ends(:, :)  !! vertices of the open edges; shape (edges, 2)
        real(dp) :: reach = 0.0_dp          !! how near vertices are that are one, deck units
        logical :: is_half = .false.        !! vertices at BL 0 are there exactly
    end type track_type

    !> How near vertices of others are to a side they lie on, relative to the panel: more than
    !> `panel_tolerance`, less than any mesh is fine.
    real(dp), parameter :: nearness = 1.0e-7_dp
    !> Samples of a side, and steps, that find the place of a vertex on it.
    integer, parameter :: samples = 200, steps = 20
    !> A place nearer than this to a corner is the corner.
    real(dp), parameter :: corner_noise = 1.0e-6_dp
    !> A vertex of its own is not laid nearer to one of others than this part of a cell.
    real(dp), parameter :: least_gap = 0.25_dp

contains

    !> Lays the vertices of all sides. `open` are half edges of the mesh without a twin.
    pure subroutine lay_borders(panel, cells, open, is_half, mesh, border)
        type(panel_type), intent(in) :: panel           !! the panel
        integer, intent(in) :: cells(2)                 !! its cells along u and v
        integer, intent(in) :: open(:)                  !! numbers of half edges
        logical, intent(in) :: is_half                  !! vertices at BL 0 are there exactly
        type(mesh_type), intent(inout) :: mesh          !! gets the vertices that are not there
        type(border_type), intent(out) :: border(4)     !! in the order of the sides
        type(track_type) :: track
        integer :: corner(4), number, next

        track%panel = panel
        track%reach = nearness*size_of(panel)
        track%is_half = is_half
        allocate (track%ends(size(open), 2))
        do number = 1, size(open)
            track%ends(number, :) = half_edge(mesh, open(number))
        end do
        do number = 1, 4
            call lay(track, place_on(number, 0.0_dp), mesh, corner(number))
        end do
        if (panel%is_round) corner([2, 3]) = corner([1, 4])
        if (panel%point > 0) corner(1 + mod(panel%point, 4)) = corner(panel%point)
        do number = 1, 4
            next = 1 + mod(number, 4)
            track%number = number
            if (number == panel%point) then
                border(number)%vertex = [corner(number)]
                border(number)%t = [0.5_dp]
            else if (panel%is_round .and. number == 4) then
                border(4)%vertex = border(2)%vertex(size(border(2)%vertex):1:-1)
                border(4)%t = 1.0_dp - border(2)%t(size(border(2)%t):1:-1)
            else
                call lay_side(track, cells(merge(1, 2, mod(number, 2) == 1)), mesh, border(number))
                border(number)%vertex = [corner(number), border(number)%vertex, corner(next)]
                border(number)%t = [0.0_dp, border(number)%t, 1.0_dp]
            end if
        end do
    end subroutine lay_borders

    !> Lays a vertex, unless an open edge ends there.
    pure subroutine lay(track, uv, mesh, vertex)
        type(track_type), intent(in) :: track   !! panel and open edges
        real(dp), intent(in) :: uv(2)           !! 0 to 1
        type(mesh_type), intent(inout) :: mesh  !! gets it, if new
        integer, intent(out) :: vertex          !! its number
        real(dp) :: at(3)
        integer :: i, k

        at = surface_point(track%panel%surface, uv(1), uv(2))
        do i = 1, size(track%ends, 1)
            do k = 1, 2
                vertex = track%ends(i, k)
                if (norm2(mesh%vertices(:, vertex) - at) <= track%reach) return
            end do
        end do
        if (track%is_half .and. abs(at(2)) <= track%reach) at(2) = 0.0_dp
        call add_vertex(mesh, at)
        vertex = mesh%vertex_count
    end subroutine lay

    !> Lays the vertices of a side between its corners.
    pure subroutine lay_side(track, cells, mesh, border)
        type(track_type), intent(in) :: track       !! the side
        integer, intent(in) :: cells                !! along it
        type(mesh_type), intent(inout) :: mesh      !! gets vertices
        type(border_type), intent(out) :: border    !! without the corners
        real(dp), allocatable :: covered(:, :)
        real(dp) :: s
        integer :: i, new

        call find_shared(track, mesh, border, covered)
        do i = 1, cells - 1
            s = real(i, dp)/real(cells, dp)
            if (any(s >= covered(1, :) .and. s <= covered(2, :))) cycle
            if (any(abs(border%t - s) < least_gap/real(cells, dp))) cycle
            call lay(track, place_on(track%number, s), mesh, new)
            border%vertex = [border%vertex, new]
            border%t = [border%t, s]
        end do
        border%vertex = border%vertex(order_of(border%t))
        border%t = ascending(border%t)
    end subroutine lay_side

    !> Finds the vertices of open edges on a side, its corners left out, and what these edges cover.
    pure subroutine find_shared(track, mesh, border, covered)
        type(track_type), intent(in) :: track               !! the side
        type(mesh_type), intent(in) :: mesh                 !! has the vertices
        type(border_type), intent(out) :: border            !! each vertex once, in no order
        real(dp), allocatable, intent(out) :: covered(:, :) !! from, to; shape (2, edges)
        real(dp) :: places(2), off
        integer :: i, k

        allocate (border%vertex(0), border%t(0), covered(2, 0))
        do i = 1, size(track%ends, 1)
            do k = 1, 2
                call find_place(track, mesh%vertices(:, track%ends(i, k)), places(k), off)
                if (off > track%reach) exit
            end do
            if (k <= 2) cycle
            covered = reshape([covered, minval(places), maxval(places)], [2, size(covered, 2) + 1])
            do k = 1, 2
                if (places(k) <= corner_noise .or. places(k) >= 1.0_dp - corner_noise) cycle
                if (any(border%vertex == track%ends(i, k))) cycle
                border%vertex = [border%vertex, track%ends(i, k)]
                border%t = [border%t, places(k)]
            end do
        end do
    end subroutine find_shared

    !> The place on a side that is nearest to a point; one that is far from all of the panel is not
    !> looked for.
    pure subroutine find_place(track, at, t, off)
        type(track_type), intent(in) :: track   !! the side
        real(dp), intent(in) :: at(3)           !! the point, deck units
        real(dp), intent(out) :: t              !! 0 to 1
        real(dp), intent(out) :: off            !! how far it is, deck units
        real(dp) :: uv(2), point(3), u(3), v(3), way(3)
        integer :: i

        t = 0.0_dp
        off = huge(1.0_dp)
        do i = 1, 3
            if (at(i) < minval(track%panel%surface%pole(i, :, :)) - track%reach) return
            if (at(i) > maxval(track%panel%surface%pole(i, :, :)) + track%reach) return
        end do
        do i = 0, samples
            uv = place_on(track%number, real(i, dp)/real(samples, dp))
            point = surface_point(track%panel%surface, uv(1), uv(2))
            if (norm2(point - at) >= off) cycle
            off = norm2(point - at)
            t = real(i, dp)/real(samples, dp)
        end do
        do i = 1, steps
            uv = place_on(track%number, t)
            call surface_jet(track%panel%surface, uv(1), uv(2), point, u, v)
            way = merge(u, v, mod(track%number, 2) == 1)
            if (track%number > 2) way = -way
            if (.not. dot_product(way, way) > 0.0_dp) exit
            t = min(max(t + dot_product(at - point, way)/dot_product(way, way), 0.0_dp), 1.0_dp)
        end do
        uv = place_on(track%number, t)
        off = norm2(surface_point(track%panel%surface, uv(1), uv(2)) - at)
    end subroutine find_place

    !> The largest extent of a panel, deck units.
    pure real(dp) function size_of(panel)
        type(panel_type), intent(in) :: panel !! any
        integer :: i
        size_of = maxval([(maxval(panel%surface%pole(i, :, :)) &
            - minval(panel%surface%pole(i, :, :)), i = 1, 3)])
    end function size_of

end module export_mesh_border
