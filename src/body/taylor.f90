!> Numbers with their first two derivatives along a way: products and sums carry them along, so that
!> a formula written once gives its own slope and curvature.
!>
!> Source: L. B. Rall, "Automatic Differentiation", LNCS 120, Springer 1981.
module body_taylor
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: taylor_type, operator(+), operator(-), operator(*), cross

    !> A number f(s) at s = 0.
    type :: taylor_type
        real(dp) :: value = 0.0_dp  !! f
        real(dp) :: first = 0.0_dp  !! df/ds
        real(dp) :: second = 0.0_dp !! d2f/ds2
    end type taylor_type

    interface operator(+)
        module procedure sum_of
    end interface operator(+)

    interface operator(-)
        module procedure difference_of
    end interface operator(-)

    interface operator(*)
        module procedure product_of
    end interface operator(*)

contains

    !> `a + b`.
    elemental type(taylor_type) function sum_of(a, b) result(c)
        type(taylor_type), intent(in) :: a !! any
        type(taylor_type), intent(in) :: b !! any
        c = taylor_type(a%value + b%value, a%first + b%first, a%second + b%second)
    end function sum_of

    !> `a - b`.
    elemental type(taylor_type) function difference_of(a, b) result(c)
        type(taylor_type), intent(in) :: a !! any
        type(taylor_type), intent(in) :: b !! any
        c = taylor_type(a%value - b%value, a%first - b%first, a%second - b%second)
    end function difference_of

    !> `a*b`.
    elemental type(taylor_type) function product_of(a, b) result(c)
        type(taylor_type), intent(in) :: a !! any
        type(taylor_type), intent(in) :: b !! any
        c%value = a%value*b%value
        c%first = a%value*b%first + a%first*b%value
        c%second = a%value*b%second + 2.0_dp*a%first*b%first + a%second*b%value
    end function product_of

    !> `u x v`, positive where the second is to the left.
    pure type(taylor_type) function cross(u, v)
        type(taylor_type), intent(in) :: u(2) !! a vector
        type(taylor_type), intent(in) :: v(2) !! another
        cross = u(1)*v(2) - u(2)*v(1)
    end function cross

end module body_taylor
