!> Panels sewn to shells: bonds of one key that are run through in opposite ways become one edge,
!> corners become vertices, and faces that share edges a shell. A curve that is there a third time,
!> or twice the same way, gets an edge of its own.
module export_shell_sew
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use export_shell, only: edge_type, shell_type, side_type, skin_model_type, vertex_type
    use export_shell_caps, only: bond_corners
    use export_shell_panels, only: bond_type, key_type, operator(==), panel_type
    implicit none (type, external)
    private

    public :: sew

    !> An edge while sewing.
    type :: seam_type
        type(key_type) :: key           !! what it is
        logical :: is_used(2) = .false. !! backwards, forwards
    end type seam_type

contains

    !> Sews the panels of a body.
    pure subroutine sew(corners, panels, model)
        real(dp), intent(in) :: corners(:, :)           !! of `ribs_type`
        type(panel_type), intent(in) :: panels(:)       !! both halves and caps
        type(skin_model_type), intent(out) :: model     !! with its shells
        integer :: known(-size(corners, 2):size(corners, 2)), i, k
        type(seam_type), allocatable :: seams(:)

        allocate (model%vertices(0), model%edges(0), model%faces(size(panels)), seams(0))
        known = 0
        do i = 1, size(panels)
            model%faces(i) = panels(i)%face
            allocate (model%faces(i)%sides(size(panels(i)%bonds)))
            do k = 1, size(panels(i)%bonds)
                call add_side(panels(i)%bonds(k), corners, known, seams, model, &
                    model%faces(i)%sides(k))
            end do
        end do
        call find_shells(model)
    end subroutine sew

    !> Makes the side of a bond, with its vertices, and with an edge where none waits for it.
    pure subroutine add_side(bond, corners, known, seams, model, side)
        type(bond_type), intent(in) :: bond                     !! of a panel
        real(dp), intent(in) :: corners(:, :)                   !! of `ribs_type`
        integer, intent(inout) :: known(-size(corners, 2):)     !! vertex of each corner, or 0
        type(seam_type), allocatable, intent(inout) :: seams(:) !! of the edges
        type(skin_model_type), intent(inout) :: model           !! gets vertices and edges
        type(side_type), intent(out) :: side                    !! it
        type(edge_type) :: edge
        integer :: ends(2), way, i

        ends = bond_corners(bond, corners)
        do i = 1, 2
            call add_vertex(ends(i), corners, known, model)
        end do
        side%vertex = known(ends(1))
        if (.not. allocated(bond%curve%pole)) return
        side%vertex = 0
        side%is_forward = bond%is_forward
        way = merge(2, 1, bond%is_forward)
        do i = 1, size(seams)
            if (.not. seams(i)%key == bond%key .or. seams(i)%is_used(way)) cycle
            side%edge = i
            seams(i)%is_used(way) = .true.
            return
        end do
        if (.not. bond%is_forward) ends = ends([2, 1])
        edge = edge_type(bond%curve, known(ends(1)), known(ends(2)))
        model%edges = [model%edges, edge]
        seams = [seams, seam_type(bond%key)]
        side%edge = size(seams)
        seams(side%edge)%is_used(way) = .true.
    end subroutine add_side

    !> Makes a corner a vertex, where it is none yet.
    pure subroutine add_vertex(corner, corners, known, model)
        integer, intent(in) :: corner                           !! below zero: its mirror image
        real(dp), intent(in) :: corners(:, :)                   !! of `ribs_type`
        integer, intent(inout) :: known(-size(corners, 2):)     !! vertex of each corner, or 0
        type(skin_model_type), intent(inout) :: model           !! gets it
        type(vertex_type) :: vertex

        if (known(corner) > 0) return
        vertex%at = corners(:, abs(corner))
        if (corner < 0 .and. .not. is_zero(vertex%at(2))) vertex%at(2) = -vertex%at(2)
        model%vertices = [model%vertices, vertex]
        known(corner) = size(model%vertices)
    end subroutine add_vertex

    !> Finds the faces that hang together, and whether they close.
    pure subroutine find_shells(model)
        type(skin_model_type), intent(inout) :: model !! with faces and edges
        integer :: group(size(model%faces)), first(size(model%edges)), uses(size(model%edges))
        integer :: i, k, edge, number, old
        type(shell_type) :: shell

        group = [(i, i=1, size(group))]
        first = 0
        uses = 0
        do i = 1, size(model%faces)
            do k = 1, size(model%faces(i)%sides)
                edge = model%faces(i)%sides(k)%edge
                if (edge == 0) cycle
                uses(edge) = uses(edge) + 1
                if (first(edge) == 0) first(edge) = i
                old = max(group(i), group(first(edge)))
                number = min(group(i), group(first(edge)))
                where (group == old) group = number
            end do
        end do
        allocate (model%shells(0))
        do i = 1, size(group)
            if (.not. any(group == i)) cycle
            shell%faces = pack([(k, k=1, size(group))], group == i)
            shell%is_closed = all(pack(uses, [(group(first(k)) == i, k=1, size(uses))]) == 2)
            model%shells = [model%shells, shell]
        end do
    end subroutine find_shells

end module export_shell_sew
