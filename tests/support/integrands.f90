!> Functions for the tests of quadrature.
module support_integrands
    use base_kinds, only: dp
    use geom_quadrature, only: integrand_type
    implicit none (type, external)
    private

    public :: example_type

    !> t**22
    integer, parameter, public :: power_22 = 1
    !> exp t
    integer, parameter, public :: exponential = 2
    !> 1/(1e-8 + t**2), a peak a ten-thousandth wide
    integer, parameter, public :: peak = 3
    !> sqrt t
    integer, parameter, public :: root = 4
    !> 1/t, which has no integral from 0
    integer, parameter, public :: reciprocal = 5

    !> One of the functions above.
    type, extends(integrand_type) :: example_type
        integer :: which = power_22 !! one of the above
    contains
        procedure :: at
    end type example_type

contains

    !> The value of an example.
    pure real(dp) function at(f, t)
        class(example_type), intent(in) :: f !! which
        real(dp), intent(in) :: t            !! where
        select case (f%which)
        case (power_22)
            at = t**22
        case (exponential)
            at = exp(t)
        case (peak)
            at = 1.0_dp/(1.0e-8_dp + t**2)
        case (root)
            at = sqrt(t)
        case default
            at = 1.0_dp/t
        end select
    end function at

end module support_integrands
