!> Tests of bodies laid out for networks.
program test_network_layout
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use export_network, only: network_type
    use export_network_layout, only: facing_left, lay_out, layout_type, network_along
    use export_settings, only: settings_type
    use support_bodies, only: ellipsoid
    use support_cylinders, only: cylinders
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(layout_type) :: layout
    type(network_type) :: network
    type(settings_type) :: settings
    type(error_type), allocatable :: error
    real(dp), allocatable :: none(:)
    integer :: n

    allocate (none(0))
    settings%tolerance = 0.05_dp
    settings%angle = 90.0_dp
    body = ellipsoid([50.0_dp, 50.0_dp, 50.0_dp], 50.0_dp, 0.0_dp)
    call lay_out(body, none, settings, layout, error)
    call tap%ok(.not. allocated(error) .and. layout%mesh%error <= 0.05_dp, &
        'without stations the tolerance is kept')
    call tap%ok(layout%mesh%error > 0.04_dp, 'and not much less')
    call lay_out(body, [20.0_dp, 50.0_dp], settings, layout, error)
    call tap%ok(size(layout%rows) == 4, 'stations that are given, and the ends')
    ! A meridian from the pole to STA 20: cosine of the angle .6; its chord is 50 (1 - cos(half)).
    call tap%ok(layout%mesh%error > 50.0_dp*(1.0_dp - sqrt(0.8_dp)), &
        'the error is that of the chords between them')
    ! LOWER goes from LCL to MHB, counter-clockwise: its outside is to the right.
    call tap%ok(all(facing_left(body, [1]) == [-1]), 'a section is turned about')
    call tap%ok(all(facing_left(body, [1, 2]) == [-2, -1]), 'so is a path')
    call tap%ok(all(facing_left(body, [-2, -1]) == [-2, -1]), 'unless it is right')
    network = network_along(layout, [-2, -1], [1, 1])
    n = size(network%points, 2)
    call tap%ok(size(network%points, 3) == 4 .and. n == size(layout%plan%columns(1)%share) &
        + size(layout%plan%columns(2)%share) - 1, 'sections in a row share a point')
    call tap%near(network%points(3, 1, 3) - network%points(3, n, 3), 100.0_dp, 1.0e-12_dp, &
        'it goes from the top to the bottom')
    call tap%near(maxval(abs(network%points(:, :, 1))), 0.0_dp, 0.0_dp, &
        'a section that is a point repeats it')
    call tap%near(maxval(abs(norm2(network%points(:, :, 3) - spread([50.0_dp, 0.0_dp, 0.0_dp], &
        2, n), dim=1) - 50.0_dp)), 0.0_dp, 1.0e-13_dp, 'points are on the sphere')
    call tap%near(network%error, layout%mesh%error, 0.0_dp, 'it has the error of its sections')

    body = cylinders([50.0_dp, 50.0_dp], [30.0_dp, 30.0_dp], 0.0_dp)
    body%lines(4)%plan%constant = 60.0_dp
    call lay_out(body, none, settings, layout, error)
    call tap%ok(allocated(error), 'a section without an arc is told')
    settings%tolerance = 1.0e-12_dp
    body = ellipsoid([50.0_dp, 50.0_dp, 50.0_dp], 50.0_dp, 0.0_dp)
    call lay_out(body, none, settings, layout, error)
    call tap%ok(error%cause == cause%too_many, 'too many points are refused')
    call tap%finish()
end program test_network_layout
