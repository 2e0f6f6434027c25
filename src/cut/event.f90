!> What happens to the cut of a section on the way along STA.
!>
!> All stations where one of these happens are found as zeros of smooth functions between joints of
!> the control lines (`geom_zeros`): the height of an edge over the plane, and the discriminant of
!> the meeting. A track that is longer in STA than 1/40 of such a stretch is never missed; a shorter
!> one is found where one of the functions has an extreme that its samples show.
module cut_event
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_tolerances, only: ulp
    use body_body, only: body_type
    use body_line, only: line_point, line_type
    use body_section, only: section_arc, section_type, trace_at, trace_type
    use body_section_row, only: line_points
    use cut_meeting, only: edge_height, height_noise, meeting_of, meeting_type, openness
    use cut_meeting_row, only: meetings_at
    use cut_plane, only: plane_type
    use geom_arc, only: arc_type
    use geom_twofold, only: to_real
    use geom_zeros, only: function_type, sample_points, zeros_of
    implicit none (type, external)
    private

    public :: event_type, events_between

    !> What happens at a station.
    type, public :: happening_list
        integer :: nothing = 0  !! a joint of lines or the end of the range
        integer :: start = 1    !! the start line goes through the plane
        integer :: finish = 2   !! the finish line does
        integer :: turn = 3     !! two branches become one
    end type happening_list

    !> The happenings by name.
    type(happening_list), parameter, public :: happening = happening_list()

    !> A station where something happens on a section.
    type :: event_type
        real(dp) :: sta = 0.0_dp    !! deck units
        integer :: kind = 0         !! one of `happening%...`
    end type event_type

    !> The height of an end of a section over the plane, over STA.
    type, extends(function_type) :: edge_type
        type(line_type), allocatable :: lines(:)    !! of the body
        type(section_type) :: section               !! one of its sections
        type(plane_type) :: plane                   !! the plane
        integer :: which = 1                        !! 1: start, 2: finish
    contains
        procedure :: at => edge_at
        procedure :: values => edges_at
    end type edge_type

    !> The openness of the meeting, over STA; -1 where there is no arc.
    type, extends(edge_type) :: tangency_type
    contains
        procedure :: at => openness_at
        procedure :: values => opennesses_at
    end type tangency_type

    !> Openness that is nothing but round-off.
    real(dp), parameter :: touching = 64.0_dp*ulp

contains

    !> All that happens between two stations, the ends included, in order.
    pure subroutine events_between(body, number, plane, ends, events, lies)
        type(body_type), intent(in) :: body                         !! finished
        integer, intent(in) :: number                               !! which of its sections
        type(plane_type), intent(in) :: plane                       !! not across STA
        real(dp), intent(in) :: ends(2)                             !! deck units, in order
        type(event_type), allocatable, intent(out) :: events(:)     !! see above
        logical, intent(out) :: lies(2)                             !! start, finish in the plane
        type(tangency_type) :: tangency
        integer :: i

        tangency%lines = body%lines
        tangency%section = body%sections(number)
        tangency%plane = plane
        events = [edge_event(tangency%edge_type, ends(1)), edge_event(tangency%edge_type, ends(2))]
        do i = 1, 2
            tangency%which = i
            lies(i) = lies_in_plane(tangency%edge_type, ends)
            if (.not. lies(i)) call insert(zeros_of(tangency%edge_type, ends(1), ends(2), &
                noise_between(tangency%edge_type, ends)), i, events)
        end do
        do i = size(events) - 1, 1, -1
            call insert(zeros_of(tangency, events(i)%sta, events(i + 1)%sta, touching), &
                happening%turn, events)
        end do
    end subroutine events_between

    !> Puts events among others, in order of STA; one at the station of another, as far as rounding
    !> can say, is that. (Where an end tangent lies in the plane, its edge and a turn are one
    !> event.)
    pure subroutine insert(stations, kind, events)
        real(dp), intent(in) :: stations(:)                         !! deck units
        integer, intent(in) :: kind                                 !! one of `happening%...`
        type(event_type), allocatable, intent(inout) :: events(:)   !! in order
        real(dp) :: noise
        integer :: i, before

        noise = touching*maxval(abs(events%sta))
        do i = 1, size(stations)
            if (any(abs(events%sta - stations(i)) <= noise)) cycle
            before = count(events%sta <= stations(i))
            events = [events(:before), event_type(stations(i), kind), events(before + 1:)]
        end do
    end subroutine insert

    !> The event at an end of a stretch: an edge may go through the plane just there.
    pure type(event_type) function edge_event(edge, sta) result(event)
        type(edge_type), intent(in) :: edge !! of either end of the section
        real(dp), intent(in) :: sta         !! deck units
        type(trace_type) :: trace
        logical :: meets(2)

        trace = trace_at(edge%lines, edge%section, sta)
        meets = [in_plane(edge%plane, sta, trace%start%point), &
            in_plane(edge%plane, sta, trace%finish%point)]
        event%sta = sta
        if (meets(1) .and. .not. meets(2)) event%kind = happening%start
        if (meets(2) .and. .not. meets(1)) event%kind = happening%finish
    end function edge_event

    !> True for a point of the plane, as far as decimals can say.
    pure logical function in_plane(plane, sta, at)
        type(plane_type), intent(in) :: plane   !! any plane
        real(dp), intent(in) :: sta             !! deck units
        real(dp), intent(in) :: at(2)           !! BL, WL, deck units
        in_plane = abs(to_real(edge_height(plane, sta, at))) <= height_noise(plane, sta, at)
    end function in_plane

    !> True where an end of the section is in the plane all the way.
    pure logical function lies_in_plane(edge, ends)
        type(edge_type), intent(in) :: edge     !! of one end of the section
        real(dp), intent(in) :: ends(2)         !! stations, deck units
        real(dp), allocatable :: sta(:)
        integer :: i

        allocate (sta(0))
        sta = sample_points(ends(1), ends(2))
        lies_in_plane = .false.
        do i = 1, size(sta)
            if (.not. in_plane(edge%plane, sta(i), end_point(edge, sta(i)))) return
        end do
        lies_in_plane = .true.
    end function lies_in_plane

    !> What lost decimals do to the heights of an end between two stations.
    pure real(dp) function noise_between(edge, ends) result(noise)
        type(edge_type), intent(in) :: edge     !! of one end of the section
        real(dp), intent(in) :: ends(2)         !! stations, deck units
        noise = max(height_noise(edge%plane, ends(1), end_point(edge, ends(1))), &
            height_noise(edge%plane, ends(2), end_point(edge, ends(2))))
    end function noise_between

    !> BL and WL of the start or the finish of the section, deck units.
    pure function end_point(edge, sta) result(at)
        class(edge_type), intent(in) :: edge    !! which end
        real(dp), intent(in) :: sta             !! deck units
        real(dp) :: at(2)
        at = line_point(edge%lines(edge%section%line(2*edge%which - 1)), sta)
        if (edge%section%is_port) at(1) = -at(1)
    end function end_point

    !> The height of the end of the section at a station.
    pure real(dp) function edge_at(f, x) result(height)
        class(edge_type), intent(in) :: f   !! which end, which plane
        real(dp), intent(in) :: x           !! station, deck units
        height = to_real(edge_height(f%plane, x, end_point(f, x)))
    end function edge_at

    !> The heights of the end of the section at stations.
    pure subroutine edges_at(f, x, y)
        class(edge_type), intent(in) :: f   !! which end, which plane
        real(dp), intent(in) :: x(:)        !! stations, deck units
        real(dp), intent(out) :: y(:)       !! one for each
        real(dp) :: at(2, size(x))
        integer :: i

        call line_points(f%lines(f%section%line(2*f%which - 1)), x, at)
        if (f%section%is_port) at(1, :) = -at(1, :)
        do i = 1, size(x)
            y(i) = to_real(edge_height(f%plane, x(i), at(:, i)))
        end do
    end subroutine edges_at

    !> The opennesses of the meeting at stations.
    pure subroutine opennesses_at(f, x, y)
        class(tangency_type), intent(in) :: f   !! section and plane
        real(dp), intent(in) :: x(:)            !! stations, deck units
        real(dp), intent(out) :: y(:)           !! one for each
        type(meeting_type) :: it(size(x))
        logical :: is_sure(size(x))
        integer :: i

        call meetings_at(f%lines, f%section, f%plane, x, it, is_sure)
        do i = 1, size(x)
            if (is_sure(i)) then
                y(i) = openness(it(i))
            else
                y(i) = f%at(x(i))
            end if
        end do
    end subroutine opennesses_at

    !> The openness of the meeting at a station.
    pure real(dp) function openness_at(f, x) result(open)
        class(tangency_type), intent(in) :: f   !! section and plane
        real(dp), intent(in) :: x               !! station, deck units
        type(error_type), allocatable :: error
        type(arc_type) :: arc

        open = -1.0_dp
        call section_arc(f%lines, f%section, x, arc, error)
        if (.not. allocated(error)) open = openness(meeting_of(arc, x, f%plane, [.false., .false.]))
    end function openness_at

end module cut_event
