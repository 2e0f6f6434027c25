!> Between what values a quantity of the conic lies that good figures still allow: the least and
!> the greatest of it over all conics within their bounds, found by programmes that are linear near
!> the conic reached so far. Every conic on the way keeps the bounds, so that each value is one that
!> is really met.
module audit_bounds
    use audit_climb, only: climb, most_unknowns
    use audit_condition, only: bound_rows
    use audit_curve, only: quantity_at, quantity_type
    use audit_problem, only: problem_type
    use audit_squares, only: chart_at
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: find_bounds

    !> How far the conic may change in one programme, in coefficients of length 1; what change
    !> shows how the quantity grows; programmes, each from where the last one ended.
    real(dp), parameter :: widest_step = 0.1_dp, small_step = 1.0e-7_dp
    integer, parameter :: most_programmes = 6
    !> Growth that ends the programmes, relative to the range so far.
    real(dp), parameter :: still = 1.0e-4_dp

contains

    !> The least and the greatest value of a quantity over the conics that figures allow.
    !> `is_limited` is false where the figures do not bound it.
    pure subroutine find_bounds(problem, member, k, quantity, between, is_limited)
        type(problem_type), intent(in) :: problem   !! the readings
        logical, intent(in) :: member(:)            !! figures that agree, one a condition
        real(dp), intent(in) :: k(6)                !! a conic that they allow
        type(quantity_type), intent(in) :: quantity !! which; `near` is its value at k
        real(dp), intent(out) :: between(2)         !! least and greatest
        logical, intent(out) :: is_limited          !! see above
        real(dp) :: tried(6), value
        type(quantity_type) :: followed
        integer :: side, programme
        logical :: exists, is_there

        call quantity_at(k, problem%frame, quantity, value, exists)
        between = value
        is_limited = exists
        if (.not. exists .or. problem%freedom == 0) return
        do side = 1, 2
            tried = k
            followed = quantity
            do programme = 1, most_programmes
                if (quantity%sort <= 2) followed%near = between(side)
                call push(problem, member, real(2*side - 3, dp), followed, tried, is_there)
                call quantity_at(tried, problem%frame, followed, value, exists)
                if (.not. exists) is_there = .false.
                if (.not. exists) exit
                if (abs(value - between(side)) <= still*abs(value - between(3 - side)) .and. &
                    is_there) exit
                between(side) = value
            end do
            is_limited = is_limited .and. is_there
        end do
        between = [minval(between), maxval(between)]
    end subroutine find_bounds

    !> Changes a conic so that a quantity grows, or falls, as far as the figures allow.
    pure subroutine push(problem, member, direction, quantity, k, is_there)
        type(problem_type), intent(in) :: problem   !! the readings
        logical, intent(in) :: member(:)            !! figures that agree
        real(dp), intent(in) :: direction           !! 1 to grow, -1 to fall
        type(quantity_type), intent(in) :: quantity !! which
        real(dp), intent(inout) :: k(6)             !! a conic that they allow
        logical, intent(out) :: is_there            !! the widest step was not needed
        real(dp) :: a(problem%freedom, 2*(size(member) + problem%freedom)), x(problem%freedom)
        real(dp) :: b(2*(size(member) + problem%freedom)), c(problem%freedom)
        real(dp) :: chart(6, 6), rows(6, 2), value(2), tried(6)
        integer :: stops(most_unknowns), d, i, n, side
        logical :: exists

        d = problem%freedom
        chart = chart_at(problem, k)
        n = 0
        do i = 1, size(member)
            if (.not. member(i)) cycle
            call bound_rows(problem%condition(i), k, problem%frame, rows)
            do side = 1, 2
                n = n + 1
                a(:, n) = matmul(rows(:, side), chart(:, :d))
                b(n) = min(-dot_product(rows(:, side), k), 0.0_dp)
            end do
        end do
        a(:, n + 1:n + 2*d) = 0.0_dp
        do i = 1, d
            a(i, n + 2*i - 1:n + 2*i) = [1.0_dp, -1.0_dp]
            do side = 1, 2
                tried = k + real(2*side - 3, dp)*small_step*chart(:, i)
                call quantity_at(tried, problem%frame, quantity, value(side), exists)
                if (.not. exists) value(side) = value(1)
            end do
            c(i) = direction*(value(2) - value(1))/(2.0_dp*small_step)
        end do
        b(n + 1:n + 2*d) = -widest_step
        x = 0.0_dp
        is_there = .true.
        if (.not. norm2(c) > 0.0_dp) return
        call climb(c, a(:, :n + 2*d), b(:n + 2*d), x, stops)
        k = k + matmul(chart(:, :d), x)
        k = k/norm2(k)
        is_there = .not. any(stops > n)
    end subroutine push

end module audit_bounds
