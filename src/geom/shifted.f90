!> The conic of a card as the 1970 program set it up, `A x**2 + B x y + C y**2 + D x + E y = -1`,
!> with the origin shifted so that no point is near it, but solved by LAPACK: a check on the arc,
!> and on what the shift does to the condition.
!>
!> Source: SAE 700202, "Determining aircraft contours by computer", appendix A: three rows
!> `x**2, x y, y**2, x, y, -1` for the points, two rows `2 x, y + s x, 2 s y, 1, s, 0` for the
!> slopes. For a vertical tangent the slope row is its limit on division by s, `0, x, 2 y, 0, 1, 0`.
module geom_shifted
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_type, end_type
    use geom_arc_rows, only: coordinates, places_type, terms_of, terms_type
    use geom_square_system, only: solve
    use geom_twofold_same, only: exact_difference, rows_at_once
    implicit none (type, external)
    private

    public :: shifted_type, solve_shifted, difference_from

    !> A conic in the shifted frame.
    type :: shifted_type
        real(dp) :: shift = 0.0_dp          !! added to every x and y, deck units
        real(dp) :: coefficient(5) = 0.0_dp !! A to E in the shifted frame
        real(dp) :: rcond = 0.0_dp          !! reciprocal condition of the system, equilibrated
    end type shifted_type

    !> Places of an arc at which it is compared.
    integer, parameter :: compared = 25
    !> 1 and 0 in every row.
    real(dp), parameter :: whole(rows_at_once) = 1.0_dp, nothing(rows_at_once) = 0.0_dp

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
        real(dp), dimension(rows_at_once) :: t, x, y
        type(places_type) :: places
        type(terms_type) :: terms
        integer :: i, first

        largest = 0.0_dp
        call take_distance(conic, arc%start, largest)
        call take_distance(conic, arc%finish, largest)
        do first = 1, compared - 2, rows_at_once
            t = [(real(min(first + i, compared - 2), dp)/real(compared - 1, dp), &
                i=0, rows_at_once - 1)]
            places%alpha = exact_difference(whole, t)
            places%beta = exact_difference(t, nothing)
            terms = terms_of(arc, places)
            x = coordinates(arc, 1, terms)
            y = coordinates(arc, 2, terms)
            do i = 1, min(rows_at_once, compared - 1 - first)
                call take_distance(conic, [x(i), y(i)], largest)
            end do
        end do
    end function difference_from

    !> Takes the distance of a point from a shifted conic, |F|/|grad F|, where it is the largest.
    pure subroutine take_distance(conic, at, largest)
        type(shifted_type), intent(in) :: conic !! the conic
        real(dp), intent(in) :: at(2)           !! x and y, deck units, unshifted
        real(dp), intent(inout) :: largest      !! of some points, deck units
        real(dp) :: p(2), gradient(2), value

        p = at + conic%shift
        associate (k => conic%coefficient)
            gradient = [2.0_dp*k(1)*p(1) + k(2)*p(2) + k(4), k(2)*p(1) + 2.0_dp*k(3)*p(2) + k(5)]
            value = abs(dot_product(k, point_row(p)) + 1.0_dp)
        end associate
        ! No gradient is shorter than its longer part: most points are nearer for sure.
        if (value > 0.999_dp*largest*maxval(abs(gradient))) &
            largest = max(largest, value/norm2(gradient))
    end subroutine take_distance

end module geom_shifted
