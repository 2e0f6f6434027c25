!> Two products of rows of twofold numbers (`geom_twofold_short`) and their sum or difference, done
!> as one operation: half of what the three take one after another goes into carrying their terms
!> to memory and back.
!>
!> Sources: as of `geom_twofold_short`.
module geom_twofold_pair
    use base_kinds, only: dp
    use geom_twofold, only: twofold_type
    use geom_twofold_short, only: row_type, width
    implicit none (type, external)
    private

    public :: cross, product_and_multiple

    !> Splits a double into halves whose products are exact (Veltkamp, Dekker).
    real(dp), parameter :: splitter = 2.0_dp**27 + 1.0_dp

contains

    !> `u x v`.
    pure type(row_type) function cross(u, v) result(c)
        type(row_type), intent(in) :: u(2) !! vectors of numbers below 1e290
        type(row_type), intent(in) :: v(2) !! others
        real(dp) :: wide, u_head, u_tail, v_head, v_tail, first, second, high, part, low
        integer :: i
        do i = 1, width
            wide = splitter*u(1)%high(i)
            u_head = wide - (wide - u(1)%high(i))
            u_tail = u(1)%high(i) - u_head
            wide = splitter*v(2)%high(i)
            v_head = wide - (wide - v(2)%high(i))
            v_tail = v(2)%high(i) - v_head
            first = u(1)%high(i)*v(2)%high(i)
            low = ((u_head*v_head - first) + u_head*v_tail + u_tail*v_head) + u_tail*v_tail
            low = low + (u(1)%high(i)*v(2)%low(i) + u(1)%low(i)*v(2)%high(i))
            wide = splitter*u(2)%high(i)
            u_head = wide - (wide - u(2)%high(i))
            u_tail = u(2)%high(i) - u_head
            wide = splitter*v(1)%high(i)
            v_head = wide - (wide - v(1)%high(i))
            v_tail = v(1)%high(i) - v_head
            second = u(2)%high(i)*v(1)%high(i)
            low = low - (((u_head*v_head - second) + u_head*v_tail + u_tail*v_head) &
                + u_tail*v_tail + (u(2)%high(i)*v(1)%low(i) + u(2)%low(i)*v(1)%high(i)))
            high = first - second
            part = high - first
            low = ((first - (high - part)) - (second + part)) + low
            c%high(i) = high + low
            c%low(i) = low - (c%high(i) - high)
        end do
    end function cross

    !> `a*b + x*c` for one x.
    pure type(row_type) function product_and_multiple(a, b, x, c) result(d)
        type(row_type), intent(in) :: a     !! any numbers below 1e290
        type(row_type), intent(in) :: b     !! any numbers below 1e290
        type(twofold_type), intent(in) :: x !! any number below 1e290
        type(row_type), intent(in) :: c     !! any numbers below 1e290
        real(dp) :: wide, a_head, a_tail, b_head, b_tail, x_head, x_tail
        real(dp) :: first, second, high, part, low
        integer :: i
        wide = splitter*x%high
        x_head = wide - (wide - x%high)
        x_tail = x%high - x_head
        do i = 1, width
            wide = splitter*a%high(i)
            a_head = wide - (wide - a%high(i))
            a_tail = a%high(i) - a_head
            wide = splitter*b%high(i)
            b_head = wide - (wide - b%high(i))
            b_tail = b%high(i) - b_head
            first = a%high(i)*b%high(i)
            low = ((a_head*b_head - first) + a_head*b_tail + a_tail*b_head) + a_tail*b_tail
            low = low + (a%high(i)*b%low(i) + a%low(i)*b%high(i))
            wide = splitter*c%high(i)
            b_head = wide - (wide - c%high(i))
            b_tail = c%high(i) - b_head
            second = x%high*c%high(i)
            low = low + (((x_head*b_head - second) + x_head*b_tail + x_tail*b_head) &
                + x_tail*b_tail + (x%high*c%low(i) + x%low*c%high(i)))
            high = first + second
            part = high - first
            low = ((first - (high - part)) + (second - part)) + low
            d%high(i) = high + low
            d%low(i) = low - (d%high(i) - high)
        end do
    end function product_and_multiple

end module geom_twofold_pair
