!> Tests of the inside of the skin as a path: of a sphere it is a smaller sphere.
program test_drawing_opposite
    use base_kinds, only: dp
    use body_body, only: body_type, mirrored_body
    use cut_outline, only: cut_type
    use cut_plane, only: buttock_plane, in_space, plane_type, station_plane, waterline_plane
    use export_drawing_opposite, only: is_patch_opposite, new_opposite, nowhere, opposite_type, &
        patch_opposite
    use export_drawing_outside, only: way_round, way_round_type
    use support_bodies, only: ellipsoid
    use support_cutting, only: by_number, cut_of, plane_of
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: radius = 20.0_dp, thickness = 0.5_dp
    type(tap_type) :: tap
    type(body_type) :: body
    type(cut_type) :: cut
    type(way_round_type) :: round
    type(opposite_type) :: inside
    real(dp) :: p(3)

    body = ellipsoid([radius, radius, radius], 30.0_dp, 0.0_dp)
    call judge(station_plane(22.0_dp), 'station')
    call judge(buttock_plane(5.0_dp), 'butt line')
    call judge(waterline_plane(-9.0_dp), 'waterline')
    call judge(plane_of([30.0_dp, 2.0_dp, 5.0_dp], [1.0_dp, -0.3_dp, 0.4_dp]), 'canted plane')
    call judge(waterline_plane(0.0_dp), 'waterline of the nose')
    p = inside%at(0.0_dp)
    call tap%near(p(1), 10.0_dp + thickness, 0.0_dp, &
        'in a blunt nose the skin is as thick as it is')

    body = ellipsoid([radius, radius, radius], 30.0_dp, 0.0_dp)
    cut = cut_of(body, by_number(station_plane(15.0_dp), 5))
    call way_round(mirrored_body(body), cut%plane, cut%outlines(1), round)
    call new_opposite(mirrored_body(body), cut%plane, 14.0_dp, round%path(1), inside)
    call tap%ok(patch_opposite(inside, 0.5_dp) == nowhere, &
        'a skin so thick that its frame is all skin has no inside there')
    call tap%ok(is_patch_opposite(inside, 0.5_dp, nowhere), 'which is so all along')
    call tap%finish()

contains

    !> The inside of a cut of the sphere, on the sphere with the smaller radius.
    subroutine judge(plane, name)
        type(plane_type), intent(in) :: plane
        character(*), intent(in) :: name
        real(dp) :: off, astray, t, q(3), way(3)
        integer :: i, k
        logical :: is_there

        cut = cut_of(body, by_number(plane, 5))
        call way_round(mirrored_body(body), cut%plane, cut%outlines(1), round)
        off = 0.0_dp
        astray = 0.0_dp
        is_there = .true.
        do i = 1, size(round%path)
            call new_opposite(mirrored_body(body), cut%plane, thickness, round%path(i), inside)
            do k = 0, 40
                t = sin(real(k, dp)*acos(-1.0_dp)/80.0_dp)**2
                is_there = is_there .and. patch_opposite(inside, t) /= nowhere
                is_there = is_there .and. is_patch_opposite(inside, t, patch_opposite(inside, t))
                q = inside%at(t)
                way = inside%way(t)
                way = (way(1)*cut%plane%u + way(2)*cut%plane%v)/norm2(way)
                q = in_space(cut%plane, q(:2)) - [30.0_dp, 0.0_dp, 0.0_dp]
                off = max(off, abs(norm2(q) - (radius - thickness)))
                astray = max(astray, abs(dot_product(q/norm2(q), way)))
            end do
        end do
        call tap%ok(is_there, name//': the skin has an inside all along')
        call tap%near(off, 0.0_dp, 1.0e-12_dp, name//': which is a sphere')
        call tap%near(astray, 0.0_dp, 1.0e-12_dp, name//': its directions are across the normal')
    end subroutine judge

end program test_drawing_opposite
