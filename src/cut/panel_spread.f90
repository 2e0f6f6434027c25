!> Where the points of a cut stand on a track of a panel, and which parts of tracks are within the
!> limits of a cut. Lengths are those of a polygon with four sides to each piece of the track.
module cut_panel_spread
    use base_constants, only: largest_table
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_list, only: list_type
    use base_order, only: ascending
    use base_text, only: compact, to_text
    use body_panel, only: panel_reach
    use cut_meeting, only: is_across
    use cut_panel_track, only: panel_track_type
    use cut_panel_walk, only: last_place, part_between, point_at, walk_type
    use cut_request, only: cut_rule, request_type
    use cut_spread, only: steps_inside
    implicit none (type, external)
    private

    public :: places_on, tracks_within

    !> Sides of the polygon that lengths are measured on, to each piece.
    integer, parameter :: finer = 4
    !> Halvings that find a place.
    integer, parameter :: halvings = 60
    !> Halvings of a track for chords.
    integer, parameter :: deepest = 40

contains

    !> The places of the points of a track, rising, both its ends included. A step that is an end,
    !> as near as edges are to sides, is that end.
    !>
    !> Fails with `cause%too_many` where there are more than `largest_table`.
    pure subroutine places_on(walk, request, places, error)
        type(walk_type), intent(in) :: walk                 !! the track
        type(request_type), intent(in) :: request           !! the rule
        real(dp), allocatable, intent(out) :: places(:)     !! 0 to `last_place`
        type(error_type), allocatable, intent(out) :: error !! see above
        type(request_type), parameter :: usual = request_type()
        type(list_type) :: found
        real(dp), allocatable :: levels(:), s(:), length(:)
        real(dp) :: range(2)
        integer :: parts, i

        allocate (places(0), s(0), levels(0))
        call measure(walk, s, length)
        associate (total => length(size(length)))
            select case (request%rule)
            case (cut_rule%step)
                parts = usual%number - 1
                if (.not. (is_across(request%plane) .and. request%axis == 1)) then
                    associate (x => walk%track%at(request%axis, :), &
                        reach => panel_reach(walk%panel))
                        range = [minval(x) + reach, maxval(x) - reach]
                    end associate
                    if (range(1) < range(2)) call steps_inside(request%grid, range, levels, error)
                    if (allocated(error)) return
                    do i = 1, size(levels)
                        call found%add(crossings(walk, request%axis, levels(i)))
                    end do
                    places = [0.0_dp, ascending(found%all()), last_place(walk)]
                    return
                end if
            case (cut_rule%chord)
                call within_chords(walk, request%step, places, error)
                return
            case (cut_rule%length)
                if (total/request%step > largest_table) then
                    call fail(error, cause%too_many, 'lengths of '//compact(request%step)// &
                        ' divide an outline of '//compact(total)//' into too many; LOFT makes '// &
                        'at most '//to_text(largest_table)//' points: take longer ones')
                    return
                end if
                parts = max(1, nint(total/request%step))
            case default
                parts = max(1, request%number - 1)
            end select
            places = [0.0_dp, (place_of(s, length, total*real(i, dp)/real(parts, dp)), &
                i = 1, parts - 1), last_place(walk)]
        end associate
    end subroutine places_on

    !> The lengths at the corners of the polygon.
    pure subroutine measure(walk, s, length)
        type(walk_type), intent(in) :: walk                 !! the track
        real(dp), allocatable, intent(inout) :: s(:)        !! places of its corners
        real(dp), allocatable, intent(out) :: length(:)     !! from the start, deck units
        real(dp) :: before(3), at(3)
        integer :: i

        s = [(real(i, dp)/real(finer, dp), i = 0, finer*nint(last_place(walk)))]
        allocate (length(size(s)))
        length(1) = 0.0_dp
        before = point_at(walk, 0.0_dp)
        do i = 2, size(s)
            at = point_at(walk, s(i))
            length(i) = length(i - 1) + norm2(at - before)
            before = at
        end do
    end subroutine measure

    !> The place at a length.
    pure real(dp) function place_of(s, length, wanted) result(place)
        real(dp), intent(in) :: s(:)        !! places
        real(dp), intent(in) :: length(:)   !! lengths there, rising
        real(dp), intent(in) :: wanted      !! deck units
        integer :: i
        i = min(max(count(length <= wanted), 1), size(s) - 1)
        place = s(i) + (s(i + 1) - s(i))*(wanted - length(i)) &
            /max(length(i + 1) - length(i), tiny(1.0_dp))
    end function place_of

    !> The places inside where an ordinate has a value: where it passes it from point to point.
    pure function crossings(walk, axis, level) result(places)
        type(walk_type), intent(in) :: walk     !! the track
        integer, intent(in) :: axis             !! 1 STA, 2 BL, 3 WL
        real(dp), intent(in) :: level           !! deck units
        real(dp), allocatable :: places(:)
        real(dp) :: ends(2), middle, at(3), first
        integer :: i, k

        allocate (places(0))
        do i = 1, nint(last_place(walk))
            first = walk%track%at(axis, i) - level
            if (.not. first*(walk%track%at(axis, i + 1) - level) < 0.0_dp) then
                if (i > 1 .and. abs(first) <= 0.0_dp) places = [places, real(i - 1, dp)]
                cycle
            end if
            ends = [real(i - 1, dp), real(i, dp)]
            do k = 1, halvings
                middle = 0.5_dp*sum(ends)
                at = point_at(walk, middle)
                ends(merge(1, 2, (at(axis) - level)*first > 0.0_dp)) = middle
            end do
            places = [places, 0.5_dp*sum(ends)]
        end do
    end function crossings

    !> The places such that no chord is further than a tolerance from the track: what is ahead is
    !> halved until its chord is near enough. Fails with `cause%too_many`.
    pure subroutine within_chords(walk, tolerance, places, error)
        type(walk_type), intent(in) :: walk                     !! the track
        real(dp), intent(in) :: tolerance                       !! deck units, above zero
        real(dp), allocatable, intent(inout) :: places(:)       !! ends included
        type(error_type), allocatable, intent(out) :: error     !! see above
        type(list_type) :: found
        real(dp) :: ahead(deepest)
        integer :: left

        call found%add(0.0_dp)
        ahead(:2) = [1.0_dp, 0.5_dp]*last_place(walk)
        left = 2
        do while (left > 0)
            if (left < deepest .and. .not. is_flat(found%item(found%count), ahead(left))) then
                ahead(left + 1) = 0.5_dp*(found%item(found%count) + ahead(left))
                left = left + 1
                cycle
            end if
            call found%add(ahead(left))
            left = left - 1
            if (found%count <= largest_table) cycle
            call fail(error, cause%too_many, 'chords within '//compact(tolerance)// &
                ' of an outline are too many; LOFT makes at most '//to_text(largest_table)// &
                ' points: take a larger tolerance')
            return
        end do
        places = found%all()
    contains
        !> True where the quarters of a stretch are as near to its chord as asked.
        pure logical function is_flat(from, to)
            real(dp), intent(in) :: from    !! place
            real(dp), intent(in) :: to      !! place
            real(dp) :: start(3), off(3), chord(3), span
            integer :: quarter
            start = point_at(walk, from)
            chord = point_at(walk, to) - start
            span = max(dot_product(chord, chord), tiny(1.0_dp))
            is_flat = .true.
            do quarter = 1, 3
                off = point_at(walk, from + 0.25_dp*real(quarter, dp)*(to - from)) - start
                off = off - dot_product(off, chord)/span*chord
                is_flat = is_flat .and. norm2(off) <= tolerance
            end do
        end function is_flat
    end subroutine within_chords

    !> The parts of a track within the limits of a cut.
    pure subroutine tracks_within(walk, request, parts)
        type(walk_type), intent(in) :: walk                             !! the track
        type(request_type), intent(in) :: request                       !! its limits
        type(panel_track_type), allocatable, intent(out) :: parts(:)    !! in order
        real(dp), allocatable :: stops(:), ends(:, :)
        real(dp) :: last
        integer :: axis, i, count_of

        last = last_place(walk)
        allocate (stops(0), parts(0))
        do axis = 1, 3
            associate (limit => request%limit(axis))
                if (limit%has_from) stops = [stops, crossings(walk, axis, limit%from)]
                if (limit%has_to) stops = [stops, crossings(walk, axis, limit%to)]
            end associate
        end do
        stops = [0.0_dp, ascending(stops), last]
        allocate (ends(2, size(stops)))
        count_of = 0
        do i = 1, size(stops) - 1
            if (.not. stops(i + 1) > stops(i)) cycle
            if (.not. is_within(0.5_dp*(stops(i) + stops(i + 1)))) cycle
            if (count_of > 0) then
                if (ends(2, count_of) >= stops(i)) then
                    ends(2, count_of) = stops(i + 1)
                    cycle
                end if
            end if
            count_of = count_of + 1
            ends(:, count_of) = stops(i:i + 1)
        end do
        if (count_of == 1 .and. all(abs(ends(:, 1) - [0.0_dp, last]) <= 0.0_dp)) then
            parts = [walk%track]
            return
        end if
        if (walk%track%is_closed .and. count_of > 1) then
            if (ends(1, 1) <= 0.0_dp .and. ends(2, count_of) >= last) then
                ends(1, 1) = ends(1, count_of)
                ends(2, 1) = last + ends(2, 1)
                count_of = count_of - 1
            end if
        end if
        do i = 1, count_of
            parts = [parts, part_between(walk, ends(1, i), ends(2, i))]
        end do
    contains
        !> True for a place within all limits.
        pure logical function is_within(s)
            real(dp), intent(in) :: s !! the place
            real(dp) :: at(3)
            at = point_at(walk, s)
            is_within = .not. (any(request%limit%has_from .and. at < request%limit%from) .or. &
                any(request%limit%has_to .and. at > request%limit%to))
        end function is_within
    end subroutine tracks_within

end module cut_panel_spread
