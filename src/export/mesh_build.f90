!> The mesh of a body: rows and columns from `export_mesh_plan`, vertices on the exact skin,
!> triangles measured as they are made, flat faces over the ends, and the port half as the mirror
!> image.
!>
!> The plan is made for the tolerance; where the triangles then turn out to be further from the skin
!> it is made more closely, and where they are nearer than they need be, less so.
module export_mesh_build
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact
    use body_body, only: body_type
    use body_panel, only: panel_type
    use export_mesh, only: mesh_type, trim_mesh
    use export_mesh_cap, only: add_caps
    use export_mesh_density, only: density_type, find_density
    use export_mesh_edge, only: find_turn, find_twins, half_edge
    use export_mesh_mirror, only: add_port_half
    use export_mesh_panel, only: add_panels
    use export_mesh_plan, only: new_plan, plan_type
    use export_mesh_row, only: first_row, lay_vertices, row_type
    use export_mesh_seam, only: join_row
    use export_mesh_skin, only: add_skin
    use export_mesh_wall, only: add_walls, why_not_closed
    use export_settings, only: settings_type
    implicit none (type, external)
    private

    public :: build_mesh, build_panel_mesh

    !> What a mesh is made of.
    type :: subject_type
        type(body_type) :: body                     !! finished
        type(density_type) :: density               !! of it
        type(panel_type), allocatable :: panels(:)  !! of its starboard half, or of both
    end type subject_type

    !> Plans that are tried; the part of the tolerance that a good one comes to, and that a plan is
    !> made for; the part that a turn must come down to for it to be worth going on.
    integer, parameter :: most_tries = 6
    real(dp), parameter :: least_part = 0.8_dp, wanted_part = 0.96_dp, helpful_part = 0.98_dp
    !> Outlines of two runs are one where they are nearer than this part of the tolerance.
    real(dp), parameter :: seam_part = 0.05_dp

contains

    !> Builds the mesh of a body, both halves of a symmetric one, in deck units. The tolerance is
    !> kept, or there is no mesh; the angle is kept where the skin lets it be: the mesh says what it
    !> is.
    !>
    !> Fails with `cause%usage` where tolerance or angle is not above zero, with `cause%too_many`
    !> where there would be too many triangles, with `cause%no_convergence` where the triangles stay
    !> further from the skin than asked, and as `section_arc` where a section has no arc.
    pure subroutine build_mesh(body, settings, mesh, error, panels)
        type(body_type), intent(in) :: body                 !! finished
        type(settings_type), intent(in) :: settings         !! angle, is_open, and the tolerance, in
                                                            !! deck units
        type(mesh_type), intent(out) :: mesh                !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(panel_type), intent(in), optional :: panels(:) !! of the body; of a symmetric one those
                                                            !! of the starboard half
        type(subject_type) :: subject
        type(settings_type) :: aim
        type(mesh_type) :: tried
        integer :: try

        if (.not. (settings%tolerance > 0.0_dp .and. settings%angle > 0.0_dp)) then
            call fail(error, cause%usage, 'tolerance and angle of a mesh must be above zero')
            return
        end if
        subject%body = body
        allocate (subject%panels(0))
        if (present(panels)) subject%panels = panels
        call find_density(body, subject%density, error)
        if (allocated(error)) return
        aim = settings
        aim%tolerance = wanted_part*settings%tolerance
        do try = 1, most_tries
            call try_mesh(subject, settings, aim, tried, error)
            if (allocated(error)) exit
            if (is_better(tried, mesh)) mesh = tried
            if (is_within(tried) .and. (try > 1 .or. &
                tried%error >= least_part*settings%tolerance)) exit
            call take_aim(tried, aim%tolerance)
        end do
        if (is_within(mesh)) then
            if (allocated(error)) deallocate (error)
            call turn_less(subject, settings, aim, mesh)
            call settle(mesh)
        else if (.not. allocated(error)) then
            call explain(mesh, error)
        end if
    end subroutine build_mesh

    !> Makes a mesh again whose triangles turn more than asked from one to the next, as long as that
    !> helps; it is left as it is where the angle is not reached.
    pure subroutine turn_less(subject, settings, aim, mesh)
        type(subject_type), intent(in) :: subject       !! body and panels
        type(settings_type), intent(in) :: settings     !! what is asked
        type(settings_type), intent(inout) :: aim       !! of the plan of the mesh
        type(mesh_type), intent(inout) :: mesh          !! within the tolerance
        type(error_type), allocatable :: error
        type(mesh_type) :: tried
        real(dp) :: turn
        integer :: try

        turn = mesh%turn
        do try = 1, most_tries
            if (turn <= settings%angle) return
            aim%angle = aim%angle*wanted_part*settings%angle/turn
            call try_mesh(subject, settings, aim, tried, error)
            if (allocated(error)) return
            if (tried%turn <= settings%angle .and. is_within(tried)) mesh = tried
            if (tried%turn > helpful_part*turn .and. is_within(tried)) return
            turn = tried%turn
            if (.not. is_within(tried)) call take_aim(tried, aim%tolerance)
        end do
    end subroutine turn_less

    !> True for a mesh that keeps its tolerance.
    pure logical function is_within(mesh)
        type(mesh_type), intent(in) :: mesh     !! a mesh, or none
        is_within = mesh%triangle_count > 0 .and. mesh%error <= mesh%tolerance
    end function is_within

    !> True where a mesh is within the tolerance and another is not, or both are and it has fewer
    !> triangles, or none is and it is nearer to the skin.
    pure logical function is_better(mesh, other)
        type(mesh_type), intent(in) :: mesh     !! a mesh
        type(mesh_type), intent(in) :: other    !! another, or none
        is_better = other%triangle_count == 0
        if (is_better) return
        is_better = mesh%error < other%error
        if (is_within(mesh) .and. is_within(other)) &
            is_better = mesh%triangle_count < other%triangle_count
    end function is_better

    !> The tolerance of the next plan.
    pure subroutine take_aim(tried, tolerance)
        type(mesh_type), intent(in) :: tried            !! the mesh of the last
        real(dp), intent(inout) :: tolerance            !! of the plan, deck units
        tolerance = tolerance*min(4.0_dp, &
            wanted_part*tried%tolerance/max(tried%error, tiny(tolerance)))
    end subroutine take_aim

    !> Takes the errors of panels into those of a mesh.
    pure subroutine settle(mesh)
        type(mesh_type), intent(inout) :: mesh !! finished
        integer :: i
        do i = 1, size(mesh%parts)
            if (mesh%parts(i)%error <= mesh%error) cycle
            mesh%error = mesh%parts(i)%error
            mesh%worst = mesh%parts(i)%worst
        end do
    end subroutine settle

    !> Builds the mesh of panels alone, in deck units, with the same failures.
    pure subroutine build_panel_mesh(panels, settings, mesh, error)
        type(panel_type), intent(in) :: panels(:)           !! of both halves
        type(settings_type), intent(in) :: settings         !! angle, and tolerance in deck units
        type(mesh_type), intent(out) :: mesh                !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see `build_mesh`

        if (.not. (settings%tolerance > 0.0_dp .and. settings%angle > 0.0_dp)) then
            call fail(error, cause%usage, 'tolerance and angle of a mesh must be above zero')
            return
        end if
        mesh%tolerance = settings%tolerance
        mesh%angle = settings%angle
        allocate (mesh%parts(0), mesh%normals(3, 8), mesh%vertices(3, 8))
        call add_panels(panels, settings%tolerance, settings%angle, .false., mesh, error)
        if (allocated(error)) return
        call find_turn(mesh, find_twins(mesh), [real(dp) ::])
        call trim_mesh(mesh)
        call settle(mesh)
        call conclude('', mesh)
    end subroutine build_panel_mesh

    !> Says that a mesh stays too far from the skin.
    pure subroutine explain(mesh, error)
        type(mesh_type), intent(in) :: mesh                 !! the best one tried
        type(error_type), allocatable, intent(out) :: error !! `cause%no_convergence`

        if (mesh%triangle_count == 0) then
            call fail(error, cause%no_convergence, 'the body has no skin to make triangles of')
        else
            call fail(error, cause%no_convergence, 'the triangles stay '//compact(mesh%error)// &
                ' from the skin at STA '//compact(mesh%worst(1))//', BL '// &
                compact(mesh%worst(2))//', WL '//compact(mesh%worst(3))// &
                '; ask for a larger tolerance than '//compact(mesh%tolerance))
        end if
    end subroutine explain

    !> Builds the mesh of one plan.
    pure subroutine try_mesh(subject, settings, aim, mesh, error)
        type(subject_type), intent(in) :: subject           !! body and panels
        type(settings_type), intent(in) :: settings         !! what is asked
        type(settings_type), intent(in) :: aim              !! of the plan
        type(mesh_type), intent(out) :: mesh                !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see `build_mesh`
        type(plan_type) :: plan
        type(row_type), allocatable :: rows(:)
        integer, allocatable :: twin(:)
        character(:), allocatable :: why

        associate (it => subject%body)
            call new_plan(subject%density, aim%tolerance, aim%angle, it%is_symmetric, plan, error)
            if (allocated(error)) return
            mesh%tolerance = settings%tolerance
            mesh%angle = settings%angle
            allocate (mesh%parts(0), mesh%normals(3, 8))
            call lay_vertices(it, plan, rows, mesh, error)
            if (allocated(error)) return
            call join_rows(plan, seam_part*aim%tolerance, rows, mesh)
            call add_skin(it, plan, rows, mesh, error)
            if (allocated(error)) return
            mesh%stations = size(rows)
            why = why_not_closed(it, plan)
            if (len(why) == 0) call add_walls(it, plan, rows, mesh)
            twin = find_twins(mesh)
            call find_turn(mesh, twin, stops_of(plan))
            if (size(subject%panels) > 0) then
                call add_panels(subject%panels, settings%tolerance, settings%angle, &
                    subject%body%is_symmetric, mesh, error)
                if (allocated(error)) return
                twin = find_twins(mesh)
            end if
            if (len(why) == 0 .and. .not. aim%is_open) &
                call add_caps(mesh, twin, stops_of(plan), it%is_symmetric)
            if (it%is_symmetric) call add_port_half(mesh)
            call trim_mesh(mesh)
            if (aim%is_open .and. len(why) == 0) why = 'its ends are left open as asked'
            call conclude(why, mesh)
        end associate
    end subroutine try_mesh

    !> The stations between which the runs of a plan are.
    pure function stops_of(plan) result(stops)
        type(plan_type), intent(in) :: plan !! any
        real(dp) :: stops(size(plan%runs) + 1)
        integer :: i
        do i = 1, size(plan%runs)
            stops(i:i + 1) = [plan%runs(i)%stretch%from, plan%runs(i)%stretch%to]
        end do
    end function stops_of

    !> Joins the runs where the set of sections changes.
    pure subroutine join_rows(plan, gap, rows, mesh)
        type(plan_type), intent(in) :: plan         !! the runs
        real(dp), intent(in) :: gap                 !! how near outlines are that are one
        type(row_type), intent(inout) :: rows(:)    !! those at stops are joined
        type(mesh_type), intent(inout) :: mesh      !! their vertices
        integer :: i
        do i = 2, size(plan%runs)
            associate (row => rows(first_row(plan, i)))
                call join_row(plan%runs(i - 1)%stretch%sections, plan%runs(i)%stretch%sections, &
                    max(gap, row%ends%reach), row, mesh)
            end associate
        end do
    end subroutine join_rows

    !> Looks whether the mesh is closed, and says why where it is not.
    pure subroutine conclude(why, mesh)
        character(*), intent(in) :: why         !! why its ends were left open, or empty
        type(mesh_type), intent(inout) :: mesh  !! finished
        integer, allocatable :: twin(:)
        integer :: ends(2)

        allocate (twin, source=find_twins(mesh))
        mesh%is_closed = all(twin > 0)
        if (mesh%is_closed) return
        mesh%why = why
        if (len(why) > 0) return
        ends = half_edge(mesh, findloc(twin, 0, dim=1))
        mesh%why = 'an edge is open at STA '//compact(mesh%vertices(1, ends(1)))//', BL '// &
            compact(mesh%vertices(2, ends(1)))//', WL '//compact(mesh%vertices(3, ends(1)))
    end subroutine conclude

end module export_mesh_build
