!> Patches on pages.
program test_patch_listing
    use base_kinds, only: dp
    use base_output, only: output_type
    use body_panel, only: panel_type
    use report_ordinate, only: new_form
    use report_page, only: page_type
    use report_patch_listing, only: print_patches
    use support_saddle, only: saddle
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(output_type) :: out
    type(page_type) :: page
    type(panel_type) :: panels(1)

    call page%set_size(80, 60)
    call page%set_heading('TITLE', 'deck.crd', 'MM')
    call print_patches(page, [panel_type ::], new_form('MM', 'MM', 3), out)
    call tap%same(out%text(), '', 'a body without patches has no table')
    panels(1) = saddle()
    panels(1)%error = 1.5e-7_dp
    call print_patches(page, panels, new_form('MM', 'MM', 3), out)
    call tap%has(out%text(), 'PATCH       EDGES OFF       STA        BL        WL', 'the heads')
    ! The middle of the saddle faces along (-.2, -.2, 1).
    call tap%has(out%text(), 'SADDLE        1.5E-07 -0.192450 -0.192450  0.962250', 'the row')
    call tap%finish()
end program test_patch_listing
