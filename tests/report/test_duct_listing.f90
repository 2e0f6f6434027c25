!> Ducts on pages: a cone of ellipses, whose areas are known.
program test_duct_listing
    use base_digits, only: fixed
    use base_kinds, only: dp
    use base_output, only: output_type
    use body_duct, only: duct_type
    use cut_duct, only: duct_measure_type, measure_duct
    use geom_fairing_system, only: spline_area
    use geom_ring_spline, only: ring_from, turned_ring
    use report_duct_listing, only: print_ducts
    use report_ordinate, only: new_form
    use report_page, only: page_type
    use support_ducts, only: duct_through, outline_of, wheel
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(output_type) :: out, inches
    type(page_type) :: page
    type(duct_type) :: duct
    type(duct_measure_type) :: measure
    real(dp) :: area

    call page%set_size(80, 60)
    call page%set_heading('TITLE', 'deck.crd', 'MM')
    call print_ducts(page, [duct_type ::], [duct_measure_type ::], new_form('MM', 'MM', 3), out)
    call tap%same(out%text(), '', 'a body without ducts has no table')
    duct = duct_through([outline_of('LIP', 10.0_dp, wheel(12, [1.0_dp, 2.0_dp], [0.5_dp, &
        1.0_dp], 0.0_dp)), outline_of('FACE', 20.0_dp, turned_ring(ring_from(wheel(12, [2.0_dp, &
        4.0_dp], [1.0_dp, 2.0_dp], 0.0_dp), 4)))])
    measure = measure_duct(duct, [15.0_dp])
    call print_ducts(page, [duct], [measure], new_form('MM', 'MM', 3), out)
    area = spline_area(wheel(12, [1.0_dp, 2.0_dp], [0.0_dp, 0.0_dp], 0.0_dp), .true.)
    call tap%has(out%text(), 'DUCT DUCT THROUGH 2 OUTLINES, 12 VERTICES AROUND', 'the head')
    call tap%has(out%text(), 'LIP            10.000      12            1'//new_line('a'), &
        'an outline')
    call tap%has(out%text(), 'FACE           20.000      12            4  TURNED', &
        'one turned and begun elsewhere')
    call tap%has(out%text(), '      15.000'//fixed(2.25_dp*area, 14, 3), 'the area of a station')
    call tap%has(out%text(), '       0.750       1.500'//new_line('a'), 'its centroid')
    call tap%has(out%text(), '       1.000       2.000  FACE', 'the name of an outline')
    call tap%has(out%text(), 'VOLUME FROM STA 10.000 TO STA 20.000   1.3', 'the volume')
    call print_ducts(page, [duct], [measure], new_form('MM', 'INCHES', 6), inches)
    call tap%has(inches%text(), '     0.59055'//fixed(2.25_dp*area/25.4_dp**2, 14, 5), &
        'in inches areas are in square inches')
    call tap%finish()
end program test_duct_listing
