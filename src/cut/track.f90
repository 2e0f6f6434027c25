!> The tracks of a plane on the sections of a body: each goes from one station to another on one
!> branch, and ends where the section does, where its place reaches an edge of the section, or where
!> it turns back in STA as another branch.
module cut_track
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_order, only: rising
    use body_body, only: body_type, smooth_stops
    use body_gap, only: gap_type, section_gaps
    use body_section, only: section_arc, section_type
    use cut_event, only: event_type, events_between, happening
    use cut_meeting, only: cut_branch, has_branch, meeting_of, meeting_type, place_of, &
        turning_place
    use cut_plane, only: plane_type
    use geom_arc, only: arc_type
    use geom_place, only: is_finish, is_start, place_type
    implicit none (type, external)
    private

    public :: track_type, tracks_on, place_on

    !> One branch on one section.
    type :: track_type
        integer :: section = 0          !! in the body's list
        integer :: branch = 0           !! one of `cut_branch%...`
        type(event_type) :: from        !! where it begins; `from%sta` is below `to%sta`
        type(event_type) :: to          !! where it ends
        logical :: lies(2) = .false.    !! the start line, the finish line lies in the plane
        integer :: edge = 0             !! 1, 2: it runs along the start, the finish line
    end type track_type

contains

    !> The tracks of a plane on one section, in order of STA.
    pure function tracks_on(body, number, plane, limit) result(tracks)
        type(body_type), intent(in) :: body     !! finished
        integer, intent(in) :: number           !! which of its sections
        type(plane_type), intent(in) :: plane   !! not across STA
        real(dp), intent(in) :: limit(2)        !! least and greatest station asked, deck units
        type(track_type), allocatable :: tracks(:), more(:)
        real(dp), allocatable :: stops(:)
        integer :: i

        allocate (tracks(0), more(0), stops(0))
        stops = limited_stops(body, body%sections(number), limit)
        do i = 1, size(stops) - 1
            if (.not. is_sound_at(body, number, 0.5_dp*(stops(i) + stops(i + 1)))) cycle
            more = tracks_between(body, number, plane, stops(i), stops(i + 1))
            call append(more, tracks)
        end do
    end function tracks_on

    !> The stations between which a section is smooth and has arcs, within limits.
    pure function limited_stops(body, section, limit) result(stops)
        type(body_type), intent(in) :: body         !! finished
        type(section_type), intent(in) :: section   !! one of its sections
        real(dp), intent(in) :: limit(2)            !! least and greatest station asked, deck units
        real(dp), allocatable :: stops(:)
        type(gap_type), allocatable :: gaps(:)
        real(dp) :: from, to

        allocate (stops(0), gaps(0))
        from = max(section%from, limit(1))
        to = min(section%to, limit(2))
        if (.not. from < to) return
        gaps = section_gaps(body, section)
        stops = [from, smooth_stops(body, section), gaps%from, gaps%to, to]
        stops = rising(pack(stops, stops >= from .and. stops <= to))
    end function limited_stops

    !> True where a section has an arc at a station.
    pure logical function is_sound_at(body, number, sta)
        type(body_type), intent(in) :: body !! finished
        integer, intent(in) :: number       !! which of its sections
        real(dp), intent(in) :: sta         !! deck units
        type(arc_type) :: arc
        type(error_type), allocatable :: error
        call section_arc(body%lines, body%sections(number), sta, arc, error)
        is_sound_at = .not. allocated(error)
    end function is_sound_at

    !> The tracks between two stations with nothing but smooth lines between.
    pure function tracks_between(body, number, plane, from, to) result(tracks)
        type(body_type), intent(in) :: body     !! finished
        integer, intent(in) :: number           !! which of its sections
        type(plane_type), intent(in) :: plane   !! not across STA
        real(dp), intent(in) :: from            !! deck units
        real(dp), intent(in) :: to              !! deck units, above
        type(track_type), allocatable :: tracks(:), more(:)
        type(event_type), allocatable :: events(:)
        type(track_type) :: track
        logical :: lies(2)
        integer :: i, branch

        allocate (tracks(0), more(0))
        call events_between(body, number, plane, [from, to], events, lies)
        do i = 1, size(events) - 1
            more = [track_type ::]
            do branch = cut_branch%falling, cut_branch%rising, 2
                track = track_type(number, branch, events(i), events(i + 1), lies)
                if (.not. is_there(body, plane, track)) cycle
                track%edge = edge_of(body, plane, track)
                more = [more, track]
            end do
            call append(more, tracks)
        end do
    end function tracks_between

    !> Adds tracks behind others; one that goes on on the same branch lengthens it.
    pure subroutine append(more, tracks)
        type(track_type), intent(in) :: more(:)                     !! further aft
        type(track_type), allocatable, intent(inout) :: tracks(:)   !! so far
        integer :: i, j, before

        before = size(tracks)
        new: do i = 1, size(more)
            do j = 1, before
                if (.not. continues(tracks(j), more(i))) cycle
                tracks(j)%to = more(i)%to
                cycle new
            end do
            tracks = [tracks, more(i)]
        end do new
    end subroutine append

    !> True where a track goes on as another.
    pure logical function continues(track, next)
        type(track_type), intent(in) :: track   !! a track
        type(track_type), intent(in) :: next    !! another of the same section
        continues = track%branch == next%branch .and. track%edge == next%edge &
            .and. all(track%lies .eqv. next%lies) &
            .and. .not. abs(next%from%sta - track%to%sta) > 0.0_dp &
            .and. next%from%kind /= happening%turn
    end function continues

    !> True where a track's branch is there at the middle between its events.
    pure logical function is_there(body, plane, track)
        type(body_type), intent(in) :: body     !! finished
        type(plane_type), intent(in) :: plane   !! not across STA
        type(track_type), intent(in) :: track   !! to be looked for
        type(error_type), allocatable :: error
        type(arc_type) :: arc
        real(dp) :: middle

        is_there = .false.
        middle = track%from%sta + 0.5_dp*(track%to%sta - track%from%sta)
        if (.not. (middle > track%from%sta .and. middle < track%to%sta)) return
        call section_arc(body%lines, body%sections(track%section), middle, arc, error)
        if (allocated(error)) return
        is_there = has_branch(meeting_of(arc, middle, plane, track%lies), track%branch)
    end function is_there

    !> The edge along which a track runs, or 0.
    pure integer function edge_of(body, plane, track) result(edge)
        type(body_type), intent(in) :: body     !! finished
        type(plane_type), intent(in) :: plane   !! not across STA
        type(track_type), intent(in) :: track   !! of both
        type(place_type) :: place
        logical :: is_arc

        edge = 0
        if (.not. any(track%lies)) return
        call place_on(body, plane, track, 0.5_dp*(track%from%sta + track%to%sta), place, is_arc)
        if (track%lies(1) .and. is_start(place)) edge = 1
        if (track%lies(2) .and. is_finish(place)) edge = 2
    end function edge_of

    !> The place of a track at a station; at an end of the track it is exactly the place of what
    !> happens there. `is_arc` is false where the section is a point.
    pure subroutine place_on(body, plane, track, sta, place, is_arc)
        type(body_type), intent(in) :: body         !! finished
        type(plane_type), intent(in) :: plane       !! not across STA
        type(track_type), intent(in) :: track       !! of that body and plane
        real(dp), intent(in) :: sta                 !! from its beginning to its end, deck units
        type(place_type), intent(out) :: place      !! where on the section's arc
        logical, intent(out) :: is_arc              !! there is an arc
        type(error_type), allocatable :: error
        type(meeting_type) :: meeting
        type(arc_type) :: arc
        logical :: lies(2)
        integer :: kind

        kind = happening%nothing
        if (.not. sta > track%from%sta) kind = track%from%kind
        if (.not. sta < track%to%sta) kind = track%to%kind
        call section_arc(body%lines, body%sections(track%section), sta, arc, error)
        is_arc = .not. allocated(error)
        if (.not. is_arc) return
        lies = track%lies .or. [kind == happening%start, kind == happening%finish]
        meeting = meeting_of(arc, sta, plane, lies)
        if (kind == happening%turn) then
            place = turning_place(meeting)
        else
            place = place_of(meeting, track%branch)
        end if
    end subroutine place_on

end module cut_track
