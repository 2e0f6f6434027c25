!> Normals and curvatures at points in a row: those of a sphere.
program test_skin_row
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_section, only: section_arc
    use body_skin_row, only: row_normal_curvatures, row_normals
    use body_surface, only: patch_at
    use body_surface_row, only: patch_row_type, repeated_patch
    use geom_arc, only: arc_type
    use geom_arc_point, only: point, tangent
    use geom_place, only: place_at
    use geom_twofold_short, only: width
    use support_bodies, only: ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(patch_row_type) :: row
    type(arc_type) :: arc
    type(error_type), allocatable :: error
    real(dp) :: at(width, 2), along(width, 2), normal(width, 3), way(width, 3), left(width, 3)
    real(dp) :: curvature(width)
    logical :: has_normal(width)
    integer :: i

    body = ellipsoid([5.0_dp, 5.0_dp, 5.0_dp], 0.0_dp, 0.0_dp)
    call section_arc(body%lines, body%sections(1), 3.0_dp, arc, error)
    call repeated_patch(patch_at(body%lines, body%sections(1), 3.0_dp, arc), row)
    do i = 1, width
        at(i, :) = point(arc, place_at(real(i, dp)/real(width + 1, dp)))
        along(i, :) = tangent(arc, place_at(real(i, dp)/real(width + 1, dp)))
    end do
    call row_normals(row, at, along, body%sections(1)%outward, normal, has_normal)
    call tap%ok(all(has_normal), 'there is a normal everywhere')
    call tap%near(maxval(abs(5.0_dp*normal(:, 2:) - at)), 0.0_dp, 1.0e-14_dp, &
        'it is the radius of a sphere')
    call tap%near(maxval(abs(normal(:, 1) - 0.6_dp)), 0.0_dp, 1.0e-15_dp, 'along STA, too')
    way(:, 1) = 0.0_dp
    way(:, 2) = -at(:, 2)/4.0_dp
    way(:, 3) = at(:, 1)/4.0_dp
    left(:, 1) = 0.0_dp
    left(:, 2) = -at(:, 1)/4.0_dp
    left(:, 3) = -at(:, 2)/4.0_dp
    call row_normal_curvatures(row, at, way, left, curvature)
    call tap%near(maxval(abs(curvature - 0.25_dp)), 0.0_dp, 1.0e-14_dp, &
        'a station turns by 1/4')
    call tap%finish()
end program test_skin_row
