!> Clearances of components as they are told.
program test_clearance
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_clearance, only: check_clearance, clearance_type, component_kind, component_type
    use cut_clearance_map, only: map_type, new_map
    use support_solids, only: cylinder, ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: good = 1.0e-12_dp
    type(tap_type) :: tap
    type(body_type) :: body
    type(map_type) :: map
    type(component_type) :: item
    type(clearance_type) :: found

    body = ellipsoid([5.0_dp, 5.0_dp, 5.0_dp])
    map = new_map(body)
    item = component_type(component_kind%point, 'PUMP', [0.0_dp, 1.8_dp, 2.4_dp], &
        clearance=1.75_dp, skin=0.25_dp)
    call look()
    call tap%near(found%gap, 1.75_dp, good, 'a point 2 below the surface, 1.75 below a skin of .25')
    call tap%ok(found%has_gap .and. .not. found%is_short, 'as much as asked is not short')
    call tap%ok(found%name == 'PUMP' .and. found%kind == component_kind%point, 'it keeps its name')
    call tap%near(norm2(found%nearest - [0.0_dp, 3.0_dp, 4.0_dp]), 0.0_dp, 1.0e-10_dp, &
        'the nearest point')
    call tap%near(norm2(found%inner - [0.0_dp, 2.85_dp, 3.8_dp]), 0.0_dp, 1.0e-10_dp, &
        'the nearest point of the inside of the skin')
    call tap%near(norm2(found%normal - [0.0_dp, 0.6_dp, 0.8_dp]), 0.0_dp, 1.0e-10_dp, 'its normal')
    call tap%ok(found%is_abreast .and. found%is_certain .and. .not. allocated(found%note), &
        'nothing to be said')
    call tap%ok(found%section == 1, 'it is in the upper quarter')
    item%clearance = 1.750001_dp
    call look()
    call tap%ok(found%is_short, 'a millionth less than asked is short')

    item = component_type(component_kind%sphere, &
        'TANK', [-1.2_dp, 0.0_dp, -1.6_dp], radius=2.5_dp, &
        clearance=0.0_dp, skin=0.125_dp)
    call look()
    call tap%near(found%gap, 0.375_dp, good, 'a sphere in a sphere')
    call tap%near(norm2(found%touching - [-2.7_dp, 0.0_dp, -3.6_dp]), 0.0_dp, 1.0e-10_dp, &
        'the sphere''s own nearest point')
    item%radius = 4.0_dp
    call look()
    call tap%near(found%gap, -1.125_dp, good, 'a sphere that pierces the skin')
    call tap%ok(found%is_short, 'is short of 0')
    item%at = [0.0_dp, -4.2_dp, 5.6_dp]
    item%radius = 1.0_dp
    call look()
    call tap%near(found%gap, -3.125_dp, good, 'a sphere outside')
    call tap%near(norm2(found%touching - [0.0_dp, -4.8_dp, 6.4_dp]), 0.0_dp, 1.0e-10_dp, &
        'its own farthest point')
    item%at = [-3.0_dp, 0.0_dp, 0.0_dp]
    item%radius = 3.0_dp
    call look()
    call tap%ok(.not. found%is_abreast .and. allocated(found%note), &
        'it is told that a sphere extends beyond the nose')
    call tap%near(found%gap, -1.125_dp, good, 'and by how much')

    item = component_type(component_kind%box, '', [1.0_dp, 2.0_dp, -1.0_dp], &
        [-1.0_dp, -1.0_dp, 2.0_dp], clearance=1.5_dp, skin=0.5_dp)
    call look()
    call tap%near(found%gap, 1.5_dp, good, 'a box by two opposite corners in any order')
    call tap%ok(.not. found%is_short, 'as clear as asked')
    item%other(3) = 6.0_dp
    call look()
    call tap%near(found%gap, 4.5_dp - sqrt(41.0_dp), good, 'a box that pierces the skin')

    body = cylinder(2.0_dp, 10.0_dp)
    map = new_map(body)
    item = component_type(component_kind%box, 'SHAFT', [-3.0_dp, -0.6_dp, -0.8_dp], &
        [13.0_dp, 0.6_dp, 0.8_dp], clearance=1.0_dp)
    call look()
    call tap%near(found%gap, 1.0_dp, good, 'a box through both open ends does not touch the skin')
    call tap%ok(.not. found%is_short .and. .not. found%is_abreast, &
        'and is told to extend beyond them')
    body%sections = body%sections(:0)
    map = new_map(body)
    call look()
    call tap%ok(.not. found%has_gap .and. found%is_short, 'no skin, no clearance')
    call tap%same(found%note, 'the body has no skin', 'and it is said so')
    call tap%finish()

contains

    !> Checks the item.
    subroutine look()
        call check_clearance(body, map, item, found)
    end subroutine look

end program test_clearance
