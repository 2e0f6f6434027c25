!> Curves on the skin that can be sides of panels: arcs of sections at a station, and what a named
!> cut takes from a section.
module body_trace
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_panel_side, only: arc_side, side_type
    use body_section, only: section_arc
    use deck_job, only: asked_body_type => body_type
    use geom_arc, only: arc_type
    implicit none (type, external)
    private

    public :: trace_type, world_type, arcs_at

    !> A curve on one section.
    type :: trace_type
        integer :: cut = 0          !! which cut of the body's cards it is of; 0: a station's
        integer :: section = 0      !! in the body's list
        type(side_type) :: side     !! all of it
    end type trace_type

    !> What the sides of patches are taken from.
    type :: world_type
        type(asked_body_type) :: asked              !! the body as the deck has it
        type(body_type) :: body                     !! the same, finished
        type(trace_type), allocatable :: traces(:)  !! curves of its named cuts
        real(dp) :: gap = 0.0_dp                    !! by which sides may miss, deck units
    end type world_type

contains

    !> The arcs of all sections that have one at a station.
    pure function arcs_at(body, sta) result(traces)
        type(body_type), intent(in) :: body !! finished
        real(dp), intent(in) :: sta         !! deck units
        type(trace_type), allocatable :: traces(:)
        type(trace_type) :: trace
        type(error_type), allocatable :: error
        type(arc_type) :: arc
        integer :: i

        allocate (traces(0))
        do i = 1, size(body%sections)
            associate (section => body%sections(i))
                if (sta < section%from .or. sta > section%to) cycle
                call section_arc(body%lines, section, sta, arc, error)
            end associate
            if (allocated(error)) cycle
            trace%section = i
            trace%side = arc_side(arc, sta)
            traces = [traces, trace]
        end do
    end function arcs_at

end module body_trace
