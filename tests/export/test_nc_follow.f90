!> Contours as paths. Oracles: circle and ellipse in closed form.
program test_nc_follow
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use export_drawing, only: contour_type, shape_type
    use export_nc_follow, only: follow_arcs, follow_chords
    use export_nc_path, only: path_type, run_type
    use export_receipt, only: entity_type
    use support_sketch, only: ellipse, new_shape, segment
    use support_tap, only: tap_type
    implicit none (type, external)
    type(run_type), parameter :: run = run_type(tolerance=1.0e-3_dp, decimals=4)
    type(tap_type) :: tap
    type(shape_type) :: shape
    type(contour_type) :: contour
    type(path_type) :: chords, arcs
    type(entity_type) :: entity
    type(error_type), allocatable :: error
    real(dp), parameter :: axes(2) = [12.0_dp, 5.0_dp]
    integer :: i
    real(dp) :: off

    shape = new_shape('A', 3.0_dp)
    contour = ellipse(shape%plane, [0.0_dp, 0.0_dp], axes)
    call follow_chords(shape, contour, run, chords, entity, error)
    call tap%ok(.not. allocated(error) .and. size(chords%segments) > 50, &
        'an ellipse in many chords')
    call tap%same(entity%kind, 'CLOSED PATH', 'what it is')
    call follow_arcs(shape, contour, run, arcs, entity, error)
    call tap%ok(.not. allocated(error) .and. size(arcs%segments) < size(chords%segments)/2, &
        'takes far fewer arcs')
    call tap%same(entity%kind, 'CLOSED PATH OF ARCS', 'what it is then')
    call tap%ok(entity%spans == size(arcs%segments) .and. entity%error <= run%tolerance .and. &
        entity%error > 0.5_dp*run%tolerance, 'arcs counted, within the tolerance')
    call tap%near(norm2(arcs%segments(size(arcs%segments))%to - arcs%start), 0.0_dp, 0.0_dp, &
        'it ends where it began')
    off = 0.0_dp
    do i = 1, size(arcs%segments)
        off = max(off, abs(norm2(arcs%segments(i)%to/axes) - 1.0_dp)*minval(axes))
    end do
    call tap%ok(off < 1.5e-4_dp, 'its joints are on the ellipse')
    call tap%ok(.not. any(arcs%segments%is_clockwise), 'it turns left all the way')
    contour = segment([3.0_dp, 1.0_dp, 1.0_dp], [3.0_dp, 1.0_dp, 1.0_dp])
    call follow_arcs(shape, contour, run, arcs, entity, error)
    call tap%ok(size(arcs%segments) == 0 .and. .not. allocated(error), 'a point has no segments')
    call follow_chords(shape, contour, run, arcs, entity, error)
    call tap%ok(size(arcs%segments) == 0 .and. .not. allocated(error), 'either way')
    contour = ellipse(shape%plane, [0.0_dp, 0.0_dp], axes)
    contour%curves(2)%error = 9.9e-4_dp
    call follow_arcs(shape, contour, run, arcs, entity, error)
    call tap%ok(allocated(error), 'a curve that is too far off leaves nothing for arcs')
    if (allocated(error)) call tap%ok(error%cause == cause%no_convergence, 'and says so')
    call tap%finish()
end program test_nc_follow
