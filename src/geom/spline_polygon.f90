!> A polygon along a spline whose chords stay within a tolerance of it, with few points.
!>
!> Each span between breaks is gone along greedily: from a point the next is sought whose chord is
!> off by as much as is allowed. A chord's distance goes with the square of its length, which
!> corrects a trial quickly.
module geom_spline_polygon
    use base_kinds, only: dp
    use base_tolerances, only: ulp
    use geom_bspline, only: bspline_type, spline_breaks, spline_point
    implicit none (type, external)
    private

    public :: polygon_of

    !> Points of a stretch at which the distance from its chord is measured, its middle among them.
    integer, parameter :: stretch_points = 15
    !> The distance asked for, in parts of the tolerance: what may be missed between the points at
    !> which it is measured stays within the rest. Less than `enough` of it is a step too short.
    real(dp), parameter :: aim = 0.99_dp, enough = 0.9_dp
    !> Trials of a step; after them it is halved until it is good.
    integer, parameter :: most_trials = 8

contains

    !> The parameters of a polygon, the ends and the breaks of the spline among them; `largest` is
    !> the largest distance from the spline to its chord, measured at 15 points of each stretch.
    !> Stretches so short that doubles can't part them are taken as they are.
    pure subroutine polygon_of(spline, tolerance, t, largest)
        type(bspline_type), intent(in) :: spline        !! any spline
        real(dp), intent(in) :: tolerance               !! above zero, deck units
        real(dp), allocatable, intent(out) :: t(:)      !! rising, two or more
        real(dp), intent(out) :: largest                !! deck units
        real(dp), allocatable :: breaks(:)
        real(dp) :: next, step, miss
        integer :: count, i

        allocate (breaks, source=spline_breaks(spline))
        allocate (t(2*size(breaks)))
        t(1) = breaks(1)
        count = 1
        largest = 0.0_dp
        do i = 2, size(breaks)
            step = breaks(i) - breaks(i - 1)
            do while (t(count) < breaks(i))
                next = breaks(i)
                call find_next(spline, t(count), tolerance, step, next, miss)
                largest = max(largest, miss)
                call append(t, count, next)
            end do
        end do
        t = t(:count)
    end subroutine polygon_of

    !> The end of the longest chord from a place; `step` is what is tried, and then what was good.
    pure subroutine find_next(spline, from, tolerance, step, next, miss)
        type(bspline_type), intent(in) :: spline    !! any spline
        real(dp), intent(in) :: from                !! where the chord begins
        real(dp), intent(in) :: tolerance           !! deck units
        real(dp), intent(inout) :: step             !! see above
        real(dp), intent(inout) :: next             !! where it ends at the latest, and then does
        real(dp), intent(out) :: miss               !! its distance from the spline
        real(dp) :: limit, factor
        integer :: trial

        limit = next
        do trial = 1, most_trials + digits(step)
            next = min(from + step, limit)
            if (next >= limit) step = limit - from
            miss = distance(spline, from, next)
            factor = sqrt(aim*tolerance/max(miss, ulp*tolerance))
            if (trial > most_trials) factor = min(0.5_dp, factor)
            if (miss <= aim*tolerance .and. (next >= limit .or. miss >= enough*aim*tolerance .or. &
                trial >= most_trials)) exit
            if (.not. from + factor*step > from) exit
            step = factor*step
        end do
    end subroutine find_next

    !> The largest distance from a stretch of a spline to its chord.
    pure real(dp) function distance(spline, from, to)
        type(bspline_type), intent(in) :: spline    !! any spline
        real(dp), intent(in) :: from                !! where the chord begins
        real(dp), intent(in) :: to                  !! where it ends
        real(dp), dimension(size(spline%pole, 1)) :: start, chord, way
        real(dp) :: length, along
        integer :: i

        start = spline_point(spline, from)
        chord = spline_point(spline, to) - start
        length = dot_product(chord, chord)
        distance = 0.0_dp
        do i = 1, stretch_points
            way = spline_point(spline, from + real(i, dp)/real(stretch_points + 1, dp)* &
                (to - from)) - start
            along = 0.0_dp
            if (length > 0.0_dp) along = min(max(dot_product(way, chord)/length, 0.0_dp), 1.0_dp)
            distance = max(distance, norm2(way - along*chord))
        end do
    end function distance

    !> Puts a number behind others.
    pure subroutine append(list, count, value)
        real(dp), allocatable, intent(inout) :: list(:) !! `list(:count)` counts
        integer, intent(inout) :: count                 !! how many there are
        real(dp), intent(in) :: value                   !! one more
        real(dp), allocatable :: grown(:)

        if (count == size(list)) then
            allocate (grown(2*count))
            grown(:count) = list
            call move_alloc(grown, list)
        end if
        count = count + 1
        list(count) = value
    end subroutine append

end module geom_spline_polygon
