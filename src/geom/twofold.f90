!> Numbers of twice the working precision, each the unevaluated sum of two doubles (32 figures).
!> The control points of a card are doubles that are taken as exact; differences and products of
!> them are formed here without loss and rounded once, at the end.
!>
!> Sources: T. J. Dekker, "A floating-point technique for extending the available precision",
!> Numer. Math. 18 (1971), pp. 224-242 (split, product, quotient, root); D. E. Knuth, "The Art of
!> Computer Programming", vol. 2, 3rd ed., 4.2.2, theorem B (sum). No fused multiply-add is used;
!> the compiler must not reorder sums (`-ffp-contract=off`, no `-ffast-math`).
!> Magnitudes must stay below some 1e290, above which the split overflows.
module geom_twofold
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: twofold_type, twofold, exact_sum, exact_difference, exact_product, to_real
    public :: operator(+), operator(-), operator(*), operator(/), sqrt

    !> The number `high + low`, `high` being the double nearest to it.
    type :: twofold_type
        real(dp) :: high = 0.0_dp !! the number rounded to a double
        real(dp) :: low = 0.0_dp  !! what the rounding left over
    end type twofold_type

    interface operator(+)
        module procedure sum_of, sum_with_real
    end interface operator(+)

    interface operator(-)
        module procedure difference_of, difference_with_real, negative_of
    end interface operator(-)

    interface operator(*)
        module procedure product_of, real_times
    end interface operator(*)

    interface operator(/)
        module procedure quotient_of
    end interface operator(/)

    interface sqrt
        module procedure root_of
    end interface sqrt

    interface to_real
        module procedure twofold_to_real
    end interface to_real

contains

    !> A double as a twofold number.
    elemental type(twofold_type) function twofold(x)
        real(dp), intent(in) :: x !! any number
        twofold = twofold_type(x, 0.0_dp)
    end function twofold

    !> The double nearest to a twofold number.
    elemental real(dp) function twofold_to_real(a) result(x)
        type(twofold_type), intent(in) :: a !! any number
        x = a%high + a%low
    end function twofold_to_real

    !> The sum of two doubles, exactly (Knuth).
    elemental type(twofold_type) function exact_sum(x, y) result(s)
        real(dp), intent(in) :: x !! any number
        real(dp), intent(in) :: y !! any number
        real(dp) :: part
        s%high = x + y
        part = s%high - x
        s%low = (x - (s%high - part)) + (y - part)
    end function exact_sum

    !> The sum of two doubles, the first not the smaller, exactly (Dekker).
    elemental type(twofold_type) function ordered_sum(x, y) result(s)
        real(dp), intent(in) :: x !! the larger in magnitude, or zero where both are
        real(dp), intent(in) :: y !! the smaller
        s%high = x + y
        s%low = y - (s%high - x)
    end function ordered_sum

    !> The difference of two doubles, exactly.
    elemental type(twofold_type) function exact_difference(x, y) result(d)
        real(dp), intent(in) :: x !! any number
        real(dp), intent(in) :: y !! any number
        d = exact_sum(x, -y)
    end function exact_difference

    !> The product of two doubles, exactly unless its low part underflows (Dekker).
    elemental type(twofold_type) function exact_product(x, y) result(p)
        real(dp), intent(in) :: x !! any number
        real(dp), intent(in) :: y !! any number
        real(dp) :: x_head, x_tail, y_head, y_tail
        call split(x, x_head, x_tail)
        call split(y, y_head, y_tail)
        p%high = x*y
        p%low = ((x_head*y_head - p%high) + x_head*y_tail + x_tail*y_head) + x_tail*y_tail
    end function exact_product

    !> Parts of 26 bits each, whose products are exact (Veltkamp, Dekker).
    elemental subroutine split(x, head, tail)
        real(dp), intent(in) :: x     !! any number below 1e290
        real(dp), intent(out) :: head !! its upper half
        real(dp), intent(out) :: tail !! the rest
        real(dp), parameter :: splitter = 2.0_dp**27 + 1.0_dp
        real(dp) :: wide
        wide = splitter*x
        head = wide - (wide - x)
        tail = x - head
    end subroutine split

    !> `a + b`, within some 2**-104 of itself also where the terms cancel.
    elemental type(twofold_type) function sum_of(a, b) result(c)
        type(twofold_type), intent(in) :: a !! any number
        type(twofold_type), intent(in) :: b !! any number
        type(twofold_type) :: heads, tails
        heads = exact_sum(a%high, b%high)
        tails = exact_sum(a%low, b%low)
        c = ordered_sum(heads%high, heads%low + tails%high)
        c = ordered_sum(c%high, c%low + tails%low)
    end function sum_of

    !> `a + y`.
    elemental type(twofold_type) function sum_with_real(a, y) result(c)
        type(twofold_type), intent(in) :: a !! any number
        real(dp), intent(in) :: y           !! any number
        c = exact_sum(a%high, y)
        c = ordered_sum(c%high, c%low + a%low)
    end function sum_with_real

    !> `a - b`.
    elemental type(twofold_type) function difference_of(a, b) result(c)
        type(twofold_type), intent(in) :: a !! any number
        type(twofold_type), intent(in) :: b !! any number
        c = a + negative_of(b)
    end function difference_of

    !> `a - y`.
    elemental type(twofold_type) function difference_with_real(a, y) result(c)
        type(twofold_type), intent(in) :: a !! any number
        real(dp), intent(in) :: y           !! any number
        c = sum_with_real(a, -y)
    end function difference_with_real

    !> `-a`.
    elemental type(twofold_type) function negative_of(a) result(c)
        type(twofold_type), intent(in) :: a !! any number
        c = twofold_type(-a%high, -a%low)
    end function negative_of

    !> `a*b`.
    elemental type(twofold_type) function product_of(a, b) result(c)
        type(twofold_type), intent(in) :: a !! any number
        type(twofold_type), intent(in) :: b !! any number
        c = exact_product(a%high, b%high)
        c = ordered_sum(c%high, c%low + (a%high*b%low + a%low*b%high))
    end function product_of

    !> `x*b`; exact where `x` is a power of two.
    elemental type(twofold_type) function real_times(x, b) result(c)
        real(dp), intent(in) :: x           !! any number
        type(twofold_type), intent(in) :: b !! any number
        c = exact_product(x, b%high)
        c = ordered_sum(c%high, c%low + x*b%low)
    end function real_times

    !> `a/b`.
    elemental type(twofold_type) function quotient_of(a, b) result(c)
        type(twofold_type), intent(in) :: a !! any number
        type(twofold_type), intent(in) :: b !! any number but zero
        type(twofold_type) :: rest
        real(dp) :: first, second
        first = a%high/b%high
        rest = a - real_times(first, b)
        second = rest%high/b%high
        rest = rest - real_times(second, b)
        c = ordered_sum(first, second) + rest%high/b%high
    end function quotient_of

    !> The square root, by one step of Newton from the double nearest to it.
    elemental type(twofold_type) function root_of(a) result(c)
        type(twofold_type), intent(in) :: a !! zero or positive
        type(twofold_type) :: rest
        real(dp) :: first
        if (.not. a%high > 0.0_dp) return
        first = sqrt(a%high)
        rest = a - exact_product(first, first)
        c = ordered_sum(first, rest%high/(2.0_dp*first))
    end function root_of

end module geom_twofold
