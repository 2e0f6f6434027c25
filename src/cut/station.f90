!> The cut of a body across STA: conic arcs, one of each section, in chains.
module cut_station
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_section, only: is_point, section_arc, trace_at, trace_type
    use cut_arc_spread, only: places_on
    use cut_chain, only: chain_type, chains_of, part_type
    use cut_clip, only: places_within
    use cut_outline, only: outline_type, piece_type
    use cut_point, only: turned_back
    use cut_point_row, only: points_on_arc
    use cut_request, only: request_type
    use geom_arc, only: arc_type, reversed
    use geom_place, only: is_finish, is_start, place_type
    use geom_subarc, only: part_of, place_of_part
    implicit none (type, external)
    private

    public :: station_outlines

    !> A piece and what part of its section's arc it is.
    type :: strand_type
        type(piece_type) :: piece   !! as the section runs
        type(arc_type) :: whole     !! the section's arc
        type(place_type) :: first   !! where on it the piece begins
        type(place_type) :: last    !! where it ends
    end type strand_type

    !> The places of the points of a piece.
    type :: spread_type
        type(place_type), allocatable :: places(:)  !! on the section's arc
    end type spread_type

contains

    !> The outlines of a station. Where the body ends in a point there, that point is the outline;
    !> sections without an arc are told by `body_gap`.
    !>
    !> Fails with the causes of `places_on`.
    pure subroutine station_outlines(body, request, tolerance, outlines, error)
        type(body_type), intent(in) :: body                             !! finished
        type(request_type), intent(in) :: request                       !! plane across STA
        real(dp), intent(in) :: tolerance                               !! of meeting ends
        type(outline_type), allocatable, intent(out) :: outlines(:)     !! in order of sections
        type(error_type), allocatable, intent(out) :: error             !! see above
        type(strand_type), allocatable :: strands(:)
        type(chain_type), allocatable :: chains(:)
        integer :: i

        allocate (strands(0), chains(0))
        strands = arcs_at(body, request)
        chains = chains_of(parts_of(strands), tolerance)
        allocate (outlines(size(chains)))
        do i = 1, size(chains)
            call assemble(body, request, strands, forward(chains(i)), outlines(i), error)
            if (allocated(error)) return
        end do
        if (size(strands) == 0) call add_point(body, request, outlines)
    end subroutine station_outlines

    !> Where every section at a station has shrunk to a point, adds the first such point as an
    !> outline without pieces. It has neither slope nor normal.
    pure subroutine add_point(body, request, outlines)
        type(body_type), intent(in) :: body                             !! finished
        type(request_type), intent(in) :: request                       !! plane across STA
        type(outline_type), allocatable, intent(inout) :: outlines(:)   !! gets it
        type(outline_type) :: outline
        type(trace_type) :: trace
        real(dp) :: sta
        integer :: i

        sta = request%plane%through(1)
        do i = 1, size(body%sections)
            associate (section => body%sections(i))
                if (sta < section%from .or. sta > section%to) cycle
                trace = trace_at(body%lines, section, sta)
            end associate
            if (.not. is_point(trace)) cycle
            allocate (outline%pieces(0), outline%points(1))
            outline%points(1)%section = i
            outline%points(1)%at = [sta, trace%start%point]
            outline%points(1)%uv = trace%start%point
            outlines = [outlines, outline]
            return
        end do
    end subroutine add_point

    !> The arcs of all sections at a station, as far as they are within the limits.
    pure function arcs_at(body, request) result(strands)
        type(body_type), intent(in) :: body         !! finished
        type(request_type), intent(in) :: request   !! plane and limits
        type(strand_type), allocatable :: strands(:)
        type(strand_type) :: strand
        type(arc_type) :: arc
        type(error_type), allocatable :: error
        type(place_type), allocatable :: ends(:)
        real(dp) :: sta
        integer :: i, k

        allocate (strands(0), ends(0))
        sta = request%plane%through(1)
        do i = 1, size(body%sections)
            associate (section => body%sections(i))
                if (sta < section%from .or. sta > section%to) cycle
                call section_arc(body%lines, section, sta, arc, error)
            end associate
            if (allocated(error)) cycle
            ends = places_within(arc, request%limit(2:))
            do k = 1, size(ends), 2
                strand = strand_type(whole=arc, first=ends(k), last=ends(k + 1))
                strand%piece = piece_type(i, .true., part_of(arc, ends(k), ends(k + 1)), sta, sta)
                strands = [strands, strand]
            end do
        end do
    end function arcs_at

    !> The ends of arcs.
    pure function parts_of(strands) result(parts)
        type(strand_type), intent(in) :: strands(:) !! of a station
        type(part_type) :: parts(size(strands))
        integer :: i
        do i = 1, size(strands)
            associate (piece => strands(i)%piece)
                parts(i)%ends(:, 1) = [piece%from, piece%arc%start]
                parts(i)%ends(:, 2) = [piece%from, piece%arc%finish]
            end associate
        end do
    end function parts_of

    !> A chain in the sense in which its first section, in the body's order, runs forward.
    pure type(chain_type) function forward(chain) result(turned)
        type(chain_type), intent(in) :: chain !! any
        turned = chain
        if (chain%part(minloc(abs(chain%part), dim=1)) < 0) &
            turned%part = -chain%part(size(chain%part):1:-1)
    end function forward

    !> The outline of a chain.
    pure subroutine assemble(body, request, strands, chain, outline, error)
        type(body_type), intent(in) :: body                     !! finished
        type(request_type), intent(in) :: request               !! plane and rule
        type(strand_type), intent(in) :: strands(:)             !! of the station
        type(chain_type), intent(in) :: chain                   !! some of them
        type(outline_type), intent(out) :: outline              !! see above
        type(error_type), allocatable, intent(out) :: error     !! of `places_on`
        type(spread_type) :: spread(size(chain%part))
        integer :: i, count

        outline%is_closed = chain%is_closed
        outline%pieces = strands(abs(chain%part))%piece
        count = 0
        do i = 1, size(chain%part)
            call spread_on(strands(abs(chain%part(i))), request, spread(i)%places, error)
            if (allocated(error)) return
            outline%pieces(i)%first = count + 1
            count = count + size(spread(i)%places)
            outline%pieces(i)%last = count
        end do
        allocate (outline%points(count))
        do i = 1, size(chain%part)
            associate (piece => outline%pieces(i), strand => strands(abs(chain%part(i))), &
                    points => outline%points(outline%pieces(i)%first:outline%pieces(i)%last))
                call points_on_arc(body, piece%section, strand%whole, spread(i)%places, request, &
                    points)
                points%piece = i
                if (chain%part(i) > 0) cycle
                points = turned_back(points(size(points):1:-1))
                piece%arc = reversed(piece%arc)
            end associate
        end do
    end subroutine assemble

    !> The places of the points of a piece on its section's arc, in the order of the section.
    pure subroutine spread_on(strand, request, places, error)
        type(strand_type), intent(in) :: strand                     !! of the station
        type(request_type), intent(in) :: request                   !! the rule
        type(place_type), allocatable, intent(out) :: places(:)     !! in order
        type(error_type), allocatable, intent(out) :: error         !! of `places_on`
        integer :: i

        call places_on(strand%piece%arc, request, places, error)
        if (allocated(error)) return
        if (is_start(strand%first) .and. is_finish(strand%last)) return
        do i = 1, size(places)
            places(i) = place_of_part(strand%whole, strand%first, strand%last, places(i))
        end do
    end subroutine spread_on

end module cut_station
