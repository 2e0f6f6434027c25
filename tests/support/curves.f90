!> Curves with a formula, for tests of what is fitted to curves.
module support_curves
    use base_constants, only: pi
    use base_kinds, only: dp
    use geom_curve_fit, only: curve_function_type
    implicit none (type, external)
    private

    public :: example_type

    !> A curve by its number.
    type, extends(curve_function_type) :: example_type
        integer :: number = 0
    contains
        procedure :: at => example_point
    end type example_type

contains

    !> The curves, some 300 long.
    pure function example_point(f, t) result(point)
        class(example_type), intent(in) :: f    !! which
        real(dp), intent(in) :: t               !! 0 to 1
        real(dp) :: point(3)

        select case (f%number)
        case (1) ! a quarter of an ellipse in space
            point = [150.0_dp*sin(0.5_dp*pi*t), 40.0_dp*cos(0.5_dp*pi*t), 0.1_dp*sin(0.5_dp*pi*t)]
        case (2) ! curvature of 40 in the midst of .0001
            point = [300.0_dp*t, 20.0_dp/(1.0_dp + ((t - 0.37_dp)/1.0e-3_dp)**2), &
                5.0_dp*sin(3.0_dp*t)]
        case (3) ! waves
            point = [300.0_dp*t, 3.0_dp*sin(40.0_dp*pi*t), 2.0_dp*cos(30.0_dp*t)]
        case (4) ! a derivative with a pole at the start
            point = [300.0_dp*t, 50.0_dp*t*sqrt(t), 0.0_dp]
        case (5) ! in a plane
            point = [17.3_dp, 60.0_dp*cos(3.0_dp*t), 60.0_dp*sin(3.0_dp*t)]
        case (6) ! a point
            point = [1.0_dp, 2.0_dp, 3.0_dp]
        case (7) ! a step
            point = [300.0_dp*t, merge(0.0_dp, 1.0_dp, t < 0.3_dp), 0.0_dp]
        case default ! a polynomial of degree 5
            point = [300.0_dp*t, 100.0_dp*t**5 - 20.0_dp*t**2, 10.0_dp*t**3]
        end select
    end function example_point

end module support_curves
