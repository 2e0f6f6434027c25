!> Samples of skins.
program test_clearance_map
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_clearance_map, only: column_parts, map_type, new_map, row_parts
    use support_solids, only: cone, ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: axes(3) = [10.0_dp, 3.0_dp, 2.0_dp]
    type(tap_type) :: tap
    type(body_type) :: body
    type(map_type) :: map
    real(dp) :: worst
    integer :: i, k, row

    body = ellipsoid(axes)
    map = new_map(body)
    call tap%ok(size(map%sheets) == 4, 'two quarters of two arcs each are four sheets')
    worst = 0.0_dp
    do i = 1, 4
        do row = 0, row_parts
            do k = 0, column_parts
                worst = max(worst, abs(norm2(map%sheets(i)%at(:, k, row)/axes) - 1.0_dp))
            end do
        end do
    end do
    call tap%near(worst, 0.0_dp, 1.0e-14_dp, 'every sample is on the ellipsoid')
    call tap%ok(all([(all(map%sheets(i)%is_there), i=1, 4)]), 'none is missing')
    call tap%ok(map%sheets(1)%is_point(0) .and. .not. any(map%sheets(1)%is_point(1:)), &
        'the nose is a point, the rest is not')
    call tap%ok(map%sheets(2)%is_point(row_parts), 'so is the tail')
    call tap%ok(map%sheets(1)%spacing > 0.1_dp .and. map%sheets(1)%spacing < 1.0_dp, &
        'neighbours are near each other')

    body = cone(3.0_dp, 4.0_dp, 0.0_dp)
    body%sections(2)%line = [3, 3, 5]
    map = new_map(body)
    call tap%ok(all(map%sheets(1)%is_there), 'a sound section is sampled')
    call tap%ok(.not. any(map%sheets(2)%is_there(1:row_parts - 1)), 'one without an arc is not')
    body%sections%to = body%sections%from - 1.0_dp
    map = new_map(body)
    call tap%ok(size(map%sheets) == 0, 'sections without a range have no sheets')
    call tap%finish()
end program test_clearance_map
