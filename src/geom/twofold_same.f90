!> Twofold numbers of many rows side by side, the same as alone: each operation is that of
!> `geom_twofold` done for all rows in one loop, in the same order, so that every row has the bits
!> that `geom_twofold` gives it. Where sums may be shorter, `geom_twofold_short` is faster.
module geom_twofold_same
    use base_kinds, only: dp
    use geom_twofold, only: twofold_type
    implicit none (type, external)
    private

    public :: rows_type, exact_difference, to_real, selected
    public :: operator(+), operator(-), operator(*), operator(/), sqrt

    !> Rows that are worked side by side: even, for vectors of two, and few enough to stay at hand.
    integer, parameter, public :: rows_at_once = 12

    !> The numbers `high + low`.
    type :: rows_type
        real(dp) :: high(rows_at_once) !! each number rounded to a double
        real(dp) :: low(rows_at_once)  !! what the rounding left over
    end type rows_type

    interface operator(+)
        module procedure sum_of, sum_to_twofold
    end interface operator(+)

    interface operator(-)
        module procedure difference_of, difference_from_twofold, negative_of
    end interface operator(-)

    interface operator(*)
        module procedure product_of, product_with_twofold, twofold_times, real_times
    end interface operator(*)

    interface operator(/)
        module procedure quotient_of
    end interface operator(/)

    interface sqrt
        module procedure root_of
    end interface sqrt

    interface to_real
        module procedure rows_to_real
    end interface to_real

contains

    !> The doubles nearest to the numbers.
    pure function rows_to_real(a) result(x)
        type(rows_type), intent(in) :: a !! any numbers
        real(dp) :: x(rows_at_once)
        x = a%high + a%low
    end function rows_to_real

    !> The first number in the rows that are marked, the second in the others.
    pure type(rows_type) function selected(a, b, mark) result(c)
        type(rows_type), intent(in) :: a         !! any numbers
        type(rows_type), intent(in) :: b         !! any numbers
        logical, intent(in) :: mark(rows_at_once) !! where the first is taken
        c%high = merge(a%high, b%high, mark)
        c%low = merge(a%low, b%low, mark)
    end function selected

    !> The differences of doubles, exactly.
    pure type(rows_type) function exact_difference(x, y) result(d)
        real(dp), intent(in) :: x(rows_at_once) !! any numbers
        real(dp), intent(in) :: y(rows_at_once) !! any numbers
        real(dp) :: part
        integer :: i
        do i = 1, rows_at_once
            d%high(i) = x(i) - y(i)
            part = d%high(i) - x(i)
            d%low(i) = (x(i) - (d%high(i) - part)) + (-y(i) - part)
        end do
    end function exact_difference

    !> `a + b`.
    pure type(rows_type) function sum_of(a, b) result(c)
        type(rows_type), intent(in) :: a !! any numbers
        type(rows_type), intent(in) :: b !! any numbers
        call add(a%high, a%low, b%high, b%low, c%high, c%low)
    end function sum_of

    !> `y + b`.
    pure type(rows_type) function sum_to_twofold(y, b) result(c)
        type(twofold_type), intent(in) :: y !! the same in all rows
        type(rows_type), intent(in) :: b    !! any numbers
        call add(y%high, y%low, b%high, b%low, c%high, c%low)
    end function sum_to_twofold

    !> `a - b`.
    pure type(rows_type) function difference_of(a, b) result(c)
        type(rows_type), intent(in) :: a !! any numbers
        type(rows_type), intent(in) :: b !! any numbers
        call add(a%high, a%low, -b%high, -b%low, c%high, c%low)
    end function difference_of

    !> `y - b`.
    pure type(rows_type) function difference_from_twofold(y, b) result(c)
        type(twofold_type), intent(in) :: y !! the same in all rows
        type(rows_type), intent(in) :: b    !! any numbers
        call add(y%high, y%low, -b%high, -b%low, c%high, c%low)
    end function difference_from_twofold

    !> `-a`.
    pure type(rows_type) function negative_of(a) result(c)
        type(rows_type), intent(in) :: a !! any numbers
        c%high = -a%high
        c%low = -a%low
    end function negative_of

    !> `a*b`.
    pure type(rows_type) function product_of(a, b) result(c)
        type(rows_type), intent(in) :: a !! any numbers
        type(rows_type), intent(in) :: b !! any numbers
        call multiply(a%high, a%low, b%high, b%low, c%high, c%low)
    end function product_of

    !> `a*y`.
    pure type(rows_type) function product_with_twofold(a, y) result(c)
        type(rows_type), intent(in) :: a    !! any numbers
        type(twofold_type), intent(in) :: y !! the same in all rows
        call multiply(a%high, a%low, y%high, y%low, c%high, c%low)
    end function product_with_twofold

    !> `y*b`.
    pure type(rows_type) function twofold_times(y, b) result(c)
        type(twofold_type), intent(in) :: y !! the same in all rows
        type(rows_type), intent(in) :: b    !! any numbers
        call multiply(y%high, y%low, b%high, b%low, c%high, c%low)
    end function twofold_times

    !> `x*b`; exact where `x` is a power of two.
    pure type(rows_type) function real_times(x, b) result(c)
        real(dp), intent(in) :: x        !! the same in all rows
        type(rows_type), intent(in) :: b !! any numbers
        call multiply_real(x, b%high, b%low, c%high, c%low)
    end function real_times

    !> `a/b`.
    pure type(rows_type) function quotient_of(a, b) result(c)
        type(rows_type), intent(in) :: a !! any numbers
        type(rows_type), intent(in) :: b !! any numbers but zero
        type(rows_type) :: part, rest
        real(dp), dimension(rows_at_once) :: first, second
        integer :: i
        first = a%high/b%high
        call multiply_real(first, b%high, b%low, part%high, part%low)
        rest = a - part
        second = rest%high/b%high
        call multiply_real(second, b%high, b%low, part%high, part%low)
        rest = rest - part
        do i = 1, rows_at_once
            part%high(i) = first(i) + second(i)
            part%low(i) = second(i) - (part%high(i) - first(i))
        end do
        call add(part%high, part%low, rest%high/b%high, 0.0_dp, c%high, c%low)
    end function quotient_of

    !> The square roots; zero of what is not positive.
    pure type(rows_type) function root_of(a) result(c)
        type(rows_type), intent(in) :: a !! any numbers
        type(rows_type) :: square, rest
        real(dp), dimension(rows_at_once) :: first, second
        integer :: i
        first = sqrt(max(a%high, 0.0_dp))
        do i = 1, rows_at_once
            square%high(i) = first(i)*first(i)
            square%low(i) = rest_of_product(first(i), first(i), square%high(i))
        end do
        rest = a - square
        second = rest%high/merge(2.0_dp*first, 1.0_dp, a%high > 0.0_dp)
        do i = 1, rows_at_once
            c%high(i) = first(i) + second(i)
            c%low(i) = second(i) - (c%high(i) - first(i))
        end do
        where (.not. a%high > 0.0_dp)
            c%high = 0.0_dp
            c%low = 0.0_dp
        end where
    end function root_of

    !> The sum of two numbers.
    elemental subroutine add(a_high, a_low, b_high, b_low, high, low)
        real(dp), intent(in) :: a_high  !! of any number
        real(dp), intent(in) :: a_low   !! its rest
        real(dp), intent(in) :: b_high  !! of any number
        real(dp), intent(in) :: b_low   !! its rest
        real(dp), intent(out) :: high   !! of the sum
        real(dp), intent(out) :: low    !! its rest
        real(dp) :: part, head, head_rest, tail, tail_rest, sum

        head = a_high + b_high
        part = head - a_high
        head_rest = (a_high - (head - part)) + (b_high - part)
        tail = a_low + b_low
        part = tail - a_low
        tail_rest = (a_low - (tail - part)) + (b_low - part)
        head_rest = head_rest + tail
        sum = head + head_rest
        head_rest = head_rest - (sum - head)
        tail_rest = head_rest + tail_rest
        high = sum + tail_rest
        low = tail_rest - (high - sum)
    end subroutine add

    !> The product of two numbers.
    elemental subroutine multiply(a_high, a_low, b_high, b_low, high, low)
        real(dp), intent(in) :: a_high  !! of any number
        real(dp), intent(in) :: a_low   !! its rest
        real(dp), intent(in) :: b_high  !! of any number
        real(dp), intent(in) :: b_low   !! its rest
        real(dp), intent(out) :: high   !! of the product
        real(dp), intent(out) :: low    !! its rest
        real(dp) :: product, rest

        product = a_high*b_high
        rest = rest_of_product(a_high, b_high, product) + (a_high*b_low + a_low*b_high)
        high = product + rest
        low = rest - (high - product)
    end subroutine multiply

    !> The product of a double and a number.
    elemental subroutine multiply_real(x, b_high, b_low, high, low)
        real(dp), intent(in) :: x       !! any number
        real(dp), intent(in) :: b_high  !! of any number
        real(dp), intent(in) :: b_low   !! its rest
        real(dp), intent(out) :: high   !! of the product
        real(dp), intent(out) :: low    !! its rest
        real(dp) :: product, rest

        product = x*b_high
        rest = rest_of_product(x, b_high, product) + x*b_low
        high = product + rest
        low = rest - (high - product)
    end subroutine multiply_real

    !> What the rounding of a product left over (Veltkamp, Dekker).
    elemental real(dp) function rest_of_product(x, y, product) result(rest)
        real(dp), intent(in) :: x       !! any number below 1e290
        real(dp), intent(in) :: y       !! any number below 1e290
        real(dp), intent(in) :: product !! of the two, rounded
        real(dp), parameter :: splitter = 2.0_dp**27 + 1.0_dp
        real(dp) :: x_head, x_tail, y_head, y_tail
        x_head = splitter*x - (splitter*x - x)
        x_tail = x - x_head
        y_head = splitter*y - (splitter*y - y)
        y_tail = y - y_head
        rest = ((x_head*y_head - product) + x_head*y_tail + x_tail*y_head) + x_tail*y_tail
    end function rest_of_product

end module geom_twofold_same
