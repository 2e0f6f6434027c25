!> The greatest value of a linear function of a few unknowns within linear bounds:
!>
!>     max c . x    with    a(:, i) . x >= b(i) for every i,
!>
!> from a point that keeps the bounds. The way follows the bounds met (an active set): up along
!> what of c the bounds met leave free; where they leave nothing, off the bound that holds back
!> most.
!>
!> Source: M. J. Best, K. Ritter, "Linear Programming: Active Set Analysis and Computer Programs",
!> Prentice-Hall 1985, algorithm 3; a tie is broken by the lowest number (R. G. Bland, "New finite
!> pivoting rules for the simplex method", Math. Oper. Res. 2 (1977), pp. 103-107) once steps of no
!> length have become many.
module audit_climb
    use base_exact, only: is_zero
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: climb, most_unknowns

    !> Unknowns that a problem may have.
    integer, parameter :: most_unknowns = 7
    !> Steps after which the best point so far is taken.
    integer, parameter :: most_steps = 400
    !> What is left of a direction when the bounds met leave nothing of it: round-off.
    real(dp), parameter :: nothing = 1.0e-11_dp

    !> The bounds met, as orthonormal vectors and what they are made of.
    type :: corner_type
        integer :: met = 0                             !! how many
        integer :: bound(most_unknowns) = 0            !! their numbers
        real(dp) :: q(most_unknowns, most_unknowns)    !! orthonormal, a column a bound
        real(dp) :: r(most_unknowns, most_unknowns)    !! a(:, bound(j)) = sum of q(:, i) r(i, j)
    end type corner_type

contains

    !> Climbs as far as the bounds let. `bound` lists those that hold at the end, zeros behind them.
    pure subroutine climb(c, a, b, x, bound)
        real(dp), intent(in) :: c(:)      !! direction, at most `most_unknowns`
        real(dp), intent(in) :: a(:, :)   !! bounds, a column each
        real(dp), intent(in) :: b(:)      !! what they hold
        real(dp), intent(inout) :: x(:)   !! a point that keeps them, then the highest
        integer, intent(out) :: bound(:)  !! see above, shape (`most_unknowns`)
        type(corner_type) :: corner
        real(dp) :: way(size(c)), length, unit(size(a, 1), size(b)), holds(size(b))
        integer :: step, stopped_by, idle, i
        logical :: is_done

        do i = 1, size(b)
            length = max(norm2(a(:, i)), tiny(length))
            unit(:, i) = a(:, i)/length
            holds(i) = b(i)/length
        end do
        idle = 0
        do step = 1, most_steps
            call find_way(c, unit, corner, idle > size(c), way, is_done)
            if (is_done .or. corner%met == size(c)) exit
            call find_stop(unit, matmul(x, unit) - holds, way, corner, length, stopped_by)
            if (stopped_by == 0) exit
            x = x + length*way
            idle = merge(0, idle + 1, length*norm2(way) > nothing)
            corner%met = corner%met + 1
            corner%bound(corner%met) = stopped_by
            call orthogonalise(unit, corner, corner%met)
        end do
        bound = 0
        bound(:corner%met) = corner%bound(:corner%met)
    end subroutine climb

    !> The way up that leaves no bound met, or leaves one of them to its right side.
    pure subroutine find_way(c, a, corner, is_careful, way, is_done)
        real(dp), intent(in) :: c(:)               !! direction
        real(dp), intent(in) :: a(:, :)            !! bounds, of length 1
        type(corner_type), intent(inout) :: corner !! the bounds met; one is left, perhaps
        logical, intent(in) :: is_careful          !! leave the bound of lowest number
        real(dp), intent(out) :: way(:)            !! which way
        logical, intent(out) :: is_done            !! there is no way up
        real(dp) :: pull(most_unknowns)
        integer :: n, i, j, leave

        n = corner%met
        is_done = .false.
        way = rest_of(c, corner)
        if (norm2(way) > 0.0_dp) then
            way = way/norm2(way)
            return
        end if
        is_done = .true.
        if (n == 0) return
        ! c = sum of a(:, bound(j)) pull(j): what pulls to the right side of a bound may leave it.
        do i = n, 1, -1
            pull(i) = dot_product(corner%q(:size(c), i), c)
            do j = i + 1, n
                pull(i) = pull(i) - corner%r(i, j)*pull(j)
            end do
            pull(i) = pull(i)/corner%r(i, i)
        end do
        leave = 0
        do i = 1, n
            if (pull(i) <= nothing*norm2(c)) cycle
            if (leave == 0) leave = i
            if (is_careful) then
                if (corner%bound(i) < corner%bound(leave)) leave = i
            else if (pull(i) > pull(leave)) then
                leave = i
            end if
        end do
        if (leave == 0) return
        j = corner%bound(leave)
        corner%bound(leave:n - 1) = corner%bound(leave + 1:n)
        corner%met = n - 1
        do i = leave, n - 1
            call orthogonalise(a, corner, i)
        end do
        way = rest_of(a(:, j), corner)
        is_done = .not. norm2(way) > 0.0_dp
        if (.not. is_done) way = way/norm2(way)
    end subroutine find_way

    !> How far the way goes, and the bound that stops it: 0 where none does.
    pure subroutine find_stop(a, room, way, corner, length, stopped_by)
        real(dp), intent(in) :: a(:, :)          !! bounds, of length 1
        real(dp), intent(in) :: room(:)          !! from where the way begins to each
        real(dp), intent(in) :: way(:)           !! which way
        type(corner_type), intent(in) :: corner  !! the bounds met: they do not stop it
        real(dp), intent(out) :: length          !! in lengths of the way
        integer, intent(out) :: stopped_by       !! see above
        real(dp) :: fall
        integer :: i

        stopped_by = 0
        length = 0.0_dp
        do i = 1, size(room)
            fall = -dot_product(a(:, i), way)
            if (fall <= nothing) cycle
            if (stopped_by > 0) then
                if (max(room(i), 0.0_dp) >= length*fall) cycle
            end if
            if (any(corner%bound(:corner%met) == i)) cycle
            length = max(room(i), 0.0_dp)/fall
            stopped_by = i
        end do
    end subroutine find_stop

    !> What the bounds met leave free of a vector.
    pure function rest_of(v, corner) result(rest)
        real(dp), intent(in) :: v(:)             !! any vector
        type(corner_type), intent(in) :: corner  !! the bounds met
        real(dp) :: rest(size(v))
        integer :: i, again
        rest = v
        do again = 1, 2
            do i = 1, corner%met
                rest = rest - dot_product(corner%q(:size(v), i), rest)*corner%q(:size(v), i)
            end do
        end do
        if (norm2(rest) <= nothing*norm2(v)) rest = 0.0_dp
    end function rest_of

    !> Makes the j-th bound met orthogonal to those before it.
    pure subroutine orthogonalise(a, corner, j)
        real(dp), intent(in) :: a(:, :)            !! bounds, of length 1
        type(corner_type), intent(inout) :: corner !! those before j are done
        integer, intent(in) :: j                   !! which
        real(dp) :: v(size(a, 1)), part
        integer :: i, n, again

        n = size(a, 1)
        v = a(:, corner%bound(j))
        corner%r(:, j) = 0.0_dp
        do again = 1, 2
            do i = 1, j - 1
                part = dot_product(corner%q(:n, i), v)
                corner%r(i, j) = corner%r(i, j) + part
                v = v - part*corner%q(:n, i)
            end do
        end do
        corner%r(j, j) = norm2(v)
        if (is_zero(corner%r(j, j))) corner%r(j, j) = tiny(1.0_dp)
        corner%q(:n, j) = v/corner%r(j, j)
    end subroutine orthogonalise

end module audit_climb
