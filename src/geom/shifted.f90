!> The conic of a card as the 1970 program set it up, `A x**2 + B x y + C y**2 + D x + E y = -1`,
!> with the origin shifted so that no point is near it, but solved by LAPACK: a check on the arc,
!> and on what the shift does to the condition.
!>
!> Source: SAE 700202, "Determining aircraft contours by computer", appendix A: three rows
!> `x**2, x y, y**2, x, y, -1` for the points, two rows `2 x, y + s x, 2 s y, 1, s, 0` for the
!> slopes. For a vertical tangent the slope row is its limit on division by s, `0, x, 2 y, 0, 1, 0`.
module geom_shifted
    use base_error, only: error_type
    use base_kinds, only: dp, i128
    use geom_arc, only: arc_type, end_type
    use geom_square_system, only: solve
    use geom_twofold, only: operator(*), operator(+), twofold, twofold_type
    use geom_twofold_same, only: operator(*), operator(+), operator(-), rows_at_once, rows_type, &
        to_real
    implicit none (type, external)
    private

    public :: shifted_type, solve_shifted, difference_from

    !> A conic in the shifted frame.
    type :: shifted_type
        real(dp) :: shift = 0.0_dp          !! added to every x and y, deck units
        real(dp) :: coefficient(5) = 0.0_dp !! A to E in the shifted frame
        real(dp) :: rcond = 0.0_dp          !! reciprocal condition of the system, equilibrated
    end type shifted_type

    !> Places of an arc at which it is compared: its ends, and between them those of the parameters
    !> 1/24 to 23/24, rounded to doubles, the last of them twice to fill its rows.
    integer, parameter :: compared = 26, inner = compared - 2

contains

    !> Solves the five equations of a card in a shifted frame.
    !> Fails with `cause%singular`.
    pure subroutine solve_shifted(start, shoulder, finish, shift, conic, error)
        type(end_type), intent(in) :: start                 !! first point and its tangent
        real(dp), intent(in) :: shoulder(2)                 !! shoulder point, deck units
        type(end_type), intent(in) :: finish                !! last point and its tangent
        real(dp), intent(in) :: shift                       !! added to every x and y, deck units
        type(shifted_type), intent(out) :: conic            !! the conic
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: matrix(5, 5)

        conic%shift = shift
        matrix(1, :) = point_row(start%point + shift)
        matrix(2, :) = point_row(shoulder + shift)
        matrix(3, :) = point_row(finish%point + shift)
        matrix(4, :) = tangent_row(start%point + shift, start%tangent)
        matrix(5, :) = tangent_row(finish%point + shift, finish%tangent)
        call solve(matrix, [-1.0_dp, -1.0_dp, -1.0_dp, 0.0_dp, 0.0_dp], conic%coefficient, &
            conic%rcond, error)
    end subroutine solve_shifted

    !> The row of a point on the conic.
    pure function point_row(p) result(row)
        real(dp), intent(in) :: p(2) !! x and y in the shifted frame
        real(dp) :: row(5)
        row = [p(1)**2, p(1)*p(2), p(2)**2, p(1), p(2)]
    end function point_row

    !> The row of a tangent: the derivative of the point row along it, times dy/dx's denominator.
    pure function tangent_row(p, tangent) result(row)
        real(dp), intent(in) :: p(2)       !! x and y in the shifted frame
        real(dp), intent(in) :: tangent(2) !! direction, `1, s` or `0, 1`
        real(dp) :: row(5)
        row = tangent(1)*[2.0_dp*p(1), p(2), 0.0_dp, 1.0_dp, 0.0_dp] &
            + tangent(2)*[0.0_dp, p(1), 2.0_dp*p(2), 0.0_dp, 1.0_dp]
    end function tangent_row

    !> The largest distance, to first order, of places of an arc from a shifted conic, deck units.
    pure real(dp) function difference_from(conic, arc) result(largest)
        type(shifted_type), intent(in) :: conic !! the conic of the same card
        type(arc_type), intent(in) :: arc       !! the arc
        real(dp), dimension(compared) :: x, y
        integer :: first

        x(inner + 1:) = [arc%start(1), arc%finish(1)]
        y(inner + 1:) = [arc%start(2), arc%finish(2)]
        do first = 1, inner, rows_at_once
            call put_points(arc, first, x(first:first + rows_at_once - 1), &
                y(first:first + rows_at_once - 1))
        end do
        largest = largest_distance(conic, x, y)
    end function difference_from

    !> The points of an arc at some of the inner places, `m + (2 a b g + (b**2 - a**2) h)/D` as in
    !> `geom_arc`, deck units. All that does not depend on the arc is worked by the compiler, with
    !> the shares b = t and a = 1 - t as whole numbers of 2**-57, which they are exactly.
    pure subroutine put_points(arc, first, x, y)
        type(arc_type), intent(in) :: arc           !! any arc
        integer, intent(in) :: first                !! the first place
        real(dp), intent(out) :: x(rows_at_once)    !! of this place and those behind it
        real(dp), intent(out) :: y(rows_at_once)    !! so too
        integer :: i
        integer, parameter :: bits = 57
        integer(i128), parameter :: b(inner) = [(int(2.0_dp**bits*(real(min(i, inner - 1), dp)/ &
            real(inner, dp)), i128), i=1, inner)], a(inner) = 2_i128**bits - b
        ! 2 a b, b**2 - a**2 = b - a, and (b - a)**2, in units of 2**-114.
        integer(i128), parameter :: share(inner, 3) = reshape([2_i128*a*b, &
            (b - a)*2_i128**bits, (b - a)**2], [inner, 3])
        real(dp), parameter :: unit = 2.0_dp**(-2*bits), high(inner, 3) = real(share, dp), &
            low(inner, 3) = real(share - int(high, i128), dp)
        type(rows_type) :: bulging, along, under
        real(dp) :: one_over(rows_at_once)

        bulging = shares(1)
        along = shares(2)
        ! The reciprocal of D, by a step of Newton's from that of a double.
        under = shares(3) + bulging*arc%fullness
        one_over = 1.0_dp/under%high
        under = twofold(1.0_dp) - under*rows_type(one_over, 0.0_dp)
        under = rows_type(one_over, one_over*under%high)
        x = coordinate(1)
        y = coordinate(2)
    contains
        !> One of the terms above.
        pure type(rows_type) function shares(term)
            integer, intent(in) :: term !! which
            shares%high = unit*high(first:first + rows_at_once - 1, term)
            shares%low = unit*low(first:first + rows_at_once - 1, term)
        end function shares

        !> One coordinate.
        pure function coordinate(axis)
            integer, intent(in) :: axis !! 1: x, 2: y
            real(dp) :: coordinate(rows_at_once)
            type(twofold_type) :: half

            half = arc%size*arc%half(axis)
            coordinate = to_real((twofold(arc%start(axis)) + half) + &
                (bulging*(arc%size*arc%bulge(axis)) + along*half)*under)
        end function coordinate
    end subroutine put_points

    !> The largest distance of some points from a shifted conic, |F|/|grad F|.
    pure real(dp) function largest_distance(conic, x, y) result(largest)
        type(shifted_type), intent(in) :: conic !! the conic
        real(dp), intent(in) :: x(compared)     !! of the points, deck units, unshifted
        real(dp), intent(in) :: y(compared)     !! so too
        real(dp), dimension(compared) :: value, run, rise
        real(dp) :: p, q
        integer :: i

        associate (k => conic%coefficient)
            do i = 1, compared
                p = x(i) + conic%shift
                q = y(i) + conic%shift
                run(i) = 2.0_dp*k(1)*p + k(2)*q + k(4)
                rise(i) = k(2)*p + 2.0_dp*k(3)*q + k(5)
                value(i) = abs((k(1)*p**2 + k(2)*(p*q) + k(3)*q**2 + k(4)*p + k(5)*q) + 1.0_dp)
            end do
        end associate
        largest = 0.0_dp
        do i = 1, compared
            ! No gradient is shorter than its longer part: most points are nearer for sure.
            if (value(i) > 0.999_dp*largest*max(abs(run(i)), abs(rise(i)))) &
                largest = max(largest, value(i)/norm2([run(i), rise(i)]))
        end do
    end function largest_distance

end module geom_shifted
