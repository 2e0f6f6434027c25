!> Points, slopes and curvatures against circles, a parabola and hyperbolas in closed form.
program test_arc_point
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_tolerances, only: ulp
    use geom_arc, only: arc_through, arc_type, end_type
    use geom_arc_point, only: curvature, point, slope, slope_along, slope_type, tangent
    use geom_place, only: at_finish, at_shoulder, at_start, place_at, place_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(arc_type) :: arc, image
    type(slope_type) :: at
    type(place_type) :: place
    real(dp), parameter :: up(2) = [0.0_dp, 1.0_dp], flat(2) = [1.0_dp, 0.0_dp]
    real(dp) :: p(2), q(2), worst(4)
    integer :: i

    arc = card([1.0_dp, 0.0_dp], up, [0.6_dp, 0.8_dp], [0.0_dp, 1.0_dp], flat)
    call check_circle(arc, 1.0_dp, 'a quarter circle')
    arc = card([1.0_dp, 0.0_dp], up, [0.0_dp, 1.0_dp], [-1.0_dp, 0.0_dp], up)
    call check_circle(arc, 1.0_dp, 'a semicircle')
    arc = card([1.0_dp, 0.0_dp], up, [0.0_dp, -1.0_dp], [-1.0_dp, 0.0_dp], up)
    call check_circle(arc, -1.0_dp, 'a semicircle turning right')
    arc = card([1.0_dp, 0.0_dp], up, [-1.0_dp, 0.0_dp], [0.0_dp, -1.0_dp], flat)
    call check_circle(arc, 1.0_dp, 'three quarters of a circle')
    arc = card([-0.28_dp, 0.96_dp], [0.96_dp, 0.28_dp], [0.0_dp, -1.0_dp], [0.28_dp, 0.96_dp], &
        [0.96_dp, -0.28_dp])
    call check_circle(arc, 1.0_dp, 'all of a circle but a notch')

    arc = card([0.0_dp, 0.0_dp], flat, [1.0_dp, 1.0_dp], [2.0_dp, 4.0_dp], [1.0_dp, 4.0_dp])
    worst = 0.0_dp
    do i = 0, 16
        place = place_at(0.0625_dp*real(i, dp))
        p = point(arc, place)
        at = slope(arc, place)
        worst(1) = max(worst(1), abs(p(2) - p(1)**2))
        worst(2) = max(worst(2), abs(at%value - 2.0_dp*p(1)))
        worst(3) = max(worst(3), abs(curvature(arc, &
            place)*(1.0_dp + 4.0_dp*p(1)**2)**1.5_dp/2.0_dp - 1.0_dp))
    end do
    call tap%near(worst(1), 0.0_dp, 4*ulp, 'points of y = x**2 are on it')
    call tap%near(worst(2), 0.0_dp, 4*ulp, 'its slope is 2 x')
    call tap%near(worst(3), 0.0_dp, 8*ulp, 'its curvature is 2/(1 + 4 x**2)**1.5')

    arc = card([0.5_dp, 2.0_dp], [1.0_dp, -4.0_dp], [1.0_dp, 1.0_dp], [2.0_dp, 0.5_dp], &
        [1.0_dp, -0.25_dp])
    worst = 0.0_dp
    do i = 0, 16
        place = place_at(0.0625_dp*real(i, dp))
        p = point(arc, place)
        at = slope(arc, place)
        worst(1) = max(worst(1), abs(p(1)*p(2) - 1.0_dp))
        worst(2) = max(worst(2), abs(at%value*p(1)**2 + 1.0_dp))
    end do
    call tap%near(worst(1), 0.0_dp, 4*ulp, 'points of y = 1/x are on it')
    call tap%near(worst(2), 0.0_dp, 4*ulp, 'its slope is -1/x**2')

    ! The same shape, moved and sheared: every point is the image of a point.
    arc = card([0.5_dp, 2.0_dp], [1.0_dp, -4.0_dp], [1.0_dp, 1.0_dp], [2.0_dp, 0.5_dp], &
        [1.0_dp, -0.25_dp])
    image = card(sheared(arc%start), [1.0_dp, -2.0_dp], sheared([1.0_dp, 1.0_dp]), &
        sheared(arc%finish), &
        [1.0_dp, 1.75_dp])
    worst = 0.0_dp
    do i = 0, 16
        place = place_at(0.0625_dp*real(i, dp))
        q = point(image, place) - sheared(point(arc, place))
        worst(1) = max(worst(1), maxval(abs(q)))
    end do
    call tap%near(worst(1), 0.0_dp, 5000*ulp, 'an affine image has the images of the points')

    at = slope(image, at_start)
    call tap%ok(at%value == -2.0_dp, 'the slope at the start is the one given')
    at = slope(image, at_finish)
    call tap%ok(at%value == 1.75_dp, 'and at the finish')
    call tap%ok(all(point(image, at_start) == image%start), 'the first point is the one given')
    call tap%ok(all(point(image, at_finish) == image%finish), 'and the last')

    arc = card([1.0_dp, 0.0_dp], up, [0.0_dp, 1.0_dp], [-1.0_dp, 0.0_dp], up)
    at = slope(arc, at_start)
    call tap%ok(at%is_vertical .and. at%value == 0.0_dp, 'a semicircle starts vertical')
    at = slope(arc, at_shoulder)
    call tap%ok(.not. at%is_vertical .and. at%value == 0.0_dp, 'and is level at its shoulder')
    at = slope_along([1.0_dp, 5000.0_dp])
    call tap%ok(at%value == 5000.0_dp .and. .not. at%is_vertical, 'a steep slope is a number')
    at = slope_along([-1.0e-17_dp, 1.0_dp])
    call tap%ok(at%is_vertical, 'what rounding leaves of a vertical is vertical')

    arc = card([0.0_dp, 0.0_dp], [1.0_dp, 3.0_dp], [0.1_dp, 0.3_dp], [0.2_dp, 0.6_dp], [1.0_dp, &
        3.0_dp])
    at = slope(arc, place_at(0.3_dp))
    call tap%ok(at%value == 3.0_dp, 'a line has its slope everywhere')
    call tap%ok(curvature(arc, at_shoulder) == 0.0_dp, 'and no curvature')
    arc = card([1.0e200_dp, 0.0_dp], up, [0.6e200_dp, 0.8e200_dp], [0.0_dp, 1.0e200_dp], flat)
    call tap%near(curvature(arc, at_shoulder)*1.0e200_dp, 1.0_dp, 8*ulp, &
        'a huge circle has its curvature')
    call tap%finish()

contains

    !> The arc of a card that has one.
    type(arc_type) function card(p1, t1, p2, p3, t3) result(arc)
        real(dp), intent(in) :: p1(2), t1(2), p2(2), p3(2), t3(2)
        type(error_type), allocatable :: error
        call arc_through(end_type(p1, t1), p2, end_type(p3, t3), arc, error)
        if (allocated(error)) call tap%ok(.false., error%message)
    end function card

    !> A point under an affine map, exact for the numbers used.
    pure function sheared(p)
        real(dp), intent(in) :: p(2)
        real(dp) :: sheared(2)
        sheared = [p(1) + 4864.0_dp, 2.0_dp*p(1) + p(2) - 200.0_dp]
    end function sheared

    !> Checks points, tangents and curvatures of an arc of the unit circle.
    subroutine check_circle(arc, turn, name)
        type(arc_type), intent(in) :: arc
        real(dp), intent(in) :: turn
        character(*), intent(in) :: name
        type(place_type) :: place
        real(dp) :: p(2), t(2), worst(3)
        integer :: i

        worst = 0.0_dp
        do i = 0, 32
            place = place_at(0.03125_dp*real(i, dp))
            p = point(arc, place)
            t = tangent(arc, place)
            t = t/norm2(t)
            worst(1) = max(worst(1), abs(norm2(p) - 1.0_dp))
            worst(2) = max(worst(2), norm2(t - turn*[-p(2), p(1)]))
            worst(3) = max(worst(3), abs(curvature(arc, place) - turn))
        end do
        call tap%near(worst(1), 0.0_dp, 4*ulp, name//' has points at distance 1')
        call tap%near(worst(2), 0.0_dp, 8*ulp, name//' has tangents across the radius, forward')
        call tap%near(worst(3), 0.0_dp, 8*ulp, name//' has curvature 1, signed as it turns')
    end subroutine check_circle

end program test_arc_point
