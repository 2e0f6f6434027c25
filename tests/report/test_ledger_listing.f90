!> The continuity ledger on pages: numbers in a row, the same in words below.
program test_ledger_listing
    use base_kinds, only: dp
    use base_output, only: output_type
    use body_ledger, only: joint_between, joint_type
    use geom_arc, only: line_between
    use geom_stroke, only: conic_stroke
    use report_ledger_listing, only: print_ledger
    use report_ordinate, only: new_form
    use report_page, only: page_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(joint_type) :: joints(1)
    type(joint_type), allocatable :: none(:)
    type(page_type) :: page, blank_page, paged
    type(output_type) :: out, nothing, on_pages

    ! Two lines at right angles, slopes 1 and -1: the break is 90 degrees to the right.
    joints(1) = joint_between(conic_stroke(line_between([0.0_dp, 0.0_dp], [10.0_dp, 10.0_dp])), &
        conic_stroke(line_between([10.0_dp, 10.0_dp], [20.0_dp, 0.0_dp])))
    joints(1)%line = 'UCL'
    call page%set_heading('TITLE', 'deck.crd', 'INCHES')
    call print_ledger(page, joints, new_form('INCHES', 'INCHES', 3), out)
    call tap%has(out%text(), 'CONTINUITY LEDGER', 'it has a title')
    call tap%has(out%text(), 'UCL       SIDE        10.000   0.00E+00 -90.00000', &
        'a row names line, view and station, gap and break')
    call tap%has(out%text(), 'SLOPE BREAKS BY -90. DEGREES', 'and says it in words')
    call paged%set_heading('TITLE', 'deck.crd', 'INCHES')
    call paged%set_size(80, 20)
    call print_ledger(paged, spread(joints(1), 1, 40), new_form('INCHES', 'INCHES', 3), on_pages)
    call tap%ok(index(on_pages%text(), new_line('a')//'  SLOPE') > 0 .and. index(on_pages%text(), &
        'AFTER'//new_line('a')//'  SLOPE') == 0, 'a row and its words stay on one page')
    allocate (none(0))
    call print_ledger(blank_page, none, new_form('INCHES', 'INCHES', 3), nothing)
    call tap%same(nothing%text(), '', 'without joints there is no ledger')
    call tap%finish()

end program test_ledger_listing
