!> A contour of curves as circular arcs: each curve a chain of its own, which keeps the curve's
!> tangents where curves meet and where its pairs of arcs do; so what is smooth stays smooth, and a
!> corner stays one.
!>
!> What arcs may miss their curve by is what the curve's own error and the gap to its neighbour
!> leave of the tolerance, less a quarter, which is left for the rounding of the files that have
!> them: the listing, NC programs and DXF files have the same arcs. Each curve is run from its end
!> nearer to BL 0, so that mirror images have the same arcs, too.
module export_arcs
    use base_digits, only: shortest
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use cut_plane, only: in_space, plane_type, true_shape
    use export_chords, only: decimals_for, rounding_error, widest_gap
    use export_drawing, only: contour_type, curve_type
    use export_drawing_join, only: in_plane
    use geom_arc_chain, only: arcs_along, chain_arc_type, reversed_chain
    use geom_bspline, only: bspline_type, reversed_spline
    use geom_circular, only: circular_between, circular_type, direction_to, distance_from, &
        parted_circular
    use geom_plane_spline, only: plane_spline_type
    implicit none (type, external)
    private

    public :: arc_contour_type, arcs_of_contour, parted_arcs, decimals_of_arcs, arc_rounding

    !> A contour as arcs, in u and v of its plane.
    type :: arc_contour_type
        type(chain_arc_type), allocatable :: arcs(:)    !! in order; none: the contour is a point
        real(dp) :: start(2) = 0.0_dp                   !! where it begins
        logical :: is_closed = .false.                  !! the last ends where the first begins
        real(dp) :: error = 0.0_dp                      !! largest distance from the exact shape
        real(dp) :: worst(3) = 0.0_dp                   !! where: STA, BL, WL
    end type arc_contour_type

    !> The part of the tolerance of arcs that fitted curves may take: what is left of a fit's error
    !> in its curvature makes arcs shorter than they need be.
    real(dp), parameter, public :: part_for_curves = 1.0e-3_dp
    !> The part of the tolerance that rounding may take, that which must be left for arcs, and the
    !> distance from a straight line that is none.
    real(dp), parameter :: rounding_part = 0.25_dp, least_left = 0.01_dp, straight = 0.01_dp
    !> The turn of an arc, radians, from which on it is parted: a little below 180 degrees, where
    !> controls lose the sense of it.
    real(dp), parameter :: widest_turn = 3.0_dp

contains

    !> The arcs of a contour. `deviation` of each has the error of its curve in it.
    !>
    !> Fails with `cause%no_convergence` where the curves are too far from the exact shape to leave
    !> anything for arcs, or are not smooth; with `cause%joint_gap` where they do not meet; and with
    !> `cause%too_many` where the arcs are too many.
    pure subroutine arcs_of_contour(plane, contour, tolerance, chain, error)
        type(plane_type), intent(in) :: plane               !! of the shape
        type(contour_type), intent(in) :: contour           !! in it, of finite poles
        real(dp), intent(in) :: tolerance                   !! above zero, unit of the drawing
        type(arc_contour_type), intent(out) :: chain        !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(chain_arc_type), allocatable :: arcs(:)
        real(dp) :: gap, left
        integer :: i, k

        chain%is_closed = contour%is_closed
        chain%worst = contour%at
        if (size(contour%curves) > 0) chain%worst = contour%curves(1)%spline%pole(:, 1)
        chain%start = true_shape(plane, chain%worst)
        allocate (chain%arcs(0))
        gap = widest_gap(contour)
        do i = 1, size(contour%curves)
            associate (curve => contour%curves(i))
                left = (1.0_dp - rounding_part)*tolerance - gap - curve%error
                if (left < least_left*tolerance) then
                    call fail(error, merge(cause%joint_gap, cause%no_convergence, &
                        gap > curve%error), 'a curve is '//shortest(gap + curve%error)// &
                        ' from the exact shape; arcs within '//shortest(tolerance)// &
                        ' take a better one')
                    return
                end if
                call arcs_of_curve(plane, curve, left, arcs, error)
                if (allocated(error)) return
                arcs%deviation = arcs%deviation + gap + curve%error
                do k = 1, size(arcs)
                    if (arcs(k)%deviation < chain%error) cycle
                    chain%error = arcs(k)%deviation
                    chain%worst = in_space(plane, arcs(k)%worst)
                end do
            end associate
            chain%arcs = [chain%arcs, arcs]
        end do
    end subroutine arcs_of_contour

    !> The arcs of a curve; none where it has shrunk to a point.
    !>
    !> Fails as `arcs_along`.
    pure subroutine arcs_of_curve(plane, curve, tolerance, arcs, error)
        type(plane_type), intent(in) :: plane                       !! of the shape
        type(curve_type), intent(in) :: curve                       !! in it
        real(dp), intent(in) :: tolerance                           !! that is left for arcs
        type(chain_arc_type), allocatable, intent(out) :: arcs(:)   !! in order
        type(error_type), allocatable, intent(out) :: error         !! see above
        type(plane_spline_type) :: flat
        logical :: is_backward

        is_backward = runs_to_centre(curve%spline)
        call flatten(plane, curve%spline, is_backward, flat%spline)
        associate (poles => flat%spline%pole)
            if (all(is_equal(poles, spread(poles(:, 1), 2, size(poles, 2))))) then
                allocate (arcs(0))
                return
            end if
        end associate
        allocate (arcs(1))
        arcs(1) = line_along(flat%spline)
        if (arcs(1)%deviation > straight*tolerance) then
            call arcs_along(flat, tolerance, arcs, error)
            if (allocated(error)) return
        end if
        if (is_backward) arcs = reversed_chain(arcs)
    end subroutine arcs_of_curve

    !> True where a curve has its end nearer to BL 0 than its start; where both are as near, its end
    !> is farther forward or lower. A mirror image that runs backwards differs in this.
    pure logical function runs_to_centre(spline)
        type(bspline_type), intent(in) :: spline    !! in space
        real(dp), dimension(3) :: start, finish
        integer, parameter :: order(3) = [2, 1, 3]
        integer :: i

        start = spline%pole(:, 1)
        finish = spline%pole(:, size(spline%pole, 2))
        start(2) = abs(start(2))
        finish(2) = abs(finish(2))
        runs_to_centre = .false.
        do i = 1, size(order)
            if (is_equal(start(order(i)), finish(order(i)))) cycle
            runs_to_centre = finish(order(i)) < start(order(i))
            return
        end do
    end function runs_to_centre

    !> A spline of space in u and v of its plane.
    pure subroutine flatten(plane, spline, is_backward, flat)
        type(plane_type), intent(in) :: plane       !! of u and v
        type(bspline_type), intent(in) :: spline    !! of three dimensions, in the plane
        logical, intent(in) :: is_backward          !! it shall run the other way
        type(bspline_type), intent(out) :: flat     !! of two dimensions

        flat = spline
        if (is_backward) flat = reversed_spline(spline)
        flat%pole = in_plane(plane, flat%pole)
    end subroutine flatten

    !> The straight line from the start of a spline to its end. The spline is in the hull of its
    !> poles: none of its points is farther from the line than one of them.
    pure type(chain_arc_type) function line_along(spline) result(line)
        type(bspline_type), intent(in) :: spline    !! of two dimensions, not a point
        real(dp) :: distance, along, reach
        integer :: i

        associate (start => spline%pole(:, 1), finish => spline%pole(:, size(spline%pole, 2)))
            line%ends = [0.0_dp, 1.0_dp]
            line%worst = start
            line%deviation = huge(1.0_dp)
            if (all(is_equal(start, finish))) return
            line%arc = circular_between(start, direction_to(start, finish), finish)
            line%deviation = 0.0_dp
            reach = norm2(finish - start)
            do i = 2, size(spline%pole, 2) - 1
                associate (pole => spline%pole(:, i))
                    along = dot_product(pole - start, finish - start)/reach
                    distance = max(distance_from(line%arc, pole), -along, along - reach)
                    if (distance <= line%deviation) cycle
                    line%deviation = distance
                    line%worst = pole
                end associate
            end do
        end associate
    end function line_along

    !> The arcs of a contour, those of nearly 180 degrees and more in two or more: as NC controls
    !> and DXF files take them.
    pure function parted_arcs(chain) result(arcs)
        type(arc_contour_type), intent(in) :: chain     !! any
        type(circular_type), allocatable :: arcs(:)
        integer :: i

        allocate (arcs(0))
        do i = 1, size(chain%arcs)
            arcs = [arcs, parts_of(chain%arcs(i)%arc)]
        end do
    end function parted_arcs

    !> An arc, in as many parts as no longer turn far.
    pure function parts_of(arc) result(parts)
        type(circular_type), intent(in) :: arc !! any
        type(circular_type), allocatable :: parts(:)
        allocate (parts(1 + int(abs(arc%turn)/widest_turn)))
        parts = parted_circular(arc, size(parts))
    end function parts_of

    !> The decimals of coordinates whose rounding, at both ends of an arc and at its centre, takes
    !> no more of a tolerance than it may; not fewer than usual.
    pure integer function decimals_of_arcs(tolerance, usual) result(decimals)
        real(dp), intent(in) :: tolerance   !! above zero, unit of the drawing
        integer, intent(in) :: usual        !! decimals
        decimals = decimals_for(tolerance, usual)
        do while (arc_rounding(decimals) > rounding_part*tolerance)
            decimals = decimals + 1
        end do
    end function decimals_of_arcs

    !> How far rounding moves an arc of at most 180 degrees: its ends by as much as it moves a
    !> point, and, where its centre is moved as well, what is between them by twice that more.
    pure real(dp) function arc_rounding(decimals) result(most)
        integer, intent(in) :: decimals     !! behind the point
        most = 3.0_dp*rounding_error(decimals, 2)
    end function arc_rounding

end module export_arcs
