!> Marks along a contour: where the bevel of a frame is taken.
module export_drawing_marks
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_tolerances, only: spacing_tolerance
    use body_body, only: body_type
    use body_offset, only: foot_at, foot_type
    use cut_outline, only: cut_point_type, cut_type
    use cut_plane, only: in_view, true_shape
    use cut_point, only: give_bevel, left_of
    use export_drawing, only: contour_type, mark_type
    use export_drawing_outside, only: outside_type, way_round_type
    use geom_bspline, only: bspline_type, spline_breaks, spline_jet
    use geom_quadrature, only: integrand_type, integrate
    implicit none (type, external)
    private

    public :: add_marks

    !> The speed of a spline.
    type, extends(integrand_type) :: speed_type
        type(bspline_type) :: spline    !! in space
    contains
        procedure :: at => speed_at
    end type speed_type

    !> A stretch of a spline between two knots.
    type :: span_type
        type(speed_type) :: speed           !! of the spline
        real(dp) :: ends(2) = 0.0_dp        !! parameters
        real(dp) :: done = 0.0_dp           !! length of the contour before it, deck units
        real(dp) :: length = 0.0_dp         !! its own, deck units
    end type span_type

    !> How far inside of the ends of its section the skin is looked at, in parts of its length along
    !> STA, where it can't be at the point itself.
    real(dp), parameter :: inset(4) = [0.0_dp, 1.0e-9_dp, 1.0e-6_dp, 1.0e-4_dp]
    !> Newton steps that place a mark.
    integer, parameter :: most_steps = 20

contains

    !> Marks a contour where it begins and at each multiple of a step of its length; of a closed one
    !> not where it ends. There is no mark where the skin has no normal.
    !>
    !> Fails with `cause%no_convergence` where a length can't be found.
    pure subroutine add_marks(whole, cut, round, step, contour, error)
        type(body_type), intent(in) :: whole                !! finished, both halves
        type(cut_type), intent(in) :: cut                   !! plane and flange
        type(way_round_type), intent(in) :: round           !! its curves as paths
        real(dp), intent(in) :: step                        !! above zero, deck units
        type(contour_type), intent(inout) :: contour        !! curves in space; gets its marks
        type(error_type), allocatable, intent(out) :: error !! see above
        type(span_type) :: span
        real(dp), allocatable :: breaks(:)
        real(dp) :: total
        integer :: i, k

        total = 0.0_dp
        allocate (breaks(0))
        do i = 1, size(contour%curves)
            span%speed%spline = contour%curves(i)%spline
            breaks = spline_breaks(span%speed%spline)
            do k = 2, size(breaks)
                span%ends = breaks(k - 1:k)
                call integrate(span%speed, breaks(k - 1), breaks(k), spacing_tolerance, &
                    span%length, error)
                if (allocated(error)) return
                span%done = total
                total = total + span%length
                call mark_span(whole, cut, round%path(i), span, step, contour)
            end do
        end do
        i = size(contour%marks)
        if (.not. contour%is_closed .or. i < 2) return
        if (norm2(contour%marks(i)%uv - contour%marks(1)%uv) < 2.0_dp*spacing_tolerance*total) &
            contour%marks = contour%marks(:i - 1)
    end subroutine add_marks

    !> Marks what multiples of a step are on a span.
    pure subroutine mark_span(whole, cut, path, span, step, contour)
        type(body_type), intent(in) :: whole            !! finished, both halves
        type(cut_type), intent(in) :: cut               !! plane and flange
        type(outside_type), intent(in) :: path          !! of the curve
        type(span_type), intent(in) :: span             !! of its spline
        real(dp), intent(in) :: step                    !! deck units
        type(contour_type), intent(inout) :: contour    !! gets the marks
        real(dp) :: along
        integer :: n

        n = ceiling(span%done/step)
        if (span%done > 0.0_dp .and. real(n, dp)*step <= span%done) n = n + 1
        along = real(n, dp)*step - span%done
        do while (along <= span%length)
            call mark_at(whole, cut, path, span%speed, place_on(span, along), contour)
            n = n + 1
            along = real(n, dp)*step - span%done
        end do
    end subroutine mark_span

    !> Where a span of a spline has a length from its beginning.
    pure real(dp) function place_on(span, wanted) result(t)
        type(span_type), intent(in) :: span     !! of a spline
        real(dp), intent(in) :: wanted          !! from 0 to its length, deck units
        type(error_type), allocatable :: error
        real(dp) :: done
        integer :: i

        t = span%ends(1)
        if (.not. wanted > 0.0_dp) return
        t = t + (span%ends(2) - span%ends(1))*(wanted/span%length)
        do i = 1, most_steps
            call integrate(span%speed, span%ends(1), t, spacing_tolerance, done, error)
            if (abs(done - wanted) <= spacing_tolerance*span%length) return
            t = t - (done - wanted)/max(span%speed%at(t), tiny(t))
            t = min(max(t, span%ends(1)), span%ends(2))
        end do
    end function place_on

    !> Marks a place of a curve.
    pure subroutine mark_at(whole, cut, path, speed, t, contour)
        type(body_type), intent(in) :: whole            !! finished, both halves
        type(cut_type), intent(in) :: cut               !! plane and flange
        type(outside_type), intent(in) :: path          !! of the curve
        type(speed_type), intent(in) :: speed           !! of the curve
        real(dp), intent(in) :: t                       !! parameter of its spline
        type(contour_type), intent(inout) :: contour    !! gets the mark
        type(cut_point_type) :: point
        type(mark_type) :: mark
        type(foot_type) :: foot
        real(dp) :: at(3), first(3), second(3), near(3), range(2)
        logical :: is_there
        integer :: i

        call spline_jet(speed%spline, t, at, first, second)
        range = [whole%sections(path%section)%from, whole%sections(path%section)%to]
        do i = 1, size(inset)
            near = at
            near(1) = min(max(at(1), range(1) + inset(i)*(range(2) - range(1))), &
                range(2) - inset(i)*(range(2) - range(1)))
            call foot_at(whole, path%section, near, path%side*left_of(cut%plane, first), foot, &
                is_there)
            if (is_there) exit
        end do
        if (.not. is_there) return
        mark%uv = true_shape(cut%plane, at)
        mark%outward = in_view(cut%plane, foot%normal)
        if (.not. norm2(mark%outward) > 0.0_dp) return
        mark%outward = mark%outward/norm2(mark%outward)
        call give_bevel(foot%normal, cut%plane, cut%is_flange_forward, point)
        mark%bevel = point%bevel
        contour%marks = [contour%marks, mark]
    end subroutine mark_at

    !> The speed of a spline at a parameter.
    pure real(dp) function speed_at(f, t) result(speed)
        class(speed_type), intent(in) :: f  !! of which
        real(dp), intent(in) :: t           !! parameter
        real(dp) :: point(3), first(3), second(3)
        call spline_jet(f%spline, t, point, first, second)
        speed = norm2(first)
    end function speed_at

end module export_drawing_marks
