!> Integrals of several functions at once over a finite interval, with their own error estimates:
!> the functions share what is dear to evaluate. Fejer's second rule of 15 points, which holds the
!> rule of 7 and no end of the interval, on panels that are halved, the worst first.
!>
!> Sources: J. Waldvogel, "Fast construction of the Fejer and Clenshaw-Curtis quadrature rules", BIT
!> 46 (2006), pp. 195-202, (1.2) (nodes and weights); R. Piessens et al., "QUADPACK", Springer 1983
!> (error estimate of QK15, strategy of QAG).
module geom_integral_set
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_text, only: compact, to_text
    use base_tolerances, only: ulp
    implicit none (type, external)
    private

    public :: integrand_set_type, estimate_type, integrate_set

    !> Functions to integrate: extend it with what they need to know, and with `noise` where they
    !> are not good to an ulp of themselves.
    type, abstract :: integrand_set_type
        integer :: number = 1 !! how many functions
    contains
        procedure(values_at), deferred :: at
        procedure :: noise => noise_of
    end type integrand_set_type

    abstract interface
        !> The values of all functions. An error ends the integration.
        pure subroutine values_at(f, t, value, error)
            import :: dp, error_type, integrand_set_type
            implicit none (type, external)
            class(integrand_set_type), intent(in) :: f          !! the functions
            real(dp), intent(in) :: t                           !! where, never an end
            real(dp), intent(out) :: value(:)                   !! shape (number)
            type(error_type), allocatable, intent(out) :: error !! a value does not exist
        end subroutine values_at
    end interface

    !> Integrals with what is known of their errors.
    type :: estimate_type
        real(dp), allocatable :: value(:)     !! the integrals
        real(dp), allocatable :: error(:)     !! estimated, above the true ones for smooth functions
        real(dp), allocatable :: magnitude(:) !! integrals of the absolute values
    end type estimate_type

    !> A part of the interval with its integrals.
    type :: panel_type
        real(dp) :: from = 0.0_dp       !! lower end
        real(dp) :: to = 0.0_dp         !! upper end
        type(estimate_type) :: estimate !! over the panel
    end type panel_type

    !> Panels of one interval; smooth functions take fewer than ten.
    integer, parameter :: most_panels = 200
    !> Cosines of k pi/16, k from 1 to 7: the points outside of the middle.
    real(dp), parameter :: node(7) = [ &
        0.9807852804032304_dp, 0.9238795325112867_dp, 0.8314696123025452_dp, &
        0.7071067811865476_dp, 0.5555702330196022_dp, 0.3826834323650898_dp, &
        0.19509032201612828_dp]
    !> Weights of the 15 points, from the outermost to the middle.
    real(dp), parameter :: weight_15(8) = [ &
        0.04521184009210757_dp, 0.06763919428824987_dp, 0.11674868983679289_dp, &
        0.13111333111333112_dp, 0.17101580153660526_dp, 0.1736306469815914_dp, &
        0.20035700186782762_dp, 0.18856698856698856_dp]
    !> Weights of every second of them, the rule of 7, from the outermost to the middle.
    real(dp), parameter :: weight_7(4) = [ &
        0.1779646809620499_dp, 0.24761904761904763_dp, 0.3934638904665215_dp, &
        0.3619047619047619_dp]

contains

    !> The integrals from one end to the other, each to a tolerance relative to the integral of the
    !> absolute value, or to the noise of the functions where this is more; it is then added to the
    !> estimated errors.
    !>
    !> Fails with what the functions fail with, and with `cause%no_convergence` where `most_panels`
    !> do not reach the tolerance. The functions may be integrals of sets themselves.
    pure recursive subroutine integrate_set(f, from, to, tolerance, estimate, error)
        class(integrand_set_type), intent(in) :: f          !! the functions
        real(dp), intent(in) :: from                        !! start of the interval
        real(dp), intent(in) :: to                          !! end of the interval, may be below
        real(dp), intent(in) :: tolerance                   !! relative error asked, 50 ulp or more
        type(estimate_type), intent(out) :: estimate        !! the integrals
        type(error_type), allocatable, intent(out) :: error !! see above
        type(panel_type) :: panels(most_panels)
        real(dp) :: from_worst, middle, allowed(f%number), noise(f%number)
        integer :: count, worst

        estimate = nothing(f%number)
        if (is_equal(from, to)) return
        call measure(f, from, to, panels(1), error)
        do count = 1, most_panels - 1
            if (allocated(error)) return
            estimate = total(panels(:count))
            allowed = tolerance*estimate%magnitude
            if (all(estimate%error <= allowed)) return
            noise = f%noise(estimate%magnitude)
            allowed = allowed + noise
            if (all(estimate%error <= allowed)) then
                estimate%error = estimate%error + noise
                return
            end if
            worst = worst_of(panels(:count), estimate, allowed)
            from_worst = panels(worst)%from
            middle = 0.5_dp*(from_worst + panels(worst)%to)
            call measure(f, middle, panels(worst)%to, panels(count + 1), error)
            if (allocated(error)) return
            call measure(f, from_worst, middle, panels(worst), error)
        end do
        if (allocated(error)) return
        call fail(error, cause%no_convergence, 'an integral of '// &
            compact(estimate%value(1))//' is uncertain by '//compact(estimate%error(1))// &
            ' after '//to_text(most_panels)//' panels')
    end subroutine integrate_set

    !> What rounding of the functions can add to their integrals from one end to the other.
    pure function noise_of(f, magnitude) result(noise)
        class(integrand_set_type), intent(in) :: f  !! the functions, good to an ulp of themselves
        real(dp), intent(in) :: magnitude(:)        !! integrals of the absolute values
        real(dp) :: noise(f%number)
        noise = ulp*magnitude
    end function noise_of

    !> Integrals of nothing.
    pure type(estimate_type) function nothing(number)
        integer, intent(in) :: number !! how many
        allocate (nothing%value(number), nothing%error(number), nothing%magnitude(number))
        nothing%value = 0.0_dp
        nothing%error = 0.0_dp
        nothing%magnitude = 0.0_dp
    end function nothing

    !> The integrals over all panels.
    pure type(estimate_type) function total(panels) result(estimate)
        type(panel_type), intent(in) :: panels(:) !! one or more
        integer :: i

        estimate = panels(1)%estimate
        do i = 2, size(panels)
            associate (part => panels(i)%estimate)
                estimate%value = estimate%value + part%value
                estimate%error = estimate%error + part%error
                estimate%magnitude = estimate%magnitude + part%magnitude
            end associate
        end do
    end function total

    !> The panel with the largest error of an integral that is not good enough yet, in its measure.
    pure integer function worst_of(panels, estimate, allowed) result(worst)
        type(panel_type), intent(in) :: panels(:)     !! one or more
        type(estimate_type), intent(in) :: estimate   !! over all of them
        real(dp), intent(in) :: allowed(:)            !! errors asked, one for each integral
        real(dp) :: share, largest
        integer :: i, k

        worst = 1
        largest = -1.0_dp
        do k = 1, size(estimate%value)
            if (estimate%error(k) <= allowed(k)) cycle
            do i = 1, size(panels)
                share = panels(i)%estimate%error(k)/estimate%error(k)
                if (share <= largest) cycle
                largest = share
                worst = i
            end do
        end do
    end function worst_of

    !> Measures one panel.
    pure recursive subroutine measure(f, from, to, panel, error)
        class(integrand_set_type), intent(in) :: f          !! the functions
        real(dp), intent(in) :: from                        !! start of the panel
        real(dp), intent(in) :: to                          !! end of the panel
        type(panel_type), intent(out) :: panel              !! its integrals
        type(error_type), allocatable, intent(out) :: error !! from the functions
        real(dp) :: value(f%number, 15), half, place(15)
        integer :: i

        half = 0.5_dp*(to - from)
        place = 0.5_dp*(from + to) + half*[-node, 0.0_dp, node(7:1:-1)]
        do i = 1, 15
            call f%at(place(i), value(:, i), error)
            if (allocated(error)) return
        end do
        panel = panel_type(from, to, summed(value, half))
    end subroutine measure

    !> The integrals from the values at the nodes of a panel.
    pure type(estimate_type) function summed(value, half) result(estimate)
        real(dp), intent(in) :: value(:, :) !! of each function at each node
        real(dp), intent(in) :: half        !! half the length of the panel
        real(dp) :: weight(15), within(7), rough, spread
        integer :: k

        weight = [weight_15, weight_15(7:1:-1)]
        within = [weight_7, weight_7(3:1:-1)]
        estimate = nothing(size(value, 1))
        do k = 1, size(value, 1)
            estimate%value(k) = sum(weight*value(k, :))
            estimate%magnitude(k) = sum(weight*abs(value(k, :)))
            spread = sum(weight*abs(value(k, :) - 0.5_dp*estimate%value(k)))
            rough = abs(estimate%value(k) - sum(within*value(k, 2:14:2)))
            if (spread > 0.0_dp) rough = spread*min(1.0_dp, (200.0_dp*rough/spread)**1.5_dp)
            estimate%error(k) = max(rough, 2.0_dp*ulp*estimate%magnitude(k))
        end do
        estimate%value = half*estimate%value
        estimate%magnitude = abs(half)*estimate%magnitude
        estimate%error = abs(half)*estimate%error
    end function summed

end module geom_integral_set
