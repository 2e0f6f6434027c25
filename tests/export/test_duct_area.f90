!> Tests of the area curve of a duct: of a cone it is a parabola.
program test_duct_area
    use base_kinds, only: dp
    use body_duct, only: duct_type
    use cut_duct, only: measure_duct
    use export_body_drawing, only: drawing_type
    use export_duct_area, only: duct_area_drawing
    use geom_fairing_system, only: spline_area
    use support_ducts, only: duct_through, outline_of, wheel
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(duct_type) :: duct
    type(drawing_type) :: drawing
    real(dp), allocatable :: at(:, :)
    real(dp) :: area

    duct = duct_through([outline_of('LIP', 10.0_dp, wheel(12, [1.0_dp, 2.0_dp], [0.0_dp, 0.0_dp], &
        0.0_dp)), outline_of('FACE', 20.0_dp, wheel(12, [2.0_dp, 4.0_dp], [0.0_dp, 0.0_dp], &
        0.0_dp))])
    drawing = duct_area_drawing(duct, measure_duct(duct, [12.0_dp, 30.0_dp]), 'CONE', 'mm')
    area = spline_area(wheel(12, [1.0_dp, 2.0_dp], [0.0_dp, 0.0_dp], 0.0_dp), .true.)
    allocate (at, source=drawing%layer(1)%stroke(1)%at)
    call tap%near(maxval(abs(at(2, :) - area*(0.1_dp*at(1, :))**2)), 0.0_dp, 1.0e-13_dp, &
        'the areas of a cone: a parabola over the stations')
    call tap%near(at(1, 1), 10.0_dp, 0.0_dp, 'from the first outline')
    call tap%near(at(1, size(at, 2)), 20.0_dp, 0.0_dp, 'to the last')
    call tap%ok(drawing%layer(2)%count == 3, 'outlines and the station between are marked')
    call tap%has(drawing%view, 'Section areas of duct DUCT; volume 133.776 cubic', &
        'the volume is told')
    call tap%has(drawing%view, ' cubic mm', 'in its unit')
    call tap%finish()
end program test_duct_area
