!> A faired outline on pages: four points of a square, by hand.
program test_outline_listing
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_output, only: output_type
    use body_outline, only: outline_type
    use geom_fairing, only: fair
    use geom_fairing_system, only: fairing_end
    use report_ordinate, only: new_form
    use report_outline_listing, only: print_outline
    use report_page, only: page_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(outline_type) :: outline
    type(page_type) :: page
    type(output_type) :: out
    type(error_type), allocatable :: error

    ! Vertices of a square turn by right angles: p = (4 v + 2*0)/6 = 2 v/3 each; the energies of a
    ! vertex at r are 8/3 r**2 and 8 r**2. The least of 4 (.5*(8/3 + 8) r**2 + w (2 r/3 - 3)**2) is
    ! at r = 2.25 where w = 12: points at 1.5, E2 = 54, E3 = 162.
    outline%name = 'DUCT'
    outline%sta = 10.0_dp
    outline%measured%point = reshape([3.0_dp, 0.0_dp, 0.0_dp, 3.0_dp, -3.0_dp, 0.0_dp, 0.0_dp, &
        -3.0_dp], [2, 4])
    outline%measured%weight = [12.0_dp, 12.0_dp, 12.0_dp, 12.0_dp]
    outline%measured%ends = fairing_end%closed
    call fair(outline%measured, 0.0_dp, outline%fairing, error)
    call page%set_heading('TITLE', 'deck.crd', 'INCHES')
    call print_outline(page, 4, outline, new_form('INCHES', 'INCHES', 4), out)
    call tap%has(out%text(), 'CUT 4   STATION 10.0000   DUCT   FAIRED OUTLINE', 'its name')
    call tap%has(out%text(), '    2       0.0000       3.0000       0.0000       1.5000       '// &
        '1.5000', 'a measured point, the faired one, their distance')
    call tap%has(out%text(), 'ENERGY OF SECOND DERIVATIVE    5.40000000E+01   SHARE 0.5', 'E2')
    call tap%has(out%text(), 'AS IT COMES', 'no area was asked')
    call tap%has(out%text(), '    1       1.5000       0.0000     VERTICAL', 'a vertical slope')
    call tap%has(out%text(), '   10       0.0000       1.5000     0.000000', 'a quarter around')
    call tap%finish()

end program test_outline_listing
