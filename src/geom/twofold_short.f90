!> Rows of twofold numbers (`geom_twofold`): one operation is done on all numbers of a row, in
!> loops that the compiler turns into vector instructions. What takes one number hundreds of
!> cycles, each operation waiting for the one before, takes a number of a row a few dozen.
!>
!> Sums are short: within some 2**-105 of the magnitude of their terms, not of what is left where
!> these cancel. Formulas on rows must not lean on more; those that do take `geom_twofold_same`.
!>
!> Sources: as of `geom_twofold`; the short sum is `add2` of Dekker.
module geom_twofold_short
    use base_kinds, only: dp
    use geom_twofold, only: twofold_type
    implicit none (type, external)
    private

    public :: row_type, row_of, repeated, number_of, exact_row
    public :: square, sqrt, scaled, negative, chosen
    public :: operator(+), operator(-), operator(*), operator(/)

    !> How many numbers a row has: their loops fill vectors, and a dozen rows fit next to the
    !> processor.
    integer, parameter, public :: width = 64

    !> A row of numbers `high + low`.
    type :: row_type
        real(dp) :: high(width) !! the numbers rounded to doubles
        real(dp) :: low(width)  !! what the rounding left over
    end type row_type

    interface operator(+)
        module procedure sum_of_rows, sum_with_number
    end interface operator(+)

    interface operator(-)
        module procedure difference_of_rows
    end interface operator(-)

    interface operator(*)
        module procedure product_of_rows, number_times
    end interface operator(*)

    interface operator(/)
        module procedure quotient_of_rows
    end interface operator(/)

    interface sqrt
        module procedure roots_of
    end interface sqrt

    interface exact_row
        module procedure exact_differences, exact_differences_from
    end interface exact_row

    !> Splits a double into halves whose products are exact (Veltkamp, Dekker).
    real(dp), parameter :: splitter = 2.0_dp**27 + 1.0_dp

contains

    !> Doubles as a row.
    pure type(row_type) function row_of(x) result(row)
        real(dp), intent(in) :: x(width) !! any numbers
        row%high = x
        row%low = 0.0_dp
    end function row_of

    !> One number, as often as a row has room.
    pure type(row_type) function repeated(x) result(row)
        type(twofold_type), intent(in) :: x !! any number
        row%high = x%high
        row%low = x%low
    end function repeated

    !> One of the numbers of a row.
    pure type(twofold_type) function number_of(row, i) result(x)
        type(row_type), intent(in) :: row   !! any
        integer, intent(in) :: i            !! which
        x = twofold_type(row%high(i), row%low(i))
    end function number_of

    !> `-a`.
    pure type(row_type) function negative(a) result(c)
        type(row_type), intent(in) :: a !! any numbers
        c%high = -a%high
        c%low = -a%low
    end function negative

    !> Numbers times powers of two, exactly.
    pure type(row_type) function scaled(power, a) result(c)
        real(dp), intent(in) :: power(width)    !! powers of two
        type(row_type), intent(in) :: a         !! any numbers
        c%high = power*a%high
        c%low = power*a%low
    end function scaled

    !> `x - y`, exactly (Knuth).
    pure type(row_type) function exact_differences(x, y) result(row)
        real(dp), intent(in) :: x(width) !! any numbers
        real(dp), intent(in) :: y(width) !! any numbers
        real(dp) :: part
        integer :: i
        do i = 1, width
            row%high(i) = x(i) - y(i)
            part = row%high(i) - x(i)
            row%low(i) = (x(i) - (row%high(i) - part)) - (y(i) + part)
        end do
    end function exact_differences

    !> `x - y` for one y, exactly.
    pure type(row_type) function exact_differences_from(x, y) result(row)
        real(dp), intent(in) :: x(width) !! any numbers
        real(dp), intent(in) :: y        !! any number
        real(dp) :: part
        integer :: i
        do i = 1, width
            row%high(i) = x(i) - y
            part = row%high(i) - x(i)
            row%low(i) = (x(i) - (row%high(i) - part)) - (y + part)
        end do
    end function exact_differences_from

    !> `a + b`.
    pure type(row_type) function sum_of_rows(a, b) result(c)
        type(row_type), intent(in) :: a !! any numbers
        type(row_type), intent(in) :: b !! any numbers
        real(dp) :: high, part, low
        integer :: i
        do i = 1, width
            high = a%high(i) + b%high(i)
            part = high - a%high(i)
            low = (a%high(i) - (high - part)) + (b%high(i) - part)
            low = low + (a%low(i) + b%low(i))
            c%high(i) = high + low
            c%low(i) = low - (c%high(i) - high)
        end do
    end function sum_of_rows

    !> `a + y` for one y.
    pure type(row_type) function sum_with_number(a, y) result(c)
        type(row_type), intent(in) :: a     !! any numbers
        type(twofold_type), intent(in) :: y !! any number
        real(dp) :: high, part, low
        integer :: i
        do i = 1, width
            high = a%high(i) + y%high
            part = high - a%high(i)
            low = (a%high(i) - (high - part)) + (y%high - part)
            low = low + (a%low(i) + y%low)
            c%high(i) = high + low
            c%low(i) = low - (c%high(i) - high)
        end do
    end function sum_with_number

    !> `a - b`.
    pure type(row_type) function difference_of_rows(a, b) result(c)
        type(row_type), intent(in) :: a !! any numbers
        type(row_type), intent(in) :: b !! any numbers
        real(dp) :: high, part, low
        integer :: i
        do i = 1, width
            high = a%high(i) - b%high(i)
            part = high - a%high(i)
            low = (a%high(i) - (high - part)) - (b%high(i) + part)
            low = low + (a%low(i) - b%low(i))
            c%high(i) = high + low
            c%low(i) = low - (c%high(i) - high)
        end do
    end function difference_of_rows

    !> `a*b`.
    pure type(row_type) function product_of_rows(a, b) result(c)
        type(row_type), intent(in) :: a !! any numbers below 1e290
        type(row_type), intent(in) :: b !! any numbers below 1e290
        real(dp) :: wide, a_head, a_tail, b_head, b_tail, high, low
        integer :: i
        do i = 1, width
            wide = splitter*a%high(i)
            a_head = wide - (wide - a%high(i))
            a_tail = a%high(i) - a_head
            wide = splitter*b%high(i)
            b_head = wide - (wide - b%high(i))
            b_tail = b%high(i) - b_head
            high = a%high(i)*b%high(i)
            low = ((a_head*b_head - high) + a_head*b_tail + a_tail*b_head) + a_tail*b_tail
            low = low + (a%high(i)*b%low(i) + a%low(i)*b%high(i))
            c%high(i) = high + low
            c%low(i) = low - (c%high(i) - high)
        end do
    end function product_of_rows

    !> `x*b` for one x.
    pure type(row_type) function number_times(x, b) result(c)
        type(twofold_type), intent(in) :: x !! any number below 1e290
        type(row_type), intent(in) :: b     !! any numbers below 1e290
        real(dp) :: wide, x_head, x_tail, b_head, b_tail, high, low
        integer :: i
        wide = splitter*x%high
        x_head = wide - (wide - x%high)
        x_tail = x%high - x_head
        do i = 1, width
            wide = splitter*b%high(i)
            b_head = wide - (wide - b%high(i))
            b_tail = b%high(i) - b_head
            high = x%high*b%high(i)
            low = ((x_head*b_head - high) + x_head*b_tail + x_tail*b_head) + x_tail*b_tail
            low = low + (x%high*b%low(i) + x%low*b%high(i))
            c%high(i) = high + low
            c%low(i) = low - (c%high(i) - high)
        end do
    end function number_times

    !> The squares.
    pure type(row_type) function square(a) result(c)
        type(row_type), intent(in) :: a !! any numbers below 1e145
        real(dp) :: wide, head, tail, high, low
        integer :: i
        do i = 1, width
            wide = splitter*a%high(i)
            head = wide - (wide - a%high(i))
            tail = a%high(i) - head
            high = a%high(i)*a%high(i)
            low = ((head*head - high) + 2.0_dp*(head*tail)) + tail*tail
            low = low + 2.0_dp*(a%high(i)*a%low(i))
            c%high(i) = high + low
            c%low(i) = low - (c%high(i) - high)
        end do
    end function square

    !> `a/b`, within some 2**-103.
    pure type(row_type) function quotient_of_rows(a, b) result(c)
        type(row_type), intent(in) :: a !! any numbers below 1e290
        type(row_type), intent(in) :: b !! not zero
        real(dp) :: wide, q_head, q_tail, b_head, b_tail, high, low, first, rest
        integer :: i
        do i = 1, width
            first = a%high(i)/b%high(i)
            wide = splitter*first
            q_head = wide - (wide - first)
            q_tail = first - q_head
            wide = splitter*b%high(i)
            b_head = wide - (wide - b%high(i))
            b_tail = b%high(i) - b_head
            high = first*b%high(i)
            low = ((q_head*b_head - high) + q_head*b_tail + q_tail*b_head) + q_tail*b_tail
            rest = (a%high(i) - high) - low + (a%low(i) - first*b%low(i))
            rest = rest/b%high(i)
            c%high(i) = first + rest
            c%low(i) = rest - (c%high(i) - first)
        end do
    end function quotient_of_rows

    !> The square roots, by one step of Newton's from the nearest doubles; zero for what is below.
    pure type(row_type) function roots_of(a) result(c)
        type(row_type), intent(in) :: a !! any numbers
        real(dp) :: wide, head, tail, high, low, first, rest, under
        integer :: i
        do i = 1, width
            under = max(a%high(i), tiny(1.0_dp))
            first = sqrt(under)
            wide = splitter*first
            head = wide - (wide - first)
            tail = first - head
            high = first*first
            low = ((head*head - high) + 2.0_dp*(head*tail)) + tail*tail
            rest = ((under - high) - low + a%low(i))/(2.0_dp*first)
            high = first + rest
            c%high(i) = merge(high, 0.0_dp, a%high(i) > 0.0_dp)
            c%low(i) = merge(rest - (high - first), 0.0_dp, a%high(i) > 0.0_dp)
        end do
    end function roots_of

    !> The numbers of one row or another.
    pure type(row_type) function chosen(first, second, is_first) result(c)
        type(row_type), intent(in) :: first     !! taken where `is_first`
        type(row_type), intent(in) :: second    !! taken elsewhere
        logical, intent(in) :: is_first(width)  !! which
        integer :: i
        do i = 1, width
            c%high(i) = merge(first%high(i), second%high(i), is_first(i))
            c%low(i) = merge(first%low(i), second%low(i), is_first(i))
        end do
    end function chosen

end module geom_twofold_short
