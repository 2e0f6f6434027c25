!> Exact comparisons of reals, each meant as written. The rest of LOFT compares reals for equality
!> only through this module (`make lint` looks for others).
module base_exact
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: is_zero, is_equal, is_finite

contains

    !> True where a number is zero, of either sign, and not merely small.
    elemental logical function is_zero(x)
        real(dp), intent(in) :: x !! any number
        is_zero = x == 0.0_dp
    end function is_zero

    !> True where two numbers are the same number (zeros of either sign are one).
    elemental logical function is_equal(x, y)
        real(dp), intent(in) :: x !! any number
        real(dp), intent(in) :: y !! any number
        is_equal = x == y
    end function is_equal

    !> True for a number that is neither infinite nor NaN.
    elemental logical function is_finite(x)
        real(dp), intent(in) :: x !! any number
        is_finite = ieee_is_finite(x)
    end function is_finite

end module base_exact
