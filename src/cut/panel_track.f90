!> Where a plane crosses a panel: tracks, each a row of points in u and v, found on a mesh over the
!> panel. Points lie on the lines of the mesh, to rounding; between two of them a track is followed
!> by `cut_panel_walk`.
!>
!> The mesh has the knots of the surface and at least `fewest_cells` cells each way. An outline that
!> is closed inside one cell is not seen. A side that lies in the plane is a track of its own. Of a
!> duct the mesh is closed around: the line u = 1 is the line u = 0.
!>
!> Source: marching squares; the doubtful case is decided by the middle of the cell.
module cut_panel_track
    use base_kinds, only: dp
    use base_tolerances, only: ulp
    use body_panel, only: panel_noise, panel_reach, panel_type
    use cut_chain, only: chain_type, chains_of, part_type
    use cut_plane, only: height_over, plane_type
    use geom_bspline_basis, only: breaks_of
    use geom_bspline_surface, only: surface_point
    implicit none (type, external)
    private

    public :: panel_track_type, panel_tracks

    !> A track.
    type :: panel_track_type
        real(dp), allocatable :: uv(:, :)   !! its points on the panel, shape (2, points)
        real(dp), allocatable :: at(:, :)   !! in space, deck units, shape (3, points)
        logical :: is_closed = .false.      !! the last point is the first
    end type panel_track_type

    !> The mesh over a panel.
    type :: mesh_type
        real(dp), allocatable :: u(:)           !! rising from 0 to 1
        real(dp), allocatable :: v(:)           !! rising from 0 to 1
        real(dp), allocatable :: h(:, :)        !! height over the plane, deck units
        logical, allocatable :: is_above(:, :)  !! on which side of the plane
        real(dp) :: noise = 0.0_dp              !! heights below it are rounding, deck units
        real(dp) :: reach = 0.0_dp              !! of edges whose sides lie in the plane, at most
    end type mesh_type

    !> A piece of a track, across one cell.
    type :: piece_type
        real(dp) :: uv(2, 2) = 0.0_dp           !! its ends on the panel
    end type piece_type

    !> Cells each way at least.
    integer, parameter :: fewest_cells = 48
    !> A piece shorter than this many times the noise is none: its direction would be noise.
    real(dp), parameter :: shortest_piece = 1000.0_dp
    integer, parameter :: most_steps = 200  !! to a crossing on a line of the mesh

contains

    !> The tracks of a plane. A panel that lies in the plane has none.
    pure subroutine panel_tracks(panel, plane, tracks)
        type(panel_type), intent(in) :: panel                           !! any
        type(plane_type), intent(in) :: plane                           !! any
        type(panel_track_type), allocatable, intent(out) :: tracks(:)   !! in no order
        type(mesh_type) :: mesh
        type(piece_type), allocatable :: pieces(:)
        integer :: i, j

        allocate (tracks(0), pieces(0))
        call lay_mesh(panel, plane, mesh)
        if (all(abs(mesh%h) <= mesh%reach)) return
        call take_sides(panel, mesh, tracks)
        do j = 1, size(mesh%v) - 1
            do i = 1, size(mesh%u) - 1
                call cross_cell(panel, plane, mesh, i, j, pieces)
            end do
        end do
        call link(panel, mesh%noise, pieces, tracks)
    end subroutine panel_tracks

    !> Lays the mesh over a panel.
    pure subroutine lay_mesh(panel, plane, mesh)
        type(panel_type), intent(in) :: panel   !! any
        type(plane_type), intent(in) :: plane   !! any
        type(mesh_type), intent(out) :: mesh    !! its lines and heights
        integer :: i, j

        mesh%noise = panel_noise(panel)
        mesh%reach = panel_reach(panel)
        allocate (mesh%u(0), mesh%v(0))
        mesh%u = lines_of(breaks_of(panel%surface%u_knot))
        mesh%v = lines_of(breaks_of(panel%surface%v_knot))
        allocate (mesh%h(size(mesh%u), size(mesh%v)))
        do j = 1, size(mesh%v)
            do i = 1, size(mesh%u)
                mesh%h(i, j) = height_over(plane, &
                    surface_point(panel%surface, mesh%u(i), mesh%v(j)))
            end do
        end do
        if (panel%is_round) mesh%h(size(mesh%u), :) = mesh%h(1, :)
        mesh%is_above = mesh%h >= -mesh%noise
    end subroutine lay_mesh

    !> The lines of a mesh: the knots, with as many lines between two as make it fine enough.
    pure function lines_of(breaks) result(lines)
        real(dp), intent(in) :: breaks(:)   !! rising
        real(dp), allocatable :: lines(:)
        integer :: parts, i, k

        parts = max(2, 1 + (fewest_cells - 1)/(size(breaks) - 1))
        allocate (lines(1), source=breaks(1))
        do i = 1, size(breaks) - 1
            lines = [lines, (breaks(i) + real(k, dp)/real(parts, dp)*(breaks(i + 1) - breaks(i)), &
                k = 1, parts - 1), breaks(i + 1)]
        end do
    end function lines_of

    !> Takes the sides that lie in the plane as tracks; their points are then on the side of the
    !> plane that the panel beside them is on.
    pure subroutine take_sides(panel, mesh, tracks)
        type(panel_type), intent(in) :: panel                               !! any
        type(mesh_type), intent(inout) :: mesh                              !! over it
        type(panel_track_type), allocatable, intent(inout) :: tracks(:)     !! gets the sides
        integer :: m, n

        m = size(mesh%u)
        n = size(mesh%v)
        if (is_in(mesh%h(:, 1))) then
            mesh%is_above(:, 1) = mesh%is_above(:, 2)
            call take(panel, 1, mesh%u, spread(0.0_dp, 1, m), tracks)
        end if
        if (is_in(mesh%h(:, n))) then
            mesh%is_above(:, n) = mesh%is_above(:, n - 1)
            call take(panel, 3, mesh%u, spread(1.0_dp, 1, m), tracks)
        end if
        if (panel%is_round) return
        if (is_in(mesh%h(1, :))) then
            mesh%is_above(1, :) = mesh%is_above(2, :)
            call take(panel, 4, spread(0.0_dp, 1, n), mesh%v, tracks)
        end if
        if (is_in(mesh%h(m, :))) then
            mesh%is_above(m, :) = mesh%is_above(m - 1, :)
            call take(panel, 2, spread(1.0_dp, 1, n), mesh%v, tracks)
        end if
    contains
        !> True where an edge is as near to the plane as to a side in it.
        pure logical function is_in(h)
            real(dp), intent(in) :: h(:) !! of a side
            is_in = all(abs(h) <= mesh%reach)
        end function is_in
    end subroutine take_sides

    !> Takes a side, unless it is a point.
    pure subroutine take(panel, side, u, v, tracks)
        type(panel_type), intent(in) :: panel                               !! any
        integer, intent(in) :: side                                         !! which
        real(dp), intent(in) :: u(:)                                        !! its points
        real(dp), intent(in) :: v(:)                                        !! as many
        type(panel_track_type), allocatable, intent(inout) :: tracks(:)     !! gets it
        type(panel_track_type) :: track

        if (side == panel%point) return
        track = track_through(panel, reshape([u, v], [2, size(u)], order=[2, 1]))
        tracks = [tracks, track]
    end subroutine take

    !> The track through some points.
    pure type(panel_track_type) function track_through(panel, uv) result(track)
        type(panel_type), intent(in) :: panel   !! any
        real(dp), intent(in) :: uv(:, :)        !! points, shape (2, points)
        integer :: i
        allocate (track%uv, source=uv)
        allocate (track%at(3, size(uv, 2)))
        do i = 1, size(uv, 2)
            track%at(:, i) = surface_point(panel%surface, uv(1, i), uv(2, i))
        end do
        track%is_closed = panel%is_round .and. all(abs(uv(:, size(uv, 2)) - uv(:, 1) &
            - [1.0_dp, 0.0_dp]) <= 0.0_dp)
        if (track%is_closed) track%uv(:, size(uv, 2)) = uv(:, 1)
    end function track_through

    !> Adds the pieces of tracks across a cell: from where the plane crosses one of its sides to
    !> where it crosses another.
    pure subroutine cross_cell(panel, plane, mesh, i, j, pieces)
        type(panel_type), intent(in) :: panel                       !! any
        type(plane_type), intent(in) :: plane                       !! any
        type(mesh_type), intent(in) :: mesh                         !! over the panel
        integer, intent(in) :: i                                    !! which cell along u
        integer, intent(in) :: j                                    !! which cell along v
        type(piece_type), allocatable, intent(inout) :: pieces(:)   !! gets none, one or two
        integer, parameter :: corner(2, 4) = reshape([0, 0, 1, 0, 1, 1, 0, 1], [2, 4])
        logical :: above(4), is_crossed(4)
        real(dp) :: uv(2, 4), middle
        integer :: k, sides(4), count_of

        do k = 1, 4
            above(k) = mesh%is_above(i + corner(1, k), j + corner(2, k))
        end do
        is_crossed = above .neqv. cshift(above, 1)
        if (.not. any(is_crossed)) return
        do k = 1, 4
            if (is_crossed(k)) uv(:, k) = crossing(panel, plane, mesh, [i, j] + corner(:, k), &
                [i, j] + corner(:, 1 + mod(k, 4)))
        end do
        count_of = count(is_crossed)
        sides(:count_of) = pack([1, 2, 3, 4], is_crossed)
        if (count_of == 4) then
            middle = height_over(plane, surface_point(panel%surface, &
                0.5_dp*(mesh%u(i) + mesh%u(i + 1)), 0.5_dp*(mesh%v(j) + mesh%v(j + 1))))
            if (.not. ((middle >= 0.0_dp) .eqv. above(1))) sides = [4, 1, 2, 3]
        end if
        do k = 1, count_of, 2
            pieces = [pieces, piece_type(uv(:, sides(k:k + 1)))]
        end do
    end subroutine cross_cell

    !> Where the plane crosses a line of the mesh between two of its points: by false position that
    !> halves the height it keeps (the Illinois rule), always from the point with the lower numbers,
    !> so that the cells on both sides have the same.
    pure function crossing(panel, plane, mesh, one, other) result(uv)
        type(panel_type), intent(in) :: panel   !! any
        type(plane_type), intent(in) :: plane   !! any
        type(mesh_type), intent(in) :: mesh     !! over the panel
        integer, intent(in) :: one(2)           !! a point of the mesh
        integer, intent(in) :: other(2)         !! its neighbour
        real(dp) :: uv(2), from(2), to(2), t(2), h(2), next, height
        integer :: low(2), high(2), i, kept

        low = min(one, other)
        high = max(one, other)
        if (panel%is_round .and. low(1) == size(mesh%u)) then
            low(1) = 1
            high(1) = 1
        end if
        from = [mesh%u(low(1)), mesh%v(low(2))]
        to = [mesh%u(high(1)), mesh%v(high(2))]
        h = [mesh%h(low(1), low(2)), mesh%h(high(1), high(2))]
        t = [0.0_dp, 1.0_dp]
        if (.not. h(1)*h(2) < 0.0_dp) then
            uv = merge(from, to, abs(h(1)) <= abs(h(2)))
            return
        end if
        kept = 0
        do i = 1, most_steps
            next = t(1) - h(1)*((t(2) - t(1))/(h(2) - h(1)))
            if (.not. (next > t(1) .and. next < t(2))) next = 0.5_dp*sum(t)
            uv = from + next*(to - from)
            height = height_over(plane, surface_point(panel%surface, uv(1), uv(2)))
            if (abs(height) <= 0.0_dp .or. t(2) - t(1) <= 2.0_dp*ulp) return
            if ((height > 0.0_dp) .eqv. (h(1) > 0.0_dp)) then
                t(1) = next
                h(1) = height
                if (kept == 2) h(2) = 0.5_dp*h(2)
                kept = 2
            else
                t(2) = next
                h(2) = height
                if (kept == 1) h(1) = 0.5_dp*h(1)
                kept = 1
            end if
        end do
    end function crossing

    !> Links pieces to tracks. Those of no length, at corners of the mesh, are dropped.
    pure subroutine link(panel, noise, pieces, tracks)
        type(panel_type), intent(in) :: panel                               !! any
        real(dp), intent(in) :: noise                                       !! deck units
        type(piece_type), intent(in) :: pieces(:)                           !! in any order
        type(panel_track_type), allocatable, intent(inout) :: tracks(:)     !! gets them
        type(panel_track_type) :: track
        type(part_type) :: parts(size(pieces))
        type(chain_type), allocatable :: chains(:)
        integer, allocatable :: kept(:)
        integer :: i, k
        real(dp), allocatable :: uv(:, :)

        do i = 1, size(pieces)
            do k = 1, 2
                parts(i)%ends(:, k) = surface_point(panel%surface, pieces(i)%uv(1, k), &
                    pieces(i)%uv(2, k))
            end do
        end do
        kept = pack([(i, i = 1, size(parts))], [(norm2(parts(i)%ends(:, 2) - parts(i)%ends(:, 1)) &
            > shortest_piece*noise, i = 1, size(parts))])
        allocate (chains, source=chains_of(parts(kept), shortest_piece*noise))
        do i = 1, size(chains)
            allocate (uv(2, size(chains(i)%part) + 1))
            do k = 1, size(chains(i)%part)
                associate (number => chains(i)%part(k))
                    uv(:, k) = pieces(kept(abs(number)))%uv(:, merge(1, 2, number > 0))
                    uv(:, k + 1) = pieces(kept(abs(number)))%uv(:, merge(2, 1, number > 0))
                end associate
            end do
            track = track_through(panel, uv)
            track%is_closed = chains(i)%is_closed .or. track%is_closed
            if (track%is_closed) track%uv(:, size(uv, 2)) = track%uv(:, 1)
            if (track%is_closed) track%at(:, size(uv, 2)) = track%at(:, 1)
            tracks = [tracks, track]
            deallocate (uv)
        end do
    end subroutine link

end module cut_panel_track
