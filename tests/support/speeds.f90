!> Speeds along curves, for the tests of points at given lengths.
module support_speeds
    use base_kinds, only: dp
    use geom_quadrature, only: integrand_type
    implicit none (type, external)
    private

    public :: speed_type

    !> Speeds along t.
    type, extends(integrand_type) :: speed_type
        integer :: kind = 1     !! 1: of y = t**2, 2: zero at both ends, 3: a corner at .3
    contains
        procedure :: at => speed_at
    end type speed_type

contains

    !> The speed at t.
    pure real(dp) function speed_at(f, t) result(speed)
        class(speed_type), intent(in) :: f
        real(dp), intent(in) :: t
        real(dp), parameter :: pi = acos(-1.0_dp)
        select case (f%kind)
        case (1)
            speed = sqrt(1.0_dp + 4.0_dp*t**2)
        case (2)
            speed = 0.5_dp*pi*sin(pi*t)
        case default
            speed = merge(1.0_dp, 2.0_dp, t < 0.3_dp)
        end select
    end function speed_at

end module support_speeds
