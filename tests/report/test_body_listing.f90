!> The parts of a body listing, in order, with cuts numbered through.
program test_body_listing
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_output, only: output_type
    use body_body, only: body_type
    use body_ledger, only: joint_type
    use cut_outline, only: cut_type
    use cut_plane, only: station_plane
    use deck_job, only: job_type
    use geom_circular, only: circular_between
    use report_arc_listing, only: arc_table_type
    use report_body_listing, only: body_listing_type
    use support_job_deck, only: body_text, job_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(job_type) :: job
    type(fault_list_type) :: faults
    type(body_listing_type) :: listing
    type(body_type) :: body
    type(joint_type), allocatable :: joints(:)
    type(cut_type) :: cut
    type(arc_table_type), allocatable :: tables(:)
    type(output_type) :: out

    call job_of('TITLE,A BODY|UNITS,INCHES|OUTPUT,MM|DIGITS,2|PAGE,132,50|'//body_text// &
        'STATION,20.|END', job, faults)
    call listing%begin(job, 'body.crd', out)
    body%name = 'CANOPY'
    allocate (joints(0))
    call listing%print_body_head(body, joints, out)
    cut%plane = station_plane(20.0_dp)
    allocate (cut%outlines(0), cut%notes(0))
    call listing%print_body_cut(cut, [character(8) :: 'UP'], out)
    call listing%print_body_cut(cut, [character(8) :: 'UP'], out)
    allocate (tables(1))
    allocate (tables(1)%arcs(1))
    tables(1)%arcs(1)%arc = circular_between([0.0_dp, 0.0_dp], 0.0_dp, [1.0_dp, 1.0_dp])
    call listing%print_body_arcs(cut, tables, out)
    call tap%has(out%text(), 'ARCS OF CUT 2,', 'arcs are of the cut before them')
    call tap%has(out%text(), 'A BODY', 'the title heads the pages')
    call tap%has(out%text(), &
        'ORDINATES IN      MM, ROUNDED TO 2 DECIMALS', 'OUTPUT and DIGITS are obeyed')
    call tap%has(out%text(), 'BODY CANOPY', 'a body with a name is named')
    call tap%has(out%text(), 'CUT 1   STATION 508.00', 'cuts are numbered, 20 in are 508 mm')
    call tap%has(out%text(), 'CUT 2   STATION 508.00', 'through the deck')
    call tap%ok(index(out%text(), 'DATUM') < index(out%text(), 'BODY CANOPY') .and. &
        index(out%text(), 'BODY CANOPY') < index(out%text(), 'CUT 1'), 'the parts are in order')
    call tap%ok(index(out%text(), 'PAGE 1'//new_line('a')) == 132 - len('PAGE 1') + 1, &
        'a page of 132 columns is that wide')
    call tap%finish()

end program test_body_listing
