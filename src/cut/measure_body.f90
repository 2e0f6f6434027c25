!> Measures of a body along its length: volume, centroid, wetted area, and the curve of section
!> areas.
!>
!> Between stations where any line or section ends or joins, all integrands are smooth functions of
!> u (`cut_measure_sheet`), also at a blunt nose. They are integrated together, each section's area
!> and moments being those of its exact arcs and the skin's area the integral of |dp/du x dp/dt|.
module cut_measure_body
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_order, only: rising
    use base_text, only: compact
    use base_tolerances, only: quadrature_tolerance, segment_tolerance
    use body_body, only: body_type, smooth_stops
    use body_section, only: is_point, trace_at
    use body_taylor, only: taylor_type
    use cut_measure, only: measure_section, moments_of_rings, section_measure_type
    use cut_measure_ring, only: find_opening, link_type, rings_at, sections_at
    use cut_measure_sheet, only: frame_at, frame_type, new_span, span_type, spot_at, spot_type, &
        station_of
    use geom_arc_integral, only: moments_type
    use geom_integral_set, only: estimate_type, integrand_set_type, integrate_set
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

    !> What is integrated over u: skin; then of a body that closes volume, and its moments along
    !> STA, BL and WL.
    type, extends(integrand_set_type) :: slice_type
        type(body_type) :: body         !! the body
        integer, allocatable :: chosen(:) !! its sections that are there
        type(span_type) :: span         !! the stations
        real(dp) :: datum(3) = 0.0_dp   !! origin of the moments
    contains
        procedure :: at => slice_at
    end type slice_type

    !> |dp/du x dp/dt| over t.
    type, extends(integrand_set_type) :: band_type
        type(frame_type) :: frame !! a section at one u
    contains
        procedure :: at => band_at
    end type band_type

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
        real(dp) :: value(5), uncertain(5)
        integer :: i

        slice%body = body
        slice%number = merge(5, 1, measure%has_volume)
        slice%datum = datum_of(body, stops)
        value = 0.0_dp
        uncertain = 0.0_dp
        do i = 1, size(stops) - 1
            slice%chosen = sections_at(body, 0.5_dp*(stops(i) + stops(i + 1)))
            if (size(slice%chosen) == 0) cycle
            slice%span = new_span(body, slice%chosen, stops(i), stops(i + 1))
            call integrate_set(slice, 0.0_dp, 1.0_dp, quadrature_tolerance, estimate, error)
            if (allocated(error)) return
            value(:slice%number) = value(:slice%number) + estimate%value
            uncertain(:slice%number) = uncertain(:slice%number) + estimate%error &
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

    !> The values of a slice at u.
    pure subroutine slice_at(f, t, value, error)
        class(slice_type), intent(in) :: f                  !! body and span
        real(dp), intent(in) :: t                           !! u, 0 to 1
        real(dp), intent(out) :: value(:)                   !! shape (1) or (5)
        type(error_type), allocatable, intent(out) :: error !! a section has no arc
        type(taylor_type) :: sta

        value = 0.0_dp
        sta = station_of(f%span, t)
        if (is_equal(sta%value, f%span%from) .or. is_equal(sta%value, f%span%to)) return
        call add_bands(f, sta, value(1), error)
        if (.not. allocated(error) .and. f%number > 1) call take_moments(f, sta, value(2:5), error)
        if (allocated(error)) error%message = 'at station '//compact(sta%value)//': '// &
            error%message
    end subroutine slice_at

    !> The area of the section at one u and its moments, over du.
    pure subroutine take_moments(f, sta, value, error)
        class(slice_type), intent(in) :: f                  !! body and span
        type(taylor_type), intent(in) :: sta                !! the station over u
        real(dp), intent(out) :: value(4)                   !! area and moments
        type(error_type), allocatable, intent(out) :: error !! a section has no arc, or is open
        type(link_type), allocatable :: links(:)
        type(moments_type) :: moments
        character(:), allocatable :: why

        value = 0.0_dp
        call rings_at(f%body, sta%value, links, error)
        if (allocated(error)) return
        call find_opening(f%body, links, why)
        if (len(why) > 0) then
            call fail(error, cause%joint_gap, why)
            return
        end if
        call moments_of_rings(f%body, links, f%datum(3), moments, error)
        value = sta%first*[moments%area, moments%area*(sta%value - f%datum(1)), &
            moments%first(1) - moments%area*f%datum(2), moments%first(2)]
    end subroutine take_moments

    !> Adds the skin of all sections at one u, over du.
    pure subroutine add_bands(f, sta, skin, error)
        type(slice_type), intent(in) :: f                   !! body and span
        type(taylor_type), intent(in) :: sta                !! the station over u
        real(dp), intent(inout) :: skin                     !! gets the skin, deck units**2
        type(error_type), allocatable, intent(out) :: error !! a section has no arc
        type(band_type) :: band
        type(estimate_type) :: estimate
        integer :: i

        do i = 1, size(f%chosen)
            associate (section => f%body%sections(f%chosen(i)))
                if (is_point(trace_at(f%body%lines, section, sta%value))) cycle
                call frame_at(f%body, section, sta, band%frame, error)
                if (allocated(error)) error%message = trim(section%name)//': '//error%message
            end associate
            if (allocated(error)) return
            call integrate_set(band, 0.0_dp, 1.0_dp, segment_tolerance, estimate, error)
            if (allocated(error)) return
            skin = skin + merge(2.0_dp, 1.0_dp, f%body%is_symmetric)*estimate%value(1)
        end do
    end subroutine add_bands

    !> |dp/du x dp/dt| at t.
    pure subroutine band_at(f, t, value, error)
        class(band_type), intent(in) :: f                   !! a section at one u
        real(dp), intent(in) :: t                           !! 0 to 1
        real(dp), intent(out) :: value(:)                   !! shape (1)
        type(error_type), allocatable, intent(out) :: error !! never
        type(spot_type) :: spot

        spot = spot_at(f%frame, t)
        value(1) = norm2([spot%u(2)*spot%t(3) - spot%u(3)*spot%t(2), &
            spot%u(1)*spot%t(2), spot%u(1)*spot%t(3)])
        if (allocated(error)) deallocate (error)
    end subroutine band_at

end module cut_measure_body
