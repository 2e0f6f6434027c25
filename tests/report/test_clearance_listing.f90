!> Clearances on pages: asked, found, where; too small is said.
program test_clearance_listing
    use base_kinds, only: dp
    use base_output, only: output_type
    use cut_clearance, only: clearance_type
    use report_clearance_listing, only: print_clearances
    use report_ordinate, only: new_form
    use report_page, only: page_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(clearance_type) :: clearances(2)
    type(clearance_type), allocatable :: none(:)
    type(page_type) :: page, blank_page
    type(output_type) :: out, nothing

    clearances(1)%name = 'WHEEL'
    clearances(1)%asked = 1.0_dp
    clearances(1)%gap = 0.412_dp
    clearances(1)%is_short = .true.
    clearances(1)%nearest = [31.25_dp, 12.5_dp, -18.75_dp]
    clearances(2) = clearances(1)
    clearances(2)%name = 'HEAD'
    clearances(2)%gap = 2.0_dp
    clearances(2)%is_short = .false.
    clearances(2)%note = 'a remark'
    call page%set_heading('TITLE', 'deck.crd', 'INCHES')
    call print_clearances(page, clearances, new_form('INCHES', 'INCHES', 3), out)
    call tap%has(out%text(), &
        'WHEEL          1.000     0.412     31.250     12.500    -18.750  TOO SMALL', &
        'asked, found, nearest point, and that it is too small')
    call tap%has(out%text(), &
        'HEAD           1.000     2.000     31.250     12.500    -18.750'//new_line('a'), &
        'one that is large enough is left alone')
    call tap%has(out%text(), '  a remark', 'a remark stands below its row')
    allocate (none(0))
    call print_clearances(blank_page, none, new_form('INCHES', 'INCHES', 3), nothing)
    call tap%same(nothing%text(), '', 'without components there is no table')
    call tap%finish()

end program test_clearance_listing
