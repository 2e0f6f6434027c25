!> Standard positions of conics: circle, ellipse, hyperbola, parabola askew, worked by hand, and
!> that any arc lies on its conic and runs along it as stated.
program test_conic_axes
    use base_error, only: error_type
    use base_kinds, only: dp
    use geom_arc, only: arc_through, arc_type, end_type, line_between
    use geom_arc_point, only: point
    use geom_conic, only: conic_kind
    use geom_conic_axes, only: axes_of, axes_type, coefficients_of, distance_from_axes, reach_of, &
        to_axes
    use geom_place, only: place_at
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(axes_type) :: axes
    real(dp) :: form(6)
    integer :: i, j
    real(dp), parameter :: rhos(8) = [-0.4_dp, -0.1_dp, 0.1_dp, 0.3_dp, 0.49_dp, 0.5_dp, 0.51_dp, &
        0.9_dp]

    ! Half of an ellipse about (10, 20), 5 along (3, 4)/5, 2 across.
    axes = axes_of(arc([13.0_dp, 24.0_dp], [-4.0_dp, 3.0_dp], [8.4_dp, 21.2_dp], &
        [7.0_dp, 16.0_dp], [4.0_dp, -3.0_dp]))
    call tap%ok(axes%kind == conic_kind%ellipse, 'half of an ellipse')
    call tap%near(norm2(axes%origin - [10.0_dp, 20.0_dp]), 0.0_dp, 1.0e-14_dp, 'its centre')
    call tap%near(axes%a, 5.0_dp, 1.0e-14_dp, 'its longer half axis')
    call tap%near(axes%b, 2.0_dp, 1.0e-14_dp, 'its shorter half axis')
    call tap%near(abs(dot_product(axes%x, [0.6_dp, 0.8_dp])), 1.0_dp, 1.0e-15_dp, 'its direction')
    form = coefficients_of(axes)
    call tap%ok(all(abs(form - [0.04_dp, 0.0_dp, 0.25_dp, 0.0_dp, 0.0_dp, -1.0_dp]) < 1.0e-15_dp), &
        'its equation')
    call tap%ok(all(form([2, 4, 5]) == 0.0_dp), 'has no other terms')

    axes = axes_of(arc([5.0_dp, 0.0_dp], [0.0_dp, 1.0_dp], [3.0_dp, 4.0_dp], [0.0_dp, 5.0_dp], &
        [1.0_dp, 0.0_dp]))
    call tap%ok(axes%a == axes%b .and. abs(axes%a - 5.0_dp) < 2.0e-15_dp, 'a circle has equal axes')

    ! y = x**2 from (-1, 1) to (2, 4), and its mirror image, turned to the right.
    axes = axes_of(arc([-1.0_dp, 1.0_dp], [1.0_dp, -2.0_dp], [0.5_dp, 0.25_dp], [2.0_dp, 4.0_dp], &
        [1.0_dp, 4.0_dp]))
    call tap%ok(axes%kind == conic_kind%parabola, 'a parabola')
    call tap%near(norm2(axes%origin), 0.0_dp, 1.0e-15_dp, 'its vertex')
    call tap%near(axes%a, 1.0_dp, 1.0e-15_dp, 'its parameter')
    call tap%near(norm2(axes%x - [0.0_dp, 1.0_dp]), 0.0_dp, 1.0e-15_dp, 'it opens along x')
    call tap%near(norm2(axes%y - [1.0_dp, 0.0_dp]), 0.0_dp, 1.0e-15_dp, 'and runs along y')
    form = coefficients_of(axes)
    call tap%ok(form(3) == 1.0_dp .and. abs(form(4) + 1.0_dp) < 1.0e-15_dp .and. &
        all(form([1, 2, 5, 6]) == 0.0_dp), 'y**2 = x, without other terms')

    ! x y = 1 from (1/2, 2) to (4, 1/4): a = b = sqrt(2) along the bisector.
    axes = axes_of(arc([0.5_dp, 2.0_dp], [1.0_dp, -4.0_dp], [sqrt(2.0_dp), sqrt(0.5_dp)], &
        [4.0_dp, 0.25_dp], [16.0_dp, -1.0_dp]))
    call tap%ok(axes%kind == conic_kind%hyperbola, 'a hyperbola')
    call tap%near(norm2(axes%origin), 0.0_dp, 2.0e-15_dp, 'its centre')
    call tap%near(axes%a, sqrt(2.0_dp), 2.0e-15_dp, 'its real axis')
    call tap%near(axes%b, sqrt(2.0_dp), 2.0e-15_dp, 'its other axis')
    call tap%near(norm2(axes%x - sqrt(0.5_dp)), 0.0_dp, 1.0e-15_dp, 'towards the branch of the arc')

    axes = axes_of(line_between([0.0_dp, 0.0_dp], [1.0_dp, 1.0_dp]))
    call tap%ok(axes%kind == conic_kind%line, 'a line has none')
    do i = 1, size(rhos)
        do j = -1, 1, 2
            call check_arc(rhos(i), real(j, dp))
        end do
    end do
    call tap%finish()

contains

    !> An arc through a shoulder.
    type(arc_type) function arc(start, ahead, shoulder, finish, back)
        real(dp), intent(in) :: start(2)    !! first point
        real(dp), intent(in) :: ahead(2)    !! its tangent
        real(dp), intent(in) :: shoulder(2) !! shoulder point
        real(dp), intent(in) :: finish(2)   !! last point
        real(dp), intent(in) :: back(2)     !! its tangent
        type(error_type), allocatable :: error
        call arc_through(end_type(start, ahead), shoulder, end_type(finish, back), arc, error)
        call tap%ok(.not. allocated(error), 'there is an arc')
    end function arc

    !> An arc of some rho, turning left or right: its points are on the conic and follow each other.
    subroutine check_arc(rho, side)
        real(dp), intent(in) :: rho     !! any below 1
        real(dp), intent(in) :: side    !! 1 or -1: the apex is left or right of the chord
        type(arc_type) :: bent
        real(dp) :: p(2), q(2), apex(2), at(2), angle, last, off, turned
        character(8) :: name
        integer :: k

        write (name, '(f5.2)') rho*side
        p = [100.3_dp, 20.1_dp]
        q = [141.9_dp, 33.7_dp]
        apex = 0.5_dp*(p + q) + side*[-15.2_dp, 21.4_dp]
        bent = arc(p, apex - p, (1.0_dp - rho)*0.5_dp*(p + q) + rho*apex, q, q - apex)
        axes = axes_of(bent)
        off = 0.0_dp
        turned = 0.0_dp
        last = 0.0_dp
        do k = 0, 100
            at = to_axes(axes, point(bent, place_at(real(k, dp)/100.0_dp)))
            off = max(off, distance_from_axes(axes, point(bent, place_at(real(k, dp)/100.0_dp))))
            angle = at(2)
            if (axes%kind == conic_kind%ellipse) angle = atan2(at(2)/axes%b, at(1)/axes%a)
            if (k > 0 .and. angle < last) turned = turned + 1.0_dp
            if (axes%kind == conic_kind%hyperbola .and. at(1) <= 0.0_dp) turned = 9.0_dp
            last = angle
        end do
        call tap%near(off, 0.0_dp, 3.0e-12_dp, trim(name)//': points of the arc are on it')
        call tap%ok(turned <= merge(1.0_dp, 0.0_dp, axes%kind == conic_kind%ellipse), &
            trim(name)//': and run along it')
        call tap%near(abs(dot_product(axes%x, axes%y)) + abs(norm2(axes%x) - 1.0_dp), 0.0_dp, &
            1.0e-15_dp, trim(name)//': its axes are at right angles')
        call tap%ok(reach_of(axes, bent) >= axes%a/norm2(q - p) .and. reach_of(axes, &
            bent) < 300.0_dp, &
            trim(name)//': and near')
    end subroutine check_arc

end program test_conic_axes
