!> Rows of numbers with their first two derivatives along a way (`body_taylor`): one operation is
!> done on all numbers of a row, in loops that the compiler turns into vector instructions.
module body_taylor_row
    use base_kinds, only: dp
    use geom_twofold_short, only: width
    implicit none (type, external)
    private

    public :: taylor_row_type, operator(-), operator(*), cross

    !> Numbers f(s) at s = 0.
    type :: taylor_row_type
        real(dp) :: value(width)    !! f
        real(dp) :: first(width)    !! df/ds
        real(dp) :: second(width)   !! d2f/ds2
    end type taylor_row_type

    interface operator(-)
        module procedure difference_of
    end interface operator(-)

    interface operator(*)
        module procedure product_of
    end interface operator(*)

contains

    !> `a - b`.
    pure type(taylor_row_type) function difference_of(a, b) result(c)
        type(taylor_row_type), intent(in) :: a !! any
        type(taylor_row_type), intent(in) :: b !! any
        c%value = a%value - b%value
        c%first = a%first - b%first
        c%second = a%second - b%second
    end function difference_of

    !> `a*b`.
    pure type(taylor_row_type) function product_of(a, b) result(c)
        type(taylor_row_type), intent(in) :: a !! any
        type(taylor_row_type), intent(in) :: b !! any
        c%value = a%value*b%value
        c%first = a%value*b%first + a%first*b%value
        c%second = a%value*b%second + 2.0_dp*a%first*b%first + a%second*b%value
    end function product_of

    !> `u x v`, positive where the second is to the left.
    pure type(taylor_row_type) function cross(u, v)
        type(taylor_row_type), intent(in) :: u(2) !! vectors
        type(taylor_row_type), intent(in) :: v(2) !! others
        cross = u(1)*v(2) - u(2)*v(1)
    end function cross

end module body_taylor_row
