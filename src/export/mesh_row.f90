!> The vertices of a mesh: each row is a station, each section there a strand of vertices on its
!> exact arc. Ends of sections that meet are one vertex; those at BL 0 of a symmetric body are there
!> exactly. A section that has shrunk to a point is a strand of one vertex.
module export_mesh_row
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_tolerances, only: agreement_ulps, outline_gap, ulp
    use body_body, only: body_type
    use body_section, only: is_point, section_arc, trace_at, trace_type
    use export_mesh, only: add_vertex, mesh_type
    use export_mesh_plan, only: plan_type
    use export_mesh_share, only: parameter_at
    use geom_arc, only: arc_type, weight
    use geom_arc_point, only: point
    use geom_place, only: place_at
    implicit none (type, external)
    private

    public :: strand_type, ends_type, row_type, lay_vertices, first_row

    !> How far inside of an end with a straight section it is looked how it goes on: parts of the
    !> range.
    real(dp), parameter :: inset = 1.0e-6_dp

    !> One section at one station.
    type :: strand_type
        integer, allocatable :: vertex(:)   !! from start to finish; not allocated: not there
        real(dp), allocatable :: share(:)   !! of each, rising from 0 to 1
        real(dp), allocatable :: t(:)       !! the parameter of the arc at each, rising
        type(arc_type) :: arc               !! the section's arc, where there are two or more
    end type strand_type

    !> The control lines at one station.
    type :: ends_type
        real(dp) :: reach = 0.0_dp          !! how near points are that are one, deck units
        real(dp) :: centre = -1.0_dp        !! how near to BL 0 they are moved there, deck units
        real(dp) :: noise = -1.0_dp         !! and other vertices
        integer, allocatable :: vertex(:)   !! each once
    end type ends_type

    !> One station.
    type :: row_type
        real(dp) :: sta = 0.0_dp                        !! deck units
        type(ends_type) :: ends                         !! ends of its sections
        type(strand_type), allocatable :: strands(:)    !! of each section of the body
    end type row_type

contains

    !> The number of the first row of a run. The last row of a run is the first of the next.
    pure integer function first_row(plan, run)
        type(plan_type), intent(in) :: plan !! any
        integer, intent(in) :: run          !! number of a run, or one more than there are
        integer :: i
        first_row = 1
        do i = 1, run - 1
            first_row = first_row + size(plan%runs(i)%u) - 1
        end do
    end function first_row

    !> Lays all vertices. Fails as `section_arc` where a section has no arc.
    pure subroutine lay_vertices(body, plan, rows, mesh, error)
        type(body_type), intent(in) :: body                 !! finished
        type(plan_type), intent(in) :: plan                 !! where they are
        type(row_type), allocatable, intent(out) :: rows(:) !! which they are
        type(mesh_type), intent(inout) :: mesh              !! gets them
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: i, k, row

        allocate (rows(first_row(plan, size(plan%runs) + 1)))
        do row = 1, size(rows)
            allocate (rows(row)%strands(size(body%sections)), rows(row)%ends%vertex(0))
        end do
        row = 1
        do i = 1, size(plan%runs)
            associate (run => plan%runs(i))
                do k = 1, size(run%sta)
                    rows(row + k - 1)%sta = run%sta(k)
                    call mark(rows(row + k - 1), run%stretch%sections)
                end do
                row = row + size(run%sta) - 1
            end associate
        end do
        do row = 1, size(rows)
            call lay_row(body, plan, rows(row), mesh, error)
            if (allocated(error)) return
        end do
    end subroutine lay_vertices

    !> Marks the sections that are at a row.
    pure subroutine mark(row, sections)
        type(row_type), intent(inout) :: row    !! gets strands without vertices
        integer, intent(in) :: sections(:)      !! which
        integer :: i
        do i = 1, size(sections)
            if (.not. allocated(row%strands(sections(i))%vertex)) &
                allocate (row%strands(sections(i))%vertex(0))
        end do
    end subroutine mark

    !> Lays the vertices of a row: first all arcs, so that it is known how large the outline is.
    pure subroutine lay_row(body, plan, row, mesh, error)
        type(body_type), intent(in) :: body                 !! finished
        type(plan_type), intent(in) :: plan                 !! its columns
        type(row_type), intent(inout) :: row                !! has its station and marks
        type(mesh_type), intent(inout) :: mesh              !! gets the vertices
        type(error_type), allocatable, intent(out) :: error !! a section has no arc
        type(trace_type) :: trace
        logical :: has_shrunk(size(row%strands))
        real(dp) :: points(2, size(row%strands))
        integer :: i

        has_shrunk = .false.
        points = 0.0_dp
        do i = 1, size(row%strands)
            if (.not. allocated(row%strands(i)%vertex)) cycle
            trace = trace_at(body%lines, body%sections(i), row%sta)
            points(:, i) = trace%start%point
            row%ends%reach = max(row%ends%reach, agreement_ulps*ulp*maxval(abs(points(:, i))))
            has_shrunk(i) = is_point(trace)
            if (has_shrunk(i)) cycle
            call section_arc(body%lines, body%sections(i), row%sta, row%strands(i)%arc, error)
            if (allocated(error)) return
            associate (arc => row%strands(i)%arc)
                row%ends%reach = max(row%ends%reach, outline_gap*norm2(arc%finish - arc%start))
            end associate
        end do
        if (body%is_symmetric) then
            row%ends%centre = row%ends%reach
            row%ends%noise = agreement_ulps*ulp*maxval(abs(points))
        end if
        do i = 1, size(row%strands)
            if (.not. allocated(row%strands(i)%vertex)) cycle
            if (has_shrunk(i)) then
                row%strands(i)%vertex = [0]
                row%strands(i)%share = [0.5_dp]
                row%strands(i)%t = [0.5_dp]
                call lay_end([row%sta, points(:, i)], row%ends, mesh, row%strands(i)%vertex(1))
            else
                row%strands(i)%share = plan%columns(i)%share
                row%strands(i)%t = parameters_of(body, i, row%sta, row%strands(i))
                call lay_strand(row%sta, row%ends, mesh, row%strands(i))
            end if
        end do
    end subroutine lay_row

    !> Lays the vertices of an arc.
    pure subroutine lay_strand(sta, ends, mesh, strand)
        real(dp), intent(in) :: sta                     !! deck units
        type(ends_type), intent(inout) :: ends          !! of the row
        type(mesh_type), intent(inout) :: mesh          !! gets the vertices
        type(strand_type), intent(inout) :: strand      !! has its arc and where they are
        real(dp) :: at(3)
        integer :: i, last

        last = size(strand%t)
        deallocate (strand%vertex)
        allocate (strand%vertex(last))
        call lay_end([sta, strand%arc%start], ends, mesh, strand%vertex(1))
        do i = 2, last - 1
            at = [sta, point(strand%arc, place_at(strand%t(i)))]
            if (abs(at(2)) <= ends%noise) at(2) = 0.0_dp
            call add_vertex(mesh, at)
            strand%vertex(i) = mesh%vertex_count
        end do
        call lay_end([sta, strand%arc%finish], ends, mesh, strand%vertex(last))
    end subroutine lay_strand

    !> The parameters of the shares of an arc. Where it has shrunk to a straight line at the end of
    !> its range, those of the points nearest to what it is a little inside, so that triangles do
    !> not lean.
    pure function parameters_of(body, number, sta, strand) result(t)
        type(body_type), intent(in) :: body         !! finished
        integer, intent(in) :: number               !! of the section
        real(dp), intent(in) :: sta                 !! deck units
        type(strand_type), intent(in) :: strand     !! has arc and shares
        real(dp) :: t(size(strand%share)), along(size(strand%share)), at(2), chord(2)
        type(arc_type) :: near
        type(error_type), allocatable :: error
        integer :: i, last

        t = parameter_at(strand%share, weight(strand%arc))
        last = size(t)
        associate (section => body%sections(number))
            if (.not. strand%arc%is_line) return
            if (sta > section%from .and. sta < section%to) return
            call section_arc(body%lines, section, sta + sign(inset*(section%to - section%from), &
                0.5_dp*(section%from + section%to) - sta), near, error)
        end associate
        if (allocated(error)) return
        chord = near%finish - near%start
        do i = 1, last
            at = point(near, place_at(parameter_at(strand%share(i), weight(near))))
            along(i) = dot_product(at - near%start, chord)/dot_product(chord, chord)
        end do
        along([1, last]) = [0.0_dp, 1.0_dp]
        if (.not. all(along(2:) > along(:last - 1))) return
        ! On a line the parameter is the part of the way that is done.
        t = along
    end function parameters_of

    !> Lays an end of a section: a new vertex, or the one that is there.
    pure subroutine lay_end(at, ends, mesh, vertex)
        real(dp), intent(in) :: at(3)               !! STA, BL, WL, deck units
        type(ends_type), intent(inout) :: ends      !! of the row; gets it where it is new
        type(mesh_type), intent(inout) :: mesh      !! gets the vertex where it is new
        integer, intent(out) :: vertex              !! its number
        real(dp) :: moved(3)
        integer :: i

        do i = 1, size(ends%vertex)
            vertex = ends%vertex(i)
            if (norm2(mesh%vertices(:, vertex) - at) <= ends%reach) return
        end do
        moved = at
        if (abs(at(2)) <= ends%centre) moved(2) = 0.0_dp
        call add_vertex(mesh, moved)
        vertex = mesh%vertex_count
        ends%vertex = [ends%vertex, vertex]
    end subroutine lay_end

end module export_mesh_row
