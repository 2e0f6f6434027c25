!> A body in stretches: between two stations where nothing of it has a joint or an end, sections
!> that hang together, with the tracks that their ends run along.
!>
!> Within a stretch each view of each line is one arc. Ends of sections that are in one point all
!> along are on one track; a track in BL 0 is exactly there.
module export_shell_stretch
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_tolerances, only: outline_gap
    use body_body, only: body_type
    use body_gap, only: gap_type
    use body_line, only: line_type
    use body_section, only: section_type, trace_at, trace_type
    use cut_measure_ring, only: link_type, rings_at
    use export_shell_pace, only: pace_type, power_pace
    use export_shell_stops, only: find_gaps, sections_between, stops_of
    use geom_chain, only: chain_piece, chain_type
    use geom_stroke, only: stroke_type
    implicit none (type, external)
    private

    public :: stretch_type, slot_type, track_type, stretches_of, track_at, used_lines

    !> A section in a stretch, or a wall.
    type :: slot_type
        integer :: number = 0               !! of the section in the body; 0: a wall along BL 0
        type(section_type) :: section       !! it, without limits of its own
        integer :: track(2) = 0             !! of its start and of its finish
        real(dp) :: outward = 1.0_dp        !! outside is to the right (1) or left (-1) of its way
    end type slot_type

    !> What an end of a section runs along.
    type :: track_type
        integer :: slot = 0                 !! the first slot that has it
        integer :: end = 0                  !! 1: as its start, 2: as its finish
        logical :: is_centred = .false.     !! in BL 0
    end type track_type

    !> A stretch.
    type :: stretch_type
        type(pace_type) :: pace                     !! from where to where, and how
        type(body_type) :: body                     !! lines of one arc a view; no sections
        type(slot_type), allocatable :: slots(:)    !! in the order of the body, then walls
        type(track_type), allocatable :: tracks(:)  !! each once
        real(dp) :: touch = 0.0_dp                  !! how near tracks are one, deck units
        real(dp) :: join = 0.0_dp                   !! how near corners and ribs are
    end type stretch_type

    !> Where ends of sections are compared: this many places from end to end of a stretch.
    integer, parameter :: places = 17
    !> Tracks are one where they miss each other by less than `outline_gap`, as in all of LOFT, and
    !> than this part of the tolerance.
    real(dp), parameter :: touch_part = 0.125_dp
    !> Corners and ribs are one where they miss each other by less than this part of the tolerance,
    !> and of the longest chord of the sections.
    real(dp), parameter :: join_part = 0.25_dp, join_gap = 1.0e-4_dp

contains

    !> The stretches of a body, from fore to aft.
    pure subroutine stretches_of(body, tolerance, has_walls, stretches)
        type(body_type), intent(in) :: body                             !! finished
        real(dp), intent(in) :: tolerance                               !! of the skin, deck units
        logical, intent(in) :: has_walls                                !! rings open at BL 0 get
                                                                        !! a wall there
        type(stretch_type), allocatable, intent(out) :: stretches(:)    !! may be none
        type(gap_type), allocatable :: gaps(:)
        integer, allocatable :: owner(:), chosen(:), group(:)
        type(stretch_type) :: whole, part
        real(dp), allocatable :: stops(:)
        integer :: i, k

        allocate (stretches(0), stops(0))
        call find_gaps(body, gaps, owner)
        stops = stops_of(body, gaps)
        do i = 1, size(stops) - 1
            chosen = sections_between(body, gaps, owner, stops(i:i + 1))
            if (size(chosen) == 0) cycle
            call new_stretch(body, chosen, stops(i:i + 1), tolerance, whole)
            allocate (group, source=groups_of(whole))
            do k = 1, maxval(group)
                call new_stretch(body, pack(chosen, group == k), stops(i:i + 1), tolerance, part)
                if (has_walls) call add_walls(body, part)
                stretches = [stretches, part]
            end do
            deallocate (group)
        end do
    end subroutine stretches_of

    !> The stretch of some sections between two stops.
    pure subroutine new_stretch(body, chosen, ends, tolerance, stretch)
        type(body_type), intent(in) :: body             !! finished
        integer, intent(in) :: chosen(:)                !! sections of it, there throughout
        real(dp), intent(in) :: ends(2)                 !! neighbouring stops
        real(dp), intent(in) :: tolerance               !! of the skin, deck units
        type(stretch_type), intent(out) :: stretch      !! without walls
        type(trace_type) :: trace
        real(dp) :: middle, longest
        integer :: i

        middle = 0.5_dp*(ends(1) + ends(2))
        allocate (stretch%slots(size(chosen)), stretch%tracks(0))
        allocate (stretch%body%lines, source=body%lines)
        allocate (stretch%body%sections(0))
        do i = 1, size(stretch%body%lines)
            call take_piece(stretch%body%lines(i)%side, middle)
            call take_piece(stretch%body%lines(i)%plan, middle)
            call take_piece(stretch%body%lines(i)%angle, middle)
        end do
        longest = 0.0_dp
        do i = 1, size(chosen)
            associate (slot => stretch%slots(i))
                slot%number = chosen(i)
                slot%section = body%sections(chosen(i))
                slot%section%from = -huge(1.0_dp)
                slot%section%to = huge(1.0_dp)
                slot%outward = slot%section%outward
                trace = trace_at(stretch%body%lines, slot%section, middle)
            end associate
            longest = max(longest, norm2(trace%finish%point - trace%start%point))
        end do
        stretch%touch = min(outline_gap*longest, touch_part*tolerance)
        stretch%join = min(join_gap*longest, join_part*tolerance)
        stretch%pace = power_pace(used_lines(stretch), ends(1), ends(2))
        do i = 1, size(chosen)
            call find_track(i, 1, stretch)
            call find_track(i, 2, stretch)
        end do
    end subroutine new_stretch

    !> Makes a view its one stroke about a station.
    pure subroutine take_piece(view, sta)
        type(chain_type), intent(inout) :: view !! any chain, or none
        real(dp), intent(in) :: sta             !! deck units
        type(stroke_type) :: stroke

        if (view%is_constant .or. .not. allocated(view%stroke)) return
        stroke = view%stroke(chain_piece(view, sta))
        deallocate (view%stroke)
        allocate (view%stroke(1), source=stroke)
        view%knot = [stroke%start(1), stroke%finish(1)]
    end subroutine take_piece

    !> The lines that the sections of a stretch stand on, each once.
    pure function used_lines(stretch) result(lines)
        type(stretch_type), intent(in) :: stretch !! with its sections
        type(line_type), allocatable :: lines(:)
        logical :: is_used(size(stretch%body%lines))
        integer :: i

        is_used = .false.
        do i = 1, size(stretch%slots)
            associate (section => stretch%slots(i)%section)
                if (stretch%slots(i)%number == 0) cycle
                is_used(section%line) = .true.
                if (section%slope(1)%is_angle) is_used(section%slope(1)%line) = .true.
                if (section%slope(2)%is_angle) is_used(section%slope(2)%line) = .true.
            end associate
        end do
        allocate (lines, source=pack(stretch%body%lines, is_used))
    end function used_lines

    !> BL and WL of a track at a station, deck units.
    pure function track_at(stretch, track, sta) result(point)
        type(stretch_type), intent(in) :: stretch   !! with its sections
        type(track_type), intent(in) :: track       !! one of its tracks
        real(dp), intent(in) :: sta                 !! deck units
        real(dp) :: point(2)
        type(trace_type) :: trace

        trace = trace_at(stretch%body%lines, stretch%slots(track%slot)%section, sta)
        point = trace%start%point
        if (track%end == 2) point = trace%finish%point
        if (track%is_centred) point(1) = 0.0_dp
    end function track_at

    !> Gives an end of a section its track: one that is in the same point all along, or a new one.
    pure subroutine find_track(slot, end, stretch)
        integer, intent(in) :: slot                     !! which section of the stretch
        integer, intent(in) :: end                      !! 1: its start, 2: its finish
        type(stretch_type), intent(inout) :: stretch    !! has the tracks of those before
        type(track_type) :: track
        real(dp) :: sta(places), at(2, places), other(2, places)
        integer :: i, k

        track = track_type(slot, end)
        associate (pace => stretch%pace)
            sta = [(pace%from + (pace%to - pace%from)*(real(i, dp)/real(places - 1, dp)), &
                i=0, places - 1)]
            sta(places) = pace%to
        end associate
        at = reshape([(track_at(stretch, track, sta(i)), i=1, places)], [2, places])
        track%is_centred = all(abs(at(1, :)) <= stretch%touch)
        do k = 1, size(stretch%tracks)
            other = reshape([(track_at(stretch, stretch%tracks(k), sta(i)), i=1, places)], &
                [2, places])
            if (any(norm2(at - other, dim=1) > stretch%touch)) cycle
            stretch%slots(slot)%track(end) = k
            return
        end do
        stretch%tracks = [stretch%tracks, track]
        stretch%slots(slot)%track(end) = size(stretch%tracks)
    end subroutine find_track

    !> Numbers the sections of a stretch so that those that share tracks have one number.
    pure function groups_of(stretch) result(group)
        type(stretch_type), intent(in) :: stretch !! any
        integer :: group(size(stretch%slots))
        integer :: low, number, i, k

        group = [(i, i=1, size(group))]
        do k = 1, size(stretch%tracks)
            low = huge(low)
            do i = 1, size(group)
                if (any(stretch%slots(i)%track == k)) low = min(low, group(i))
            end do
            do i = 1, size(group)
                if (.not. any(stretch%slots(i)%track == k)) cycle
                number = group(i)
                where (group == number) group = low
            end do
        end do
        number = 0
        do i = 1, size(group)
            if (.not. any(group == i)) cycle
            number = number + 1
            where (group == i) group = number
        end do
    end function groups_of

    !> Adds a wall along BL 0 for each ring that begins and ends there.
    pure subroutine add_walls(body, stretch)
        type(body_type), intent(in) :: body             !! finished
        type(stretch_type), intent(inout) :: stretch    !! gets them
        type(link_type), allocatable :: links(:), ring(:)
        type(error_type), allocatable :: error
        integer :: first(2), last(2), i, last_link

        call rings_at(body, 0.5_dp*(stretch%pace%from + stretch%pace%to), links, error)
        if (allocated(error)) return
        do i = 1, maxval([0, links%ring])
            ring = pack(links, links%ring == i)
            last_link = size(ring)
            first = tracks_of(stretch, ring(1))
            last = tracks_of(stretch, ring(last_link))
            if (first(1) == 0 .or. last(2) == 0 .or. first(1) == last(2)) cycle
            if (.not. all(stretch%tracks([first(1), last(2)])%is_centred)) cycle
            stretch%slots = [stretch%slots, slot_type(track=[last(2), first(1)], &
                outward=body%sections(ring(1)%section)%outward* &
                merge(-1.0_dp, 1.0_dp, ring(1)%is_turned))]
        end do
    end subroutine add_walls

    !> The tracks that a link of a ring leads from and to; zero where its section is not of the
    !> stretch.
    pure function tracks_of(stretch, link) result(tracks)
        type(stretch_type), intent(in) :: stretch   !! any
        type(link_type), intent(in) :: link         !! of a ring
        integer :: tracks(2)
        integer :: i

        tracks = 0
        do i = 1, size(stretch%slots)
            if (stretch%slots(i)%number == link%section) tracks = stretch%slots(i)%track
        end do
        if (link%is_turned) tracks = tracks([2, 1])
    end function tracks_of

end module export_shell_stretch
