!> Tests of exact and fitted curves against closed forms.
program test_drawing_fit
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use export_drawing, only: curve_type
    use export_drawing_fit, only: arc_curve, fitted_curve, flat_curve, measure_spline
    use geom_arc, only: line_between
    use geom_bspline, only: bspline_type, spline_point
    use support_paths, only: form, plane_path_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(curve_type) :: curve
    type(bspline_type) :: spline
    type(plane_path_type) :: path
    type(error_type), allocatable :: error
    real(dp), parameter :: tolerances(4) = [1.0e-2_dp, 1.0e-4_dp, 1.0e-6_dp, 1.0e-9_dp]
    real(dp) :: largest, worst(3)
    integer :: i, poles

    path = plane_path_type(form=form%ellipse, axes=[3.0_dp, 2.0_dp], ends=[0.2_dp, 1.9_dp])
    call flat_curve(path, 1.0e-13_dp, 1.0e-3_dp, curve, error)
    call tap%ok(.not. allocated(error) .and. curve%is_exact .and. curve%is_conic &
        .and. curve%spline%degree == 2, 'an arc of an ellipse is drawn exactly')
    call tap%near(off_ellipse(curve%spline), 0.0_dp, 2.0e-15_dp, 'its spline is the ellipse')
    path%is_mute = .true.
    poles = 0
    do i = 1, size(tolerances)
        call flat_curve(path, 1.0e-13_dp, tolerances(i), curve, error)
        call tap%ok(.not. allocated(error) .and. .not. curve%is_exact, 'else it is fitted')
        largest = off_ellipse(curve%spline)
        call tap%ok(largest <= tolerances(i) .and. curve%error <= tolerances(i), &
            'within the tolerance')
        call tap%near(curve%error, largest, 0.02_dp*largest, 'its error is the one measured')
        call tap%ok(size(curve%spline%weight) >= poles, 'with more poles, the finer it is')
        poles = size(curve%spline%weight)
    end do
    call tap%ok(poles < 40, 'few poles for 1e-9')
    call tap%ok(size(curve%spline%pole, 1) == 2, 'in two dimensions')
    path%form = form%blunt
    call fitted_curve(path, 3, 1.0e-6_dp, curve, error)
    call tap%ok(off_ellipse(curve%spline) <= 1.0e-6_dp .and. size(curve%spline%pole, 1) == 3, &
        'in three, where the parameter stands still at both ends')

    path = plane_path_type(form=form%step, axes=[1.0_dp, 1.0_dp])
    call fitted_curve(path, 2, 1.0e-3_dp, curve, error)
    call tap%ok(allocated(error), 'a curve that jumps can''t be fitted')
    if (allocated(error)) call tap%ok(error%cause == cause%no_convergence, 'which is said')

    path = plane_path_type(form=form%parabola, axes=[4.0_dp, 1.0_dp])
    call fitted_curve(path, 3, 1.0e-9_dp, curve, error)
    spline = curve%spline
    spline%pole(2, :) = spline%pole(2, :) + 0.25_dp
    call measure_spline(path, spline, largest, worst)
    call tap%near(largest, 0.25_dp, 2.0e-3_dp, 'a spline that lies .25 beside is found so')
    call tap%ok(worst(1) < 0.1_dp, 'furthest where the curve runs across')
    spline = curve%spline
    spline%pole(1, :) = spline%pole(1, :) + 1.0e-4_dp
    call measure_spline(path, spline, largest, worst)
    call tap%near(largest, 1.0e-4_dp*0.5_dp/sqrt(1.25_dp), 1.0e-6_dp, &
        'what it lags along the curve does not count')
    curve = arc_curve(line_between([1.0_dp, 2.0_dp], [3.0_dp, 5.0_dp]))
    call tap%ok(curve%is_exact .and. curve%spline%degree == 1, 'a line is a line')
    call tap%finish()

contains

    !> The largest distance of a spline from the ellipse with axes 3 and 2.
    real(dp) function off_ellipse(s) result(off)
        type(bspline_type), intent(in) :: s
        real(dp) :: at(size(s%pole, 1))
        integer :: k
        off = 0.0_dp
        do k = 0, 2000
            at = spline_point(s, real(k, dp)/2000.0_dp)
            off = max(off, abs(sum((at(:2)/[3.0_dp, 2.0_dp])**2) - 1.0_dp) &
                /(2.0_dp*norm2(at(:2)/[9.0_dp, 4.0_dp])))
        end do
    end function off_ellipse

end program test_drawing_fit
