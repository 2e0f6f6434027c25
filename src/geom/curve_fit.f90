!> A spline fitted to any smooth curve within a tolerance, with few poles.
!>
!> The spline of degree 5 that interpolates the curve at the nodes of some breaks is compared with
!> it densely. The error of a span goes with the sixth power of its length; so each span tells how
!> many spans like it are wanted, and new breaks part these evenly. That is done until the largest
!> distance is within the tolerance; after some rounds only the spans that miss it are halved.
!>
!> Source: C. de Boor, "A Practical Guide to Splines", revised ed., Springer 2001, chapter XII,
!> "Good approximation by splines with variable knots".
module geom_curve_fit
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact, to_text
    use geom_bspline, only: bspline_type, spline_jet
    use geom_spline_fit, only: fit_knots, fit_nodes, fit_values
    implicit none (type, external)
    private

    public :: curve_function_type, fit_curve

    !> A curve in space that can be evaluated anywhere.
    type, abstract :: curve_function_type
    contains
        procedure(at_interface), deferred :: at !! the point of a parameter from 0 to 1
    end type curve_function_type

    abstract interface
        !> The point of a curve.
        pure function at_interface(f, t) result(point)
            import :: curve_function_type, dp
            implicit none (type, external)
            class(curve_function_type), intent(in) :: f !! the curve
            real(dp), intent(in) :: t                   !! 0 to 1
            real(dp) :: point(3)                        !! deck units
        end function at_interface
    end interface

    !> Degree of the splines: odd, so that nodes and knots are the same away from the ends.
    integer, parameter :: degree = 5
    !> Spans a spline may have, and rounds that may be made: beyond them the curve is not smooth, or
    !> the tolerance is below rounding.
    integer, parameter :: most_spans = 4000, most_rounds = 40
    !> Rounds after which spans are only halved.
    integer, parameter :: free_rounds = 12
    !> Points of a span, and of the whole curve, at which the distance is measured at least.
    integer, parameter :: span_points = 16, curve_points = 512
    !> The error aimed at, in parts of the tolerance.
    real(dp), parameter :: aim = 0.6_dp
    !> Spans that one span may become in a round, at least and at most; and the least share of what
    !> its neighbour becomes, so that lengths of spans change gently.
    real(dp), parameter :: fewest = 0.2_dp, most = 5.0_dp, gentle = 0.4_dp

contains

    !> Fits a curve within a tolerance; the spline has the parameter of the curve, and its ends are
    !> the curve's. `largest` is the largest distance found from points of the spline to the curve,
    !> measured at 16 points of each span or more and 512 in all.
    !>
    !> Fails with `cause%no_convergence` where `most_spans` spans do not reach the tolerance; the
    !> spline, its distance and its place are then the last ones tried.
    pure subroutine fit_curve(f, tolerance, spline, largest, worst_t, error)
        class(curve_function_type), intent(in) :: f         !! the curve
        real(dp), intent(in) :: tolerance                   !! above zero, deck units
        type(bspline_type), intent(out) :: spline           !! of degree 5
        real(dp), intent(out) :: largest                    !! distance, deck units
        real(dp), intent(out) :: worst_t                    !! where it is
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp), allocatable :: breaks(:), misses(:)
        integer :: round

        breaks = [0.0_dp, 1.0_dp]
        do round = 1, most_rounds
            call interpolate(f, breaks, spline, error)
            if (allocated(error)) return
            call measure(f, breaks, spline, misses, worst_t)
            largest = maxval(misses)
            if (largest <= tolerance) return
            if (round < free_rounds) then
                breaks = spread_breaks(breaks, misses/(aim*tolerance))
            else
                breaks = halved_breaks(breaks, misses > tolerance)
            end if
            if (size(breaks) > most_spans) exit
        end do
        call fail(error, cause%no_convergence, 'a curve can''t be fitted within '// &
            compact(tolerance)//': a spline of '//to_text(size(misses))//' spans is '// &
            compact(largest)//' off')
    end subroutine fit_curve

    !> The spline through the points of a curve at the nodes of some breaks.
    pure subroutine interpolate(f, breaks, spline, error)
        class(curve_function_type), intent(in) :: f         !! the curve
        real(dp), intent(in) :: breaks(:)                   !! rising from 0 to 1
        type(bspline_type), intent(out) :: spline           !! through them
        type(error_type), allocatable, intent(out) :: error !! as `fit_values`
        real(dp) :: nodes(size(breaks) + degree - 1), values(3, size(breaks) + degree - 1)
        integer :: i

        nodes = fit_nodes(breaks, degree)
        do i = 1, size(nodes)
            values(:, i) = f%at(nodes(i))
        end do
        spline%degree = degree
        allocate (spline%knot(size(breaks) + 2*degree), spline%weight(size(nodes)), &
            spline%pole(3, size(nodes)))
        spline%knot = fit_knots(breaks, degree)
        spline%weight = 1.0_dp
        call fit_values(breaks, degree, values, spline%pole, error)
    end subroutine interpolate

    !> How far each span is from the curve.
    pure subroutine measure(f, breaks, spline, misses, worst_t)
        class(curve_function_type), intent(in) :: f         !! the curve
        real(dp), intent(in) :: breaks(:)                   !! rising from 0 to 1
        type(bspline_type), intent(in) :: spline            !! with these breaks
        real(dp), allocatable, intent(out) :: misses(:)     !! largest distance of each span
        real(dp), intent(out) :: worst_t                    !! where the largest of all is
        real(dp) :: t, miss, greatest
        integer :: points, i, j

        allocate (misses(size(breaks) - 1), source=0.0_dp)
        points = max(span_points, curve_points/size(misses) + 1)
        greatest = -1.0_dp
        worst_t = 0.0_dp
        do i = 1, size(misses)
            do j = 1, points
                t = breaks(i) + (real(j, dp) - 0.5_dp)/real(points, dp)*(breaks(i + 1) - breaks(i))
                miss = distance(f, spline, t)
                misses(i) = max(misses(i), miss)
                if (miss <= greatest) cycle
                greatest = miss
                worst_t = t
            end do
        end do
    end subroutine measure

    !> The distance from the point of a spline to the curve: to the curve's point at the same
    !> parameter, or at one set ahead by what the spline lags, where that is nearer.
    pure real(dp) function distance(f, spline, t)
        class(curve_function_type), intent(in) :: f !! the curve
        type(bspline_type), intent(in) :: spline    !! fitted to it
        real(dp), intent(in) :: t                   !! 0 to 1
        real(dp) :: point(3), first(3), second(3), way(3), pace, ahead

        call spline_jet(spline, t, point, first, second)
        way = point - f%at(t)
        distance = norm2(way)
        pace = dot_product(first, first)
        if (.not. pace > 0.0_dp) return
        ahead = min(max(t + dot_product(way, first)/pace, 0.0_dp), 1.0_dp)
        distance = min(distance, norm2(point - f%at(ahead)))
    end function distance

    !> New breaks: as many as the spans ask for, spread as they ask.
    pure function spread_breaks(breaks, excess) result(new)
        real(dp), intent(in) :: breaks(:)   !! rising
        real(dp), intent(in) :: excess(:)   !! error of each span over the one aimed at
        real(dp), allocatable :: new(:)
        real(dp) :: asked(size(excess)), counted(size(breaks)), wanted, share
        integer :: spans, i, j

        asked = min(max(excess**(1.0_dp/real(degree + 1, dp)), fewest), most)
        do i = 2, size(asked)
            asked(i) = max(asked(i), gentle*asked(i - 1))
        end do
        do i = size(asked) - 1, 1, -1
            asked(i) = max(asked(i), gentle*asked(i + 1))
        end do
        counted(1) = 0.0_dp
        do i = 1, size(asked)
            counted(i + 1) = counted(i) + asked(i)
        end do
        spans = ceiling(counted(size(breaks)))
        allocate (new(spans + 1))
        new(1) = breaks(1)
        new(spans + 1) = breaks(size(breaks))
        j = 1
        do i = 1, spans - 1
            wanted = counted(size(breaks))*real(i, dp)/real(spans, dp)
            do while (counted(j + 1) < wanted)
                j = j + 1
            end do
            share = (wanted - counted(j))/asked(j)
            new(i + 1) = breaks(j) + share*(breaks(j + 1) - breaks(j))
        end do
    end function spread_breaks

    !> The breaks with the middles of some spans.
    pure function halved_breaks(breaks, is_wanted) result(new)
        real(dp), intent(in) :: breaks(:)       !! rising
        logical, intent(in) :: is_wanted(:)     !! these spans are halved
        real(dp), allocatable :: new(:)
        integer :: i, last

        allocate (new(size(breaks) + count(is_wanted)))
        new(1) = breaks(1)
        last = 1
        do i = 1, size(is_wanted)
            if (is_wanted(i)) then
                last = last + 1
                new(last) = 0.5_dp*(breaks(i) + breaks(i + 1))
            end if
            last = last + 1
            new(last) = breaks(i + 1)
        end do
    end function halved_breaks

end module geom_curve_fit
