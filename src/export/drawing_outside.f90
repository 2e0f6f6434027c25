!> The pieces of the outline of a cut as smooth paths: each arc of a station, and each stretch of a
!> track between two stations where lines of its section join.
module export_drawing_outside
    use base_constants, only: pi
    use base_kinds, only: dp
    use base_tolerances, only: agreement_ulps, ulp
    use body_body, only: body_type, smooth_stops
    use body_section, only: section_arc
    use body_skin, only: skin_type
    use base_error, only: error_type
    use cut_event, only: event_type, happening
    use cut_outline, only: outline_type, piece_type
    use cut_plane, only: in_view, plane_type, true_shape
    use cut_point, only: left_of, tangent_of
    use cut_track, only: track_type, tracks_on
    use cut_walk, only: point_at, skin_on
    use export_drawing_path, only: paced, pace_of, path_type
    use geom_arc, only: arc_type
    use geom_arc_point, only: curvature, point, tangent
    use geom_place, only: at_shoulder, place_at
    implicit none (type, external)
    private

    public :: outside_type, way_round_type, way_round

    !> A smooth stretch of an outline, in u and v.
    type, extends(path_type) :: outside_type
        integer :: section = 0              !! in the list of the whole body
        character(:), allocatable :: name   !! of the section
        real(dp) :: side = 0.0_dp           !! the skin's outside is to the left (1), right (-1)
        logical :: is_arc = .false.         !! of a station: `arc` is it
        type(arc_type) :: arc               !! x is BL, y is WL; runs as the outline does
        type(body_type), allocatable :: body !! finished, both halves; where no arc
        type(plane_type) :: plane           !! not across STA; where no arc
        type(track_type) :: track           !! of that body and plane
        real(dp) :: ends(2) = 0.0_dp        !! stations where it begins and ends, deck units
        real(dp) :: near(2) = 0.0_dp        !! the same, or just inside of a joint of lines
        real(dp) :: pace(2) = 1.0_dp        !! of the station at these ends
    contains
        procedure :: at => outside_at
        procedure :: way => outside_way
    end type outside_type

    !> The paths of a piece.
    type :: pack_type
        type(outside_type), allocatable :: path(:)  !! in order
    end type pack_type

    !> All of an outline.
    type :: way_round_type
        type(outside_type), allocatable :: path(:)  !! in order
        logical :: is_closed = .false.              !! the last ends where the first begins
        logical :: is_half = .false.                !! its mirror image belongs to the shape
        real(dp) :: noise = 0.0_dp                  !! distance that is but rounding, deck units
    end type way_round_type

    !> Chords of which the length of a stretch is summed up.
    integer, parameter :: chords = 16

contains

    !> The smooth paths of an outline.
    pure subroutine way_round(whole, plane, outline, round)
        type(body_type), intent(in) :: whole            !! finished, both halves
        type(plane_type), intent(in) :: plane           !! of the cut
        type(outline_type), intent(in) :: outline       !! one of it
        type(way_round_type), intent(out) :: round      !! of as many paths as it has, or none
        type(outside_type), allocatable :: path(:)
        type(pack_type) :: pack(size(outline%pieces))
        integer :: i, count

        round%is_closed = outline%is_closed
        count = 0
        do i = 1, size(outline%points)
            round%noise = max(round%noise, agreement_ulps*ulp*maxval(abs(outline%points(i)%at)))
        end do
        do i = 1, size(outline%pieces)
            call paths_of(whole, plane, outline%pieces(i), pack(i)%path)
            count = count + size(pack(i)%path)
        end do
        allocate (path(count))
        count = 0
        do i = 1, size(outline%pieces)
            path(count + 1:count + size(pack(i)%path)) = pack(i)%path
            count = count + size(pack(i)%path)
        end do
        call move_alloc(path, round%path)
    end subroutine way_round

    !> The smooth paths of a piece, in its order.
    pure subroutine paths_of(whole, plane, piece, paths)
        type(body_type), intent(in) :: whole                        !! finished, both halves
        type(plane_type), intent(in) :: plane                       !! of the cut
        type(piece_type), intent(in) :: piece                       !! of an outline of it
        type(outside_type), allocatable, intent(out) :: paths(:)    !! see above
        real(dp), allocatable :: stops(:)
        type(track_type) :: track
        integer :: section, i, k, count

        section = piece%section
        if (piece%is_image) section = section + size(whole%sections)/2
        if (piece%is_arc) then
            allocate (paths(1))
            paths(1)%section = section
            paths(1)%name = trim(whole%sections(section)%name)
            paths(1)%is_arc = .true.
            paths(1)%arc = shifted(piece%arc, plane%origin(2:))
            paths(1)%side = arc_side(whole, section, piece)
            return
        end if
        track = track_of(whole, plane, section, piece)
        allocate (stops(0))
        stops = smooth_stops(whole, whole%sections(section))
        stops = [min(piece%from, piece%to), &
            pack(stops, (stops - piece%from)*(stops - piece%to) < 0.0_dp), &
            max(piece%from, piece%to)]
        count = size(stops) - 1
        allocate (paths(count))
        do i = 1, count
            k = merge(i, count + 1 - i, piece%to > piece%from)
            paths(k)%section = section
            paths(k)%name = trim(whole%sections(section)%name)
            paths(k)%body = whole
            paths(k)%plane = plane
            paths(k)%track = track
            paths(k)%ends = stops(i:i + 1)
            paths(k)%near = stops(i:i + 1)
            if (i < count) paths(k)%near(2) = nearest(stops(i + 1), -1.0_dp)
            if (piece%to < piece%from) then
                paths(k)%ends = paths(k)%ends([2, 1])
                paths(k)%near = paths(k)%near([2, 1])
            end if
            call settle(paths(k))
        end do
    end subroutine paths_of

    !> An arc, moved: BL and WL in a plane whose origin is elsewhere.
    pure type(arc_type) function shifted(arc, back) result(moved)
        type(arc_type), intent(in) :: arc   !! any
        real(dp), intent(in) :: back(2)     !! what to take off, deck units
        moved = arc
        moved%start = arc%start - back
        moved%finish = arc%finish - back
    end function shifted

    !> The side of an arc of a station on which the outside is.
    pure real(dp) function arc_side(whole, section, piece) result(side)
        type(body_type), intent(in) :: whole    !! finished, both halves
        integer, intent(in) :: section          !! which of its sections
        type(piece_type), intent(in) :: piece   !! all or a part of its arc, either way
        type(arc_type) :: arc
        type(error_type), allocatable :: error
        real(dp) :: turn

        side = -whole%sections(section)%outward
        call section_arc(whole%lines, whole%sections(section), piece%from, arc, error)
        if (allocated(error)) return
        if (arc%is_line .or. piece%arc%is_line) then
            turn = dot_product(arc%finish - arc%start, piece%arc%finish - piece%arc%start)
        else
            turn = curvature(arc, at_shoulder)*curvature(piece%arc, at_shoulder)
        end if
        if (turn < 0.0_dp) side = -side
    end function arc_side

    !> The track of a piece: what happens at its ends is found again.
    pure type(track_type) function track_of(whole, plane, section, piece) result(track)
        type(body_type), intent(in) :: whole    !! finished, both halves
        type(plane_type), intent(in) :: plane   !! not across STA
        integer, intent(in) :: section          !! which of its sections
        type(piece_type), intent(in) :: piece   !! of an outline of the plane
        type(track_type), allocatable :: tracks(:)
        real(dp), allocatable :: stops(:)
        real(dp) :: from, to, noise
        integer :: i

        from = min(piece%from, piece%to)
        to = max(piece%from, piece%to)
        noise = agreement_ulps*ulp*max(abs(from), abs(to))
        allocate (stops(0), tracks(0))
        stops = smooth_stops(whole, whole%sections(section))
        tracks = tracks_on(whole, section, plane, &
            [maxval(stops, mask=stops <= from), minval(stops, mask=stops >= to)])
        track = track_type(section, piece%branch, event_type(from), event_type(to))
        do i = 1, size(tracks)
            if (tracks(i)%branch /= piece%branch) cycle
            if (tracks(i)%from%sta > from + noise .or. tracks(i)%to%sta < to - noise) cycle
            track = tracks(i)
            if (track%from%sta < from - noise) track%from%kind = happening%nothing
            if (track%to%sta > to + noise) track%to%kind = happening%nothing
            track%from%sta = from
            track%to%sta = to
        end do
    end function track_of

    !> Finds how a path runs along STA, and where its outside is.
    pure subroutine settle(path)
        type(outside_type), intent(inout) :: path !! of a track, with its ends
        type(skin_type) :: skin
        real(dp) :: length, before(3), next(3), slant(2), noise, middle
        integer :: i

        associate (a => path%ends(1), b => path%ends(2))
            before = at_station(path, a)
            noise = agreement_ulps*ulp*maxval(abs(before))
            do i = 1, 2
                if (norm2(at_station(path, path%near(i)) - at_station(path, path%ends(i))) > &
                    noise) path%ends(i) = path%near(i)
            end do
            before = at_station(path, a)
            length = 0.0_dp
            do i = 1, chords
                next = at_station(path, a + (b - a)*sin(0.5_dp*pi*real(i, dp)/real(chords, dp))**2)
                length = length + norm2(next - before)
                before = next
            end do
            do i = 1, 2
                slant(i) = slant_at(path, path%near(i))
            end do
            path%pace = pace_of(slant, length, b - a)
            middle = 0.5_dp*(a + b)
            skin = skin_on(path%body, path%plane, path%track, middle)
            path%side = sign(1.0_dp, dot_product(skin%normal, &
                left_of(path%plane, space_way(path, middle))))
        end associate
    end subroutine settle

    !> The part of the unit direction along STA; where there is no direction that of the mean.
    pure real(dp) function slant_at(path, sta) result(slant)
        type(outside_type), intent(in) :: path  !! of a track
        real(dp), intent(in) :: sta             !! deck units
        real(dp) :: way(3)

        way = space_way(path, sta)
        slant = way(1)
        if (norm2(way) > 0.0_dp) return
        way = at_station(path, path%ends(2)) - at_station(path, path%ends(1))
        slant = (path%ends(2) - path%ends(1))/norm2(way)
    end function slant_at

    !> The point of a path of a track at a station, in u and v.
    pure function at_station(path, sta) result(at)
        type(outside_type), intent(in) :: path  !! of a track
        real(dp), intent(in) :: sta             !! deck units
        real(dp) :: at(3)
        at = [true_shape(path%plane, point_at(path%body, path%plane, path%track, sta)), 0.0_dp]
    end function at_station

    !> The unit direction of a path of a track at a station, in space; zero where there is none.
    !> Where the track turns back it is across STA.
    pure function space_way(path, sta) result(way)
        type(outside_type), intent(in) :: path  !! of a track
        real(dp), intent(in) :: sta             !! deck units
        real(dp) :: way(3)
        type(skin_type) :: skin

        skin = skin_on(path%body, path%plane, path%track, sta)
        way = tangent_of(skin%normal, path%plane, path%track, &
            path%body%sections(path%section)%outward)
        if (path%ends(2) < path%ends(1)) way = -way
        if ((path%track%from%kind == happening%turn .and. .not. sta > path%track%from%sta) .or. &
            (path%track%to%kind == happening%turn .and. .not. sta < path%track%to%sta)) &
            way(1) = 0.0_dp
    end function space_way

    !> The point of a path.
    pure function outside_at(f, t) result(point_of)
        class(outside_type), intent(in) :: f    !! the path
        real(dp), intent(in) :: t               !! 0 to 1
        real(dp) :: point_of(3)

        if (f%is_arc) then
            point_of = [point(f%arc, place_at(t)), 0.0_dp]
        else
            point_of = at_station(f, paced(f%ends(1), f%ends(2), f%pace, t))
        end if
    end function outside_at

    !> The direction of a path.
    pure function outside_way(f, t) result(way)
        class(outside_type), intent(in) :: f    !! the path
        real(dp), intent(in) :: t               !! 0 to 1
        real(dp) :: way(3), sta

        if (f%is_arc) then
            way = [tangent(f%arc, place_at(t)), 0.0_dp]
        else
            sta = paced(f%ends(1), f%ends(2), f%pace, t)
            sta = min(max(sta, minval(f%near)), maxval(f%near))
            way = [in_view(f%plane, space_way(f, sta)), 0.0_dp]
        end if
    end function outside_way

end module export_drawing_outside
