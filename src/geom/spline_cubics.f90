!> A plane spline as cubic Bezier arcs end to end, within a tolerance: the curves of SVG and PDF.
!>
!> An arc has the ends and the end tangents of its stretch of the spline; the lengths a and b of its
!> two handles are found by least squares of the distances across the spline, after which the error
!> goes with the sixth power of the stretch. Stretches are taken greedily, as long as the tolerance
!> allows, and end where the spline may have a corner.
!>
!> Source: C. de Boor, K. Hollig and M. Sabin, "High accuracy geometric Hermite interpolation",
!> Computer Aided Geometric Design 4 (1987), pp. 269-278, for the order; the least squares are ours.
module geom_spline_cubics
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_tolerances, only: ulp
    use geom_bspline, only: bspline_type, spline_from, spline_jet, spline_point, spline_to
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: cubics_of

    !> Points of an arc at which its distance from the spline is measured.
    integer, parameter :: arc_points = 15
    !> Points of a stretch among which the one nearest to a point is sought, and steps of Newton's
    !> method from it.
    integer, parameter :: stretch_points = 32, foot_steps = 4
    !> Rounds of least squares; what holds the handles where the distances don't, in parts of what
    !> the distances weigh.
    integer, parameter :: rounds = 5
    real(dp), parameter :: hold = 1.0e-6_dp
    !> Trials of a stretch as in `geom_spline_polygon`.
    integer, parameter :: most_trials = 8
    real(dp), parameter :: aim = 0.97_dp, enough = 0.6_dp
    !> Order of the error.
    real(dp), parameter :: order = 6.0_dp

    !> A Bezier arc.
    type :: cubic_type
        real(dp) :: control(2, 4) = 0.0_dp  !! control points, deck units
        real(dp) :: miss = 0.0_dp           !! its distance from the spline, measured
        real(dp) :: worst(2) = 0.0_dp       !! the point of the spline where that is
    end type cubic_type

    !> A stretch of a spline, sampled, and the handles of the arc that stands for it.
    type :: stretch_type
        real(dp) :: from = 0.0_dp                   !! parameter
        real(dp) :: to = 0.0_dp                     !! parameter
        real(dp) :: t(0:stretch_points) = 0.0_dp    !! parameters of points of it
        real(dp) :: at(2, 0:stretch_points) = 0.0_dp !! the points
        real(dp) :: ahead(2, 2) = 0.0_dp            !! unit tangents at its ends
        real(dp) :: length = 0.0_dp                 !! along the points
        real(dp) :: handle(2) = 0.0_dp              !! a and b
    end type stretch_type

contains

    !> The cubic arcs: of each its four control points. Neighbours share their end points, and their
    !> tangents where the spline has one there. `largest` is the largest distance of a point of an
    !> arc from the spline, measured at 15 points of each, and `worst` where it is. Stretches so
    !> short that doubles can't part them are taken as they are.
    pure subroutine cubics_of(spline, tolerance, control, largest, worst)
        type(bspline_type), intent(in) :: spline                !! in a plane
        real(dp), intent(in) :: tolerance                       !! above zero, deck units
        real(dp), allocatable, intent(out) :: control(:, :, :)  !! shape (2, 4, arcs), deck units
        real(dp), intent(out) :: largest                        !! deck units
        real(dp), intent(out) :: worst(2)                       !! a point of the spline
        type(bspline_type) :: piece
        type(cubic_type) :: arc
        real(dp) :: from, step, next
        integer :: count, first, last

        allocate (control(2, 4, size(spline%weight)))
        worst = spline%pole(:, 1)
        count = 0
        largest = -1.0_dp
        first = 1
        do while (first < size(spline%weight))
            last = piece_end(spline, first)
            piece = piece_of(spline, first, last)
            from = spline_from(piece)
            step = spline_to(piece) - from
            do while (from < spline_to(piece))
                call find_next(piece, from, tolerance, step, next, arc)
                if (arc%miss > largest) worst = arc%worst
                largest = max(largest, arc%miss)
                call append(control, count, arc%control)
                from = next
            end do
            first = last
        end do
        control = control(:, :, :count)
    end subroutine cubics_of

    !> The longest arc from a place; `step` is what is tried, and then what was good.
    pure subroutine find_next(piece, from, tolerance, step, next, arc)
        type(bspline_type), intent(in) :: piece !! without corners
        real(dp), intent(in) :: from            !! where the arc begins
        real(dp), intent(in) :: tolerance       !! deck units
        real(dp), intent(inout) :: step         !! see above
        real(dp), intent(out) :: next           !! where it ends
        type(cubic_type), intent(out) :: arc    !! the arc
        real(dp) :: limit, factor
        integer :: trial

        limit = spline_to(piece)
        do trial = 1, most_trials + digits(step)
            next = min(from + step, limit)
            if (next >= limit) step = limit - from
            arc = best_arc(piece, from, next)
            factor = (aim*tolerance/max(arc%miss, ulp*tolerance))**(1.0_dp/order)
            if (trial > most_trials) factor = min(0.5_dp, factor)
            if (arc%miss <= aim*tolerance .and. (next >= limit .or. trial >= most_trials .or. &
                arc%miss >= enough*aim*tolerance)) exit
            if (.not. from + factor*step > from) exit
            step = factor*step
        end do
    end subroutine find_next

    !> The best arc for a stretch.
    pure type(cubic_type) function best_arc(piece, from, to) result(arc)
        type(bspline_type), intent(in) :: piece !! without corners
        real(dp), intent(in) :: from            !! where the stretch begins
        real(dp), intent(in) :: to              !! where it ends
        type(stretch_type) :: stretch
        real(dp) :: foot(2), across(2)
        integer :: i

        call sample(piece, from, to, stretch)
        do i = 1, rounds
            call improve(piece, stretch)
        end do
        arc%control = control_of(stretch)
        arc%worst = arc%control(:, 1)
        do i = 1, arc_points
            associate (p => bezier(arc%control, real(i, dp)/real(arc_points + 1, dp)))
                call find_foot(piece, stretch, p, foot, across)
                if (norm2(p - foot) <= arc%miss) cycle
                arc%miss = norm2(p - foot)
                arc%worst = foot
            end associate
        end do
    end function best_arc

    !> Samples a stretch; its handles are a third of its length.
    pure subroutine sample(piece, from, to, stretch)
        type(bspline_type), intent(in) :: piece         !! without corners
        real(dp), intent(in) :: from                    !! where the stretch begins
        real(dp), intent(in) :: to                      !! where it ends
        type(stretch_type), intent(out) :: stretch      !! sampled
        integer :: i

        stretch%from = from
        stretch%to = to
        do i = 0, stretch_points
            stretch%t(i) = min(from + real(i, dp)/real(stretch_points, dp)*(to - from), to)
            stretch%at(:, i) = spline_point(piece, stretch%t(i))
            if (i > 0) stretch%length = stretch%length + &
                norm2(stretch%at(:, i) - stretch%at(:, i - 1))
        end do
        stretch%handle = stretch%length/3.0_dp
        stretch%ahead(:, 1) = direction(piece, from, stretch%at(:, 1) - stretch%at(:, 0))
        stretch%ahead(:, 2) = direction(piece, to, stretch%at(:, stretch_points) - &
            stretch%at(:, stretch_points - 1))
    end subroutine sample

    !> The unit tangent of a spline, or a direction near it where the derivative is zero.
    pure function direction(piece, t, near)
        type(bspline_type), intent(in) :: piece !! without corners
        real(dp), intent(in) :: t               !! parameter
        real(dp), intent(in) :: near(2)         !! see above
        real(dp) :: direction(2)
        real(dp) :: point(2), second(2)

        call spline_jet(piece, t, point, direction, second)
        if (.not. norm2(direction) > 0.0_dp) direction = near
        if (norm2(direction) > 0.0_dp) direction = direction/norm2(direction)
    end function direction

    !> Corrects the handles by one step of least squares.
    pure subroutine improve(piece, stretch)
        type(bspline_type), intent(in) :: piece         !! without corners
        type(stretch_type), intent(inout) :: stretch    !! sampled
        real(dp) :: u, foot(2), across(2), moves(2), matrix(2, 2), right(2), weight
        integer :: i

        matrix = 0.0_dp
        right = 0.0_dp
        do i = 1, arc_points
            u = real(i, dp)/real(arc_points + 1, dp)
            associate (p => bezier(control_of(stretch), u))
                call find_foot(piece, stretch, p, foot, across)
                moves(1) = 3.0_dp*u*(1.0_dp - u)**2*dot_product(across, stretch%ahead(:, 1))
                moves(2) = -3.0_dp*u**2*(1.0_dp - u)*dot_product(across, stretch%ahead(:, 2))
                right = right - moves*dot_product(across, p - foot)
                matrix = matrix + spread(moves, 1, 2)*spread(moves, 2, 2)
            end associate
        end do
        weight = hold*(matrix(1, 1) + matrix(2, 2))
        if (.not. weight > ulp**2) return
        matrix(1, 1) = matrix(1, 1) + weight
        matrix(2, 2) = matrix(2, 2) + weight
        stretch%handle = stretch%handle + [cross(right, matrix(:, 2)), &
            cross(matrix(:, 1), right)]/cross(matrix(:, 1), matrix(:, 2))
        stretch%handle = min(max(stretch%handle, 0.01_dp*stretch%length), stretch%length)
    end subroutine improve

    !> The point of a stretch nearest to a point, and the unit normal there.
    pure subroutine find_foot(piece, stretch, p, foot, across)
        type(bspline_type), intent(in) :: piece     !! without corners
        type(stretch_type), intent(in) :: stretch   !! sampled
        real(dp), intent(in) :: p(2)                !! near the stretch
        real(dp), intent(out) :: foot(2)            !! see above
        real(dp), intent(out) :: across(2)          !! see above
        real(dp) :: t, first(2), second(2), slope
        integer :: i

        i = minloc((stretch%at(1, :) - p(1))**2 + (stretch%at(2, :) - p(2))**2, dim=1)
        t = stretch%t(i - 1)
        do i = 0, foot_steps
            call spline_jet(piece, t, foot, first, second)
            if (i == foot_steps) exit
            slope = dot_product(first, first) + dot_product(foot - p, second)
            if (.not. slope > 0.0_dp) exit
            t = min(max(t - dot_product(foot - p, first)/slope, stretch%from), stretch%to)
        end do
        across = [-first(2), first(1)]
        if (norm2(across) > 0.0_dp) across = across/norm2(across)
    end subroutine find_foot

    !> The control points of the arc that stands for a stretch.
    pure function control_of(stretch) result(arc)
        type(stretch_type), intent(in) :: stretch   !! sampled
        real(dp) :: arc(2, 4)
        arc(:, 1) = stretch%at(:, 0)
        arc(:, 2) = stretch%at(:, 0) + stretch%handle(1)*stretch%ahead(:, 1)
        arc(:, 3) = stretch%at(:, stretch_points) - stretch%handle(2)*stretch%ahead(:, 2)
        arc(:, 4) = stretch%at(:, stretch_points)
    end function control_of

    !> A point of a Bezier arc.
    pure function bezier(arc, u) result(p)
        real(dp), intent(in) :: arc(2, 4)   !! control points
        real(dp), intent(in) :: u           !! 0 to 1
        real(dp) :: p(2)
        p = (1.0_dp - u)**3*arc(:, 1) + 3.0_dp*u*(1.0_dp - u)**2*arc(:, 2) + &
            3.0_dp*u**2*(1.0_dp - u)*arc(:, 3) + u**3*arc(:, 4)
    end function bezier

    !> The last pole of a stretch that begins at a pole the curve goes through: the next such pole.
    pure integer function piece_end(spline, first) result(last)
        type(bspline_type), intent(in) :: spline    !! any spline
        integer, intent(in) :: first                !! a pole the curve goes through, not the last
        do last = first + 1, size(spline%weight) - 1
            if (is_equal(spline%knot(last + 1), spline%knot(last + spline%degree))) return
        end do
    end function piece_end

    !> The stretch of a spline between two poles that it goes through.
    pure type(bspline_type) function piece_of(spline, first, last) result(piece)
        type(bspline_type), intent(in) :: spline    !! any spline
        integer, intent(in) :: first                !! a pole the curve goes through
        integer, intent(in) :: last                 !! another behind it
        integer :: knots

        knots = last - first + 2 + spline%degree
        piece%degree = spline%degree
        allocate (piece%knot(knots))
        piece%knot(2:knots - 1) = spline%knot(first + 1:last + spline%degree)
        piece%knot([1, knots]) = piece%knot([2, knots - 1])
        allocate (piece%pole, source=spline%pole(:, first:last))
        allocate (piece%weight, source=spline%weight(first:last))
    end function piece_of

    !> Puts an arc behind others.
    pure subroutine append(arcs, count, arc)
        real(dp), allocatable, intent(inout) :: arcs(:, :, :)   !! `arcs(:, :, :count)` count
        integer, intent(inout) :: count                         !! how many there are
        real(dp), intent(in) :: arc(2, 4)                       !! one more
        real(dp), allocatable :: grown(:, :, :)

        if (count == size(arcs, 3)) then
            allocate (grown(2, 4, 2*count))
            grown(:, :, :count) = arcs
            call move_alloc(grown, arcs)
        end if
        count = count + 1
        arcs(:, :, count) = arc
    end subroutine append

end module geom_spline_cubics
