!> Whether a point is inside of the body's section at its station, by the exact arcs: a ray to
!> starboard from an inside point passes the closed outline an odd number of times.
module cut_clearance_inside
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_measure_ring, only: find_opening, link_type, rings_at
    use geom_arc, only: arc_type
    use geom_arc_point, only: point
    use geom_crossing, only: crossing, turning_places
    use geom_place, only: at_finish, at_start, place_type
    implicit none (type, external)
    private

    public :: test_inside

contains

    !> Tests a point against the section at its station.
    pure subroutine test_inside(body, at, is_known, is_inside)
        type(body_type), intent(in) :: body     !! finished
        real(dp), intent(in) :: at(3)           !! STA, BL, WL, deck units
        logical, intent(out) :: is_known        !! the section is there and closes
        logical, intent(out) :: is_inside       !! where known
        type(link_type), allocatable :: links(:)
        type(error_type), allocatable :: error
        character(:), allocatable :: why
        real(dp) :: seen(2)
        integer :: i

        is_inside = .false.
        call rings_at(body, at(1), links, error)
        is_known = .not. allocated(error) .and. size(links) > 0
        if (is_known) then
            call find_opening(body, links, why)
            is_known = len(why) == 0
        end if
        if (.not. is_known) return
        seen = at(2:)
        if (body%is_symmetric) seen(1) = abs(seen(1))
        do i = 1, size(links)
            if (is_odd(passes(links(i)%arc, seen))) is_inside = .not. is_inside
        end do
        do i = 1, maxval(links%ring)
            if (passes_axis(pack(links, links%ring == i), seen)) is_inside = .not. is_inside
        end do
    end subroutine test_inside

    !> True for an odd number.
    elemental logical function is_odd(number)
        integer, intent(in) :: number !! any
        is_odd = modulo(number, 2) == 1
    end function is_odd

    !> How often a ray from a point to starboard passes an arc.
    pure integer function passes(arc, from)
        type(arc_type), intent(in) :: arc   !! any arc
        real(dp), intent(in) :: from(2)     !! BL, WL, deck units
        type(place_type), allocatable :: places(:)
        real(dp) :: before(2), after(2), met(2)
        integer :: i

        allocate (places(0))
        places = [at_start, turning_places(arc, 2), at_finish]
        passes = 0
        do i = 1, size(places) - 1
            before = point(arc, places(i))
            after = point(arc, places(i + 1))
            if ((before(2) > from(2)) .eqv. (after(2) > from(2))) cycle
            met = point(arc, crossing(arc, 2, from(2), rising=after(2) > before(2)))
            if (met(1) > from(1)) passes = passes + 1
        end do
    end function passes

    !> True where a ring that is closed along BL 0 is passed there.
    pure logical function passes_axis(ring, from)
        type(link_type), intent(in) :: ring(:)  !! in order
        real(dp), intent(in) :: from(2)         !! BL, WL, deck units
        associate (first => ring(1)%arc%start, last => ring(size(ring))%arc%finish)
            passes_axis = from(1) < 0.0_dp .and. ((first(2) > from(2)) .neqv. (last(2) > from(2)))
        end associate
    end function passes_axis

end module cut_clearance_inside
