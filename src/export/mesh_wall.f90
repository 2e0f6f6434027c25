!> Flat walls in BL 0, of bodies that are not symmetric and whose sections are closed along BL 0
!> (CLOSE): where a ring of sections ends at BL 0 on both sides, the strip between these ends.
module export_mesh_wall
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_measure_ring, only: link_type, rings_at, why_open
    use export_mesh, only: add_normal, add_triangle, mesh_part_type, mesh_type
    use export_mesh_plan, only: plan_type
    use export_mesh_row, only: first_row, row_type
    implicit none (type, external)
    private

    public :: add_walls, why_not_closed

contains

    !> Why a body does not close all along, in words; empty where it does.
    pure function why_not_closed(body, plan) result(why)
        type(body_type), intent(in) :: body     !! finished
        type(plan_type), intent(in) :: plan     !! its stretches
        character(:), allocatable :: why
        type(link_type), allocatable :: links(:)
        type(error_type), allocatable :: error
        integer :: i

        why = ''
        do i = 1, size(plan%runs)
            associate (stretch => plan%runs(i)%stretch)
                call rings_at(body, 0.5_dp*(stretch%from + stretch%to), links, error)
            end associate
            if (.not. allocated(error)) why = why_open(body, links)
            if (allocated(error)) why = error%message
            if (len(why) > 0) return
        end do
    end function why_not_closed

    !> Adds the walls of all runs, as one part.
    pure subroutine add_walls(body, plan, rows, mesh)
        type(body_type), intent(in) :: body     !! closed all along
        type(plan_type), intent(in) :: plan     !! its runs
        type(row_type), intent(in) :: rows(:)   !! its rows
        type(mesh_type), intent(inout) :: mesh  !! gets them
        type(mesh_part_type) :: part
        type(link_type), allocatable :: links(:)
        type(error_type), allocatable :: error
        integer :: i, k

        if (body%is_symmetric) return
        part%name = 'WALL BL 0'
        part%first = mesh%triangle_count + 1
        part%last = mesh%triangle_count
        mesh%parts = [mesh%parts, part]
        do i = 1, size(plan%runs)
            associate (stretch => plan%runs(i)%stretch)
                call rings_at(body, 0.5_dp*(stretch%from + stretch%to), links, error)
            end associate
            if (allocated(error)) cycle
            do k = 1, maxval([0, links%ring])
                call add_wall(body, pack(links, links%ring == k), &
                    rows(first_row(plan, i):first_row(plan, i + 1)), mesh)
            end do
        end do
        if (mesh%parts(size(mesh%parts))%last < part%first) &
            mesh%parts = mesh%parts(:size(mesh%parts) - 1)
    end subroutine add_walls

    !> Adds the wall of a ring over its rows, where it is not closed by its own sections.
    pure subroutine add_wall(body, ring, rows, mesh)
        type(body_type), intent(in) :: body     !! closed all along
        type(link_type), intent(in) :: ring(:)  !! in the middle of the run
        type(row_type), intent(in) :: rows(:)   !! of the run
        type(mesh_type), intent(inout) :: mesh  !! gets it
        integer :: ends(2, size(rows)), i
        real(dp) :: facing

        do i = 1, size(rows)
            ends(:, i) = [first_of(rows(i), ring(1)), last_of(rows(i), ring(size(ring)))]
        end do
        if (all(ends(1, 2:size(rows) - 1) == ends(2, 2:size(rows) - 1))) return
        facing = body%sections(ring(1)%section)%outward
        if (ring(1)%is_turned) facing = -facing
        call add_normal(mesh, [0.0_dp, -facing*direction(mesh, ends), 0.0_dp])
        if (facing < 0.0_dp) ends = ends([2, 1], :)
        do i = 1, size(rows) - 1
            call add_flat([ends(1, i), ends(1, i + 1), ends(2, i)], mesh)
            call add_flat([ends(2, i), ends(1, i + 1), ends(2, i + 1)], mesh)
        end do
    end subroutine add_wall

    !> 1 where the ends of a ring are above its starts, else -1.
    pure real(dp) function direction(mesh, ends)
        type(mesh_type), intent(in) :: mesh     !! has the vertices
        integer, intent(in) :: ends(:, :)       !! start and end in each row
        direction = sign(1.0_dp, sum(mesh%vertices(3, ends(2, :)) - mesh%vertices(3, ends(1, :))))
    end function direction

    !> Adds a flat triangle unless it has shrunk to a line.
    pure subroutine add_flat(vertex, mesh)
        integer, intent(in) :: vertex(3)        !! its corners
        type(mesh_type), intent(inout) :: mesh  !! gets it; its last normal is that of the wall
        if (vertex(1) == vertex(2) .or. vertex(2) == vertex(3) .or. vertex(3) == vertex(1)) return
        call add_triangle(mesh, vertex, [mesh%normal_count, mesh%normal_count, mesh%normal_count])
    end subroutine add_flat

    !> The vertex at which a ring begins.
    pure integer function first_of(row, link) result(vertex)
        type(row_type), intent(in) :: row   !! a row of the run
        type(link_type), intent(in) :: link !! the first of the ring
        associate (list => row%strands(link%section)%vertex)
            vertex = list(1)
            if (link%is_turned) vertex = list(size(list))
        end associate
    end function first_of

    !> The vertex at which a ring ends.
    pure integer function last_of(row, link) result(vertex)
        type(row_type), intent(in) :: row   !! a row of the run
        type(link_type), intent(in) :: link !! the last of the ring
        associate (list => row%strands(link%section)%vertex)
            vertex = list(size(list))
            if (link%is_turned) vertex = list(1)
        end associate
    end function last_of

end module export_mesh_wall
