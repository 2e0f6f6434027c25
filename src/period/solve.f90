!> The five conditions of a conic as a 5x6 array, and Gauss-Jordan elimination as the program of
!> SAE 700202 did it. No sum is reordered: the digits printed depend on it.
!>
!> The conic is `A x**2 + B x y + C y**2 + D x + E y = -1`; points 1, 2, 3 lie on it, and its slope
!> is s1 at point 1 and s3 at point 3.
!>
!> Source: SAE 700202, equations (2) and (3), and appendix A, statements 10 to 115.
module period_solve
    use period_arithmetic, only: operator(*), operator(+), operator(-), operator(/)
    use period_word, only: hex_type, is_zero, whole
    implicit none (type, external)
    private

    public :: conditions_type, array_of, solve_array

    !> Three points and two slopes, the points already shifted.
    type :: conditions_type
        type(hex_type) :: x1, y1, s1 !! first point and the slope dy/dx there
        type(hex_type) :: x2, y2     !! shoulder point
        type(hex_type) :: x3, y3, s3 !! last point and the slope dy/dx there
    end type conditions_type

contains

    !> The 5x6 array: a row for each point, then a row for each slope; column 6 is the right side.
    pure function array_of(given) result(w)
        type(conditions_type), intent(in) :: given !! the five conditions
        type(hex_type) :: w(5, 6)

        w(1, :) = point_row(given%x1, given%y1)
        w(2, :) = point_row(given%x2, given%y2)
        w(3, :) = point_row(given%x3, given%y3)
        w(4, :) = slope_row(given%x1, given%y1, given%s1)
        w(5, :) = slope_row(given%x3, given%y3, given%s3)
    end function array_of

    !> The conic passes through a point.
    pure function point_row(x, y) result(row)
        type(hex_type), intent(in) :: x !! the point, shifted
        type(hex_type), intent(in) :: y !! the point, shifted
        type(hex_type) :: row(6)
        row = [x*x, x*y, y*y, x, y, whole(-1)]
    end function point_row

    !> The conic has a slope at a point: equation (3) without its quotient.
    pure function slope_row(x, y, s) result(row)
        type(hex_type), intent(in) :: x !! the point, shifted
        type(hex_type), intent(in) :: y !! the point, shifted
        type(hex_type), intent(in) :: s !! slope dy/dx there
        type(hex_type) :: row(6)
        row = [whole(2)*x, y + s*x, (whole(2)*s)*y, whole(1), s, whole(0)]
    end function slope_row

    !> Gauss-Jordan, column by column, without a search for the largest pivot: the first row from k
    !> on with an element in column k is added to row k, also when it is row k itself.
    !>
    !> Stops after the column in which an operation trapped; the array shows the trap.
    pure subroutine solve_array(w, solved)
        type(hex_type), intent(inout) :: w(5, 6) !! the array; on return column 6 is A to E
        logical, intent(out) :: solved           !! false: there is no unique solution
        type(hex_type) :: pivot, factor
        integer :: k, m, found

        solved = .false.
        do k = 1, 5
            found = first_row(w, k)
            if (found == 0) return
            w(k, :) = w(k, :) + w(found, :)
            pivot = w(k, k)
            w(k, :) = w(k, :)/pivot
            do m = 1, 5
                if (m == k) cycle
                factor = -w(m, k)
                w(m, :) = w(m, :) + factor*w(k, :)
            end do
            if (any(w%trap /= 0)) return
        end do
        solved = .true.
    end subroutine solve_array

    !> The first row from k on whose element in column k is not zero; 0 where there is none.
    pure integer function first_row(w, k) result(row)
        type(hex_type), intent(in) :: w(5, 6) !! the array
        integer, intent(in) :: k              !! the column
        do row = k, 5
            if (.not. is_zero(w(row, k))) return
        end do
        row = 0
    end function first_row

end module period_solve
