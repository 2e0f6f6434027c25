!> Curves of a contour end to end: where two meet they have the same numbers.
module export_drawing_join
    use base_kinds, only: dp
    use base_tolerances, only: agreement_ulps, ulp
    use cut_plane, only: in_space, plane_type, true_shape
    use export_drawing, only: contour_type, curve_type
    implicit none (type, external)
    private

    public :: join, gap_between, first_point, last_point, put_in_space, in_plane, seat_ends

contains

    !> Where a curve begins.
    pure function first_point(curve) result(at)
        type(curve_type), intent(in) :: curve !! has a spline
        real(dp), allocatable :: at(:)
        allocate (at, source=curve%spline%pole(:, 1))
    end function first_point

    !> Where a curve ends.
    pure function last_point(curve) result(at)
        type(curve_type), intent(in) :: curve !! has a spline
        real(dp), allocatable :: at(:)
        allocate (at, source=curve%spline%pole(:, size(curve%spline%pole, 2)))
    end function last_point

    !> The distance from the end of a curve to the start of the next.
    pure real(dp) function gap_between(curve, next) result(gap)
        type(curve_type), intent(in) :: curve   !! has a spline
        type(curve_type), intent(in) :: next    !! of as many dimensions
        gap = norm2(first_point(next) - last_point(curve))
    end function gap_between

    !> Lets a curve begin at a point. The distance is added to its error; where it is more than
    !> rounding the curve is then not exact.
    pure subroutine join(at, noise, curve)
        real(dp), intent(in) :: at(:)               !! where, of as many dimensions
        real(dp), intent(in) :: noise               !! what is but rounding, deck units
        type(curve_type), intent(inout) :: curve    !! begins near to it; then there
        real(dp) :: gap

        gap = norm2(first_point(curve) - at)
        curve%spline%pole(:, 1) = at
        if (curve%is_conic) curve%arc%start = at(:2)
        curve%error = curve%error + gap
        if (gap <= noise) return
        curve%is_exact = .false.
        curve%is_conic = .false.
        curve%worst = 0.0_dp
        curve%worst(:size(at)) = at
    end subroutine join

    !> Puts a curve given in u and v into space.
    pure subroutine put_in_space(plane, curve)
        type(plane_type), intent(in) :: plane       !! of u and v
        type(curve_type), intent(inout) :: curve    !! of two dimensions; then of three
        real(dp), allocatable :: pole(:, :)
        integer :: i

        allocate (pole(3, size(curve%spline%pole, 2)))
        do i = 1, size(pole, 2)
            pole(:, i) = in_space(plane, curve%spline%pole(:, i))
        end do
        call move_alloc(pole, curve%spline%pole)
        curve%worst = in_space(plane, curve%worst(:2))
    end subroutine put_in_space

    !> Points of space in u and v of a plane.
    pure function in_plane(plane, at) result(uv)
        type(plane_type), intent(in) :: plane   !! of u and v
        real(dp), intent(in) :: at(:, :)        !! STA, BL, WL by columns
        real(dp), allocatable :: uv(:, :)
        integer :: i
        allocate (uv(2, size(at, 2)))
        do i = 1, size(at, 2)
            uv(:, i) = true_shape(plane, at(:, i))
        end do
    end function in_plane

    !> Puts ends of an open contour that are at BL 0, but for rounding, there.
    pure subroutine seat_ends(plane, contour, meets)
        type(plane_type), intent(in) :: plane               !! of the shape
        type(contour_type), intent(inout) :: contour        !! any
        logical, intent(out) :: meets(2)                    !! it begins, it ends at BL 0
        real(dp) :: noise
        integer :: i, last

        meets = .false.
        if (contour%is_closed .or. size(contour%curves) == 0) return
        noise = 0.0_dp
        do i = 1, size(contour%curves)
            noise = max(noise, agreement_ulps*ulp*maxval(abs(contour%curves(i)%spline%pole)))
        end do
        associate (curve => contour%curves(1))
            meets(1) = abs(curve%spline%pole(2, 1)) <= noise
            if (meets(1)) curve%spline%pole(2, 1) = 0.0_dp
            if (meets(1) .and. curve%is_conic) &
                curve%arc%start = true_shape(plane, curve%spline%pole(:, 1))
        end associate
        associate (curve => contour%curves(size(contour%curves)))
            last = size(curve%spline%pole, 2)
            meets(2) = abs(curve%spline%pole(2, last)) <= noise
            if (meets(2)) curve%spline%pole(2, last) = 0.0_dp
            if (meets(2) .and. curve%is_conic) &
                curve%arc%finish = true_shape(plane, curve%spline%pole(:, last))
        end associate
    end subroutine seat_ends

end module export_drawing_join
