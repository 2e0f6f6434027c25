!> A curve as a chain of circular arcs with a common tangent wherever two meet.
!>
!> Between two points of the curve with its tangents, P1 and P2, go two arcs that meet in a third
!> point Q of the curve. Q is where the second arc leaves P2 in the true direction; so each pair
!> begins afresh, and the error of direction that swings from arc to arc in a plain chain never
!> begins. Q exists and is the only one where the curvature between P1 and P2 only grows or only
!> falls, and turns by less than 180 degrees.
!>
!> The curve is parted where its curvature is zero or has an extreme; from there each pair goes as
!> far as the tolerance lets it. A stretch that one arc follows is one arc.
!>
!> Source: seed 003, second paper, equations (3) to (12), with (6) corrected; the way to choose P1
!> and P2 is added. The deviation goes as |dk/ds| L**3/324 over a length L of curvature k.
module geom_arc_chain
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_text, only: compact, to_text
    use geom_circular, only: circular_between, circular_type, direction_to, distance_from, &
        leaving, reversed_circular, wrapped
    use geom_plane_curve, only: curvature_stops, plane_curve_type
    implicit none (type, external)
    private

    public :: chain_arc_type, arcs_along, arc_pair, reversed_chain

    !> An arc of a chain.
    type :: chain_arc_type
        type(circular_type) :: arc          !! the arc
        real(dp) :: ends(2) = 0.0_dp        !! parameters of the curve at its ends
        real(dp) :: deviation = 0.0_dp      !! largest distance from the curve to it, deck units
        real(dp) :: worst(2) = 0.0_dp       !! where that is, on the curve
        logical :: is_primary = .true.      !! it ends where the curve's tangent is kept
    end type chain_arc_type

    !> Points of an arc where its deviation is looked at, and finally measured.
    integer, parameter :: looks = 48, measures = 256
    !> Steps that find how far a pair can go, and how near to the furthest is near enough.
    integer, parameter :: most_steps = 60
    real(dp), parameter :: near_enough = 1.0e-5_dp
    !> Arcs of a chain at most.
    integer, parameter :: most_arcs = 20000
    !> The part of the tolerance that is aimed at: looks may miss the largest deviation by the rest.
    real(dp), parameter :: aim = 0.999_dp
    !> Directions, radians, that are one.
    real(dp), parameter :: same_direction = 1.0e-10_dp

contains

    !> The chain of arcs along a curve, within a tolerance of it.
    !>
    !> Fails with `cause%too_many` where more than `most_arcs` are needed, and with
    !> `cause%no_convergence` where the curve is not smooth enough for any.
    pure subroutine arcs_along(f, tolerance, arcs, error)
        class(plane_curve_type), intent(in) :: f                    !! the curve
        real(dp), intent(in) :: tolerance                           !! above zero, deck units
        type(chain_arc_type), allocatable, intent(out) :: arcs(:)   !! in order along the curve
        type(error_type), allocatable, intent(out) :: error         !! see above
        type(chain_arc_type), allocatable :: pair(:)
        real(dp), allocatable :: stops(:)
        real(dp) :: t, reached
        integer :: i

        allocate (arcs(0), pair(0), stops(0))
        stops = curvature_stops(f)
        do i = 1, size(stops) - 1
            t = stops(i)
            do while (t < stops(i + 1))
                call longest_pair(f, t, stops(i + 1), tolerance, pair, reached)
                if (size(pair) == 0) then
                    call fail(error, cause%no_convergence, 'no circular arcs within '// &
                        compact(tolerance)//' follow a curve at its parameter '//compact(t))
                    return
                end if
                arcs = [arcs, pair]
                if (size(arcs) > most_arcs) then
                    call fail(error, cause%too_many, 'circular arcs within '// &
                        compact(tolerance)//' of a curve are more than '//to_text(most_arcs)// &
                        '; take a larger tolerance')
                    return
                end if
                t = reached
            end do
        end do
    end subroutine arcs_along

    !> The longest pair of arcs from a parameter on that stays within a tolerance, up to a stop. The
    !> deviation grows as the third power of the length: by that the next length is guessed, between
    !> the longest that is well and the shortest that is not.
    pure subroutine longest_pair(f, from, stop, tolerance, pair, reached)
        class(plane_curve_type), intent(in) :: f                    !! the curve
        real(dp), intent(in) :: from                                !! parameter where it begins
        real(dp), intent(in) :: stop                                !! parameter, above
        real(dp), intent(in) :: tolerance                           !! deck units
        type(chain_arc_type), allocatable, intent(out) :: pair(:)   !! one or two; or none
        real(dp), intent(out) :: reached                            !! parameter where it ends
        type(chain_arc_type), allocatable :: tried(:)
        real(dp) :: good, bad, to, deviation
        integer :: i

        allocate (pair(0), tried(0))
        good = from
        bad = stop
        to = stop
        do i = 1, most_steps
            call try_pair(f, [from, to], looks, tried)
            deviation = huge(1.0_dp)
            if (size(tried) > 0) deviation = maxval(tried%deviation)
            if (deviation <= aim*tolerance) then
                good = to
                pair = tried
                if (to >= stop) exit
            else
                bad = to
            end if
            if (bad - good <= near_enough*(good - from)) exit
            if (.not. bad > good) exit
            to = good + 0.5_dp*(bad - good)
            if (size(tried) > 0 .and. mod(i, 3) /= 0) &
                to = guess(tried(size(tried))%ends(2) - from, deviation)
        end do
        reached = good
        if (size(pair) == 0) return
        call try_pair(f, [from, good], measures, pair)
    contains
        !> A length by the law of the third power, kept well inside of what is known.
        pure real(dp) function guess(length, deviation) result(to)
            real(dp), intent(in) :: length      !! of the pair tried
            real(dp), intent(in) :: deviation   !! of it
            real(dp) :: ratio
            ratio = 0.999_dp*aim*tolerance/max(deviation, tiny(1.0_dp))
            to = from + length*ratio**(1.0_dp/3.0_dp)
            to = min(max(to, good + 0.001_dp*(bad - good)), bad - 0.001_dp*(bad - good))
        end function guess
    end subroutine longest_pair

    !> The arc, or the two, from a parameter to another, with their deviations; none where there are
    !> none.
    pure subroutine try_pair(f, ends, points, pair)
        class(plane_curve_type), intent(in) :: f                    !! the curve
        real(dp), intent(in) :: ends(2)                             !! parameters, rising
        integer, intent(in) :: points                               !! to measure at, of each arc
        type(chain_arc_type), allocatable, intent(out) :: pair(:)   !! see above
        real(dp) :: direction(2), at(2, 2)
        type(circular_type) :: one
        logical :: exists
        integer :: i

        do i = 1, 2
            call look(f, ends(i), at(:, i), direction(i))
        end do
        if (all(is_equal(at(:, 1), at(:, 2)))) then
            allocate (pair(0))
            return
        end if
        one = circular_between(at(:, 1), direction(1), at(:, 2))
        if (abs(wrapped(leaving(one) - direction(2))) <= same_direction) then
            allocate (pair(1))
            pair(1) = chain_arc_type(one, ends)
            call measure(f, points, pair(1))
            if (abs(one%turn) > 0.0_dp .or. one%is_line) return
            deallocate (pair)
        end if
        call arc_pair(f, ends, direction(1), pair, exists)
        if (.not. exists) then
            deallocate (pair)
            allocate (pair(0))
            return
        end if
        do i = 1, 2
            call measure(f, points, pair(i))
        end do
    end subroutine try_pair

    !> The point of a curve and the direction of its tangent.
    pure subroutine look(f, t, at, direction)
        class(plane_curve_type), intent(in) :: f    !! the curve
        real(dp), intent(in) :: t                   !! 0 to 1
        real(dp), intent(out) :: at(2)              !! deck units
        real(dp), intent(out) :: direction          !! radians
        real(dp) :: first(2), second(2)
        call f%jet(t, at, first, second)
        direction = atan2(first(2), first(1))
    end subroutine look

    !> The pair of arcs from a parameter, in a direction, to another, where the second arc ends in
    !> the direction of the curve: by halving to the last bit.
    pure subroutine arc_pair(f, ends, direction, pair, exists)
        class(plane_curve_type), intent(in) :: f                    !! the curve
        real(dp), intent(in) :: ends(2)                             !! parameters, rising
        real(dp), intent(in) :: direction                           !! at the first, radians
        type(chain_arc_type), allocatable, intent(out) :: pair(:)   !! two arcs, where they exist
        logical, intent(out) :: exists                              !! they do
        real(dp) :: true(2), at(2, 2), chord, off(2), bounds(2), t, middle(2)
        type(circular_type) :: first, second
        integer :: i

        allocate (pair(2))
        do i = 1, 2
            call look(f, ends(i), at(:, i), true(i))
        end do
        chord = direction_to(at(:, 1), at(:, 2))
        off(1) = wrapped(2.0_dp*(chord - true(1)) + direction - true(2))
        off(2) = wrapped(2.0_dp*(true(2) - chord) + direction - true(2))
        exists = off(1)*off(2) < 0.0_dp
        if (.not. exists) return
        bounds = ends
        do
            t = bounds(1) + 0.5_dp*(bounds(2) - bounds(1))
            if (t <= bounds(1) .or. t >= bounds(2)) exit
            middle = point_at(f, t)
            bounds(merge(1, 2, off(1)*wrapped(2.0_dp*(direction_to(middle, at(:, 2)) &
                - direction_to(at(:, 1), middle)) + direction - true(2)) > 0.0_dp)) = t
        end do
        first = circular_between(at(:, 1), direction, point_at(f, t))
        second = circular_between(point_at(f, t), leaving(first), at(:, 2))
        exists = first%turn*second%turn > 0.0_dp
        pair(1) = chain_arc_type(first, [ends(1), t], is_primary=.false.)
        pair(2) = chain_arc_type(second, [t, ends(2)])
    end subroutine arc_pair

    !> The point of a curve.
    pure function point_at(f, t) result(at)
        class(plane_curve_type), intent(in) :: f    !! the curve
        real(dp), intent(in) :: t                   !! 0 to 1
        real(dp) :: at(2), first(2), second(2)
        call f%jet(t, at, first, second)
    end function point_at

    !> Finds the largest distance from the curve to an arc that stands for it.
    pure subroutine measure(f, points, arc)
        class(plane_curve_type), intent(in) :: f    !! the curve
        integer, intent(in) :: points               !! where it is measured
        type(chain_arc_type), intent(inout) :: arc  !! with its parameters; gets its deviation
        real(dp) :: at(2), distance
        integer :: i

        arc%worst = arc%arc%start
        do i = 1, points - 1
            at = point_at(f, arc%ends(1) + real(i, dp)/real(points, dp)*(arc%ends(2) - arc%ends(1)))
            distance = distance_from(arc%arc, at)
            if (distance <= arc%deviation) cycle
            arc%deviation = distance
            arc%worst = at
        end do
    end subroutine measure

    !> The same arcs, run through backwards.
    pure function reversed_chain(arcs) result(back)
        type(chain_arc_type), intent(in) :: arcs(:) !! along a curve
        type(chain_arc_type) :: back(size(arcs))
        integer :: i, count

        count = size(arcs)
        do i = 1, count
            back(i) = arcs(count + 1 - i)
            back(i)%arc = reversed_circular(back(i)%arc)
            back(i)%ends = 1.0_dp - back(i)%ends([2, 1])
            back(i)%is_primary = .true.
            if (i < count) back(i)%is_primary = arcs(count - i)%is_primary
        end do
    end function reversed_chain

end module geom_arc_chain
