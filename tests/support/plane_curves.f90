!> Curves in a plane for tests of chains of circular arcs.
module support_plane_curves
    use base_constants, only: pi
    use base_kinds, only: dp
    use geom_plane_curve, only: plane_curve_type
    implicit none (type, external)
    private

    public :: example_type

    !> y over x: -x**2, the paper's cubic and its wave, x**3, a circle of 2, an ellipse, a line.
    type, extends(plane_curve_type) :: example_type
        integer :: which = 1                        !! in that order
        real(dp) :: range(2) = [0.0_dp, 1.0_dp]     !! of x, or of the angle
    contains
        procedure :: jet => example_jet
    end type example_type

contains

    !> The point of an example and its derivatives.
    pure subroutine example_jet(f, t, point, first, second)
        class(example_type), intent(in) :: f    !! which
        real(dp), intent(in) :: t               !! 0 to 1
        real(dp), intent(out) :: point(2)       !! x, y
        real(dp), intent(out) :: first(2)       !! first derivative
        real(dp), intent(out) :: second(2)      !! second derivative
        real(dp) :: x, width, axes(2)

        width = f%range(2) - f%range(1)
        x = f%range(1) + t*width
        point(1) = x
        first = [1.0_dp, 0.0_dp]
        second = 0.0_dp
        select case (f%which)
        case (1)
            point(2) = -x**2
            first(2) = -2.0_dp*x
            second(2) = -2.0_dp
        case (2)
            point(2) = 0.1_dp*x*(x**2 - 27.0_dp)
            first(2) = 0.3_dp*x**2 - 2.7_dp
            second(2) = 0.6_dp*x
        case (3)
            call wave(pi*x/3.0_dp, point(2), first(2), second(2))
        case (4)
            point(2) = x**3
            first(2) = 3.0_dp*x**2
            second(2) = 6.0_dp*x
        case (5, 6)
            axes = merge([2.0_dp, 2.0_dp], [3.0_dp, 1.0_dp], f%which == 5)
            point = axes*[cos(x), sin(x)]
            first = axes*[-sin(x), cos(x)]
            second = -point
        case default
            point(2) = 0.5_dp*x
            first(2) = 0.5_dp
        end select
        first = width*first
        second = width**2*second
    end subroutine example_jet

    !> 10 sin(a)/a and its derivatives over x = 3 a/pi; near zero by its series.
    pure subroutine wave(a, y, first, second)
        real(dp), intent(in) :: a           !! angle
        real(dp), intent(out) :: y          !! value
        real(dp), intent(out) :: first      !! dy/dx
        real(dp), intent(out) :: second     !! d2y/dx2
        real(dp) :: s

        s = pi/3.0_dp
        if (abs(a) < 0.02_dp) then
            y = 1.0_dp - a**2/6.0_dp + a**4/120.0_dp - a**6/5040.0_dp
            first = -a/3.0_dp + a**3/30.0_dp - a**5/840.0_dp
            second = -1.0_dp/3.0_dp + a**2/10.0_dp - a**4/168.0_dp
        else
            y = sin(a)/a
            first = (a*cos(a) - sin(a))/a**2
            second = (2.0_dp*sin(a) - 2.0_dp*a*cos(a) - a**2*sin(a))/a**3
        end if
        y = 10.0_dp*y
        first = 10.0_dp*s*first
        second = 10.0_dp*s**2*second
    end subroutine wave

end module support_plane_curves
