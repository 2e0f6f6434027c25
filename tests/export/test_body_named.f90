!> Tests of curves with names on them.
program test_body_named
    use base_kinds, only: dp
    use export_body_drawing, only: drawing_type
    use export_body_named, only: along, draw_named
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(drawing_type) :: drawing
    !> Three to the right, four up.
    real(dp), parameter :: bend(2, 3) = reshape([0.0_dp, 0.0_dp, 300.0_dp, 0.0_dp, 300.0_dp, &
        400.0_dp], [2, 3])

    call tap%ok(all(abs(along(bend, [0.0_dp, 0.5_dp, 1.0_dp]) - reshape([0.0_dp, 0.0_dp, 300.0_dp, &
        50.0_dp, 300.0_dp, 400.0_dp], [2, 3])) < 1.0e-12_dp), 'parts are parts of the length')
    call draw_named('line', bend, 'MHB', drawing)
    call draw_named('line', bend, 'USH', drawing)
    call draw_named('line', bend, '', drawing)
    call draw_named('line', bend(:, :1), 'POINT', drawing)
    call tap%ok(drawing%layer(1)%count == 3, 'curves are drawn; a point is none')
    call tap%ok(drawing%count == 2, 'each name once')
    call tap%ok(all(abs(drawing%words(1)%at - [300.0_dp, 50.0_dp]) < 1.0e-12_dp), &
        'a name stands in the middle')
    call tap%ok(norm2(drawing%words(2)%at - drawing%words(1)%at) > 10.0_dp, &
        'the next of the same curve elsewhere')
    call tap%finish()
end program test_body_named
