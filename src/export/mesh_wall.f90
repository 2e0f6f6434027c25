!> Flat walls in BL 0, of bodies that are not symmetric and whose sections are closed along BL 0
!> (CLOSE): where a ring of sections ends at BL 0 on both sides, the strip between these ends.
module export_mesh_wall
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_measure_ring, only: link_type, rings_at, find_opening
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
            if (.not. allocated(error)) call find_opening(body, links, why)
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
        integer :: ends(2, size(rows)), middle, i
        logical :: is_inverted
        real(dp) :: rise

        do i = 1, size(rows)
            ends(:, i) = [end_of(rows(i), ring(1), .false.), &
                end_of(rows(i), ring(size(ring)), .true.)]
        end do
        middle = (size(rows) + 1)/2
        if (ends(1, middle) == ends(2, middle)) return
        rise = mesh%vertices(3, ends(2, middle)) - mesh%vertices(3, ends(1, middle))
        is_inverted = rise < 0.0_dp
        if (is_inverted) ends = ends([2, 1], :)
        if (ring(1)%is_turned .neqv. body%sections(ring(1)%section)%outward < 0.0_dp) &
            is_inverted = .not. is_inverted
        call add_normal(mesh, [0.0_dp, merge(1.0_dp, -1.0_dp, is_inverted), 0.0_dp])
        do i = 2, size(rows)
            call zip_wall(wall_line(rows(i - 1), ends(:, i - 1), mesh), &
                wall_line(rows(i), ends(:, i), mesh), is_inverted, mesh)
        end do
    end subroutine add_wall

    !> The vertices of a row in BL 0 from the lower end of a wall to its upper: also ends of other
    !> rings that are between, so that faces at a stop meet it edge to edge.
    pure function wall_line(row, ends, mesh) result(line)
        type(row_type), intent(in) :: row       !! a row of the run
        integer, intent(in) :: ends(2)          !! lower and upper end of the wall
        type(mesh_type), intent(in) :: mesh     !! has the vertices
        integer, allocatable :: line(:)
        integer :: i, k

        line = [ends(1)]
        if (ends(1) == ends(2)) return
        do i = 1, size(row%ends%vertex)
            associate (v => row%ends%vertex(i))
                if (abs(mesh%vertices(2, v)) > row%ends%reach) cycle
                if (mesh%vertices(3, v) <= mesh%vertices(3, ends(1))) cycle
                if (mesh%vertices(3, v) >= mesh%vertices(3, ends(2))) cycle
                k = count(mesh%vertices(3, line) < mesh%vertices(3, v))
                line = [line(:k), v, line(k + 1:)]
            end associate
        end do
        line = [line, ends(2)]
    end function wall_line

    !> Adds the triangles of a wall between two rows.
    pure subroutine zip_wall(fore, aft, is_inverted, mesh)
        integer, intent(in) :: fore(:)          !! vertices of the fore row, upwards
        integer, intent(in) :: aft(:)           !! vertices of the aft row, upwards
        logical, intent(in) :: is_inverted      !! the outside is to starboard
        type(mesh_type), intent(inout) :: mesh  !! gets them; its last normal is that of the wall
        integer :: corner(3), normal(3), i, k

        normal = mesh%normal_count
        i = 1
        k = 1
        do while (i < size(fore) .or. k < size(aft))
            if (i*size(aft) < k*size(fore) .and. i < size(fore) .or. k == size(aft)) then
                corner = [fore(i), aft(k), fore(i + 1)]
                i = i + 1
            else
                corner = [fore(i), aft(k), aft(k + 1)]
                k = k + 1
            end if
            if (is_inverted) corner = corner([1, 3, 2])
            call add_triangle(mesh, corner, normal)
        end do
    end subroutine zip_wall

    !> The vertex at which a ring begins, of the first of its links, or ends, of the last.
    pure integer function end_of(row, link, is_last) result(vertex)
        type(row_type), intent(in) :: row   !! a row of the run
        type(link_type), intent(in) :: link !! the first of the ring, or the last
        logical, intent(in) :: is_last      !! where it ends
        associate (list => row%strands(link%section)%vertex)
            vertex = list(merge(size(list), 1, is_last .neqv. link%is_turned))
        end associate
    end function end_of

end module export_mesh_wall
