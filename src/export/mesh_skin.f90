!> The skin of a mesh: the triangles of all sections between all rows, each section a part.
module export_mesh_skin
    use base_error, only: error_type
    use body_body, only: body_type
    use export_mesh, only: mesh_part_type, mesh_type
    use export_mesh_chord, only: new_gauge
    use export_mesh_plan, only: plan_type, run_type
    use export_mesh_row, only: first_row, row_type
    use export_mesh_strip, only: set_edge, strip_type, zip_strip
    implicit none (type, external)
    private

    public :: add_skin, add_run

contains

    !> Adds the skin of all sections, each as a part, and its largest distance from the exact one.
    pure subroutine add_skin(body, plan, rows, mesh, error)
        type(body_type), intent(in) :: body                 !! finished
        type(plan_type), intent(in) :: plan                 !! its runs
        type(row_type), intent(in) :: rows(:)               !! its vertices
        type(mesh_type), intent(inout) :: mesh              !! gets the triangles
        type(error_type), allocatable, intent(out) :: error !! a section has no arc
        type(mesh_part_type) :: part
        integer :: i, run

        do i = 1, size(body%sections)
            part%name = trim(body%sections(i)%name)
            if (body%sections(i)%is_port) part%name = part%name//' P'
            part%section = i
            part%is_port = body%sections(i)%is_port
            part%first = mesh%triangle_count + 1
            part%last = mesh%triangle_count
            mesh%parts = [mesh%parts, part]
            do run = 1, size(plan%runs)
                if (all(plan%runs(run)%stretch%sections /= i)) cycle
                call add_run(body, i, plan%runs(run), &
                    rows(first_row(plan, run):first_row(plan, run + 1)), mesh, error)
                if (allocated(error)) return
            end do
        end do
        if (size(mesh%parts) == 0) return
        i = maxloc(mesh%parts%error, dim=1)
        mesh%error = mesh%parts(i)%error
        mesh%worst = mesh%parts(i)%worst
    end subroutine add_skin

    !> Adds the skin of a section over a run to the last part of a mesh.
    pure subroutine add_run(body, section, run, rows, mesh, error)
        type(body_type), intent(in) :: body                 !! finished
        integer, intent(in) :: section                      !! in the body's list
        type(run_type), intent(in) :: run                   !! one where it is
        type(row_type), intent(in) :: rows(:)               !! those of the run
        type(mesh_type), intent(inout) :: mesh              !! gets the triangles
        type(error_type), allocatable, intent(out) :: error !! the section has no arc
        type(strip_type) :: strip
        integer :: k

        strip%section = section
        do k = 2, size(rows)
            call new_gauge(body, section, run%stretch%span, run%u(k - 1:k), strip%gauge, error)
            if (allocated(error)) return
            if (k == 2) then
                call set_edge(body, strip, 1, rows(1)%strands(section), mesh)
            else
                strip%edge(1) = strip%edge(2)
                strip%edge(1)%corner%row = 0
            end if
            call set_edge(body, strip, 2, rows(k)%strands(section), mesh)
            call zip_strip(body, strip, mesh)
        end do
    end subroutine add_run

end module export_mesh_skin
