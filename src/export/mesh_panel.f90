!> The triangles of panels in a mesh. Inside, vertices stand in even columns and rows (u, v); along
!> the sides they are those of `export_mesh_border`, so that panels meet the skin, and each other,
!> edge to edge where they have a side in common. What is between is zipped: a strip along each
!> side, from its vertices to the outermost inner row.
!>
!> The distance of a triangle from the surface is measured at its middle and at the middles of its
!> sides, along the normal of the surface.
module export_mesh_panel
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact
    use body_panel, only: panel_type
    use body_panel_side, only: place_on
    use export_mesh, only: add_normal, add_triangle, add_vertex, mesh_part_type, mesh_type
    use export_mesh_border, only: border_type, lay_borders
    use export_mesh_edge, only: find_twins
    use export_mesh_grid, only: grid_cells, panel_place_normal
    implicit none (type, external)
    private

    public :: add_panels

    !> A vertex of a panel.
    type :: spot_type
        integer :: vertex = 0           !! in the mesh
        integer :: normal = 0           !! in the mesh
        real(dp) :: uv(2) = 0.0_dp      !! on the panel
    end type spot_type

    !> Tries to keep the tolerance, and how much closer each next one is.
    integer, parameter :: most_tries = 6
    !> What parts of panels have for a section.
    integer, parameter :: panel_part = -1
    real(dp), parameter :: closer = 0.9_dp

contains

    !> Adds panels to a mesh, each as a part. Fails with `cause%no_convergence` where the tolerance
    !> can't be kept.
    pure subroutine add_panels(panels, tolerance, angle, is_half, mesh, error)
        type(panel_type), intent(in) :: panels(:)           !! of a body
        real(dp), intent(in) :: tolerance                   !! deck units
        real(dp), intent(in) :: angle                       !! degrees
        logical, intent(in) :: is_half                      !! the port half will be added
        type(mesh_type), intent(inout) :: mesh              !! gets the triangles
        type(error_type), allocatable, intent(out) :: error !! see above
        type(mesh_type) :: tried
        real(dp) :: aim
        integer :: i, try, cells(2), before(2)

        do i = 1, size(panels)
            aim = tolerance
            before = 0
            do try = 1, most_tries
                cells = grid_cells(panels(i), aim, angle)
                if (all(cells == before)) exit
                before = cells
                tried = mesh
                call add_panel(panels(i), cells, is_half, tried)
                associate (part => tried%parts(size(tried%parts)))
                    if (part%error <= tolerance) exit
                    aim = closer*aim*tolerance/part%error
                end associate
            end do
            associate (part => tried%parts(size(tried%parts)))
                if (part%error > tolerance) then
                    call fail(error, cause%no_convergence, 'the triangles of patch '// &
                        trim(panels(i)%name)//' stay '//compact(part%error)// &
                        ' from it; ask for a larger tolerance than '//compact(tolerance))
                    return
                end if
            end associate
            mesh = tried
        end do
    end subroutine add_panels

    !> Adds a panel in some cells.
    pure subroutine add_panel(panel, cells, is_half, mesh)
        type(panel_type), intent(in) :: panel       !! the panel
        integer, intent(in) :: cells(2)             !! along u and v, two or more
        logical, intent(in) :: is_half              !! the port half will be added
        type(mesh_type), intent(inout) :: mesh      !! gets it
        type(border_type) :: border(4)
        type(spot_type), allocatable :: inner(:, :), outer(:)
        integer, allocatable :: twin(:)
        integer :: i, j, m, n

        allocate (twin, source=find_twins(mesh))
        call lay_borders(panel, cells, pack([(i, i = 1, size(twin))], twin == 0), is_half, mesh, &
            border)
        call begin_part(panel, mesh)
        m = cells(1) - 1
        n = cells(2) - 1
        allocate (inner(m, n))
        do j = 1, n
            do i = 1, m
                call lay_spot(panel, real([i, j], dp)/real(cells, dp), 0, mesh, inner(i, j))
            end do
        end do
        do j = 1, n - 1
            call zip(panel, 1, inner(:, j), inner(:, j + 1), mesh)
        end do
        do i = 1, 4
            allocate (outer(size(border(i)%vertex)))
            do j = 1, size(outer)
                call lay_spot(panel, place_on(i, border(i)%t(j)), border(i)%vertex(j), mesh, &
                    outer(j))
            end do
            if (i == 1) call zip(panel, i, outer, inner(:, 1), mesh)
            if (i == 2) call zip(panel, i, outer, inner(m, :), mesh)
            if (i == 3) call zip(panel, i, outer, inner(m:1:-1, n), mesh)
            if (i == 4) call zip(panel, i, outer, inner(1, n:1:-1), mesh)
            deallocate (outer)
        end do
    end subroutine add_panel

    !> Begins the part of a panel.
    pure subroutine begin_part(panel, mesh)
        type(panel_type), intent(in) :: panel       !! the panel
        type(mesh_type), intent(inout) :: mesh      !! gets the part
        type(mesh_part_type) :: part

        part%name = trim(panel%name)
        part%is_port = panel%outward < 0.0_dp
        if (part%is_port) part%name = part%name//' P'
        part%section = panel_part
        part%first = mesh%triangle_count + 1
        part%last = mesh%triangle_count
        mesh%parts = [mesh%parts, part]
    end subroutine begin_part

    !> A vertex of a panel with its normal; a new one where it has no number.
    pure subroutine lay_spot(panel, uv, vertex, mesh, spot)
        type(panel_type), intent(in) :: panel       !! the panel
        real(dp), intent(in) :: uv(2)               !! 0 to 1
        integer, intent(in) :: vertex               !! in the mesh, or 0
        type(mesh_type), intent(inout) :: mesh      !! gets normal and vertex
        type(spot_type), intent(out) :: spot        !! the vertex
        real(dp) :: at(3), normal(3)

        call panel_place_normal(panel, uv, at, normal)
        spot%uv = uv
        spot%vertex = vertex
        if (vertex == 0) then
            call add_vertex(mesh, at)
            spot%vertex = mesh%vertex_count
        end if
        call add_normal(mesh, normal)
        spot%normal = mesh%normal_count
    end subroutine lay_spot

    !> Adds the triangles between two rows of vertices that run along a side, the second inside.
    pure subroutine zip(panel, number, outer, inner, mesh)
        type(panel_type), intent(in) :: panel       !! the panel
        integer, intent(in) :: number               !! of the side
        type(spot_type), intent(in) :: outer(:)     !! along it
        type(spot_type), intent(in) :: inner(:)     !! beside them, to the left
        type(mesh_type), intent(inout) :: mesh      !! gets the triangles
        integer :: i, k
        logical :: on_outer

        i = 1
        k = 1
        do while (i < size(outer) .or. k < size(inner))
            on_outer = k == size(inner)
            if (i < size(outer) .and. k < size(inner)) &
                on_outer = along(number, outer(i + 1)) <= along(number, inner(k + 1))
            if (on_outer) then
                call add_face(panel, [outer(i), outer(i + 1), inner(k)], mesh)
                i = i + 1
            else
                call add_face(panel, [outer(i), inner(k + 1), inner(k)], mesh)
                k = k + 1
            end if
        end do
    end subroutine zip

    !> How far along a side a vertex is, 0 to 1.
    pure real(dp) function along(number, spot) result(t)
        integer, intent(in) :: number           !! of the side
        type(spot_type), intent(in) :: spot     !! the vertex
        t = spot%uv(merge(1, 2, mod(number, 2) == 1))
        if (number > 2) t = 1.0_dp - t
    end function along

    !> Adds a triangle, turned so that it faces outward, and measures it.
    pure subroutine add_face(panel, spot, mesh)
        type(panel_type), intent(in) :: panel       !! the panel
        type(spot_type), intent(in) :: spot(3)      !! counter-clockwise in u and v
        type(mesh_type), intent(inout) :: mesh      !! gets it
        real(dp), parameter :: shares(3, 4) = reshape([1.0_dp, 1.0_dp, 1.0_dp, 1.5_dp, 1.5_dp, &
            0.0_dp, 0.0_dp, 1.5_dp, 1.5_dp, 1.5_dp, 0.0_dp, 1.5_dp], [3, 4])/3.0_dp
        real(dp) :: uv(2), at(3), normal(3), flat(3), off
        integer :: order(3), i

        order = [1, 2, 3]
        if (panel%outward < 0.0_dp) order = [1, 3, 2]
        if (any(spot%vertex == cshift(spot%vertex, 1))) return
        call add_triangle(mesh, spot(order)%vertex, spot(order)%normal)
        do i = 1, size(shares, 2)
            uv = [dot_product(shares(:, i), spot%uv(1)), dot_product(shares(:, i), spot%uv(2))]
            flat = matmul(mesh%vertices(:, spot%vertex), shares(:, i))
            call panel_place_normal(panel, uv, at, normal)
            off = abs(dot_product(at - flat, normal))
            associate (part => mesh%parts(size(mesh%parts)))
                if (off <= part%error) cycle
                part%error = off
                part%worst = at
            end associate
        end do
    end subroutine add_face

end module export_mesh_panel
