!> Sides of a patch over the unit square that has a hump.
module support_hump
    use base_kinds, only: dp
    use geom_curve_fit, only: curve_function_type
    implicit none (type, external)
    private

    public :: hump_type

    !> Sides of a hump over the unit square, WL above it bent on each side in its own way.
    type, extends(curve_function_type) :: hump_type
        integer :: side = 1 !! which
    contains
        procedure :: at
    end type hump_type

contains

    !> The point of a side.
    pure function at(f, t) result(point)
        class(hump_type), intent(in) :: f   !! the side
        real(dp), intent(in) :: t           !! 0 to 1
        real(dp) :: point(3)
        select case (f%side)
        case (1)
            point = [t, 0.0_dp, sin(3.0_dp*t)]
        case (2)
            point = [1.0_dp, t, sin(3.0_dp) + exp(t) - 1.0_dp]
        case (3)
            point = [t, 1.0_dp, 0.5_dp*t*(1.0_dp - t) + t*(sin(3.0_dp) + exp(1.0_dp) - 1.0_dp)]
        case default
            point = [0.2_dp*t*(1.0_dp - t), t, 2.0_dp*t*(1.0_dp - t)/(1.0_dp + t)]
        end select
    end function at

end module support_hump
