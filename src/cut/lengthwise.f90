!> The cut of a body by a plane that is not across STA: tracks on sections, in chains.
module cut_lengthwise
    use base_error, only: error_type
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_tolerances, only: meeting_tolerance
    use body_body, only: body_type
    use cut_chain, only: chain_type, chains_of, part_type
    use cut_clip, only: clipped
    use cut_event, only: happening
    use cut_outline, only: cut_point_type, outline_type, piece_type
    use cut_request, only: request_type
    use cut_strand, only: close_at, join, points_said, say_points, spread_on, strand_type
    use cut_track, only: track_type, tracks_on
    use cut_walk, only: point_at
    implicit none (type, external)
    private

    public :: lengthwise_outlines

contains

    !> The outlines of a plane. Fails with the causes of `stations_on`.
    pure subroutine lengthwise_outlines(body, request, outlines, error)
        type(body_type), intent(in) :: body                             !! finished
        type(request_type), intent(in) :: request                       !! plane not across STA
        type(outline_type), allocatable, intent(out) :: outlines(:)     !! foremost first
        type(error_type), allocatable, intent(out) :: error             !! see above
        type(track_type), allocatable :: tracks(:)
        type(part_type), allocatable :: parts(:)
        type(chain_type), allocatable :: chains(:)
        real(dp) :: tolerance
        integer :: i

        allocate (tracks(0), parts(0), chains(0))
        tracks = clipped(body, request, all_tracks(body, request))
        parts = parts_of(body, request, tracks)
        tolerance = meeting_tolerance*largest(parts)
        chains = chains_of(parts, tolerance)
        allocate (outlines(size(chains)))
        do i = 1, size(chains)
            call assemble(body, request, tracks, from_foremost(chains(i), parts), outlines(i), &
                error)
            if (allocated(error)) return
        end do
    end subroutine lengthwise_outlines

    !> The largest coordinate of any end.
    pure real(dp) function largest(parts)
        type(part_type), intent(in) :: parts(:) !! any
        integer :: i
        largest = 0.0_dp
        do i = 1, size(parts)
            largest = max(largest, maxval(abs(parts(i)%ends)))
        end do
    end function largest

    !> The tracks on all sections; of two that run along the line on which two sections meet, one.
    pure function all_tracks(body, request) result(tracks)
        type(body_type), intent(in) :: body         !! finished
        type(request_type), intent(in) :: request   !! plane not across STA
        type(track_type), allocatable :: tracks(:), more(:)
        real(dp) :: limit(2)
        integer :: i, j

        allocate (tracks(0), more(0))
        limit = [-huge(1.0_dp), huge(1.0_dp)]
        if (request%limit(1)%has_from) limit(1) = request%limit(1)%from
        if (request%limit(1)%has_to) limit(2) = request%limit(1)%to
        do i = 1, size(body%sections)
            more = tracks_on(body, i, request%plane, limit)
            do j = 1, size(more)
                if (.not. is_repeated(body, tracks, more(j))) tracks = [tracks, more(j)]
            end do
        end do
    end function all_tracks

    !> True for a track along an edge that a track of another section runs along, too.
    pure logical function is_repeated(body, tracks, track)
        type(body_type), intent(in) :: body             !! finished
        type(track_type), intent(in) :: tracks(:)       !! of other sections
        type(track_type), intent(in) :: track           !! perhaps the same as one of them
        integer :: i, line

        is_repeated = .false.
        line = edge_line(body, track)
        if (line == 0) return
        do i = 1, size(tracks)
            if (edge_line(body, tracks(i)) /= line) cycle
            if (.not. shares_side(body, tracks(i), track)) cycle
            is_repeated = is_repeated .or. (tracks(i)%from%sta <= track%from%sta &
                .and. tracks(i)%to%sta >= track%to%sta)
        end do
    end function is_repeated

    !> The line along which a track runs, or 0: the edge that lies in the plane. (Of a section both
    !> of whose edges do, each branch runs along the one where its height begins or ends.)
    pure integer function edge_line(body, track) result(line)
        type(body_type), intent(in) :: body     !! finished
        type(track_type), intent(in) :: track   !! any
        line = 0
        associate (section => body%sections(track%section))
            if (track%edge > 0) line = section%line(2*track%edge - 1)
        end associate
    end function edge_line

    !> True for tracks of one side of the body, or on BL 0.
    pure logical function shares_side(body, first, second)
        type(body_type), intent(in) :: body     !! finished
        type(track_type), intent(in) :: first   !! a track
        type(track_type), intent(in) :: second  !! another
        shares_side = (body%sections(first%section)%is_port &
            .eqv. body%sections(second%section)%is_port) &
            .or. .not. body%lines(edge_line(body, first))%has_plan
    end function shares_side

    !> The ends of tracks. Those that turn back into another of the same section are a group.
    pure function parts_of(body, request, tracks) result(parts)
        type(body_type), intent(in) :: body         !! finished
        type(request_type), intent(in) :: request   !! the plane
        type(track_type), intent(in) :: tracks(:)   !! of both
        type(part_type) :: parts(size(tracks))
        integer :: i

        do i = 1, size(tracks)
            associate (track => tracks(i))
                parts(i)%ends(:, 1) = point_at(body, request%plane, track, track%from%sta)
                parts(i)%ends(:, 2) = point_at(body, request%plane, track, track%to%sta)
                if (track%from%kind == happening%turn) parts(i)%group(1) = track%section
                if (track%to%kind == happening%turn) parts(i)%group(2) = track%section
            end associate
        end do
    end function parts_of

    !> An open chain from its foremost end; a closed one from its foremost joint.
    pure type(chain_type) function from_foremost(chain, parts) result(turned)
        type(chain_type), intent(in) :: chain   !! any
        type(part_type), intent(in) :: parts(:) !! its parts
        integer :: i, best, count

        turned = chain
        count = size(chain%part)
        if (chain%is_closed) then
            best = 1
            do i = 2, count
                if (is_before(beginning(chain%part(i)), beginning(chain%part(best)))) best = i
            end do
            turned%part = cshift(chain%part, best - 1)
        else if (is_before(beginning(-chain%part(count)), beginning(chain%part(1)))) then
            turned%part = -chain%part(count:1:-1)
        end if
    contains
        !> Where a part begins, as it is run through.
        pure function beginning(part) result(at)
            integer, intent(in) :: part !! negative: backwards
            real(dp) :: at(3)
            at = parts(abs(part))%ends(:, merge(1, 2, part > 0))
        end function beginning
    end function from_foremost

    !> True where a point is forward of another; of two at one station, nearer to BL 0 or lower.
    pure logical function is_before(first, second)
        real(dp), intent(in) :: first(3)    !! STA, BL, WL
        real(dp), intent(in) :: second(3)   !! STA, BL, WL
        integer :: axis
        is_before = .false.
        do axis = 1, 3
            if (is_equal(first(axis), second(axis))) cycle
            is_before = first(axis) < second(axis)
            return
        end do
    end function is_before

    !> The outline of a chain; a closed one counter-clockwise in its view.
    pure subroutine assemble(body, request, tracks, chain, outline, error)
        type(body_type), intent(in) :: body                     !! finished
        type(request_type), intent(in) :: request               !! plane and rule
        type(track_type), intent(in) :: tracks(:)               !! of both
        type(chain_type), intent(in) :: chain                   !! some of them
        type(outline_type), intent(out) :: outline              !! see above
        type(error_type), allocatable, intent(out) :: error     !! of `stations_on`
        type(chain_type) :: turned

        call run_through(body, request, tracks, chain, outline, error)
        if (allocated(error) .or. .not. chain%is_closed) return
        if (enclosed_area(outline%points) >= 0.0_dp) return
        turned = chain
        turned%part = -chain%part(size(chain%part):1:-1)
        call run_through(body, request, tracks, turned, outline, error)
    end subroutine assemble

    !> Twice the area of the polygon of some points, positive where it is counter-clockwise.
    pure real(dp) function enclosed_area(points) result(area)
        type(cut_point_type), intent(in) :: points(:) !! of a closed outline
        real(dp) :: u(size(points)), v(size(points))
        u = points%uv(1) - points(1)%uv(1)
        v = points%uv(2) - points(1)%uv(2)
        area = sum(u*cshift(v, 1) - v*cshift(u, 1))
    end function enclosed_area

    !> The pieces and points of a chain in its order. A point at which a piece turns back into the
    !> next, on the same section, is said once, by the first of the two.
    pure subroutine run_through(body, request, tracks, chain, outline, error)
        type(body_type), intent(in) :: body                     !! finished
        type(request_type), intent(in) :: request               !! plane and rule
        type(track_type), intent(in) :: tracks(:)               !! of both
        type(chain_type), intent(in) :: chain                   !! some of them
        type(outline_type), intent(out) :: outline              !! see above
        type(error_type), allocatable, intent(out) :: error     !! of `stations_on`
        type(strand_type) :: strands(size(chain%part))
        integer :: i, count

        do i = 1, size(strands)
            call spread_on(body, request, tracks(abs(chain%part(i))), chain%part(i) > 0, &
                strands(i), error)
            if (allocated(error)) return
        end do
        do i = 2, size(strands)
            call join(strands(i - 1), strands(i))
        end do
        if (chain%is_closed .and. size(strands) > 1) &
            call close_at(strands(size(strands)), strands(1))
        outline%is_closed = chain%is_closed
        allocate (outline%pieces(size(strands)))
        count = 0
        do i = 1, size(strands)
            associate (piece => outline%pieces(i))
                piece = piece_of(tracks(abs(chain%part(i))), chain%part(i) > 0)
                piece%first = count + 1
                count = count + points_said(strands(i))
                piece%last = count
            end associate
        end do
        allocate (outline%points(count))
        do i = 1, size(strands)
            associate (piece => outline%pieces(i))
                call say_points(body, request, tracks(abs(chain%part(i))), strands(i), &
                    outline%points(piece%first:piece%last))
                outline%points(piece%first:piece%last)%piece = i
            end associate
        end do
    end subroutine run_through

    !> A track as a piece.
    pure type(piece_type) function piece_of(track, is_aft) result(piece)
        type(track_type), intent(in) :: track   !! any
        logical, intent(in) :: is_aft           !! the outline goes aft on it
        piece%section = track%section
        piece%branch = track%branch
        piece%from = merge(track%from%sta, track%to%sta, is_aft)
        piece%to = merge(track%to%sta, track%from%sta, is_aft)
    end function piece_of

end module cut_lengthwise
