!> What the points given for an arc must be to each other: apart, in line or not, on one branch.
!> Whether decimals were meant to be in line is decided here, with the noise they have in doubles.
module geom_points
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_tolerances, only: decimal_noise, ulp
    use geom_span, only: way
    use geom_twofold, only: to_real
    use geom_vector, only: at_text, cross
    implicit none (type, external)
    private

    public :: noise_of, check_distinct, are_in_line, is_in_order, has_inner_point, find_in_line

contains

    !> How far points may miss each other, or a line, because binary can't hold their decimals.
    pure real(dp) function noise_of(points)
        real(dp), intent(in) :: points(:, :) !! shape (2, number), deck units
        noise_of = decimal_noise*ulp*maxval(abs(points))
    end function noise_of

    !> Fails with `cause%points_coincide` where two points are one, as far as decimals can say.
    pure subroutine check_distinct(points, names, error)
        real(dp), intent(in) :: points(:, :)                !! shape (2, number), deck units
        character(*), intent(in) :: names                   !! a letter for each, for the message
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: i, j

        do j = 2, size(points, 2)
            do i = 1, j - 1
                if (any(abs(points(:, j) - points(:, i)) > noise_of(points))) cycle
                call fail(error, cause%points_coincide, 'points '//names(i:i)//' and '// &
                    names(j:j)//' are both '//at_text(points(:, i))//'; they must be apart')
                return
            end do
        end do
    end subroutine check_distinct

    !> True where a point is on the straight line through two others, as far as decimals can say.
    pure logical function are_in_line(points)
        real(dp), intent(in) :: points(:, :) !! shape (2, 3), deck units, apart
        integer :: far(2), i
        real(dp) :: length(3)

        length = [(norm2(points(:, other(i, 2)) - points(:, other(i, 1))), i = 1, 3)]
        i = maxloc(length, dim=1)
        far = [other(i, 1), other(i, 2)]
        are_in_line = abs(turn(points(:, far(1)), points(:, far(2)), points(:, i))) &
            <= noise_of(points)*length(i)
    end function are_in_line

    !> The points of three that are not the one of a number.
    pure integer function other(number, which)
        integer, intent(in) :: number !! 1 to 3
        integer, intent(in) :: which  !! 1 or 2
        other = mod(number + which - 1, 3) + 1
    end function other

    !> Twice the area of a triangle, positive where it runs left about.
    pure real(dp) function turn(a, b, c)
        real(dp), intent(in) :: a(2) !! deck units
        real(dp), intent(in) :: b(2) !! deck units
        real(dp), intent(in) :: c(2) !! deck units
        turn = to_real(cross(way(a, b), way(a, c)))
    end function turn

    !> True where points in line follow each other from the first to the last.
    pure logical function is_in_order(points)
        real(dp), intent(in) :: points(:, :) !! shape (2, number), deck units, in line and apart
        real(dp) :: along(size(points, 2))
        integer :: last

        last = size(points, 2)
        along = matmul(points(:, last) - points(:, 1), points - spread(points(:, 1), 2, last))
        is_in_order = all(along(2:) > along(:last - 1))
    end function is_in_order

    !> True where one of the points is inside the triangle of three others: a conic through them
    !> all is then a hyperbola that has them on both of its branches.
    pure logical function has_inner_point(points)
        real(dp), intent(in) :: points(:, :) !! shape (2, number), deck units
        integer :: i, j, k, inner

        has_inner_point = .true.
        do inner = 1, size(points, 2)
            do i = 1, size(points, 2)
                do j = i + 1, size(points, 2)
                    do k = j + 1, size(points, 2)
                        if (any([i, j, k] == inner)) cycle
                        if (is_inside(points(:, inner), points(:, [i, j, k]))) return
                    end do
                end do
            end do
        end do
        has_inner_point = .false.
    end function has_inner_point

    !> True where a point is inside a triangle.
    pure logical function is_inside(point, corners)
        real(dp), intent(in) :: point(2)      !! deck units
        real(dp), intent(in) :: corners(2, 3) !! deck units
        real(dp) :: side(3)
        side = [turn(corners(:, 1), corners(:, 2), point), &
            turn(corners(:, 2), corners(:, 3), point), &
            turn(corners(:, 3), corners(:, 1), point)]
        is_inside = all(side > 0.0_dp) .or. all(side < 0.0_dp)
    end function is_inside

    !> The first three points that are in one line, in words: `points 1, A and C are in line`;
    !> nothing where there are none.
    pure subroutine find_in_line(points, names, words)
        real(dp), intent(in) :: points(:, :)                !! shape (2, number), deck units, apart
        character(*), intent(in) :: names                   !! a letter for each
        character(:), allocatable, intent(out) :: words     !! see above
        integer :: i, j, k

        words = ''
        do k = 3, size(points, 2)
            do j = 2, k - 1
                do i = 1, j - 1
                    if (.not. are_in_line(points(:, [i, j, k]))) cycle
                    words = 'points '//names(i:i)//', '//names(j:j)//' and '//names(k:k)// &
                        ' are in line'
                    return
                end do
            end do
        end do
    end subroutine find_in_line

end module geom_points
