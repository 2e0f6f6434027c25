!> The Pareto front: the variants that keep all limits and that no other such variant equals or
!> betters in every objective and betters in one. Objectives become keys that are to be small: the
!> measure, less the measure, or how far it is from the value wanted.
module sweep_front
    use base_decimal, only: to_real
    use base_kinds, only: dp
    use base_order, only: order_of
    use deck_sweep, only: goal
    use sweep_record, only: record_type, state
    use sweep_study, only: objectives_of, study_type
    implicit none (type, external)
    private

    public :: keys_of, mark_front, best_of, front_of

contains

    !> The keys of all records, shape (objectives, records).
    pure function keys_of(study, records) result(key)
        type(study_type), intent(in) :: study       !! the sweep
        type(record_type), intent(in) :: records(:) !! its variants
        real(dp), allocatable :: key(:, :)
        integer, allocatable :: chosen(:)
        integer :: i, k

        allocate (chosen, source=objectives_of(study))
        allocate (key(size(chosen), size(records)))
        do k = 1, size(chosen)
            associate (wanted => study%job%sweep%wanted(chosen(k)), &
                column => study%column(chosen(k)))
                do i = 1, size(records)
                    key(k, i) = records(i)%measure(column)
                    if (wanted%goal == goal%most) key(k, i) = -key(k, i)
                    if (wanted%goal == goal%near) key(k, i) = &
                        abs(key(k, i) - to_real(wanted%value))
                end do
            end associate
        end do
    end function keys_of

    !> Marks the variants of the front. In the order of their keys none betters one before it, so
    !> each is held against the front so far, the latest first.
    pure subroutine mark_front(study, records)
        type(study_type), intent(in) :: study           !! the sweep
        type(record_type), intent(inout) :: records(:)  !! its variants
        real(dp), allocatable :: key(:, :)
        integer, allocatable :: order(:), front(:)
        integer :: i, k, count

        allocate (key, source=keys_of(study, records))
        records%is_front = .false.
        allocate (order, source=pack([(i, i = 1, size(records))], records%state == state%ok))
        order = order(order_of(key(:, order)))
        allocate (front(size(order)))
        count = 0
        candidates: do i = 1, size(order)
            do k = count, 1, -1
                if (betters(key(:, front(k)), key(:, order(i)))) cycle candidates
            end do
            count = count + 1
            front(count) = order(i)
        end do candidates
        records(front(:count))%is_front = .true.
    end subroutine mark_front

    !> True where one is nowhere worse than the other and somewhere better.
    pure logical function betters(a, b)
        real(dp), intent(in) :: a(:) !! keys
        real(dp), intent(in) :: b(:) !! keys of another
        betters = all(a <= b) .and. any(a < b)
    end function betters

    !> The variants of the front, in the order of their first objective, then of the next, at last
    !> of their numbers.
    pure function front_of(study, records) result(front)
        type(study_type), intent(in) :: study       !! the sweep
        type(record_type), intent(in) :: records(:) !! marked
        real(dp), allocatable :: key(:, :)
        integer, allocatable :: front(:)
        integer :: i
        allocate (key, source=keys_of(study, records))
        allocate (front, source=pack([(i, i = 1, size(records))], records%is_front))
        front = front(order_of(key(:, front)))
    end function front_of

    !> The best variant: of one objective the best, of several the one of the front that is nearest
    !> to the best of each, their ranges over the front being units; 0 where the front is empty. Of
    !> equals the first.
    pure integer function best_of(study, records) result(best)
        type(study_type), intent(in) :: study       !! the sweep
        type(record_type), intent(in) :: records(:) !! marked
        real(dp), allocatable :: key(:, :)
        real(dp) :: low, high, least
        real(dp), allocatable :: distance(:)
        integer, allocatable :: front(:)
        integer :: i, k

        best = 0
        allocate (front, source=pack([(i, i = 1, size(records))], records%is_front))
        if (size(front) == 0) return
        allocate (key, source=keys_of(study, records))
        key = key(:, front)
        allocate (distance(size(front)))
        distance = 0.0_dp
        do k = 1, size(key, 1)
            low = minval(key(k, :))
            high = maxval(key(k, :))
            if (high > low) distance = distance + ((key(k, :) - low)/(high - low))**2
        end do
        least = minval(distance)
        best = front(findloc(distance <= least, .true., 1))
    end function best_of

end module sweep_front
