!> The parts of a cut within limits along BL and WL.
module cut_clip
    use base_kinds, only: dp
    use base_tolerances, only: decimal_noise, ulp
    use body_body, only: body_type
    use cut_event, only: event_type
    use cut_meeting, only: cut_branch, has_branch, meeting_of, meeting_type, place_of
    use cut_plane, only: buttock_plane, plane_type, waterline_plane
    use cut_request, only: limit_type, request_type
    use cut_track, only: track_type
    use cut_walk, only: coordinate_type
    use geom_arc, only: arc_type
    use geom_arc_point, only: point
    use geom_place, only: at_finish, at_start, is_before, place_type
    use geom_subarc, only: place_between
    use geom_zeros, only: zeros_of
    implicit none (type, external)
    private

    public :: clipped, places_within

contains

    !> The parts of tracks that are within the limits along BL and WL.
    pure function clipped(body, request, tracks) result(parts)
        type(body_type), intent(in) :: body         !! finished
        type(request_type), intent(in) :: request   !! plane and limits
        type(track_type), intent(in) :: tracks(:)   !! of both
        type(track_type), allocatable :: parts(:), whole(:)
        integer :: i, axis

        allocate (parts(0), whole(0))
        parts = tracks
        do axis = 2, 3
            if (.not. is_limit(request%limit(axis))) cycle
            whole = parts
            parts = [track_type ::]
            do i = 1, size(whole)
                parts = [parts, parts_within(body, request, whole(i), axis)]
            end do
        end do
    end function clipped

    !> True where a range ends anywhere.
    elemental logical function is_limit(limit)
        type(limit_type), intent(in) :: limit !! along an axis
        is_limit = limit%has_from .or. limit%has_to
    end function is_limit

    !> True for a coordinate within a limit, as far as decimals can say.
    pure logical function is_within(limit, x)
        type(limit_type), intent(in) :: limit   !! along an axis
        real(dp), intent(in) :: x               !! coordinate, deck units
        real(dp) :: noise
        noise = decimal_noise*ulp*max(abs(limit%from), abs(limit%to))
        is_within = (.not. limit%has_from .or. x >= limit%from - noise) &
            .and. (.not. limit%has_to .or. x <= limit%to + noise)
    end function is_within

    !> The parts of a track within the limit along one axis.
    pure function parts_within(body, request, track, axis) result(parts)
        type(body_type), intent(in) :: body         !! finished
        type(request_type), intent(in) :: request   !! plane and limits
        type(track_type), intent(in) :: track       !! of both
        integer, intent(in) :: axis                 !! 2: BL, 3: WL
        type(track_type), allocatable :: parts(:)
        type(coordinate_type) :: along
        type(event_type), allocatable :: events(:)
        integer :: i

        along%body = body
        along%plane = request%plane
        along%track = track
        along%axis = axis
        allocate (parts(0))
        allocate (events(0))
        events = [track%from, track%to]
        associate (limit => request%limit(axis))
            if (limit%has_from) call divide_track(along, limit%from, events)
            if (limit%has_to) call divide_track(along, limit%to, events)
            along%level = 0.0_dp
            do i = 1, size(events) - 1
                if (.not. is_within(limit, &
                    along%at(0.5_dp*(events(i)%sta + events(i + 1)%sta)))) cycle
                parts = [parts, track]
                parts(size(parts))%from = events(i)
                parts(size(parts))%to = events(i + 1)
            end do
        end associate
    end function parts_within

    !> Puts the stations where a coordinate is at its level among the events of its track.
    pure subroutine divide_track(along, level, events)
        type(coordinate_type), intent(inout) :: along               !! gets the level
        real(dp), intent(in) :: level                               !! deck units
        type(event_type), allocatable, intent(inout) :: events(:)   !! in order
        real(dp), allocatable :: at(:)
        integer :: i, before

        along%level = level
        allocate (at(0))
        at = zeros_of(along, along%track%from%sta, along%track%to%sta, 0.0_dp)
        do i = 1, size(at)
            before = count(events%sta <= at(i))
            events = [events(:before), event_type(sta=at(i)), events(before + 1:)]
        end do
    end subroutine divide_track

    !> The places between which an arc is within the limits along BL and WL: beginnings and ends in
    !> turn, in order along it.
    pure function places_within(arc, limit) result(places)
        type(arc_type), intent(in) :: arc       !! x is BL, y is WL
        type(limit_type), intent(in) :: limit(2) !! along BL and WL
        type(place_type), allocatable :: places(:), stops(:)
        real(dp) :: at(2)
        integer :: i

        allocate (stops(0))
        stops = [at_start, at_finish]
        if (limit(1)%has_from) call divide_arc(arc, buttock_plane(limit(1)%from), stops)
        if (limit(1)%has_to) call divide_arc(arc, buttock_plane(limit(1)%to), stops)
        if (limit(2)%has_from) call divide_arc(arc, waterline_plane(limit(2)%from), stops)
        if (limit(2)%has_to) call divide_arc(arc, waterline_plane(limit(2)%to), stops)
        allocate (places(0))
        do i = 1, size(stops) - 1
            at = point(arc, place_between(arc, stops(i), stops(i + 1)))
            if (is_within(limit(1), at(1)) .and. is_within(limit(2), at(2))) &
                places = [places, stops(i:i + 1)]
        end do
    end function places_within

    !> Puts the places where an arc passes a plane among its stops.
    pure subroutine divide_arc(arc, plane, stops)
        type(arc_type), intent(in) :: arc                           !! x is BL, y is WL
        type(plane_type), intent(in) :: plane                       !! along STA
        type(place_type), allocatable, intent(inout) :: stops(:)    !! in order
        type(meeting_type) :: meeting
        type(place_type) :: place
        integer :: branch, before

        meeting = meeting_of(arc, 0.0_dp, plane, [.false., .false.])
        do branch = cut_branch%falling, cut_branch%rising, 2
            if (.not. has_branch(meeting, branch)) cycle
            place = place_of(meeting, branch)
            before = count(is_before(stops, place))
            if (before == 0) cycle
            if (.not. is_before(place, stops(before + 1))) cycle
            stops = [stops(:before), place, stops(before + 1:)]
        end do
    end subroutine divide_arc

end module cut_clip
