!> The mitre of two insides of the skin at a corner of it, a chine or a keel: their ends cross, and
!> where they do both end.
module export_drawing_mitre
    use base_kinds, only: dp
    use cut_plane, only: in_space
    use export_drawing_opposite, only: is_own_patch, opposite_type
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: side_type, mitre, mitre_image

    !> The inside opposite to a path, and the parameter of the outside where each patch begins.
    type :: side_type
        type(opposite_type) :: path             !! with patches
        real(dp), allocatable :: from(:)        !! as many as patches
    end type side_type

    !> Newton steps at most, and what is a step of rounding, in thicknesses: feet are no better.
    integer, parameter :: most_steps = 30
    real(dp), parameter :: rounding = 1.0e-9_dp
    !> Sine of the least angle that is a corner.
    real(dp), parameter :: corner = 1.0e-6_dp
    !> How far a crossing may be from the ends, in thicknesses.
    real(dp), parameter :: furthest = 8.0_dp
    !> Step of the parameter over which the pace of a path is measured.
    real(dp), parameter :: pace_step = 1.0e-5_dp
    !> A path that is shorter than so many thicknesses is a point.
    real(dp), parameter :: least_pace = 1.0e-3_dp

contains

    !> Ends one path and begins the next where their insides cross. Where these go on smoothly, or
    !> part from one another as in a valley, nothing is done.
    pure subroutine mitre(before, after, noise)
        type(side_type), intent(inout) :: before    !! ends in the corner
        type(side_type), intent(inout) :: after     !! begins in it
        real(dp), intent(in) :: noise               !! distance that is but rounding, deck units
        real(dp) :: s(2)
        logical :: is_found
        integer :: last, first

        last = findloc(is_own_patch(before%path), .true., dim=1, back=.true.)
        first = findloc(is_own_patch(after%path), .true., dim=1)
        if (last == 0 .or. first == 0) return
        s = [before%path%until(last), after%from(first)]
        call find_crossing(before%path, after%path, max(noise, rounding*before%path%thickness), s, &
            is_found)
        if (.not. is_found) return
        if (s(1) <= before%from(last) .or. s(2) >= after%path%until(first)) return
        before%path%patch = before%path%patch(:last)
        before%path%until = [before%path%until(:last - 1), s(1)]
        before%from = before%from(:last)
        after%path%patch = after%path%patch(first:)
        after%path%until = after%path%until(first:)
        after%from = [s(2), after%from(first + 1:)]
    end subroutine mitre

    !> Ends a path where its inside crosses BL 0, opposite to an end of the outline on BL 0: a keel,
    !> where it meets its own mirror image. Where it does not get that far nothing is done.
    pure subroutine mitre_image(side, is_last, noise)
        type(side_type), intent(inout) :: side      !! the first path of an outline, or the last
        logical, intent(in) :: is_last              !! it is the last one, which ends there
        real(dp), intent(in) :: noise               !! distance that is but rounding, deck units
        real(dp) :: at(3), s
        logical :: is_found
        integer :: i

        at = side%path%outside%at(merge(1.0_dp, 0.0_dp, is_last))
        at = in_space(side%path%plane, at(:2))
        i = findloc(is_own_patch(side%path), .true., dim=1, back=is_last)
        if (abs(at(2)) > noise .or. i == 0) return
        s = merge(side%path%until(i), side%from(i), is_last)
        call find_image(side%path, is_last, max(noise, rounding*side%path%thickness), s, is_found)
        if (.not. is_found .or. s <= side%from(i) .or. s >= side%path%until(i)) return
        if (is_last) then
            side%path%patch = side%path%patch(:i)
            side%path%until = [side%path%until(:i - 1), s]
            side%from = side%from(:i)
        else
            side%path%patch = side%path%patch(i:)
            side%path%until = side%path%until(i:)
            side%from = [s, side%from(i + 1:)]
        end if
    end subroutine mitre_image

    !> Where an inside crosses BL 0, in front of the end that is given.
    pure subroutine find_image(path, is_last, noise, s, is_found)
        type(opposite_type), intent(in) :: path     !! first or last of an outline
        logical, intent(in) :: is_last              !! it is the last one
        real(dp), intent(in) :: noise               !! distance that is but rounding, deck units
        real(dp), intent(inout) :: s                !! parameter: of the end, then of the crossing
        logical, intent(out) :: is_found            !! it crosses there
        real(dp) :: at(3), way(3), across, move, limit, back, rate
        integer :: i

        is_found = .false.
        limit = s
        back = merge(-pace_step, pace_step, is_last)
        do i = 1, most_steps
            at = path%at(s)
            at = in_space(path%plane, at(:2))
            if (i == 1 .and. abs(at(2)) <= noise) return
            way = unit(path%way(s))
            across = way(1)*path%plane%u(2) + way(2)*path%plane%v(2)
            if (abs(across) < corner) return
            move = -at(2)/across
            if (abs(move) > furthest*path%thickness) return
            rate = pace(path, [s, s + back])
            if (rate <= least_pace*path%thickness) return
            s = s + move/rate
            if ((s - limit)*back < 0.0_dp) return
            is_found = abs(move) <= noise
            if (is_found) return
        end do
    end subroutine find_image

    !> Where two insides cross, in front of the ends that are given.
    pure subroutine find_crossing(before, after, noise, s, is_found)
        type(opposite_type), intent(in) :: before   !! ends in the corner
        type(opposite_type), intent(in) :: after    !! begins in it
        real(dp), intent(in) :: noise               !! distance that is but rounding, deck units
        real(dp), intent(inout) :: s(2)             !! parameters: of the ends, then of the crossing
        logical, intent(out) :: is_found            !! they cross there
        real(dp) :: apart(3), way(3, 2), turn, move(2), limit(2), rate(2)
        integer :: i

        is_found = .false.
        limit = s
        do i = 1, most_steps
            apart = after%at(s(2)) - before%at(s(1))
            if (i == 1 .and. norm2(apart) <= noise) return
            way(:, 1) = unit(before%way(s(1)))
            way(:, 2) = unit(after%way(s(2)))
            turn = cross(way(:2, 1), way(:2, 2))
            if (abs(turn) < corner) return
            move = [cross(apart(:2), way(:2, 2)), cross(apart(:2), way(:2, 1))]/turn
            if (maxval(abs(move)) > furthest*before%thickness) return
            rate = [pace(before, [s(1) - pace_step, s(1)]), pace(after, [s(2), s(2) + pace_step])]
            if (any(rate <= least_pace*before%thickness)) return
            s = s + move/rate
            if (s(1) > limit(1) .or. s(2) < limit(2)) return
            is_found = maxval(abs(move)) <= noise
            if (is_found) return
        end do
    end subroutine find_crossing

    !> How far an inside goes for a step of the parameter, as a rate.
    pure real(dp) function pace(path, s)
        type(opposite_type), intent(in) :: path     !! an inside
        real(dp), intent(in) :: s(2)                !! from, to
        pace = norm2(path%at(s(2)) - path%at(s(1)))/abs(s(2) - s(1))
    end function pace

    !> A vector of unit length; nothing where it is none.
    pure function unit(vector)
        real(dp), intent(in) :: vector(3)   !! any
        real(dp) :: unit(3)
        unit = vector/max(norm2(vector), tiny(1.0_dp))
    end function unit

end module export_drawing_mitre
