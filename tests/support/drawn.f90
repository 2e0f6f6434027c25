!> What tests ask of drawn shapes: how far points are from them, and whether they hang together.
module support_drawn
    use base_kinds, only: dp
    use cut_outline, only: outline_type
    use export_drawing, only: contour_type, curve_type, shape_type
    use geom_bspline, only: bspline_type, spline_from, spline_jet, spline_to
    implicit none (type, external)
    private

    public :: distance_from_contour, distance_from_curve, largest_miss, is_end_to_end
    public :: largest_error, curve_count

    !> Points of a curve next to which the nearest one is looked for, and Newton steps to it.
    integer, parameter :: points = 100, steps = 20

contains

    !> The distance of a point from a contour.
    real(dp) function distance_from_contour(contour, at) result(distance)
        type(contour_type), intent(in) :: contour   !! with curves
        real(dp), intent(in) :: at(3)               !! STA, BL, WL
        integer :: i
        distance = huge(1.0_dp)
        do i = 1, size(contour%curves)
            distance = min(distance, distance_from_curve(contour%curves(i)%spline, at))
        end do
    end function distance_from_contour

    !> The distance of a point from a spline.
    real(dp) function distance_from_curve(spline, at) result(distance)
        type(bspline_type), intent(in) :: spline    !! in space
        real(dp), intent(in) :: at(3)               !! STA, BL, WL
        real(dp) :: t, best, point(3), first(3), second(3), slope
        integer :: i

        best = spline_from(spline)
        distance = huge(1.0_dp)
        do i = 0, points
            t = spline_from(spline) + (spline_to(spline) - spline_from(spline))*real(i, dp)/points
            call spline_jet(spline, t, point, first, second)
            if (norm2(point - at) > distance) cycle
            distance = norm2(point - at)
            best = t
        end do
        t = best
        do i = 1, steps
            call spline_jet(spline, t, point, first, second)
            distance = min(distance, norm2(point - at))
            slope = dot_product(first, first) + dot_product(point - at, second)
            if (.not. slope > 0.0_dp) exit
            t = t - dot_product(point - at, first)/slope
            t = min(max(t, spline_from(spline)), spline_to(spline))
        end do
    end function distance_from_curve

    !> The largest distance of the points of outlines from the contours of a shape: of the outside,
    !> or of the inside.
    real(dp) function largest_miss(outlines, shape, is_inside) result(largest)
        type(outline_type), intent(in) :: outlines(:)   !! of a cut
        type(shape_type), intent(in) :: shape           !! of it
        logical, intent(in) :: is_inside                !! which contours
        real(dp) :: nearest
        integer :: i, k, n

        largest = 0.0_dp
        do i = 1, size(outlines)
            do k = 1, size(outlines(i)%points)
                nearest = huge(1.0_dp)
                do n = 1, size(shape%contours)
                    if (shape%contours(n)%is_inside .neqv. is_inside) cycle
                    nearest = min(nearest, distance_from_contour(shape%contours(n), &
                        outlines(i)%points(k)%at))
                end do
                largest = max(largest, nearest)
            end do
        end do
    end function largest_miss

    !> True where the curves of every contour meet in the same numbers, and closed ones close.
    logical function is_end_to_end(shape)
        type(shape_type), intent(in) :: shape !! any
        integer :: i, k
        is_end_to_end = .true.
        do i = 1, size(shape%contours)
            associate (curves => shape%contours(i)%curves)
                do k = 1, size(curves)
                    if (k == size(curves) .and. .not. shape%contours(i)%is_closed) cycle
                    is_end_to_end = is_end_to_end .and. &
                        meet(curves(k), curves(mod(k, size(curves)) + 1))
                end do
            end associate
        end do
    end function is_end_to_end

    !> True where a curve ends in the numbers in which another begins; the arcs, too.
    logical function meet(curve, next)
        type(curve_type), intent(in) :: curve   !! any
        type(curve_type), intent(in) :: next    !! another
        meet = all(abs(curve%spline%pole(:, size(curve%spline%weight)) - next%spline%pole(:, 1)) &
            <= 0.0_dp)
        if (curve%is_conic .and. next%is_conic) &
            meet = meet .and. all(abs(curve%arc%finish - next%arc%start) <= 0.0_dp)
    end function meet

    !> The largest error that any curve of a shape says it has.
    real(dp) function largest_error(shape)
        type(shape_type), intent(in) :: shape !! any
        integer :: i
        largest_error = 0.0_dp
        do i = 1, size(shape%contours)
            largest_error = max(largest_error, maxval([0.0_dp, shape%contours(i)%curves%error]))
        end do
    end function largest_error

    !> How many curves a shape has: all, or those that say they are exact.
    integer function curve_count(shape, is_exact) result(number)
        type(shape_type), intent(in) :: shape   !! any
        logical, intent(in) :: is_exact         !! exact ones only
        integer :: i
        number = 0
        do i = 1, size(shape%contours)
            number = number + count(shape%contours(i)%curves%is_exact .or. .not. is_exact)
        end do
    end function curve_count

end module support_drawn
