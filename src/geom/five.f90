!> Five linear equations with five unknowns: equilibrated, solved by elimination with pivoting and
!> refined, with an estimate of their condition.
!>
!> The operations and their order are those of the reference sources of LAPACK's DGESVX (DGEEQU,
!> DGETRF2, DGECON, DGERFS), so that the figures are those that it gives. A card has but five
!> equations: most of what DGESVX costs is to find out what it is asked for.
!>
!> Source: E. Anderson et al., "LAPACK Users' Guide", 3rd ed., SIAM 1999, 2.3.1 and 2.4.1; N. J.
!> Higham, "Accuracy and Stability of Numerical Algorithms", 2nd ed., SIAM 2002, algorithm 15.4 (the
!> estimate) and 12.1 (the refinement).
module geom_five
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_equal
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: solve_five

    !> How many equations.
    integer, parameter, public :: five = 5
    !> Scales that are all within this ratio are left at 1.
    real(dp), parameter :: well_scaled = 0.1_dp
    !> Half an ulp of 1: what a rounding is off by, relatively.
    real(dp), parameter :: unit = 0.5_dp*epsilon(1.0_dp)
    !> Matrices with larger or smaller elements are scaled in any case.
    real(dp), parameter :: least = tiny(1.0_dp)/epsilon(1.0_dp), most = 1.0_dp/least
    !> Turns of the estimate and of the refinement, at most.
    integer, parameter :: most_turns = 5

    !> A right-hand side for which a matrix that misleads the estimate has a large solution.
    real(dp), parameter :: zigzag(five) = [1.0_dp, -1.25_dp, 1.5_dp, -1.75_dp, 2.0_dp]

    !> A matrix as the product of a lower triangle with ones on its diagonal and an upper one.
    type :: factors_type
        real(dp) :: both(five, five)    !! the upper triangle, below its diagonal the lower
        integer :: pivot(five)          !! the row that came to each place
    end type factors_type

contains

    !> Solves `a x = b`.
    !>
    !> Fails with `cause%singular` where the matrix is singular, exactly or to working precision;
    !> `x` is zero then, and `rcond` says how near to singular it is.
    pure subroutine solve_five(a, b, x, rcond, error)
        real(dp), intent(in) :: a(five, five)               !! matrix
        real(dp), intent(in) :: b(five)                     !! right-hand side
        real(dp), intent(out) :: x(five)                    !! solution
        real(dp), intent(out) :: rcond                      !! reciprocal condition, 0 to 1
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: matrix(five, five), right(five), rows(five), columns(five), norm
        type(factors_type) :: factors
        logical :: is_singular
        integer :: j

        x = 0.0_dp
        rcond = 0.0_dp
        call find_scales(a, rows, columns, is_singular)
        if (.not. is_singular) then
            do j = 1, five
                matrix(:, j) = (columns(j)*rows)*a(:, j)
            end do
            call factor(matrix, factors, is_singular)
        end if
        if (.not. is_singular) then
            norm = norm_of_inverse(factors%both)
            if (norm > 0.0_dp) rcond = (1.0_dp/norm)/maxval(sum(abs(matrix), 1))
            is_singular = rcond < unit
        end if
        if (is_singular) then
            call fail(error, cause%singular, 'the system of 5 equations has no unique solution')
            return
        end if
        right = rows*b
        x = solution(factors, right)
        call refine(matrix, right, factors, x)
        x = columns*x
    end subroutine solve_five

    !> Scales of rows and columns that bring the largest element of each to 1; ones where these are
    !> of a size already. A row or column of zeros makes the matrix singular.
    pure subroutine find_scales(a, rows, columns, is_singular)
        real(dp), intent(in) :: a(five, five)   !! matrix
        real(dp), intent(out) :: rows(five)     !! factors of its rows
        real(dp), intent(out) :: columns(five)  !! factors of its columns
        logical, intent(out) :: is_singular     !! see above; there are no scales then
        real(dp) :: largest(five)
        integer :: j

        rows = 1.0_dp
        columns = 1.0_dp
        largest = abs(a(:, 1))
        do j = 2, five
            largest = max(largest, abs(a(:, j)))
        end do
        is_singular = any(largest < tiny(1.0_dp))
        if (is_singular) return
        rows = 1.0_dp/largest
        do j = 1, five
            columns(j) = maxval(abs(a(:, j))*rows)
        end do
        is_singular = any(columns < tiny(1.0_dp))
        if (is_singular) return
        if (minval(largest)/maxval(largest) >= well_scaled .and. maxval(largest) >= least .and. &
            maxval(largest) <= most) rows = 1.0_dp
        if (minval(columns)/maxval(columns) >= well_scaled) then
            columns = 1.0_dp
        else
            columns = 1.0_dp/columns
        end if
    end subroutine find_scales

    !> The factors of a matrix by elimination; the largest element of a column is its pivot.
    pure subroutine factor(a, factors, is_singular)
        real(dp), intent(in) :: a(five, five)       !! matrix
        type(factors_type), intent(out) :: factors  !! its factors, rows exchanged
        logical, intent(out) :: is_singular         !! a pivot is zero; there are no factors
        real(dp) :: row(five)
        integer :: i, j, k

        associate (f => factors%both)
            f = a
            do k = 1, five
                i = k - 1 + maxloc(abs(f(k:, k)), 1)
                factors%pivot(k) = i
                is_singular = abs(f(i, k)) < tiny(1.0_dp)
                if (is_singular) return
                row = f(i, :)
                f(i, :) = f(k, :)
                f(k, :) = row
                f(k + 1:, k) = f(k + 1:, k)*(1.0_dp/f(k, k))
                do j = k + 1, five
                    f(k + 1:, j) = f(k + 1:, j) - f(k + 1:, k)*f(k, j)
                end do
            end do
        end associate
    end subroutine factor

    !> The solution of the factored equations.
    pure function solution(factors, b) result(x)
        type(factors_type), intent(in) :: factors   !! of the matrix
        real(dp), intent(in) :: b(five)             !! right-hand side
        real(dp) :: x(five)
        real(dp) :: there
        integer :: k

        x = b
        do k = 1, five
            there = x(factors%pivot(k))
            x(factors%pivot(k)) = x(k)
            x(k) = there
        end do
        x = times_inverse(factors%both, x)
    end function solution

    !> The inverse of a product of triangles, times a vector.
    pure function times_inverse(f, b) result(x)
        real(dp), intent(in) :: f(five, five)   !! both triangles
        real(dp), intent(in) :: b(five)         !! the vector
        real(dp) :: x(five)
        integer :: k

        x = b
        do k = 1, five - 1
            x(k + 1:) = x(k + 1:) - x(k)*f(k + 1:, k)
        end do
        do k = five, 1, -1
            x(k) = x(k)/f(k, k)
            x(:k - 1) = x(:k - 1) - x(k)*f(:k - 1, k)
        end do
    end function times_inverse

    !> The transpose of the inverse, times a vector.
    pure function times_transpose(f, b) result(x)
        real(dp), intent(in) :: f(five, five)   !! both triangles
        real(dp), intent(in) :: b(five)         !! the vector
        real(dp) :: x(five)
        integer :: i, k

        x = b
        do k = 1, five
            do i = 1, k - 1
                x(k) = x(k) - f(i, k)*x(i)
            end do
            x(k) = x(k)/f(k, k)
        end do
        do k = five - 1, 1, -1
            do i = five, k + 1, -1
                x(k) = x(k) - f(i, k)*x(i)
            end do
        end do
    end function times_transpose

    !> Corrects a solution by what it leaves over, until that is rounding or no longer halves.
    pure subroutine refine(a, b, factors, x)
        real(dp), intent(in) :: a(five, five)       !! matrix
        real(dp), intent(in) :: b(five)             !! right-hand side
        type(factors_type), intent(in) :: factors   !! of the matrix
        real(dp), intent(inout) :: x(five)          !! the solution
        real(dp), parameter :: safe = real(five + 1, dp)*tiny(1.0_dp)
        real(dp) :: rest(five), size(five), room(five), worst, last
        integer :: turn, j

        last = 3.0_dp
        do turn = 1, most_turns
            rest = b
            size = abs(b)
            do j = 1, five
                rest = rest - x(j)*a(:, j)
                size = size + abs(x(j))*abs(a(:, j))
            end do
            room = merge(0.0_dp, safe, size > safe/unit)
            worst = maxval((abs(rest) + room)/(size + room))
            if (.not. (worst > unit .and. 2.0_dp*worst <= last)) return
            x = x + solution(factors, rest)
            last = worst
        end do
    end subroutine refine

    !> An estimate of the largest column sum of the inverse, hardly ever less than a third of it.
    !> The signs of a column's elements, times the inverse from the left, show which column to try
    !> next.
    pure real(dp) function norm_of_inverse(f) result(norm)
        real(dp), intent(in) :: f(five, five)   !! both triangles
        real(dp) :: x(five), signs(five), rows(five), before
        integer :: turn, column, last

        x = 1.0_dp/real(five, dp)
        x = times_inverse(f, x)
        norm = sum(abs(x))
        signs = signs_of(x)
        rows = times_transpose(f, signs)
        column = maxloc(abs(rows), 1)
        do turn = 2, most_turns
            x = 0.0_dp
            x(column) = 1.0_dp
            x = times_inverse(f, x)
            before = norm
            norm = sum(abs(x))
            if (all(is_equal(signs_of(x), signs)) .or. norm <= before) exit
            signs = signs_of(x)
            rows = times_transpose(f, signs)
            last = column
            column = maxloc(abs(rows), 1)
            if (is_equal(rows(last), abs(rows(column)))) exit
        end do
        x = times_inverse(f, zigzag)
        norm = max(norm, 2.0_dp*(sum(abs(x))/real(3*five, dp)))
    end function norm_of_inverse

    !> 1 or -1 for each number.
    pure function signs_of(x) result(signs)
        real(dp), intent(in) :: x(five) !! any numbers
        real(dp) :: signs(five)
        signs = merge(1.0_dp, -1.0_dp, x >= 0.0_dp)
    end function signs_of

end module geom_five
