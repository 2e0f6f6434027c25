!> Pairs of products of rows of twofold numbers against real128.
program test_twofold_pair
    use, intrinsic :: iso_fortran_env, only: real128
    use base_kinds, only: dp
    use geom_twofold, only: twofold_type
    use geom_twofold_pair, only: cross, product_and_multiple
    use geom_twofold_short, only: exact_row, operator(*), row_of, row_type, width
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    integer, parameter :: qp = real128
    real(dp), parameter :: few = 2.0_dp**(-101)
    type(tap_type) :: tap
    type(random_type) :: random
    type(row_type) :: u(2), v(2), c
    type(twofold_type) :: x
    real(qp) :: first(width), second(width)
    real(dp) :: worst(2)
    integer :: k

    x = twofold_type(-0.3_dp, 1.0e-18_dp)
    worst = 0.0_dp
    do k = 1, 200
        u = [some(), some()]
        v = [some(), some()]
        first = wide(u(1))*wide(v(2))
        second = wide(u(2))*wide(v(1))
        c = cross(u, v)
        worst(1) = max(worst(1), part(wide(c) - (first - second), first, second))
        second = (real(x%high, qp) + real(x%low, qp))*wide(v(1))
        c = product_and_multiple(u(1), v(2), x, v(1))
        worst(2) = max(worst(2), part(wide(c) - (first + second), first, second))
    end do
    call tap%near(worst(1), 0.0_dp, few, 'cross products are right to 101 bits of their terms')
    call tap%near(worst(2), 0.0_dp, few, 'so are products and multiples')
    c = cross(u, u)
    call tap%ok(all(c%high == 0.0_dp) .and. all(c%low == 0.0_dp), 'u x u is zero')
    call tap%finish()

contains

    !> Numbers of both signs and many magnitudes that fill twofold ones.
    type(row_type) function some()
        real(dp) :: first(width), second(width)
        integer :: i
        do i = 1, width
            first(i) = random%sign()*10.0_dp**random%between(-9.0_dp, 9.0_dp)
            second(i) = random%sign()*10.0_dp**random%between(-9.0_dp, 9.0_dp)
        end do
        some = row_of(first)*exact_row(second, 0.1_dp)
    end function some

    !> The numbers of a row.
    pure function wide(row)
        type(row_type), intent(in) :: row
        real(qp) :: wide(width)
        wide = real(row%high, qp) + real(row%low, qp)
    end function wide

    !> The largest error as a part of the two products.
    pure real(dp) function part(error, first, second)
        real(qp), intent(in) :: error(width), first(width), second(width)
        part = real(maxval(abs(error)/(abs(first) + abs(second))), dp)
    end function part

end program test_twofold_pair
