!> Meetings, closures and loose ends as they are printed.
program test_ring_listing
    use base_kinds, only: dp
    use base_output, only: output_type
    use body_body, only: body_type
    use body_ring_list, only: closure, loose_end_type, meeting_type, ring_type, stretch_type
    use report_ordinate, only: new_form
    use report_page, only: page_type
    use report_ring_listing, only: print_ring
    use support_bodies, only: ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    character, parameter :: nl = new_line('a')
    type(tap_type) :: tap
    type(body_type) :: body
    type(ring_type) :: ring

    body = ellipsoid([10.0_dp, 5.0_dp, 3.0_dp], 0.0_dp, 2.0_dp)
    allocate (ring%meetings(0), ring%loose(0), ring%stretches(0))
    call tap%same(printed('INCHES'), '', 'of a body without sections nothing is said')
    ring%meetings = [meeting_type([2, 3], -10.0_dp, 10.0_dp, 12.345678_dp, 2.5_dp), &
        meeting_type([4, 0], -10.0_dp, 10.0_dp, 4.0e-6_dp, 1.0_dp)]
    ring%stretches = [stretch_type(closure%halves, -10.0_dp, 10.0_dp)]
    call has('INCHES', 'LOWER       UPPER       MHB            -10.000      10.000  12.34568'// &
        '       2.500'//nl, 'a pair, their line, their range, the break and where')
    call has('INCHES', 'UPPER       ITS IMAGE   UCL            -10.000      10.000   0.00000'//nl, &
        'a break too small to show is nowhere')
    call has('MM', '-254.00', 'ordinates are in the unit of the listing')
    call has('MM', '12.34568', 'degrees stay')
    call has('INCHES', 'FROM STA -10.000 TO STA 10.000 THE SECTIONS GO FROM BL 0 TO BL 0'//nl, &
        'how they close')
    ring%stretches%closure = closure%round
    call has('INCHES', 'THE SECTIONS GO ALL ROUND'//nl, 'or go round')
    ring%stretches%closure = closure%open
    ring%loose = [loose_end_type(2, 0, -10.0_dp, 0.0_dp, [0.0_dp, 0.0_dp], 0.0_dp), &
        loose_end_type(2, 3, 0.0_dp, 10.0_dp, [0.25_dp, -1.5_dp], 7.5_dp)]
    call has('INCHES', 'THE SECTIONS ARE OPEN'//nl, 'or do not')
    call has('INCHES', '  FROM STA -10.000 TO STA 0.000 LOWER MEETS NO SECTION ON MHB'//nl, &
        'where an end is loose')
    call has('INCHES', 'UP TO 0.250 IN BL AND -1.500 IN WL AWAY, AT STA 7.500', &
        'and how far from the next')
    call tap%ok(index(printed('INCHES'), 'CHINE') == 0, 'nothing of chines where there are none')
    body%lines(body%sections(1)%line(3))%is_chine = .true.
    call has('INCHES', nl//'CHINES, WHERE A BREAK IS MEANT: MHB'//nl, 'and their names, each once')
    deallocate (ring%meetings)
    allocate (ring%meetings(0))
    call tap%ok(index(printed('INCHES'), 'DEGREES') == 0, 'without meetings there is no table')
    call tap%finish()

contains

    !> The page in a unit.
    function printed(unit) result(text)
        character(*), intent(in) :: unit
        character(:), allocatable :: text
        type(page_type) :: page
        type(output_type) :: out
        call page%set_heading('TITLE', 'deck', unit)
        call print_ring(page, body, ring, new_form('INCHES', unit, merge(3, 2, unit == 'INCHES')), &
            out)
        text = out%text()
    end function printed

    !> The page has this text in it.
    subroutine has(unit, part, name)
        character(*), intent(in) :: unit, part, name
        call tap%ok(index(printed(unit), part) > 0, name)
        if (index(printed(unit), part) == 0) call tap%note(printed(unit))
    end subroutine has

end program test_ring_listing
