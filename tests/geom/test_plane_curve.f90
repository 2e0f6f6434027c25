!> Where the curvature of a curve changes its ways: extremes and inflections known in closed form.
program test_plane_curve
    use base_constants, only: pi
    use base_kinds, only: dp
    use geom_plane_curve, only: curvature_stops
    use geom_plane_spline, only: plane_spline_type
    use support_plane_curves, only: example_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(plane_spline_type) :: still

    ! y = .1 x (x**2 - 27): an inflection at 0, the greatest curvature at +-3.0334771757.
    call check(example_type(2, [-6.0_dp, 6.0_dp]), [-3.0334771757_dp, 0.0_dp, 3.0334771757_dp], &
        'the cubic turns from one curvature to another three times')
    ! An ellipse of axes 3 and 1 has its extremes on them.
    call check(example_type(6, [0.1_dp, 6.2_dp]), 0.5_dp*pi*[1.0_dp, 2.0_dp, 3.0_dp], &
        'an ellipse on its axes')
    call tap%ok(size(curvature_stops(example_type(5, [0.3_dp, 2.9_dp]))) == 2, 'a circle nowhere')
    call tap%ok(size(curvature_stops(example_type(7, [0.0_dp, 9.0_dp]))) == 2, 'a line nowhere')
    call tap%ok(size(curvature_stops(example_type(1, [0.5_dp, 1.5_dp]))) == 2, &
        'nor a parabola off its axis')
    still%spline%degree = 2
    still%spline%knot = [0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 1.0_dp]
    still%spline%weight = [1.0_dp, 1.0_dp, 1.0_dp]
    still%spline%pole = reshape([0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp], [2, 3])
    call tap%ok(size(curvature_stops(still)) >= 2, 'a curve that starts from a stand is looked at')
    call tap%finish()

contains

    !> Compares the stops of a curve, without its ends.
    subroutine check(f, places, name)
        type(example_type), intent(in) :: f     !! the curve
        real(dp), intent(in) :: places(:)       !! x, or the angle
        character(*), intent(in) :: name        !! the check as a phrase
        real(dp), allocatable :: stops(:)

        allocate (stops(0))
        stops = curvature_stops(f)
        call tap%ok(size(stops) == size(places) + 2, name)
        if (size(stops) /= size(places) + 2) return
        call tap%near(maxval(abs(f%range(1) + (f%range(2) - f%range(1)) &
            *stops(2:size(stops) - 1) - places)), 0.0_dp, 1.0e-6_dp, 'where it should')
    end subroutine check

end program test_plane_curve
