!> Measures of a section at a station: girth, and where it encloses an area this area, its centroid
!> and second moments. All are of the whole body: a symmetric body counts both its halves.
module cut_measure
    use base_error, only: error_type
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_text, only: compact
    use body_body, only: body_type
    use body_section, only: trace_at, trace_type
    use cut_measure_ring, only: find_opening, link_type, rings_at, sections_at
    use geom_arc_integral, only: moments_type, operator(+), scaled, swept_by
    use geom_length, only: arc_length
    implicit none (type, external)
    private

    public :: section_measure_type, measure_section, moments_of_rings

    !> What a section measures. What does not exist is marked absent and is zero.
    type :: section_measure_type
        real(dp) :: sta = 0.0_dp                !! station, deck units
        logical :: has_girth = .false.          !! every section there has an arc
        real(dp) :: girth = 0.0_dp              !! length of the skin, deck units
        logical :: has_area = .false.           !! the section closes
        real(dp) :: area = 0.0_dp               !! deck units**2
        real(dp) :: centroid(2) = 0.0_dp        !! BL and WL, deck units
        real(dp) :: inertia(3) = 0.0_dp         !! about the centroid: integrals of WL**2, BL**2 and
                                                !! BL WL over the area, deck units**4
        character(:), allocatable :: why        !! where there is no area: why not
    end type section_measure_type

contains

    !> Measures the section at a station; says why where it can't.
    pure subroutine measure_section(body, sta, measure)
        type(body_type), intent(in) :: body                 !! finished
        real(dp), intent(in) :: sta                         !! deck units
        type(section_measure_type), intent(out) :: measure  !! what there is
        type(link_type), allocatable :: links(:)
        type(error_type), allocatable :: error

        measure%sta = sta
        if (size(sections_at(body, sta)) == 0) then
            measure%why = 'the body has no section at station '//compact(sta)
            return
        end if
        call rings_at(body, sta, links, error)
        if (.not. allocated(error)) call measure_girth(body, links, measure, error)
        if (allocated(error)) then
            measure%why = error%message
            return
        end if
        call find_opening(body, links, measure%why)
        if (len(measure%why) > 0) return
        call measure_area(body, links, measure, error)
        deallocate (measure%why)
        if (allocated(error)) measure%why = error%message
    end subroutine measure_section

    !> Adds up the lengths of all arcs of a station.
    pure subroutine measure_girth(body, links, measure, error)
        type(body_type), intent(in) :: body                     !! finished
        type(link_type), intent(in) :: links(:)                 !! of the station
        type(section_measure_type), intent(inout) :: measure    !! gets the girth
        type(error_type), allocatable, intent(out) :: error     !! from quadrature
        real(dp) :: length
        integer :: i

        do i = 1, size(links)
            call arc_length(links(i)%arc, length, error)
            if (allocated(error)) return
            measure%girth = measure%girth + length
        end do
        if (body%is_symmetric) measure%girth = 2.0_dp*measure%girth
        measure%has_girth = .true.
    end subroutine measure_girth

    !> Area, centroid and second moments of a section that closes.
    pure subroutine measure_area(body, links, measure, error)
        type(body_type), intent(in) :: body                     !! finished
        type(link_type), intent(in) :: links(:)                 !! of the station
        type(section_measure_type), intent(inout) :: measure    !! gets them
        type(error_type), allocatable, intent(out) :: error     !! from quadrature
        type(moments_type) :: moments
        real(dp) :: datum, arm(2)

        if (size(links) == 0) then
            measure%centroid = point_of(body, measure%sta)
            measure%has_area = .true.
            return
        end if
        datum = links(1)%arc%start(2)
        call moments_of_rings(body, links, datum, moments, error)
        if (allocated(error)) return
        measure%has_area = .true.
        measure%area = moments%area
        measure%centroid = [0.0_dp, datum]
        if (is_zero(moments%area)) return
        arm = moments%first/moments%area
        measure%centroid = measure%centroid + arm
        measure%inertia(1) = moments%second(2) - moments%first(2)*arm(2)
        measure%inertia(2) = moments%second(1) - moments%first(1)*arm(1)
        measure%inertia(3) = moments%second(3) - moments%first(1)*arm(2)
    end subroutine measure_area

    !> BL and WL of a body that is but a point at a station.
    pure function point_of(body, sta) result(point)
        type(body_type), intent(in) :: body !! finished
        real(dp), intent(in) :: sta         !! deck units
        real(dp) :: point(2)
        type(trace_type) :: trace
        integer, allocatable :: chosen(:)

        allocate (chosen(0))
        chosen = sections_at(body, sta)
        trace = trace_at(body%lines, body%sections(chosen(1)), sta)
        point = trace%start%point
        if (body%is_symmetric) point(1) = 0.0_dp
    end function point_of

    !> Area and moments of the whole section about BL 0 and a waterline. Each ring counts as
    !> positive.
    pure subroutine moments_of_rings(body, links, datum, moments, error)
        type(body_type), intent(in) :: body                 !! finished
        type(link_type), intent(in) :: links(:)             !! rings that enclose an area
        real(dp), intent(in) :: datum                       !! WL, deck units
        type(moments_type), intent(out) :: moments          !! x is BL, y is WL above the datum
        type(error_type), allocatable, intent(out) :: error !! from quadrature
        type(moments_type) :: ring, part
        integer :: i, k

        do k = 1, maxval([0, links%ring])
            ring = moments_type()
            do i = 1, size(links)
                if (links(i)%ring /= k) cycle
                call swept_by(links(i)%arc, [0.0_dp, datum], part, error)
                if (allocated(error)) return
                ring = ring + part
            end do
            moments = moments + scaled(ring, sign(1.0_dp, ring%area))
        end do
        if (.not. body%is_symmetric) return
        moments = scaled(moments, 2.0_dp)
        moments%first(1) = 0.0_dp
        moments%second(3) = 0.0_dp
    end subroutine moments_of_rings

end module cut_measure
