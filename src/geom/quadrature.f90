!> Integrals over a finite interval, by the Gauss-Kronrod rule of 7 and 15 points on panels that are
!> halved, the worst first, until the estimated error is small enough.
!>
!> Source: R. Piessens, E. de Doncker-Kapenga, C. W. Ueberhuber, D. K. Kahaner, "QUADPACK", Springer
!> 1983: rule QK15 (nodes, weights and error estimate) and strategy QAG.
module geom_quadrature
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_text, only: compact, to_text
    use base_tolerances, only: ulp
    implicit none (type, external)
    private

    public :: integrand_type, integrate

    !> A function to integrate: extend it with what the function needs to know, and with `values`
    !> where many values at once cost less.
    type, abstract :: integrand_type
    contains
        procedure(value_at), deferred :: at
        procedure :: values => one_by_one
    end type integrand_type

    abstract interface
        !> The value of the function.
        pure real(dp) function value_at(f, t)
            import :: dp, integrand_type
            implicit none (type, external)
            class(integrand_type), intent(in) :: f !! the function
            real(dp), intent(in) :: t              !! where
        end function value_at
    end interface

    !> A part of the interval with its integral.
    type :: panel_type
        real(dp) :: from = 0.0_dp     !! lower end
        real(dp) :: to = 0.0_dp       !! upper end
        real(dp) :: integral = 0.0_dp !! by the rule of 15 points
        real(dp) :: error = 0.0_dp    !! estimated
    end type panel_type

    !> More panels than any smooth function needs; each halving gains three figures.
    integer, parameter :: most_panels = 400

    !> Nodes of the rule of 15 points above zero; every second is one of the rule of 7.
    real(dp), parameter :: node(7) = [ &
        0.9914553711208126_dp, 0.9491079123427585_dp, &
        0.8648644233597691_dp, 0.7415311855993945_dp, &
        0.5860872354676911_dp, 0.4058451513773972_dp, &
        0.20778495500789848_dp]
    !> Weights of the 15 points, from the outermost to the middle.
    real(dp), parameter :: weight_15(8) = [ &
        0.022935322010529224_dp, 0.06309209262997856_dp, &
        0.10479001032225019_dp, 0.14065325971552592_dp, &
        0.1690047266392679_dp, 0.19035057806478542_dp, &
        0.20443294007529889_dp, 0.20948214108472782_dp]
    !> Weights of the 7 points, from the outermost to the middle.
    real(dp), parameter :: weight_7(4) = [ &
        0.1294849661688697_dp, 0.27970539148927664_dp, &
        0.3818300505051189_dp, 0.4179591836734694_dp]

contains

    !> The integral of a function from one end to the other.
    !>
    !> Fails with `cause%no_convergence` where `most_panels` do not reach the tolerance; the message
    !> says what was reached.
    pure subroutine integrate(f, from, to, tolerance, integral, error)
        class(integrand_type), intent(in) :: f              !! the function
        real(dp), intent(in) :: from                        !! start of the interval
        real(dp), intent(in) :: to                          !! end of the interval, may be below
        real(dp), intent(in) :: tolerance                   !! relative error asked, 50 ulp or more
        real(dp), intent(out) :: integral                   !! the integral
        type(error_type), allocatable, intent(out) :: error !! see above
        type(panel_type) :: whole

        integral = 0.0_dp
        if (is_equal(from, to)) return
        whole = measured(f, from, to)
        integral = whole%integral
        if (whole%error > tolerance*abs(integral)) &
            call integrate_by_panels(f, whole, tolerance, integral, error)
    end subroutine integrate

    !> The integral over a panel that is too long for the rule. Fails as `integrate`.
    pure subroutine integrate_by_panels(f, whole, tolerance, integral, error)
        class(integrand_type), intent(in) :: f              !! the function
        type(panel_type), intent(in) :: whole               !! the interval, measured
        real(dp), intent(in) :: tolerance                   !! as `integrate`
        real(dp), intent(out) :: integral                   !! the integral
        type(error_type), allocatable, intent(out) :: error !! see above
        type(panel_type) :: panels(most_panels)
        real(dp) :: estimate, middle
        integer :: count, worst

        panels(1) = whole
        do count = 1, most_panels - 1
            integral = sum(panels(:count)%integral)
            estimate = sum(panels(:count)%error)
            if (estimate <= tolerance*abs(integral)) return
            worst = maxloc(panels(:count)%error, dim=1)
            middle = 0.5_dp*(panels(worst)%from + panels(worst)%to)
            panels(count + 1) = measured(f, middle, panels(worst)%to)
            panels(worst) = measured(f, panels(worst)%from, middle)
        end do
        call fail(error, cause%no_convergence, 'the integral '//compact(integral)// &
            ' is uncertain by '//compact(estimate)//' after '//to_text(most_panels)//' panels')
    end subroutine integrate_by_panels

    !> The integral over a panel with its estimated error.
    pure type(panel_type) function measured(f, from, to) result(panel)
        class(integrand_type), intent(in) :: f !! the function
        real(dp), intent(in) :: from           !! start of the panel
        real(dp), intent(in) :: to             !! end of the panel
        real(dp) :: value(15), weight(15), half, mean, spread, fine, coarse, rough, share

        half = 0.5_dp*(to - from)
        value = values(f, 0.5_dp*(from + to), half)
        weight = [weight_15, weight_15(7:1:-1)]
        fine = sum(weight*value)
        coarse = sum([weight_7, weight_7(3:1:-1)]*value(2:14:2))
        mean = 0.5_dp*fine
        spread = sum(weight*abs(value - mean))
        rough = abs(fine - coarse)
        if (spread > 0.0_dp) then
            share = 200.0_dp*rough/spread
            rough = spread*min(1.0_dp, share*sqrt(share))
        end if
        rough = max(rough, 2.0_dp*ulp*sum(weight*abs(value)))
        panel = panel_type(from, to, half*fine, abs(half)*rough)
    end function measured

    !> The function at the 15 nodes of a panel, in order.
    pure function values(f, centre, half) result(value)
        class(integrand_type), intent(in) :: f !! the function
        real(dp), intent(in) :: centre         !! middle of the panel
        real(dp), intent(in) :: half           !! half its length
        real(dp) :: value(15)
        call f%values([centre - half*node, centre, centre + half*node(7:1:-1)], value)
    end function values

    !> The values of a function.
    pure subroutine one_by_one(f, t, value)
        class(integrand_type), intent(in) :: f  !! the function
        real(dp), intent(in) :: t(:)            !! where
        real(dp), intent(out) :: value(:)       !! one for each
        integer :: i
        do i = 1, size(t)
            value(i) = f%at(t(i))
        end do
    end subroutine one_by_one

end module geom_quadrature
