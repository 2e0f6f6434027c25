!> Faired lines on pages.
program test_faired_listing
    use base_kinds, only: dp
    use base_output, only: output_type
    use body_faired, only: faired_point_type, faired_type
    use deck_job, only: view
    use report_faired_listing, only: print_faired
    use report_ordinate, only: new_form
    use report_page, only: page_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(faired_type) :: list(2)
    type(page_type) :: page, blank_page
    type(output_type) :: out, nothing

    list(1)%line = 'SHR'
    list(1)%view = view%side
    list(1)%point = [faired_point_type(0.0_dp, 1.0_dp, 10.0_dp, .true., .true., 1.0_dp), &
        faired_point_type(24.0_dp, 2.5_dp, 0.25_dp, .false., .true., 2.25_dp), &
        faired_point_type(48.0_dp, 9.0_dp, 0.25_dp, .false., .false., 0.0_dp)]
    list(2) = list(1)
    list(2)%view = view%angle
    call page%set_heading('TITLE', 'deck.crd', 'MM')
    call print_faired(page, list, new_form('INCHES', 'MM', 2), out)
    call tap%has(out%text(), 'FAIRED LINES', 'they have a title')
    call tap%has(out%text(), 'SHR       SIDE       HELD        0.00       25.40       25.40'// &
        '        0.00', 'an end is held')
    call tap%has(out%text(), 'SHR       SIDE       0.25      609.60       63.50       57.15'// &
        '       -6.35', 'a row has weight, station, both ordinates, difference')
    call tap%has(out%text(), '     1219.20      228.60           -           -', &
        'where a nose has cut the line off there is none')
    call tap%has(out%text(), 'LARGEST DIFFERENCE 6.35 AT STA 609.60', 'the largest in words')
    call tap%has(out%text(), '      609.60     2.50000     2.25000    -0.25000', &
        'angles stay degrees')
    call print_faired(blank_page, list(:0), new_form('INCHES', 'INCHES', 3), nothing)
    call tap%same(nothing%text(), '', 'without them there is nothing')
    call tap%finish()

end program test_faired_listing
