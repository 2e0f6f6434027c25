!> From the PATCH cards of a job to panels: which curves are the sides, and what lies beside those
!> that are to be tangent.
module body_build_panels
    use base_decimal, only: to_real
    use base_error, only: cause, error_type, fail
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_text, only: to_text
    use body_beside, only: beside_type, find_edge, find_skin, is_in_mirror, neighbour
    use body_body, only: body_type
    use body_build_sides, only: trimmed_sides
    use body_line, only: line_type
    use body_panel, only: new_panel, panel_type, plan_type
    use body_panel_side, only: side_type
    use body_trace, only: trace_type, world_type
    use body_whole_sides, only: whole_sides
    use deck_body_card, only: blame, warn
    use deck_job, only: asked_body_type => body_type, bound, job_type, patch_type
    implicit none (type, external)
    private

    public :: build_panels

contains

    !> Builds the panels of a body. One that can't be built is said of its card and left out.
    pure subroutine build_panels(job, number, body, traces, panels, faults)
        type(job_type), intent(in) :: job                           !! what the deck asks for
        integer, intent(in) :: number                               !! which of its bodies
        type(body_type), intent(in) :: body                         !! with its lines and sections
        type(trace_type), intent(in) :: traces(:)                   !! of its named cuts
        type(panel_type), allocatable, intent(out) :: panels(:)     !! in the order of the deck
        type(fault_list_type), intent(inout) :: faults              !! what is wrong is added
        type(error_type), allocatable :: error
        type(panel_type) :: panel
        type(world_type) :: world
        integer :: i

        world%gap = to_real(job%joint_gap)
        world%asked = job%body(number)
        world%body = body
        world%traces = traces
        allocate (panels(0))
        do i = 1, size(world%asked%patch)
            associate (asked => world%asked%patch(i))
                if (.not. is_buildable(world%asked, asked, body%lines)) cycle
                call build_panel(asked, world, panels, panel, error)
                if (allocated(error)) then
                    call blame(asked%card, 2, 'patch '//trim(asked%name)//': '//error%message, &
                        faults)
                    cycle
                end if
                if (any(panel%joint%is_inward)) call warn(asked%card, 2, 'patch '// &
                    trim(asked%name)//' faces the other way than the skin beside it; name its '// &
                    'sides the other way round', faults)
                panels = [panels, panel]
            end associate
        end do
    end subroutine build_panels

    !> True where the lines of a patch are there. (If not, that was said of their cards.)
    pure logical function is_buildable(asked, patch, lines)
        type(asked_body_type), intent(in) :: asked  !! as the deck has it
        type(patch_type), intent(in) :: patch       !! one of its patches
        type(line_type), intent(in) :: lines(:)     !! its lines
        integer :: i, line

        is_buildable = .true.
        do i = 1, 4
            line = patch%side(i)%line
            if (line == 0) cycle
            is_buildable = is_buildable .and. all(asked%line(line)%view(:2)%is_sound .or. &
                asked%line(line)%view(:2)%origin == 0) .and. lines(line)%has_side .and. &
                (lines(line)%has_plan .or. asked%line(line)%view(2)%origin == 0)
        end do
    end function is_buildable

    !> Builds a panel. Fails where a corner or a side can't be found, where there is nothing beside
    !> a side that is to be tangent, and as `new_panel`.
    pure subroutine build_panel(asked, world, panels, panel, error)
        type(patch_type), intent(in) :: asked               !! as the deck has it
        type(world_type), intent(in) :: world               !! what sides are taken from
        type(panel_type), intent(in) :: panels(:)           !! built before it
        type(panel_type), intent(out) :: panel              !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(plan_type) :: plan
        integer :: i

        plan%name = asked%name
        plan%twists = asked%twist
        plan%gap = world%gap
        call find_sides(asked, world, plan%side, error)
        if (allocated(error)) return
        do i = 1, 4
            if (.not. asked%side(i)%is_tangent) cycle
            call find_beside(plan%side(i), world, panels, plan%beside(i), error)
            if (.not. allocated(error)) cycle
            error%message = 'TANGENT'//to_text(i)//': side '//to_text(i)//' '//error%message
            return
        end do
        call new_panel(plan, panel, error)
    end subroutine build_panel

    !> Finds what lies beside a side: skin, else an edge of a panel, else the mirror image. Fails
    !> with `cause%beyond_lines` where nothing does.
    pure subroutine find_beside(side, world, panels, beside, error)
        type(side_type), intent(in) :: side                 !! no point
        type(world_type), intent(in) :: world               !! sections
        type(panel_type), intent(in) :: panels(:)           !! built before
        type(beside_type), intent(out) :: beside            !! what it is
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: i

        call find_skin(world%body, side, world%gap, beside, error)
        if (allocated(error) .or. beside%kind /= neighbour%none) return
        do i = 1, size(panels)
            call find_edge(panels(i)%surface, panels(i)%outward, side, world%gap, beside)
            beside%name = panels(i)%name
            if (beside%kind /= neighbour%none) return
        end do
        beside%name = 'MIRROR'
        if (world%body%is_symmetric .and. is_in_mirror(side, world%gap)) then
            beside%kind = neighbour%mirror
        else
            call fail(error, cause%beyond_lines, 'is not on the skin of a section all along, '// &
                'nor on the whole side of a patch before it, nor in BL 0 of a symmetric body')
        end if
    end subroutine find_beside

    !> Finds the sides of a patch: between lines the arcs of the sections that go from one to the
    !> other; with cuts, and else, any curves trimmed where they meet.
    pure subroutine find_sides(asked, world, side, error)
        type(patch_type), intent(in) :: asked               !! as the deck has it
        type(world_type), intent(in) :: world               !! lines, sections, cuts
        type(side_type), intent(out) :: side(4)             !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(error_type), allocatable :: trouble

        if (any(asked%side%kind == bound%cut)) then
            call trimmed_sides(asked, world, side, error)
            return
        end if
        call whole_sides(asked, world%body, world%gap, side, error)
        if (.not. allocated(error) .or. all(asked%side%kind /= bound%station)) return
        call trimmed_sides(asked, world, side, trouble)
        if (.not. allocated(trouble)) deallocate (error)
    end subroutine find_sides

end module body_build_panels
