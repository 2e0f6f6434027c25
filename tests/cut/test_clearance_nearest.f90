!> Nearest points of skins to points and boxes.
program test_clearance_nearest
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_clearance_map, only: map_type, new_map
    use cut_clearance_nearest, only: box_type, foot_type, nearest_to, reach_of
    use support_random, only: random_type
    use support_solids, only: cone, conic_type, cylinder, ellipsoid, solid
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: good = 1.0e-12_dp
    type(tap_type) :: tap
    type(body_type) :: body
    type(map_type) :: map
    type(foot_type) :: foot
    type(random_type) :: random
    real(dp) :: p(3), worst, astray, short, long
    integer :: i

    ! Skin of the starboard half only: BL of the points is positive.
    body = ellipsoid([5.0_dp, 3.0_dp, 2.0_dp])
    map = new_map(body)
    worst = 0.0_dp
    astray = 0.0_dp
    short = huge(1.0_dp)
    long = 0.0_dp
    do i = 1, 300
        p = [random%between(-6.0_dp, 6.0_dp), random%between(0.0_dp, 4.0_dp), &
            random%between(-3.0_dp, 3.0_dp)]
        call nearest_to(body, map, box_type(p, p), foot)
        worst = max(worst, abs(norm2(foot%at/[5.0_dp, 3.0_dp, 2.0_dp]) - 1.0_dp))
        astray = max(astray, norm2(cross(p - foot%at, foot%normal)))
        short = min(short, reach_of(body, map, p) - foot%distance)
        long = max(long, reach_of(body, map, p*[1.0_dp, -1.0_dp, 1.0_dp]) - foot%distance)
    end do
    call tap%near(worst, 0.0_dp, 1.0e-14_dp, 'nearest points are on the ellipsoid')
    call tap%near(astray, 0.0_dp, 1.0e-7_dp, 'the way to each is along the normal')
    call tap%ok(short >= 0.0_dp, 'none is farther than the nearest sample')
    call tap%ok(long < maxval(map%sheets%spacing), 'nor much nearer, to port as to starboard')
    call look([1.0_dp, 0.5_dp, -9.0_dp], [1.5_dp, 0.75_dp, -1.0_dp])
    call tap%ok(foot%exists .and. foot%distance <= 0.0_dp, 'a box that the skin passes is at 0')

    body = cone(3.0_dp, 4.0_dp, 0.0_dp)
    map = new_map(body)
    call look([-2.0_dp, 0.0_dp, 0.0_dp], [-1.0_dp, 0.5_dp, 0.5_dp])
    call tap%near(foot%distance, 1.0_dp, good, 'the apex is nearest to a box before it')
    call tap%near(norm2(foot%at), 0.0_dp, good, 'exactly there')
    call look([5.0_dp, 2.4_dp, 3.2_dp], [5.0_dp, 2.4_dp, 3.2_dp])
    call tap%near(foot%distance, sqrt(2.0_dp), good, &
        'the rim of the base is nearest to a point behind')
    call tap%near(norm2(foot%at - [4.0_dp, 1.8_dp, 2.4_dp]), 0.0_dp, 1.0e-10_dp, 'there')
    body = cylinder(3.0_dp, 7.0_dp)
    map = new_map(body)
    call look([2.0_dp, 0.5_dp, -1.0_dp], [3.0_dp, 1.6_dp, 1.2_dp])
    call tap%near(foot%distance, 1.0_dp, good, &
        'an edge along a cylinder has no single nearest point')
    call look([2.0_dp, 1.0_dp, -5.0_dp], [3.0_dp, 2.0_dp, -4.0_dp])
    call tap%near(foot%distance, sqrt(17.0_dp) - 3.0_dp, good, 'outside, with an edge')
    call look([2.0_dp, 0.0_dp, -5.0_dp], [3.0_dp, 2.0_dp, -4.0_dp])
    call tap%near(foot%distance, 1.0_dp, good, 'outside, with a face, at the keel')
    call tap%near(norm2(foot%normal - [0.0_dp, 0.0_dp, -1.0_dp]), 0.0_dp, good, 'which faces down')

    ! Two cones base to base: the knuckle between is an edge that stands out.
    body = solid([conic_type([-4.0_dp, 0.0_dp], [4.0_dp, 3.0_dp], [-2.0_dp, 1.5_dp], &
        [0.0_dp, 3.0_dp], [4.0_dp, 3.0_dp]), conic_type([0.0_dp, 3.0_dp], [4.0_dp, -3.0_dp], &
        [2.0_dp, 1.5_dp], [4.0_dp, 0.0_dp], [4.0_dp, -3.0_dp])], 1.0_dp, 1.0_dp, 0.0_dp)
    map = new_map(body)
    call look([0.25_dp, 3.0_dp, 4.0_dp], [0.25_dp, 3.0_dp, 4.0_dp])
    call tap%near(foot%distance, norm2([0.25_dp, 2.0_dp]), good, 'a knuckle is nearest')
    call tap%near(norm2(foot%normal - [0.0_dp, 0.6_dp, 0.8_dp]), 0.0_dp, 1.0e-10_dp, &
        'its normal is the mean of both sides')
    call look([1.0_dp, 0.0_dp, 0.0_dp], [1.0_dp, 0.0_dp, 0.0_dp])
    call tap%near(foot%distance, 0.8_dp*2.25_dp, good, 'from inside it is not')

    body%sections = body%sections(:0)
    map = new_map(body)
    call look([1.0_dp, 0.0_dp, 0.0_dp], [1.0_dp, 0.0_dp, 0.0_dp])
    call tap%ok(.not. foot%exists, 'without skin there is no nearest point')
    call tap%finish()

contains

    !> Looks for the point nearest to a box.
    subroutine look(lower, upper)
        real(dp), intent(in) :: lower(3), upper(3)
        call nearest_to(body, map, box_type(lower, upper), foot)
    end subroutine look

    !> `a x b`.
    pure function cross(a, b)
        real(dp), intent(in) :: a(3), b(3)
        real(dp) :: cross(3)
        cross = [a(2)*b(3) - a(3)*b(2), a(3)*b(1) - a(1)*b(3), a(1)*b(2) - a(2)*b(1)]
    end function cross

end program test_clearance_nearest
