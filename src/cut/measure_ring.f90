!> How the sections of a body join at a station: rings, each a chain of section arcs end to end. A
!> ring encloses an area where it comes back to its start, or where both its ends are at BL 0 and
!> the deck says CLOSE.
module cut_measure_ring
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_text, only: compact
    use base_tolerances, only: outline_gap
    use body_body, only: body_type
    use body_section, only: is_point, section_arc, trace_at
    use geom_arc, only: arc_type, reversed
    implicit none (type, external)
    private

    public :: link_type, rings_at, find_opening, sections_at

    !> One section of a station with its place in a ring.
    type :: link_type
        integer :: section = 0          !! place in the body's list of sections
        integer :: ring = 0             !! number of its ring, from 1
        type(arc_type) :: arc           !! the arc, run through as the ring is
        logical :: is_turned = .false.  !! the ring runs against the section's own way
    end type link_type

contains

    !> The sections of a body that are there at a station.
    pure function sections_at(body, sta) result(chosen)
        type(body_type), intent(in) :: body !! finished
        real(dp), intent(in) :: sta         !! deck units
        integer, allocatable :: chosen(:)
        integer :: i
        chosen = pack([(i, i=1, size(body%sections))], &
            body%sections%from <= sta .and. body%sections%to >= sta)
    end function sections_at

    !> The rings of a station: links in order, ring by ring. A section that has shrunk to a point is
    !> left out. Fails with the causes of `section_arc` where a section has no arc.
    pure subroutine rings_at(body, sta, links, error)
        type(body_type), intent(in) :: body                     !! finished
        real(dp), intent(in) :: sta                             !! deck units
        type(link_type), allocatable, intent(out) :: links(:)   !! in order, ring by ring
        type(error_type), allocatable, intent(out) :: error     !! see above
        type(link_type), allocatable :: rest(:), ring(:)
        integer :: number

        call links_at(body, sta, rest, error)
        allocate (links(0))
        if (allocated(error)) return
        number = 0
        do while (size(rest) > 0)
            number = number + 1
            call take_ring(rest, ring)
            ring%ring = number
            links = [links, ring]
        end do
    end subroutine rings_at

    !> The arcs of a station, joined to nothing yet.
    pure subroutine links_at(body, sta, links, error)
        type(body_type), intent(in) :: body                     !! finished
        real(dp), intent(in) :: sta                             !! deck units
        type(link_type), allocatable, intent(out) :: links(:)   !! in the body's order
        type(error_type), allocatable, intent(out) :: error     !! see `rings_at`
        integer, allocatable :: chosen(:)
        type(link_type) :: link
        integer :: i

        allocate (links(0), chosen(0))
        chosen = sections_at(body, sta)
        do i = 1, size(chosen)
            link%section = chosen(i)
            associate (section => body%sections(chosen(i)))
                if (is_point(trace_at(body%lines, section, sta))) cycle
                call section_arc(body%lines, section, sta, link%arc, error)
            end associate
            if (allocated(error)) return
            links = [links, link]
        end do
    end subroutine links_at

    !> Takes the ring of the first arc out of a list: goes on at its end as long as an arc meets it
    !> there, then at its start.
    pure subroutine take_ring(rest, ring)
        type(link_type), allocatable, intent(inout) :: rest(:)  !! not empty
        type(link_type), allocatable, intent(out) :: ring(:)    !! in order
        type(link_type) :: next
        logical :: was_met

        ring = rest(:1)
        rest = rest(2:)
        was_met = .true.
        do while (was_met .and. .not. meet(ring(size(ring))%arc%finish, ring(1)%arc%start, ring))
            call take_next(rest, ring(size(ring))%arc%finish, ring, next, was_met)
            if (was_met) ring = [ring, next]
        end do
        if (was_met) return
        was_met = .true.
        do while (was_met)
            call take_next(rest, ring(1)%arc%start, ring, next, was_met)
            if (was_met) ring = [turned(next), ring]
        end do
    end subroutine take_ring

    !> Takes an arc that meets a point out of a list, pointed away from it.
    pure subroutine take_next(rest, point, ring, next, was_met)
        type(link_type), allocatable, intent(inout) :: rest(:)  !! arcs of no ring yet
        real(dp), intent(in) :: point(2)                        !! an end of the ring, deck units
        type(link_type), intent(in) :: ring(:)                  !! the ring, for its size
        type(link_type), intent(out) :: next                    !! the arc
        logical, intent(out) :: was_met                         !! there is one
        integer :: i

        was_met = .true.
        do i = 1, size(rest)
            next = rest(i)
            if (.not. meet(next%arc%start, point, ring)) next = turned(next)
            if (.not. meet(next%arc%start, point, ring)) cycle
            rest = [rest(:i - 1), rest(i + 1:)]
            return
        end do
        was_met = .false.
    end subroutine take_next

    !> A link run through the other way.
    pure type(link_type) function turned(link)
        type(link_type), intent(in) :: link !! any
        turned = link
        turned%arc = reversed(link%arc)
        turned%is_turned = .not. link%is_turned
    end function turned

    !> True where two points are one, within `outline_gap` of the longest chord of a ring.
    pure logical function meet(first, second, ring)
        real(dp), intent(in) :: first(2)        !! deck units
        real(dp), intent(in) :: second(2)       !! deck units
        type(link_type), intent(in) :: ring(:)  !! not empty
        meet = norm2(second - first) <= outline_gap*extent(ring)
    end function meet

    !> The longest chord of some arcs, deck units.
    pure real(dp) function extent(ring)
        type(link_type), intent(in) :: ring(:) !! any
        integer :: i
        extent = 0.0_dp
        do i = 1, size(ring)
            extent = max(extent, norm2(ring(i)%arc%finish - ring(i)%arc%start))
        end do
    end function extent

    !> Why the rings of a station enclose no area, in words; empty where they all do.
    pure subroutine find_opening(body, links, why)
        type(body_type), intent(in) :: body             !! finished
        type(link_type), intent(in) :: links(:)         !! of `rings_at`
        character(:), allocatable, intent(out) :: why   !! empty: all are closed
        integer :: i

        why = ''
        do i = 1, maxval([0, links%ring])
            if (len(why) == 0) call open_ring(body, pack(links, links%ring == i), why)
        end do
    end subroutine find_opening

    !> Why a ring encloses no area, in words; empty where it does.
    pure subroutine open_ring(body, ring, why)
        type(body_type), intent(in) :: body             !! finished
        type(link_type), intent(in) :: ring(:)          !! not empty
        character(:), allocatable, intent(out) :: why   !! see above
        real(dp) :: ends(2, 2)
        integer :: i

        why = ''
        ends(:, 1) = ring(1)%arc%start
        ends(:, 2) = ring(size(ring))%arc%finish
        if (meet(ends(:, 1), ends(:, 2), ring)) return
        do i = 1, 2
            if (abs(ends(1, i)) > outline_gap*extent(ring)) then
                why = 'the section is open at BL '//compact(ends(1, i))// &
                    ', WL '//compact(ends(2, i))
                return
            end if
        end do
        if (.not. body%is_closed) why = 'the section ends at BL 0 but the deck does not say CLOSE'
    end subroutine open_ring

end module cut_measure_ring
