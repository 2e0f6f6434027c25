!> Normals and curvatures of the skin against those of an ellipsoid and a cone; noses.
program test_skin
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_skin, only: normal_curvature, skin_at, skin_type
    use geom_place, only: at_finish, at_shoulder, at_start, place_at
    use support_bodies, only: constant_view, ellipsoid, nose_of_the_book, straight_view, tapered
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_ellipsoid()
    call check_cone()
    call check_nose()
    call tap%finish()

contains

    !> Points all over an ellipsoid.
    subroutine check_ellipsoid()
        real(dp), parameter :: axes(3) = [5.0_dp, 2.0_dp, 1.0_dp]
        type(body_type) :: body
        type(skin_type) :: skin
        real(dp) :: n(3), worst(2)
        integer :: i, k, section
        body = ellipsoid(axes, 0.0_dp, 0.0_dp)
        worst = 0.0_dp
        do section = 1, 2
            do i = -9, 9
                do k = 0, 10
                    skin = skin_at(body%lines, body%sections(section), 0.5_dp*real(i, dp), &
                        place_at(0.1_dp*real(k, dp)))
                    n = skin%at/axes**2
                    worst(1) = max(worst(1), norm2(n/norm2(n) - skin%normal))
                    worst(2) = max(worst(2), abs(sum((skin%at/axes)**2) - 1.0_dp))
                end do
            end do
        end do
        call tap%near(worst(1), 0.0_dp, 1.0e-13_dp, &
            'normals all over an ellipsoid are outward and its own')
        call tap%near(worst(2), 0.0_dp, 1.0e-15_dp, 'points are on it')
        skin = skin_at(body%lines, body%sections(1), 0.0_dp, at_finish)
        call tap%near(normal_curvature(skin, [1.0_dp, 0.0_dp, 0.0_dp], [0.0_dp, -1.0_dp, 0.0_dp]), &
            2.0_dp/25.0_dp, 1.0e-15_dp, 'the waterline amidships has curvature b/a**2')
        call tap%near(normal_curvature(skin, [0.0_dp, 0.0_dp, 1.0_dp], [0.0_dp, -1.0_dp, 0.0_dp]), &
            2.0_dp, 1.0e-15_dp, 'the station has b/c**2')
        skin = skin_at(body%lines, body%sections(1), -5.0_dp, at_shoulder)
        call tap%ok(skin%has_normal .and. .not. skin%is_smooth, 'the round nose has a normal')
        call tap%ok(all(skin%normal == [-1.0_dp, 0.0_dp, 0.0_dp]), 'straight forward')
        skin = skin_at(body%lines, body%sections(2), 5.0_dp, at_shoulder)
        call tap%ok(all(skin%normal == [1.0_dp, 0.0_dp, 0.0_dp]), 'the round tail straight aft')
    end subroutine check_ellipsoid

    !> A cone of slope 1/2.
    subroutine check_cone()
        type(body_type) :: body
        type(skin_type) :: skin
        body = tapered(straight_view([0.0_dp, 0.0_dp], [10.0_dp, 5.0_dp]), &
            straight_view([0.0_dp, 0.0_dp], [10.0_dp, 3.0_dp]), &
            straight_view([0.0_dp, 0.0_dp], [10.0_dp, 4.0_dp]), &
            straight_view([0.0_dp, 0.0_dp], [10.0_dp, -4.0_dp]), &
            straight_view([0.0_dp, 0.0_dp], [10.0_dp, -5.0_dp]))
        skin = skin_at(body%lines, body%sections(2), 10.0_dp, at_shoulder)
        call tap%near(skin%normal(1), -sqrt(0.2_dp), 1.0e-15_dp, &
            'a cone of slope 1/2 leans by asin(1/sqrt 5)')
        call tap%near(norm2(skin%normal(2:) - sqrt(0.4_dp)), 0.0_dp, 1.0e-15_dp, &
            'at 45 degrees round')
        call tap%near(normal_curvature(skin, [2.0_dp, sqrt(0.5_dp), sqrt(0.5_dp)]/sqrt(5.0_dp), &
            skin%normal), 0.0_dp, 1.0e-15_dp, 'it is straight along a generator')
        skin = skin_at(body%lines, body%sections(2), 0.0_dp, at_shoulder)
        call tap%ok(.not. skin%has_normal, 'a point nose has no normal')
        call tap%ok(all(skin%at == 0.0_dp), 'but is a point')
    end subroutine check_cone

    !> The book's nose is pointed, and open above.
    subroutine check_nose()
        type(body_type) :: body
        type(skin_type) :: skin
        body = nose_of_the_book()
        call tap%ok(body%sections(1)%outward == 1.0_dp, 'outside is to the right from keel to side')
        skin = skin_at(body%lines, body%sections(1), 10.0_dp, at_start)
        call tap%ok(skin%normal(3) < -0.9_dp .and. skin%normal(1) < 0.0_dp, &
            'the keel looks down and forward')
        call tap%ok(skin%normal(2) == 0.0_dp, 'and not aside')
        skin = skin_at(body%lines, body%sections(1), 10.0_dp, at_finish)
        call tap%ok(skin%normal(2) > 0.9_dp .and. skin%normal(3) == 0.0_dp, &
            'the side looks to starboard')
    end subroutine check_nose

end program test_skin
