!> What is integrated over a span of a body, between stations where any line or section ends or
!> joins: all integrands are smooth functions of u (`cut_measure_sheet`), also at a blunt nose, each
!> section's area and moments being those of its exact arcs and the skin's area the integral of
!> |dp/du x dp/dt|.
!>
!> Where sections have nearly shrunk to a point or a line, the rounding of their points is no longer
!> small beside them. It is known how far it moves them, and what this adds to each integral.
module cut_measure_slice
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_text, only: compact
    use base_tolerances, only: decimal_noise, segment_tolerance, ulp
    use body_body, only: body_type
    use body_section, only: is_point, trace_at, trace_type
    use body_taylor, only: taylor_type
    use cut_measure, only: moments_of_rings
    use cut_measure_ring, only: find_opening, link_type, rings_at, sections_at
    use cut_measure_sheet, only: frame_at, frame_type, new_span, span_type, spot_at, spot_type, &
        station_of
    use geom_arc_integral, only: moments_type
    use geom_integral_set, only: estimate_type, integrand_set_type, integrate_set
    implicit none (type, external)
    private

    public :: slice_type, new_slice

    !> What is integrated over u: skin; then of a body that closes volume, and its moments along
    !> STA, BL and WL.
    type, extends(integrand_set_type) :: slice_type
        type(body_type) :: body             !! the body
        integer, allocatable :: chosen(:)   !! its sections that are there
        type(span_type) :: span             !! the stations
        real(dp) :: datum(3) = 0.0_dp       !! origin of the moments
        real(dp) :: doubt = 0.0_dp          !! how far rounding moves points, deck units
        real(dp) :: reach(3) = 0.0_dp       !! how far from the origin there are some, deck units
    contains
        procedure :: at => slice_at
        procedure :: noise => noise_of
    end type slice_type

    !> |dp/du x dp/dt| over t.
    type, extends(integrand_set_type) :: band_type
        type(frame_type) :: frame !! a section at one u
    contains
        procedure :: at => band_at
    end type band_type

contains

    !> What is integrated between two stations.
    pure type(slice_type) function new_slice(body, ends, datum, number) result(slice)
        type(body_type), intent(in) :: body     !! finished
        real(dp), intent(in) :: ends(2)         !! stations next to each other of `stops_of`
        real(dp), intent(in) :: datum(3)        !! origin of the moments, deck units
        integer, intent(in) :: number           !! 1, the skin; 5, volume and moments, too
        integer :: i, k

        slice%number = number
        slice%body = body
        slice%chosen = sections_at(body, 0.5_dp*(ends(1) + ends(2)))
        slice%span = new_span(body, slice%chosen, ends(1), ends(2))
        slice%datum = datum
        slice%reach(1) = maxval(abs(ends - datum(1)))
        do i = 1, size(slice%chosen)
            do k = 0, 2
                call reach_out(trace_at(body%lines, body%sections(slice%chosen(i)), &
                    ends(1) + 0.5_dp*real(k, dp)*(ends(2) - ends(1))), slice)
            end do
        end do
    end function new_slice

    !> Takes the points of a section into account.
    pure subroutine reach_out(trace, slice)
        type(trace_type), intent(in) :: trace       !! of the section
        type(slice_type), intent(inout) :: slice    !! gets doubt and reach
        real(dp) :: at(2, 3)
        integer :: axis

        at = reshape([trace%start%point, trace%shoulder, trace%finish%point], [2, 3])
        slice%doubt = max(slice%doubt, decimal_noise*ulp*maxval(abs(at)))
        do axis = 1, 2
            slice%reach(axis + 1) = max(slice%reach(axis + 1), &
                maxval(abs(at(axis, :) - slice%datum(axis + 1))))
        end do
    end subroutine reach_out

    !> What rounding of points can add to the integrals: to the skin as much to each end of each
    !> section, to the volume a layer all over the skin, and to the moments its own.
    pure function noise_of(f, magnitude) result(noise)
        class(slice_type), intent(in) :: f      !! body and span
        real(dp), intent(in) :: magnitude(:)    !! integrals of the absolute values, the skin first
        real(dp) :: noise(f%number)

        noise(1) = 4.0_dp*real(size(f%chosen), dp)*f%doubt*abs(f%span%to - f%span%from)
        if (f%number == 1) return
        noise(2) = f%doubt*magnitude(1)
        noise(3:5) = noise(2)*f%reach
    end function noise_of

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

end module cut_measure_slice
