!> A curve that is dear to evaluate, sampled once: on each panel of its parameter the polynomial
!> through its points at 17 Chebyshev points, which are halved until what is between the points is
!> right, too. A spline is fitted to the samples and then measured against the curve itself.
!>
!> Source: J.-P. Berrut and L. N. Trefethen, "Barycentric Lagrange interpolation", SIAM Review 46
!> (2004), pp. 501-517, (5.4) and (4.2).
module export_drawing_sample
    use base_constants, only: pi
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use geom_curve_fit, only: curve_function_type
    implicit none (type, external)
    private

    public :: sampled_type, sample_curve

    !> Degree of the polynomials.
    integer, parameter :: degree = 16
    !> Panels there may be, and the shortest one that is halved: what is left there is a jump.
    integer, parameter :: most_panels = 256
    real(dp), parameter :: shortest = 1.0e-9_dp
    !> A jump by so many tolerances is not sampled beyond.
    real(dp), parameter, public :: hopeless = 100.0_dp

    !> One panel.
    type :: panel_type
        real(dp) :: from = 0.0_dp                   !! parameter where it begins
        real(dp) :: to = 0.0_dp                     !! parameter where it ends
        real(dp) :: point(3, 0:degree) = 0.0_dp     !! at its Chebyshev points, deck units
    end type panel_type

    !> A curve as samples.
    type, extends(curve_function_type) :: sampled_type
        type(panel_type), allocatable :: panel(:)   !! in order, from 0 to 1
        real(dp) :: rest = 0.0_dp                   !! largest miss that was found and left
    contains
        procedure :: at => sample_at
    end type sampled_type

contains

    !> Samples a curve until the samples give what is between them within a tolerance, as far as
    !> `most_panels` go. Where the curve jumps by more than `hopeless` tolerances it is given up:
    !> `rest` says by how much, and the samples end there.
    pure subroutine sample_curve(curve, tolerance, sampled)
        class(curve_function_type), intent(in) :: curve !! any
        real(dp), intent(in) :: tolerance               !! deck units
        type(sampled_type), intent(out) :: sampled      !! its samples
        type(panel_type), allocatable :: panel(:)
        real(dp) :: off
        integer :: count, i

        allocate (panel(most_panels))
        panel(1) = panel_of(curve, 0.0_dp, 1.0_dp)
        count = 1
        i = 1
        do while (i <= count)
            off = miss(curve, panel(i))
            if (off > tolerance .and. count < most_panels .and. &
                panel(i)%to - panel(i)%from > shortest) then
                panel(i + 2:count + 1) = panel(i + 1:count)
                count = count + 1
                call halve(curve, panel(i), panel(i + 1))
            else
                sampled%rest = max(sampled%rest, off)
                if (off > hopeless*tolerance .and. count < most_panels) exit
                i = i + 1
            end if
        end do
        sampled%panel = panel(:min(i, count))
    end subroutine sample_curve

    !> Makes two panels of one.
    pure subroutine halve(curve, first, second)
        class(curve_function_type), intent(in) :: curve !! sampled
        type(panel_type), intent(inout) :: first        !! a panel; then its first half
        type(panel_type), intent(out) :: second         !! its second half
        real(dp) :: middle
        middle = 0.5_dp*(first%from + first%to)
        second = panel_of(curve, middle, first%to)
        first = panel_of(curve, first%from, middle)
    end subroutine halve

    !> A panel with its points.
    pure type(panel_type) function panel_of(curve, from, to) result(panel)
        class(curve_function_type), intent(in) :: curve !! to sample
        real(dp), intent(in) :: from                    !! parameter where the panel begins
        real(dp), intent(in) :: to                      !! where it ends
        integer :: k

        panel%from = from
        panel%to = to
        do k = 0, degree
            panel%point(:, k) = curve%at(from + (to - from)*abscissa(real(k, dp)))
        end do
    end function panel_of

    !> A Chebyshev point, counted from 0, as a share of its panel: 0 and 1 at the ends.
    elemental real(dp) function abscissa(k)
        real(dp), intent(in) :: k !! 0 to the degree; between whole numbers a point between
        abscissa = sin(0.5_dp*pi*k/real(degree, dp))**2
    end function abscissa

    !> The largest difference between curve and samples, halfway between the samples.
    pure real(dp) function miss(curve, panel)
        class(curve_function_type), intent(in) :: curve !! sampled
        type(panel_type), intent(in) :: panel           !! of it
        real(dp) :: share
        integer :: k

        miss = 0.0_dp
        do k = 1, degree
            share = abscissa(real(k, dp) - 0.5_dp)
            miss = max(miss, norm2(curve%at(panel%from + (panel%to - panel%from)*share) &
                - on_panel(panel, share)))
        end do
    end function miss

    !> The point of the samples.
    pure function sample_at(f, t) result(point)
        class(sampled_type), intent(in) :: f    !! a curve as samples
        real(dp), intent(in) :: t               !! 0 to 1
        real(dp) :: point(3)
        integer :: low, high, middle

        low = 1
        high = size(f%panel) + 1
        do while (high - low > 1)
            middle = (low + high)/2
            if (t < f%panel(middle)%from) then
                high = middle
            else
                low = middle
            end if
        end do
        associate (panel => f%panel(low))
            point = on_panel(panel, (t - panel%from)/(panel%to - panel%from))
        end associate
    end function sample_at

    !> The point of a panel at a share of it.
    pure function on_panel(panel, share) result(point)
        type(panel_type), intent(in) :: panel   !! any
        real(dp), intent(in) :: share           !! 0 to 1
        real(dp) :: point(3), weight, sum_of_weights, off
        integer :: k

        point = 0.0_dp
        sum_of_weights = 0.0_dp
        do k = 0, degree
            off = share - abscissa(real(k, dp))
            if (is_zero(off)) then
                point = panel%point(:, k)
                return
            end if
            weight = merge(1.0_dp, -1.0_dp, mod(k, 2) == 0)/off
            if (k == 0 .or. k == degree) weight = 0.5_dp*weight
            point = point + weight*(panel%point(:, k) - panel%point(:, 0))
            sum_of_weights = sum_of_weights + weight
        end do
        point = panel%point(:, 0) + point/sum_of_weights
    end function on_panel

end module export_drawing_sample
