!> Functions for the tests whose zeros are chosen.
module support_polynomial
    use base_kinds, only: dp
    use geom_zeros, only: function_type
    implicit none (type, external)
    private

    public :: product_type

    !> The product of x less each zero, less a level.
    type, extends(function_type) :: product_type
        real(dp), allocatable :: zero(:)    !! in any order
        real(dp) :: level = 0.0_dp          !! taken off
    contains
        procedure :: at
    end type product_type

contains

    !> The value.
    pure real(dp) function at(f, x)
        class(product_type), intent(in) :: f !! the function
        real(dp), intent(in) :: x            !! where
        at = product(x - f%zero) - f%level
    end function at

end module support_polynomial
