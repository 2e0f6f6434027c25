!> Tests of the curves of pictures on bodies with closed forms.
program test_body_curves
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_make, only: make_cut
    use cut_outline, only: cut_type
    use cut_plane, only: station_plane
    use cut_request, only: request_type
    use export_body_curves, only: body_range, chain_strokes, mirror_in_plane, on_paper, &
        outline_points, swept_area
    use export_body_drawing, only: stroke_type
    use geom_chain, only: chain_type, constant_chain
    use support_solids, only: cylinder, ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(chain_type) :: flat
    type(stroke_type), allocatable :: strokes(:)
    type(cut_type) :: cut
    type(request_type) :: request
    type(error_type), allocatable :: error
    real(dp), allocatable :: at(:, :)
    real(dp), parameter :: pi = acos(-1.0_dp)

    body = ellipsoid([5.0_dp, 3.0_dp, 2.0_dp])
    allocate (strokes, source=chain_strokes(body%lines(3)%plan, [0.0_dp, 0.0_dp]))
    call tap%ok(size(strokes) == 2, 'a stroke an arc')
    call tap%ok(all(abs((strokes(1)%at(1, :)/5.0_dp)**2 + (strokes(1)%at(2, :)/3.0_dp)**2 - &
        1.0_dp) &
        < 1.0e-14_dp), 'points of a stroke are on the ellipse')
    call tap%ok(size(strokes(1)%at, 2) > 15, 'a quarter of it has points close together')
    deallocate (strokes)
    call constant_chain(7.0_dp, flat)
    allocate (strokes, source=chain_strokes(flat, [-1.0_dp, 4.0_dp]))
    call tap%ok(all(abs(strokes(1)%at - reshape([-1.0_dp, 7.0_dp, 4.0_dp, 7.0_dp], [2, 2])) &
        <= 0.0_dp), 'a constant is drawn over the range')

    call tap%ok(all(abs(body_range([body, cylinder(1.0_dp, 9.0_dp)]) - [-5.0_dp, &
        9.0_dp]) <= 0.0_dp), &
        'the range of bodies holds all of them')
    call tap%ok(all(abs(body_range([body_type ::])) <= 0.0_dp), 'of none it is nought')

    request%plane = station_plane(0.0_dp)
    request%number = 2
    call make_cut(body, request, cut, error)
    call tap%ok(.not. allocated(error), 'a station is cut')
    allocate (at, source=outline_points(cut%outlines(1)))
    call tap%ok(size(at, 2) > 30, 'a station follows its arcs, not the few points asked')
    call tap%ok(all(abs((at(2, :)/3.0_dp)**2 + (at(3, :)/2.0_dp)**2 - 1.0_dp) < 1.0e-14_dp), &
        'its points are on the ellipse')
    call tap%near(abs(swept_area(cut)), 3.0_dp*pi, 0.03_dp, 'its area is half that of the ellipse')
    call tap%ok(all(abs(on_paper(cut, at) - at(2:3, :)) <= 0.0_dp), &
        'true shape of a station: BL, WL')
    call tap%ok(all(abs(mirror_in_plane(at) - spread([1.0_dp, -1.0_dp, 1.0_dp], 2, size(at, &
        2))*at) &
        <= 0.0_dp), 'the mirror image has the other BL')
    call tap%finish()
end program test_body_curves
