!> A body laid out for networks: rows of vertices on its exact skin at given stations or at those
!> that keep a tolerance, and the flat panels between them measured.
module export_network_layout
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use export_mesh, only: mesh_part_type, mesh_type
    use export_mesh_density, only: density_type, find_density
    use export_mesh_plan, only: new_plan, plan_type, station_plan
    use export_mesh_row, only: first_row, lay_vertices, row_type, strand_type
    use export_mesh_skin, only: add_run
    use export_network, only: network_type
    use export_settings, only: settings_type
    implicit none (type, external)
    private

    public :: layout_type, lay_out, facing_left, network_along

    !> Plans that are tried for a tolerance, and the part of it that the next is made for.
    integer, parameter :: most_tries = 6
    real(dp), parameter :: wanted_part = 0.93_dp

    !> A body laid out in rows.
    type :: layout_type
        type(plan_type) :: plan                     !! rows and columns
        type(row_type), allocatable :: rows(:)      !! the vertices of each
        type(mesh_type) :: mesh                     !! the skin, measured, a part for each section
                                                    !! and run
        integer, allocatable :: run(:)              !! the run of each part
    end type layout_type

contains

    !> Lays out a body. Without stations the tolerance is kept where that can be: the mesh says what
    !> it is.
    !>
    !> Fails with `cause%too_many` where there would be too many points, and as `section_arc` where
    !> a section has no arc.
    pure subroutine lay_out(body, stations, settings, layout, error)
        type(body_type), intent(in) :: body                 !! finished
        real(dp), intent(in) :: stations(:)                 !! deck units; may be none
        type(settings_type), intent(in) :: settings         !! angle, and tolerance in deck units
        type(layout_type), intent(out) :: layout            !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(density_type) :: density
        type(plan_type) :: plan
        real(dp) :: tolerance
        integer :: try

        call find_density(body, density, error)
        if (allocated(error)) return
        tolerance = settings%tolerance
        do try = 1, most_tries
            if (size(stations) > 0) then
                call station_plan(density, tolerance, settings%angle, stations, plan)
            else
                call new_plan(density, tolerance, settings%angle, .false., plan, error)
            end if
            if (allocated(error)) return
            call lay_skin(body, plan, layout, error)
            if (allocated(error)) return
            if (size(stations) > 0 .or. layout%mesh%error <= settings%tolerance) return
            tolerance = tolerance*wanted_part*settings%tolerance/layout%mesh%error
        end do
    end subroutine lay_out

    !> Lays vertices on the skin, and measures flat panels between them.
    pure subroutine lay_skin(body, plan, layout, error)
        type(body_type), intent(in) :: body                 !! finished
        type(plan_type), intent(in) :: plan                 !! where they are
        type(layout_type), intent(out) :: layout            !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! a section has no arc
        type(mesh_part_type) :: part
        integer :: run, i

        layout%plan = plan
        allocate (layout%mesh%parts(0), layout%run(0))
        call lay_vertices(body, plan, layout%rows, layout%mesh, error)
        if (allocated(error)) return
        do run = 1, size(plan%runs)
            do i = 1, size(plan%runs(run)%stretch%sections)
                part%section = plan%runs(run)%stretch%sections(i)
                layout%mesh%parts = [layout%mesh%parts, part]
                layout%run = [layout%run, run]
                call add_run(body, part%section, plan%runs(run), &
                    layout%rows(first_row(plan, run):first_row(plan, run + 1)), layout%mesh, error)
                if (allocated(error)) return
            end do
        end do
        layout%mesh%error = maxval([0.0_dp, layout%mesh%parts%error])
    end subroutine lay_skin

    !> A path of sections (a negative one is run through against its own way), turned about where
    !> its outside is to the right.
    pure function facing_left(body, path) result(turned)
        type(body_type), intent(in) :: body !! finished
        integer, intent(in) :: path(:)      !! sections in the body's list, end to end
        integer :: turned(size(path))
        turned = path
        if (body%sections(abs(path(1)))%outward > 0.0_dp .eqv. path(1) > 0) &
            turned = -path(size(path):1:-1)
    end function facing_left

    !> The network of a path of sections over some runs, without a name.
    pure type(network_type) function network_along(layout, path, runs) result(network)
        type(layout_type), intent(in) :: layout     !! of the body
        integer, intent(in) :: path(:)              !! as `facing_left` has it
        integer, intent(in) :: runs(2)              !! the first and the last of them
        integer :: columns(size(path)), i, k, n, row, first, last

        first = first_row(layout%plan, runs(1))
        last = first_row(layout%plan, runs(2) + 1)
        do i = 1, size(path)
            columns(i) = size(layout%plan%columns(abs(path(i)))%share)
        end do
        allocate (network%points(3, sum(columns - 1) + 1, last - first + 1))
        do row = first, last
            n = 0
            do i = 1, size(path)
                do k = merge(1, 2, i == 1), columns(i)
                    n = n + 1
                    network%points(:, n, row - first + 1) = layout%mesh%vertices(:, &
                        vertex_of(layout%rows(row)%strands(abs(path(i))), &
                        merge(k, columns(i) + 1 - k, path(i) > 0)))
                end do
            end do
        end do
        do i = 1, size(layout%run)
            associate (part => layout%mesh%parts(i))
                if (layout%run(i) < runs(1) .or. layout%run(i) > runs(2)) cycle
                if (all(abs(path) /= part%section) .or. part%error <= network%error) cycle
                network%error = part%error
                network%worst = part%worst
            end associate
        end do
    end function network_along

    !> A vertex of a strand; where it has shrunk to a point, that one.
    pure integer function vertex_of(strand, column) result(vertex)
        type(strand_type), intent(in) :: strand !! any
        integer, intent(in) :: column           !! number of the column
        vertex = strand%vertex(min(column, size(strand%vertex)))
    end function vertex_of

end module export_network_layout
