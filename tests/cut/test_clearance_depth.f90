!> Depths of points and boxes below surfaces whose distance has a closed form.
program test_clearance_depth
    use base_kinds, only: dp
    use body_body, only: body_type, mirrored_body
    use cut_clearance_depth, only: depth_of, depth_type
    use cut_clearance_map, only: map_type, new_map
    use cut_clearance_nearest, only: box_type
    use support_random, only: random_type
    use support_solids, only: cone, cylinder, ellipsoid, paraboloid, waist
    use support_tap, only: tap_type
    implicit none (type, external)

    integer, parameter :: qp = selected_real_kind(30)
    real(dp), parameter :: good = 1.0e-12_dp, axes(3) = [10.0_dp, 3.0_dp, 2.0_dp]
    type(tap_type) :: tap
    type(body_type) :: body
    type(map_type) :: map
    type(random_type) :: random
    type(depth_type) :: found
    real(dp) :: p(3), q(3), worst, far
    integer :: i, uncertain

    body = ellipsoid([3.0_dp, 3.0_dp, 3.0_dp])
    map = new_map(body)
    worst = 0.0_dp
    far = 0.0_dp
    uncertain = 0
    do i = 1, 200
        p = [random%between(-4.0_dp, 4.0_dp), random%between(-4.0_dp, 4.0_dp), &
            random%between(-4.0_dp, 4.0_dp)]
        found = depth_of(body, map, box_type(p, p))
        worst = max(worst, abs(found%depth - (3.0_dp - norm2(p))))
        far = max(far, norm2(found%foot%at - 3.0_dp*p/norm2(p)))
        if (.not. found%is_certain) uncertain = uncertain + 1
    end do
    call tap%near(worst, 0.0_dp, good, &
        'sphere: depth of 200 points, port and starboard, in and out')
    call tap%near(far, 0.0_dp, 1.0e-9_dp, 'sphere: their nearest points')
    call tap%ok(uncertain == 0, 'normal and section agree of all of them')
    call check_point([0.0_dp, 0.0_dp, 0.0_dp], 3.0_dp, &
        'the centre of a sphere, to which all is near')
    call check_point([-2.9_dp, 0.0_dp, 0.0_dp], 0.1_dp, 'a point behind the nose of a sphere')
    call check_point([-3.5_dp, 0.0_dp, 0.0_dp], -0.5_dp, 'a point before the nose of a sphere')
    call check_point([3.0_dp, 0.0_dp, 0.0_dp], 0.0_dp, 'the tail of a sphere itself')
    call check_point([0.0_dp, -1.8_dp, 2.4_dp], 0.0_dp, 'a shoulder point of a sphere, to port')
    call check_box([-1.0_dp, -0.5_dp, -1.5_dp], [0.5_dp, 1.0_dp, 2.0_dp], &
        3.0_dp - norm2([1.0_dp, 1.0_dp, 2.0_dp]), 'a box in a sphere: its farthest corner')
    call check_box([-1.0_dp, -0.5_dp, -1.5_dp], [0.5_dp, 1.0_dp, 3.0_dp], &
        3.0_dp - norm2([1.0_dp, 1.0_dp, 3.0_dp]), 'a box that pierces a sphere')
    call check_box([-0.5_dp, -4.0_dp, -0.5_dp], [0.5_dp, -3.5_dp, 0.5_dp], &
        3.0_dp - norm2([0.5_dp, 4.0_dp, 0.5_dp]), 'a box outside of a sphere, to port')
    call check_box([-5.0_dp, -4.0_dp, -3.5_dp], [5.0_dp, 4.0_dp, 3.5_dp], &
        3.0_dp - norm2([5.0_dp, 4.0_dp, 3.5_dp]), 'a box about a sphere')

    body = ellipsoid(axes)
    map = new_map(body)
    call check_ellipsoid('an ellipsoid by two quarters')
    body = mirrored_body(body)
    map = new_map(body)
    call check_ellipsoid('an ellipsoid by four quarters, not symmetric')

    body = cone(3.0_dp, 4.0_dp, -50.0_dp)
    map = new_map(body)
    call check_point([2.0_dp, 0.5_dp, -50.0_dp], 0.8_dp*(1.5_dp - 0.5_dp), 'a point in a cone')
    call check_point([-1.0_dp, 0.0_dp, -50.0_dp], -1.0_dp, 'a point before the apex of a cone')
    call check_point([0.0_dp, 0.0_dp, -50.0_dp], 0.0_dp, 'the apex of a cone')
    call check_box([-3.0_dp, -1.0_dp, -51.0_dp], [-1.0_dp, 1.0_dp, -49.0_dp], &
        -norm2([3.0_dp, 1.0_dp, 1.0_dp]), 'a box before a cone, nearest to its apex')
    call check_box([-1.0_dp, -0.5_dp, -50.5_dp], [0.5_dp, 0.5_dp, -49.5_dp], &
        -norm2([1.0_dp, 0.5_dp, 0.5_dp]), 'a box about the apex of a cone')
    call check_point([2.0_dp, -2.0_dp, -50.0_dp], -0.4_dp, 'a point beside a cone, to port')
    body = paraboloid(2.0_dp, 9.0_dp)
    map = new_map(body)
    call check_point([1.5_dp, 0.0_dp, 0.0_dp], 1.5_dp, 'a point before the centre of a blunt nose')
    call check_point([4.0_dp, 0.0_dp, 0.0_dp], sqrt(12.0_dp), 'a point of the axis behind it')
    call check_point([-0.25_dp, 0.0_dp, 0.0_dp], -0.25_dp, 'a point before a blunt nose')
    body = cylinder(3.0_dp, 7.0_dp)
    map = new_map(body)
    call check_point([0.125_dp, 1.2_dp, -1.6_dp], 1.0_dp, 'a point of a cylinder near its open end')
    call check_point([-3.0_dp, 0.0_dp, -7.0_dp], -5.0_dp, 'a point before a cylinder: its rim')
    call check_box([1.0_dp, -0.6_dp, -1.0_dp], [6.0_dp, 0.2_dp, 0.8_dp], &
        3.0_dp - norm2([0.6_dp, 1.0_dp]), 'a box in a cylinder, nearest with an edge')
    body = waist()
    map = new_map(body)
    call check_box([-0.7_dp, -0.4_dp, -0.4_dp], [0.6_dp, 0.3_dp, 0.2_dp], &
        1.0_dp - norm2([0.4_dp, 0.4_dp]), 'a box in a waist, nearest in the middle of an edge')
    call check_box([-0.5_dp, -0.2_dp, 0.5_dp], [0.5_dp, 0.2_dp, 1.4_dp], 1.0_dp - sqrt(2.0_dp), &
        'a box through a waist, deepest in the middle of an edge')
    call check_box([-0.5_dp, 0.0_dp, 0.5_dp], [0.4_dp, 0.0_dp, 1.25_dp], -0.25_dp, &
        'a plate through a waist, deepest where no sample is')

    body%sections = body%sections(:0)
    map = new_map(body)
    found = depth_of(body, map, box_type(p, p))
    call tap%ok(.not. found%foot%exists, 'a body without sections has no nearest point')
    call tap%finish()

contains

    !> Checks the depth of a point.
    subroutine check_point(at, depth, name)
        real(dp), intent(in) :: at(3), depth
        character(*), intent(in) :: name
        call check_box(at, at, depth, name)
    end subroutine check_point

    !> Checks the depth of a box, and that its nearest points are as far apart.
    subroutine check_box(lower, upper, depth, name)
        real(dp), intent(in) :: lower(3), upper(3), depth
        character(*), intent(in) :: name
        type(depth_type) :: found
        found = depth_of(body, map, box_type(lower, upper))
        call tap%near(found%depth, depth, 1.0e-11_dp, 'depth of '//name)
        call tap%near(norm2(found%foot%at - found%foot%touching), abs(depth), 1.0e-11_dp, &
            'distance of '//name)
        call tap%ok(all(found%foot%touching >= lower .and. found%foot%touching <= upper), &
            'its own point is its own: '//name)
    end subroutine check_box

    !> Checks random points against the distance from the ellipsoid.
    subroutine check_ellipsoid(name)
        character(*), intent(in) :: name
        type(depth_type) :: found
        integer :: k
        worst = 0.0_dp
        far = 0.0_dp
        do k = 1, 200
            p = [random%between(-11.0_dp, 11.0_dp), random%between(-3.5_dp, 3.5_dp), &
                random%between(-2.5_dp, 2.5_dp)]
            if (modulo(k, 5) == 0) p(1 + modulo(k, 3)) = 0.0_dp
            q = nearest_of_ellipsoid(p)
            found = depth_of(body, map, box_type(p, p))
            worst = max(worst, abs(found%depth - sign(norm2(p - q), 1.0_dp - norm2(p/axes))))
        end do
        call tap%near(worst, 0.0_dp, good, 'depth of 200 points: '//name)
    end subroutine check_ellipsoid

    !> The point of the ellipsoid nearest to a point, in real128: the largest root t of
    !> sum (a p/(t + a**2))**2 = 1 (D. Eberly, "Distance from a point to an ellipsoid", 2013);
    !> where p is zero along an axis and the root would be below -a**2, the point leaves the plane.
    function nearest_of_ellipsoid(p) result(q)
        real(dp), intent(in) :: p(3)
        real(dp) :: q(3)
        real(qp) :: a2(3), s(3), low, high, t, rest
        integer :: step
        a2 = real(axes, qp)**2
        low = -minval(a2) + real(axes(3), qp)*abs(real(p(3), qp))
        high = sqrt(sum(a2*real(p, qp)**2)) + 1.0_qp
        s = 0.0_qp
        do step = 1, 200
            t = 0.5_qp*(low + high)
            where (abs(p) > 0.0_dp) s = real(axes, qp)*real(p, qp)/(t + a2)
            if (sum(s**2) > 1.0_qp) then
                low = t
            else
                high = t
            end if
        end do
        where (abs(p) > 0.0_dp) s = real(p, qp)*a2/(t + a2)
        rest = 1.0_qp - sum((s/real(axes, qp))**2)
        if (.not. abs(p(3)) > 0.0_dp .and. rest > 1.0e-20_qp) s(3) = real(axes(3), qp)*sqrt(rest)
        q = real(s, dp)
    end function nearest_of_ellipsoid

end program test_clearance_depth
