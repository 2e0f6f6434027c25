!> The readings of one conic as conditions, in the order of the readings, and what the ones that are
!> held exactly leave free: the conic is `free_to(:, :freedom + 1)` times as many weights.
module audit_problem
    use audit_condition, only: condition_type, exact_row, new_condition, takes_part
    use audit_curve, only: frame_type
    use audit_figure, only: scale_type
    use audit_reading, only: line_type, meaning, reading_type, sort
    use audit_span, only: free_basis
    use base_kinds, only: dp
    use base_order, only: ascending
    implicit none (type, external)
    private

    public :: problem_type, new_problem, hold, is_point

    !> A conic to be found.
    type :: problem_type
        type(frame_type) :: frame                           !! of the conic
        type(condition_type), allocatable :: condition(:)   !! those of sound readings
        integer, allocatable :: column(:)                   !! of the table, one a condition
        logical, allocatable :: is_exact(:)                 !! a number known exactly
        logical, allocatable :: is_sure(:)                  !! beyond doubt
        logical, allocatable :: is_held(:)                  !! met exactly by what is free
        real(dp) :: free_to(6, 6) = 0.0_dp                  !! orthonormal
        integer :: freedom = 5                              !! degrees of freedom left
        logical :: is_straight = .false.                    !! only straight lines are sought
    end type problem_type

    !> Conditions that fix a conic.
    integer, parameter :: most_held = 5

contains

    !> The conditions of the readings that take part. None is held.
    pure type(problem_type) function new_problem(line, scale, way, chosen) result(problem)
        type(line_type), intent(in) :: line   !! the line
        type(scale_type), intent(in) :: scale !! of its table
        integer, intent(in) :: way            !! one of `printing%...`
        logical, intent(in) :: chosen(:)      !! readings that may take part
        integer :: i, n, put

        n = 0
        do i = 1, size(line%reading)
            if (chosen(i) .and. takes_part(line%reading(i), scale)) n = n + 1
        end do
        allocate (problem%condition(n), problem%is_exact(n), problem%is_sure(n), &
            problem%is_held(n), problem%column(n))
        put = 0
        do i = 1, size(line%reading)
            if (.not. (chosen(i) .and. takes_part(line%reading(i), scale))) cycle
            put = put + 1
            problem%condition(put) = new_condition(line%reading(i), way, line%shift)
            problem%condition(put)%reading = i
            problem%is_exact(put) = line%reading(i)%meaning == meaning%exact
            problem%column(put) = line%reading(i)%column
            problem%is_sure(put) = line%reading(i)%is_sure
        end do
        problem%frame = frame_of(problem%condition)
        call find_points(problem)
        call hold(problem, spread(.false., 1, n))
    end function new_problem

    !> A frame about the middle figures, which bad ones do not move.
    pure type(frame_type) function frame_of(condition) result(frame)
        type(condition_type), intent(in) :: condition(:) !! of any sorts
        real(dp) :: given(size(condition), 2)
        integer :: axis, i, n

        n = 0
        do i = 1, size(condition)
            associate (it => condition(i))
                if (.not. is_point(it)) cycle
                n = n + 1
                axis = merge(1, 2, it%quantity%sort == sort%ordinate)
                given(n, axis) = it%quantity%along
                given(n, 3 - axis) = it%centre
            end associate
        end do
        if (n == 0) return
        do axis = 1, 2
            given(:n, axis) = ascending(given(:n, axis))
            frame%origin(axis) = given((n + 1)/2, axis)
            frame%size(axis) = given(n - n/8, axis) - given(1 + n/8, axis)
            if (.not. frame%size(axis) > 0.0_dp) &
                frame%size(axis) = given(n, axis) - given(1, axis)
            if (.not. frame%size(axis) > 0.0_dp) frame%size(axis) = 1.0_dp
        end do
    end function frame_of

    !> True for a condition that is a point of the conic.
    elemental logical function is_point(condition)
        type(condition_type), intent(in) :: condition !! any
        is_point = condition%quantity%sort <= sort%abscissa
    end function is_point

    !> Gives slopes their points: the exact ordinate at the same abscissa, or the one of the nearest
    !> abscissa to tell the roots apart.
    pure subroutine find_points(problem)
        type(problem_type), intent(inout) :: problem !! its conditions are given
        real(dp) :: apart, nearest
        integer :: i, j

        do i = 1, size(problem%condition)
            if (problem%condition(i)%quantity%sort /= sort%slope) cycle
            nearest = huge(nearest)
            do j = 1, size(problem%condition)
                if (problem%condition(j)%quantity%sort /= sort%ordinate) cycle
                apart = abs(problem%condition(j)%quantity%along - &
                    problem%condition(i)%quantity%along)
                if (apart >= nearest) cycle
                nearest = apart
                problem%condition(i)%quantity%near = problem%condition(j)%centre
            end do
        end do
    end subroutine find_points

    !> Holds conditions exactly: the conics left are those that meet them. A straight line is a
    !> conic without its terms of second degree. A slope can be held only
    !> with its point, and five conditions are all that a conic can meet; what can't be held is not.
    !> `problem%is_held` says which are.
    pure subroutine hold(problem, held)
        type(problem_type), intent(inout) :: problem !! its conditions are given
        logical, intent(in) :: held(:)               !! which; only exact ones can be
        real(dp) :: rows(6, most_held)
        integer :: i, n, pass

        problem%is_held = .false.
        problem%condition%has_point = .false.
        n = 0
        if (problem%is_straight) then
            n = 3
            rows(:, :n) = reshape([((merge(1.0_dp, 0.0_dp, i == pass), i = 1, 6), pass = 1, n)], &
                [6, 3])
        end if
        do pass = 1, 2
            do i = 1, size(held)
                if (.not. held(i) .or. n == most_held) cycle
                if ((problem%condition(i)%quantity%sort == sort%slope) .neqv. pass == 2) cycle
                if (problem%condition(i)%quantity%sort == sort%coefficient) cycle
                if (pass == 2 .and. .not. problem%condition(i)%has_point) cycle
                n = n + 1
                rows(:, n) = exact_row(problem%condition(i), problem%frame)
                problem%is_held(i) = .true.
            end do
            if (pass == 1) call give_points(problem)
        end do
        call free_basis(rows(:, :n), problem%free_to, problem%freedom)
        problem%freedom = problem%freedom - 1
    end subroutine hold

    !> Gives slopes the point that is held at their abscissa.
    pure subroutine give_points(problem)
        type(problem_type), intent(inout) :: problem !! points held are marked
        real(dp) :: x
        integer :: i, j

        do i = 1, size(problem%condition)
            if (problem%condition(i)%quantity%sort /= sort%slope) cycle
            do j = 1, size(problem%condition)
                if (.not. problem%is_held(j)) cycle
                associate (at => problem%condition(j))
                    if (at%quantity%sort /= sort%ordinate) cycle
                    x = at%quantity%along
                    if (abs(x - problem%condition(i)%quantity%along) > &
                        1.0e-9_dp*problem%frame%size(1)) cycle
                    problem%condition(i)%point = [x, at%centre]
                    problem%condition(i)%has_point = .true.
                end associate
            end do
        end do
    end subroutine give_points

end module audit_problem
