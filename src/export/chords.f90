!> A contour of curves as a polygon: points of the curves so close that the straight lines between
!> them stay within a tolerance of the exact shape.
!>
!> What a chord may miss its curve by is what the curve's own error and the gap to its neighbour
!> leave of the tolerance. Each chord is measured again, at places between its ends.
module export_chords
    use base_digits, only: scientific, shortest
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use export_drawing, only: contour_type
    use export_drawing_join, only: gap_between
    use geom_bspline, only: bspline_type, spline_point
    use geom_spline_polygon, only: polygon_of
    implicit none (type, external)
    private

    public :: polygon_type, chord_polygon, round_polygon, rounding_error, decimals_for, rounded
    public :: widest_gap

    !> A polygon, in space or in a plane.
    type :: polygon_type
        real(dp), allocatable :: at(:, :)       !! corners by columns; one: the contour is a point
        logical :: is_closed = .false.          !! the last is joined to the first
        real(dp) :: error = 0.0_dp              !! largest distance from the exact shape
        real(dp) :: worst(3) = 0.0_dp           !! where: STA, BL, WL
    end type polygon_type

    !> The part of the tolerance that must be left for chords, and that which rounding may take.
    real(dp), parameter :: least_left = 0.01_dp, rounding_part = 0.1_dp
    !> The finest tolerance of chords, in parts of the largest coordinate: a circle about the origin
    !> has then some 200000 of them. Finer ones would fill the memory and come near to rounding.
    real(dp), parameter :: finest_part = 1.0e-10_dp
    !> Places where each chord is measured, besides those where it was made.
    integer, parameter :: measured_places = 4

contains

    !> The polygon of a contour, in space. A contour without curves has one corner.
    !>
    !> Fails with `cause%no_convergence` where the curves are too far from the exact shape to leave
    !> anything for chords, `cause%joint_gap` where they do not meet, and `cause%too_many` where the
    !> tolerance takes more chords than are of use.
    pure subroutine chord_polygon(contour, tolerance, polygon, error)
        type(contour_type), intent(in) :: contour           !! of finite poles
        real(dp), intent(in) :: tolerance                   !! above zero, unit of the drawing
        type(polygon_type), intent(out) :: polygon          !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: gap, finest
        integer :: i

        polygon%is_closed = contour%is_closed
        polygon%worst = contour%at
        polygon%at = reshape(contour%at, [3, 1])
        if (size(contour%curves) == 0) return
        polygon%at = polygon%at(:, :0)
        finest = finest_part*largest_coordinate(contour)
        if (tolerance < finest) then
            call fail(error, cause%too_many, 'chords within '// &
                trim(adjustl(scientific(tolerance, 9, 2)))// &
                ' are too many; a shape so large takes a tolerance of '// &
                trim(adjustl(scientific(finest, 9, 2)))//' or more')
            return
        end if
        gap = widest_gap(contour)
        if (gap > 0.5_dp*tolerance) then
            call fail(error, cause%joint_gap, 'the curves of a contour are '//shortest(gap)// &
                ' apart, which is more than the tolerance allows')
            return
        end if
        do i = 1, size(contour%curves)
            call add_curve(contour, i, tolerance - gap, polygon, error)
            if (allocated(error)) return
        end do
        polygon%error = polygon%error + gap
        call drop_repeated(polygon)
    end subroutine chord_polygon

    !> The largest magnitude of a coordinate of the poles.
    pure real(dp) function largest_coordinate(contour) result(largest)
        type(contour_type), intent(in) :: contour   !! any
        integer :: i
        largest = 0.0_dp
        do i = 1, size(contour%curves)
            largest = max(largest, maxval(abs(contour%curves(i)%spline%pole)))
        end do
    end function largest_coordinate

    !> How far apart ends of neighbouring curves are that should meet.
    pure real(dp) function widest_gap(contour) result(gap)
        type(contour_type), intent(in) :: contour   !! any
        integer :: i, before

        gap = 0.0_dp
        do i = 1, size(contour%curves)
            before = i - 1
            if (before == 0) before = size(contour%curves)
            if (i == 1 .and. .not. contour%is_closed) cycle
            gap = max(gap, gap_between(contour%curves(before), contour%curves(i)))
        end do
    end function widest_gap

    !> Adds the corners of one curve, its last left out where another begins there.
    pure subroutine add_curve(contour, i, tolerance, polygon, error)
        type(contour_type), intent(in) :: contour           !! with curves
        integer, intent(in) :: i                            !! which
        real(dp), intent(in) :: tolerance                   !! for curve and chords
        type(polygon_type), intent(inout) :: polygon        !! gets them
        type(error_type), allocatable, intent(out) :: error !! see `chord_polygon`
        real(dp), allocatable :: t(:), at(:, :)
        real(dp) :: largest, worst(3)
        integer :: k

        associate (curve => contour%curves(i))
            if (tolerance - curve%error < least_left*tolerance) then
                call fail(error, cause%no_convergence, 'a curve is '//shortest(curve%error)// &
                    ' from the exact shape; chords within '//shortest(tolerance)// &
                    ' take a better one')
                return
            end if
            call polygon_of(curve%spline, tolerance - curve%error, t, largest)
            allocate (at(3, size(t)))
            do k = 1, size(t)
                at(:, k) = spline_point(curve%spline, t(k))
            end do
            call measure(curve%spline, t, at, largest, worst)
            if (curve%error + largest >= polygon%error) then
                polygon%error = curve%error + largest
                polygon%worst = merge(curve%worst, worst, curve%error > largest)
            end if
        end associate
        polygon%at = reshape([polygon%at, at], [3, size(polygon%at, 2) + size(at, 2)])
        if (i < size(contour%curves) .or. contour%is_closed) &
            polygon%at = polygon%at(:, :size(polygon%at, 2) - 1)
    end subroutine add_curve

    !> Measures the chords of a curve.
    pure subroutine measure(spline, t, at, largest, worst)
        type(bspline_type), intent(in) :: spline    !! the curve
        real(dp), intent(in) :: t(:)                !! parameters of the corners
        real(dp), intent(in) :: at(:, :)            !! the corners
        real(dp), intent(inout) :: largest          !! distance, made larger where one is
        real(dp), intent(out) :: worst(3)           !! where the largest is that was met
        real(dp) :: there(3), distance, met
        integer :: k, j

        worst = at(:, 1)
        met = 0.0_dp
        do k = 2, size(t)
            do j = 1, measured_places
                there = spline_point(spline, t(k - 1) + (t(k) - t(k - 1))*real(j, dp)/ &
                    real(measured_places + 1, dp))
                distance = distance_from(at(:, k - 1), at(:, k), there)
                if (distance <= met) cycle
                met = distance
                worst = there
            end do
        end do
        largest = max(largest, met)
    end subroutine measure

    !> The distance of a point from a straight piece.
    pure real(dp) function distance_from(from, to, place) result(distance)
        real(dp), intent(in) :: from(3)     !! one end of the piece
        real(dp), intent(in) :: to(3)       !! its other end
        real(dp), intent(in) :: place(3)    !! the point
        real(dp) :: along(3), length, part

        length = norm2(to - from)
        distance = norm2(place - from)
        if (.not. length > 0.0_dp) return
        along = (to - from)/length
        part = min(length, max(0.0_dp, dot_product(place - from, along)))
        distance = norm2(place - from - part*along)
    end function distance_from

    !> Rounds the corners to decimals and leaves out those that fall on the one before. The error
    !> becomes what it may be then.
    pure subroutine round_polygon(polygon, decimals)
        type(polygon_type), intent(inout) :: polygon    !! at least one corner
        integer, intent(in) :: decimals                 !! behind the point
        polygon%error = polygon%error + rounding_error(decimals, size(polygon%at, 1))
        polygon%at = rounded(polygon%at, decimals)
        call drop_repeated(polygon)
    end subroutine round_polygon

    !> A number rounded to decimals, where a double has as many.
    elemental real(dp) function rounded(value, decimals)
        real(dp), intent(in) :: value       !! finite
        integer, intent(in) :: decimals     !! behind the point
        real(dp) :: power
        power = 10.0_dp**decimals
        rounded = value
        if (abs(value) < 1.0_dp/(epsilon(1.0_dp)*power)) rounded = anint(value*power)/power
    end function rounded

    !> How far rounding moves a corner at most.
    pure real(dp) function rounding_error(decimals, dimensions) result(most)
        integer, intent(in) :: decimals     !! behind the point
        integer, intent(in) :: dimensions   !! of the corner
        most = 0.5_dp*10.0_dp**(-decimals)*sqrt(real(dimensions, dp))
    end function rounding_error

    !> The decimals whose rounding takes little of a tolerance; not fewer than usual.
    pure integer function decimals_for(tolerance, usual) result(decimals)
        real(dp), intent(in) :: tolerance   !! above zero
        integer, intent(in) :: usual        !! decimals
        decimals = usual
        do while (rounding_error(decimals, 3) > rounding_part*tolerance)
            decimals = decimals + 1
        end do
    end function decimals_for

    !> Leaves out corners that fall on the one before; of a closed polygon a last one on the first.
    pure subroutine drop_repeated(polygon)
        type(polygon_type), intent(inout) :: polygon !! at least one corner
        logical :: is_kept(size(polygon%at, 2))
        integer :: i, count

        is_kept = .true.
        do i = 2, size(is_kept)
            is_kept(i) = any(abs(polygon%at(:, i) - polygon%at(:, i - 1)) > 0.0_dp)
        end do
        count = size(is_kept)
        if (polygon%is_closed .and. count > 1) is_kept(count) = is_kept(count) .and. &
            any(abs(polygon%at(:, count) - polygon%at(:, 1)) > 0.0_dp)
        polygon%at = polygon%at(:, pack([(i, i=1, count)], is_kept))
    end subroutine drop_repeated

end module export_chords
