!> From a curve as it is known exactly to a curve of a drawing: the conic or straight line that it
!> is, or a spline fitted to it.
module export_drawing_fit
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact
    use export_drawing, only: curve_type
    use export_drawing_conic, only: find_conic
    use export_drawing_path, only: path_type
    use export_drawing_sample, only: hopeless, sample_curve, sampled_type
    use geom_arc, only: arc_type
    use geom_arc_spline, only: arc_spline
    use geom_bspline, only: bspline_type, spline_breaks, spline_jet
    use geom_curve_fit, only: curve_function_type, fit_curve
    implicit none (type, external)
    private

    public :: flat_curve, fitted_curve, arc_curve, measure_spline

    !> Share of the tolerance that the samples of a curve may miss it by (a jump by all of it is
    !> then hopeless), and share that is left for the spline through them.
    real(dp), parameter :: for_samples = 1.0_dp/hopeless, for_spline = 0.95_dp
    !> Points of a span, and of a curve, at which its distance is measured at least.
    integer, parameter :: span_points = 8, curve_points = 64

contains

    !> A curve of a plane, in u and v: exact where it is one arc, else fitted. Fails as
    !> `fitted_curve`.
    pure subroutine flat_curve(path, noise, tolerance, curve, error)
        class(path_type), intent(in) :: path                !! in u and v
        real(dp), intent(in) :: noise                       !! what is but rounding, deck units
        real(dp), intent(in) :: tolerance                   !! of a fitted curve, deck units
        type(curve_type), intent(out) :: curve              !! of two dimensions; `worst` is u, v, 0
        type(error_type), allocatable, intent(out) :: error !! see above
        type(arc_type) :: arc
        real(dp) :: largest
        logical :: is_conic

        call find_conic(path, noise, arc, largest, is_conic)
        if (is_conic) then
            curve = arc_curve(arc)
            curve%error = largest
            curve%worst = path%at(0.5_dp)
        else
            call fitted_curve(path, 2, tolerance, curve, error)
        end if
    end subroutine flat_curve

    !> An arc, as it is.
    pure type(curve_type) function arc_curve(arc) result(curve)
        type(arc_type), intent(in) :: arc !! in u and v
        curve%section = ''
        curve%spline = arc_spline(arc)
        curve%is_exact = .true.
        curve%is_conic = .true.
        curve%arc = arc
        curve%worst(:2) = arc%start
    end function arc_curve

    !> A spline fitted to a curve, with its distance from it.
    !>
    !> Fails with `cause%no_convergence` where it can't be fitted.
    pure subroutine fitted_curve(path, dimensions, tolerance, curve, error)
        class(curve_function_type), intent(in) :: path      !! the curve
        integer, intent(in) :: dimensions                   !! that it has, the first ones
        real(dp), intent(in) :: tolerance                   !! above zero, deck units
        type(curve_type), intent(out) :: curve              !! of so many dimensions
        type(error_type), allocatable, intent(out) :: error !! see above
        type(sampled_type) :: sampled
        real(dp) :: largest, worst_t, worst(3)

        curve%section = ''
        call sample_curve(path, for_samples*tolerance, sampled)
        if (sampled%rest > tolerance) then
            call fail(error, cause%no_convergence, 'a curve can''t be fitted: it jumps by '// &
                compact(sampled%rest))
            return
        end if
        call fit_curve(sampled, for_spline*tolerance, curve%spline, curve%error, worst_t, error)
        if (allocated(error)) return
        curve%worst = path%at(worst_t)
        call measure_spline(path, curve%spline, largest, worst)
        if (largest > curve%error) then
            curve%error = largest
            curve%worst = worst
        end if
        curve%spline%pole = curve%spline%pole(:dimensions, :)
        if (curve%error <= tolerance) return
        call fail(error, cause%no_convergence, 'a curve can''t be fitted within '// &
            compact(tolerance)//': a spline is '//compact(curve%error)//' off')
    end subroutine fitted_curve

    !> The largest distance of a curve from a spline with its parameter, across the spline: between
    !> the points of one parameter, less the part along the spline (which leaves out no more than
    !> the square of that part, times half the curvature).
    pure subroutine measure_spline(path, spline, largest, worst)
        class(curve_function_type), intent(in) :: path !! the curve
        type(bspline_type), intent(in) :: spline    !! of three dimensions, fitted to it
        real(dp), intent(out) :: largest            !! distance, deck units
        real(dp), intent(out) :: worst(3)           !! where on the curve
        real(dp), allocatable :: breaks(:)
        real(dp) :: at(3), point(3), first(3), second(3), apart(3), t
        integer :: points, i, k

        allocate (breaks(0))
        breaks = spline_breaks(spline)
        points = max(span_points, curve_points/(size(breaks) - 1) + 1)
        largest = 0.0_dp
        worst = path%at(0.0_dp)
        do i = 2, size(breaks)
            do k = 1, points
                t = breaks(i) - (breaks(i) - breaks(i - 1))*(real(k, dp) - 0.5_dp)/real(points, dp)
                call spline_jet(spline, t, point, first, second)
                at = path%at(t)
                apart = at - point
                if (norm2(first) > 0.0_dp) apart = apart &
                    - dot_product(apart, first/norm2(first))*(first/norm2(first))
                if (norm2(apart) <= largest) cycle
                largest = norm2(apart)
                worst = at
            end do
        end do
    end subroutine measure_spline

end module export_drawing_fit
