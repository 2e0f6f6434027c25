!> Everything a body deck asks of one body, computed once: printed as listing or CSV, or drawn.
module api_computed_body
    use api_computed_arcs, only: arcs_of_cut, arcs_of_outline
    use api_computed_cuts, only: how_type, made_type, make_cuts, say
    use api_ring_faults, only: warn_of_ring
    use api_traces, only: traces_of_sides
    use base_decimal, only: to_real
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_text, only: compact
    use body_body, only: body_type
    use body_build, only: build_body
    use body_build_panels, only: build_panels
    use body_duct, only: build_ducts, duct_type
    use body_gap_faults, only: report_gaps, warn_of_turns
    use body_ledger, only: joint_type
    use body_outline, only: build_outlines, outline_type
    use body_panel, only: panel_type
    use body_ring, only: ring_of
    use body_ring_list, only: ring_type
    use cut_clearance, only: check_clearance, clearance_type
    use cut_clearance_map, only: map_type, new_map
    use cut_duct, only: duct_measure_type, measure_duct
    use cut_measure_body, only: body_measure_type, measure_body
    use cut_offsets, only: half_breadths, heights, offset_table_type
    use cut_outline, only: cut_at, cut_type
    use cut_plane, only: cut_kind
    use deck_body_card, only: blame
    use deck_job, only: asked_body_type => body_type, job_type, name_length
    use report_arc_listing, only: arc_table_type
    use sweep_component, only: component_of
    implicit none (type, external)
    private

    public :: computed_body_type, compute_body, judge_body, cut_body, how_type

    !> The circular arcs of a cut.
    type :: cut_arcs_type
        type(arc_table_type), allocatable :: tables(:)  !! one a contour; none: none are asked
    end type cut_arcs_type

    !> A body and what was asked of it.
    type :: computed_body_type
        type(body_type) :: body                                     !! lines and sections
        type(panel_type), allocatable :: panels(:)                  !! its patches, then its ducts
        character(name_length), allocatable :: sections(:)          !! names of its sections, then
                                                                    !! of its panels
        type(joint_type), allocatable :: joints(:)                  !! the continuity ledger
        type(ring_type) :: ring                                     !! how its sections meet
        type(cut_type), allocatable :: cuts(:)                      !! in the order of the deck
        integer, allocatable :: cards(:)                            !! which card each is of
        type(cut_arcs_type), allocatable :: arcs(:)                 !! of each cut
        type(offset_table_type) :: heights                          !! on the butt lines asked for
        type(offset_table_type) :: half_breadths                    !! on the waterlines
        type(body_measure_type) :: measure                          !! areas and volume
        type(clearance_type), allocatable :: clearances(:)          !! of its components
        type(outline_type), allocatable :: outlines(:)              !! its faired outlines
        type(cut_arcs_type), allocatable :: outline_arcs(:)         !! of each of these
        type(duct_type), allocatable :: ducts(:)                    !! its ducts
        type(duct_measure_type), allocatable :: duct_measures(:)    !! of each of these
    end type computed_body_type

contains

    !> Computes all that is asked of a body: what `judge_body` does, offset tables and measures.
    subroutine compute_body(job, number, computed, faults, how)
        type(job_type), intent(in) :: job                       !! what the deck asks for
        integer, intent(in) :: number                           !! which of its bodies
        type(computed_body_type), intent(out) :: computed       !! what came out
        type(fault_list_type), intent(inout) :: faults          !! what is wrong is added
        type(how_type), intent(in), optional :: how             !! facts, threads; else all, one
        real(dp), allocatable :: stations(:)
        integer :: i

        call judge_body(job, number, computed, faults, how)
        stations = cut_at(computed%cuts, cut_kind%station, 1)
        computed%heights = heights(computed%body, cut_at(computed%cuts, cut_kind%buttock, 2), &
            stations)
        computed%half_breadths = half_breadths(computed%body, &
            cut_at(computed%cuts, cut_kind%waterline, 3), stations)
        call measure_body(computed%body, stations, computed%measure)
        allocate (computed%duct_measures(size(computed%ducts)))
        do i = 1, size(computed%ducts)
            computed%duct_measures(i) = measure_duct(computed%ducts(i), stations)
        end do
    end subroutine compute_body

    !> Computes all of a body that a fault can be found in: lines, sections and how they meet, cuts,
    !> clearances. Offset tables and measures are left out.
    subroutine judge_body(job, number, computed, faults, how)
        type(job_type), intent(in) :: job                       !! what the deck asks for
        integer, intent(in) :: number                           !! which of its bodies
        type(computed_body_type), intent(out) :: computed       !! what came out
        type(fault_list_type), intent(inout) :: faults          !! what is wrong is added
        type(how_type), intent(in), optional :: how             !! facts, threads; else all, one

        call cut_body(job, number, computed, faults, how)
        call add_arcs(job%body(number), computed, faults)
        call check_components(job%body(number), computed, faults)
    end subroutine judge_body

    !> Builds a body, looks how its sections meet, and cuts it.
    subroutine cut_body(job, number, computed, faults, how)
        type(job_type), intent(in) :: job                       !! what the deck asks for
        integer, intent(in) :: number                           !! which of its bodies
        type(computed_body_type), intent(out) :: computed       !! body, joints, ring and cuts
        type(fault_list_type), intent(inout) :: faults          !! what is wrong is added
        type(how_type), intent(in), optional :: how             !! facts, threads; else all, one

        call cuts_of_body(job, number, computed, faults, how)
        computed%ring = ring_of(computed%body)
        call warn_of_ring(job%body(number), computed%body, computed%ring, faults)
    end subroutine cut_body

    !> Builds a body and cuts it; no measures, no tables. A body without sections is not cut: why it
    !> has none has been said.
    subroutine cuts_of_body(job, number, computed, faults, how)
        type(job_type), intent(in) :: job                       !! what the deck asks for
        integer, intent(in) :: number                           !! which of its bodies
        type(computed_body_type), intent(out) :: computed       !! body, joints and cuts
        type(fault_list_type), intent(inout) :: faults          !! what is wrong is added
        type(how_type), intent(in), optional :: how             !! facts, threads; else all, one
        type(how_type) :: asked
        type(made_type) :: made
        integer :: i

        if (present(how)) asked = how
        call build_body(job, number, computed%body, computed%joints, faults)
        call build_outlines(job%body(number), computed%outlines, faults)
        allocate (computed%cuts(0), computed%cards(0), computed%clearances(0))
        call build_panels(job, number, computed%body, &
            traces_of_sides(job%body(number), computed%body), computed%panels, faults)
        call build_ducts(job%body(number), computed%outlines, computed%ducts, faults)
        do i = 1, size(computed%ducts)
            computed%panels = [computed%panels, computed%ducts(i)%panel]
        end do
        computed%sections = [character(name_length) :: computed%body%sections%name, &
            computed%panels%name]
        call report_gaps(job%body(number), computed%body, faults)
        call warn_of_turns(job%body(number), computed%body, faults)
        if (size(computed%sections) == 0) return
        call make_cuts(computed%body, computed%panels, job%body(number)%cut, asked, made, faults)
        call move_alloc(made%cuts, computed%cuts)
        call move_alloc(made%cards, computed%cards)
    end subroutine cuts_of_body

    !> Makes the arcs of the cuts and outlines that ask for them. What is wrong is said on the card.
    subroutine add_arcs(asked, computed, faults)
        type(asked_body_type), intent(in) :: asked              !! as the deck has it
        type(computed_body_type), intent(inout) :: computed     !! gets the arcs
        type(fault_list_type), intent(inout) :: faults          !! what is wrong is added
        type(error_type), allocatable :: error
        character(:), allocatable :: said
        integer :: i, k

        allocate (computed%arcs(size(computed%cuts)))
        said = ''
        do i = 1, size(computed%cuts)
            if (i > 1) then
                if (computed%cards(i) /= computed%cards(i - 1)) said = ''
            end if
            call arcs_of_cut(computed%body, computed%cuts(i), computed%arcs(i)%tables, error)
            if (allocated(error)) call say(asked%cut(computed%cards(i)), error%message, .true., &
                said, faults)
        end do
        allocate (computed%outline_arcs(size(computed%outlines)))
        do i = 1, size(computed%outlines)
            call arcs_of_outline(computed%outlines(i), computed%outline_arcs(i)%tables, error)
            if (.not. allocated(error)) cycle
            k = findloc(asked%outline%name, computed%outlines(i)%name, dim=1)
            call blame(asked%outline(k)%card, 2, error%message, faults)
        end do
    end subroutine add_arcs

    !> Looks how clear the components are; one that is nearer than asked is an error on its card.
    subroutine check_components(asked, computed, faults)
        type(asked_body_type), intent(in) :: asked              !! as the deck has it
        type(computed_body_type), intent(inout) :: computed     !! gets the clearances
        type(fault_list_type), intent(inout) :: faults          !! what is wrong is added
        type(map_type) :: map
        integer :: i

        if (size(asked%check) == 0) return
        map = new_map(computed%body)
        deallocate (computed%clearances)
        allocate (computed%clearances(size(asked%check)))
        do i = 1, size(asked%check)
            associate (found => computed%clearances(i), card => asked%check(i))
                call check_clearance(computed%body, map, component_of(card), found)
                if (.not. found%is_short) cycle
                call blame(card%card, 2, 'clearance '//compact(found%gap)//' at STA '// &
                    compact(found%nearest(1))//', BL '//compact(found%nearest(2))//', WL '// &
                    compact(found%nearest(3))//'; '//compact(to_real(card%clearance))// &
                    ' is asked for', faults)
            end associate
        end do
    end subroutine check_components

end module api_computed_body
