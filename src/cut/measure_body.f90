!> Measures of a body along its length: volume, centroid, wetted area, and the curve of section
!> areas.
!>
!> Between stations where any line or section ends or joins all integrands are smooth, and
!> integrated together (`cut_measure_slice`).
module cut_measure_body
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use base_order, only: rising
    use base_text, only: compact
    use base_tolerances, only: quadrature_tolerance, segment_tolerance
    use body_body, only: body_type, smooth_stops
    use cut_measure, only: measure_section, section_measure_type
    use cut_measure_ring, only: find_opening, link_type, rings_at, sections_at
    use cut_measure_slice, only: new_slice, slice_type
    use geom_integral_set, only: estimate_type, integrate_set
    implicit none (type, external)
    private

    public :: body_measure_type, measure_body, measure_whole, stops_of

    !> What a body measures, both halves of a symmetric one. What does not exist is marked absent.
    type :: body_measure_type
        real(dp) :: from = 0.0_dp               !! least station, deck units
        real(dp) :: to = 0.0_dp                 !! greatest station, deck units
        logical :: has_volume = .false.         !! its sections close all along
        real(dp) :: volume = 0.0_dp             !! deck units**3
        real(dp) :: volume_error = 0.0_dp       !! estimate of the quadrature, deck units**3
        real(dp) :: centroid(3) = 0.0_dp        !! of the volume: STA, BL, WL, deck units
        real(dp) :: centroid_error = 0.0_dp     !! largest estimate of the quadrature, deck units
        logical :: has_wetted = .false.         !! every section has an arc all along
        real(dp) :: wetted_area = 0.0_dp        !! of the skin, without flat ends, deck units**2
        real(dp) :: wetted_error = 0.0_dp       !! estimate of the quadrature, deck units**2
        character(:), allocatable :: why        !! where there is no volume: why not
        type(section_measure_type), allocatable :: curve(:) !! along the length, rising stations
    end type body_measure_type

    !> Parts of the regular grid of the area curve.
    integer, parameter :: grid_parts = 20

contains

    !> Measures a body.
    pure subroutine measure_body(body, stations, measure)
        type(body_type), intent(in) :: body             !! finished
        real(dp), intent(in) :: stations(:)             !! wanted in the area curve, in any order
        type(body_measure_type), intent(out) :: measure !! what there is
        call measure_whole(body, measure)
        if (measure%from < measure%to) call draw_curve(body, stations, measure)
    end subroutine measure_body

    !> Measures a body without its area curve, which is left empty.
    pure subroutine measure_whole(body, measure)
        type(body_type), intent(in) :: body             !! finished
        type(body_measure_type), intent(out) :: measure !! what there is
        type(error_type), allocatable :: error
        real(dp), allocatable :: stops(:)

        allocate (measure%curve(0))
        stops = stops_of(body)
        if (size(stops) < 2) then
            measure%why = 'the body has no section'
            return
        end if
        measure%from = stops(1)
        measure%to = stops(size(stops))
        call find_no_volume(body, stops, measure%why)
        measure%has_volume = len(measure%why) == 0
        call add_slices(body, stops, measure, error)
        measure%has_wetted = .not. allocated(error)
        if (allocated(error)) then
            measure%has_volume = .false.
            measure%why = error%message
        end if
        if (measure%has_volume) deallocate (measure%why)
    end subroutine measure_whole

    !> The stations where a section of a body begins, joins or ends, in order, each once.
    pure function stops_of(body) result(stops)
        type(body_type), intent(in) :: body !! finished
        real(dp), allocatable :: stops(:), found(:)
        integer :: i

        allocate (found(0))
        do i = 1, size(body%sections)
            if (body%sections(i)%from < body%sections(i)%to) &
                found = [found, smooth_stops(body, body%sections(i))]
        end do
        stops = rising(found)
    end function stops_of

    !> Measures the sections at the stations wanted and on a regular grid.
    pure subroutine draw_curve(body, stations, measure)
        type(body_type), intent(in) :: body                 !! finished
        real(dp), intent(in) :: stations(:)                 !! wanted
        type(body_measure_type), intent(inout) :: measure   !! has its range; gets the curve
        real(dp) :: grid(0:grid_parts)
        real(dp), allocatable :: sta(:)
        integer :: i

        grid = [(measure%from + (measure%to - measure%from)*real(i, dp)/real(grid_parts, dp), &
            i=0, grid_parts)]
        grid(grid_parts) = measure%to
        allocate (sta(0))
        sta = rising([grid, pack(stations, stations >= measure%from &
            .and. stations <= measure%to)])
        deallocate (measure%curve)
        allocate (measure%curve(size(sta)))
        do i = 1, size(sta)
            call measure_section(body, sta(i), measure%curve(i))
        end do
    end subroutine draw_curve

    !> Why a body has no volume, in words; empty where it has one.
    pure subroutine find_no_volume(body, stops, why)
        type(body_type), intent(in) :: body             !! finished
        real(dp), intent(in) :: stops(:)                !! of `stops_of`
        character(:), allocatable, intent(out) :: why   !! see above
        type(link_type), allocatable :: links(:)
        type(error_type), allocatable :: error
        integer :: i

        why = ''
        do i = 1, size(stops) - 1
            call rings_at(body, 0.5_dp*(stops(i) + stops(i + 1)), links, error)
            if (allocated(error)) then
                why = error%message
            else
                call find_opening(body, links, why)
            end if
            if (len(why) == 0) cycle
            why = 'between stations '//compact(stops(i))//' and '//compact(stops(i + 1))//' '//why
            return
        end do
    end subroutine find_no_volume

    !> Integrates over all spans and adds up.
    pure subroutine add_slices(body, stops, measure, error)
        type(body_type), intent(in) :: body                 !! finished
        real(dp), intent(in) :: stops(:)                    !! of `stops_of`
        type(body_measure_type), intent(inout) :: measure   !! gets volume and wetted area
        type(error_type), allocatable, intent(out) :: error !! a section has no arc
        type(slice_type) :: slice
        type(estimate_type) :: estimate
        real(dp) :: value(5), uncertain(5), datum(3)
        integer :: i, number

        number = merge(5, 1, measure%has_volume)
        datum = datum_of(body, stops)
        value = 0.0_dp
        uncertain = 0.0_dp
        do i = 1, size(stops) - 1
            if (size(sections_at(body, 0.5_dp*(stops(i) + stops(i + 1)))) == 0) cycle
            slice = new_slice(body, stops(i:i + 1), datum, number)
            call integrate_set(slice, 0.0_dp, 1.0_dp, quadrature_tolerance, estimate, error)
            if (allocated(error)) then
                if (error%cause == cause%no_convergence) error%message = 'between stations '// &
                    compact(stops(i))//' and '//compact(stops(i + 1))//': '//error%message
                return
            end if
            value(:number) = value(:number) + estimate%value
            uncertain(:number) = uncertain(:number) + estimate%error &
                + segment_tolerance*estimate%magnitude
        end do
        measure%wetted_area = value(1)
        measure%wetted_error = uncertain(1)
        if (.not. (measure%has_volume .and. value(2) > 0.0_dp)) return
        measure%volume = value(2)
        measure%volume_error = uncertain(2)
        measure%centroid = slice%datum + value(3:)/value(2)
        measure%centroid_error = maxval(uncertain(3:) &
            + abs(value(3:)/value(2))*uncertain(2))/value(2)
    end subroutine add_slices

    !> An origin of moments beside the body, so that no moment is nothing but rounding: STA, BL, WL,
    !> deck units.
    pure function datum_of(body, stops) result(datum)
        type(body_type), intent(in) :: body !! finished
        real(dp), intent(in) :: stops(:)    !! of `stops_of`
        real(dp) :: datum(3), reach
        type(section_measure_type) :: middle

        call measure_section(body, 0.5_dp*(stops(1) + stops(size(stops))), middle)
        reach = stops(size(stops)) - stops(1)
        if (middle%has_girth) reach = min(reach, middle%girth)
        datum = [stops(1), middle%centroid] - reach
    end function datum_of

end module cut_measure_body
