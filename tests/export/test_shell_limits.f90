!> Tests of sections at the ends of stretches: where they are points or lines, what they near.
program test_shell_limits
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use export_shell_limits, only: end_rows
    use export_shell_rows, only: rows_type
    use export_shell_stretch, only: stretch_type, stretches_of
    use support_skins, only: deck_body, text_body
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    real(dp), parameter :: cos_45 = sqrt(0.5_dp)
    character, parameter :: nl = new_line('a')
    type(rows_type) :: rows

    rows = end_of(deck_body('ellipsoid'), 'UPPER', 1)
    call judge_point(rows, [0.0_dp, 30.0_dp], cos_45, 1.0e-11_dp, 'blunt nose')
    rows = end_of(deck_body('ellipsoid'), 'LOWER', 4)
    call judge_point(rows, [0.0_dp, 30.0_dp], cos_45, 1.0e-11_dp, 'blunt tail')
    rows = end_of(deck_body('cone'), 'UPPER', 1)
    call judge_point(rows, [0.0_dp, 10.0_dp], cos_45, 1.0e-10_dp, 'sharp nose')
    rows = end_of(deck_body('fuselage'), 'RIDGE', 9)
    call judge_point(rows, [0.0_dp, 26.0_dp], cos_45, 1.0e-9_dp, 'ridge of the fairing')
    rows = end_of(deck_body('ellipsoid'), 'UPPER', 2)
    call tap%ok(norm2(rows%middle/rows%weight - [60.0_dp, 80.0_dp]) < 1.0e-12_dp, &
        'an end that is an arc is that arc: the corner of its tangents')
    call tap%ok(all(rows%start == [0.0_dp, 80.0_dp]) .and. all(rows%finish == [60.0_dp, 30.0_dp]), &
        'from point to point, exactly')

    ! The height runs out along a conic that bends: w is that of all sections, V1 at the corner.
    rows = end_of(text_body('TITLE,STERN'//nl//'LINE,UCL,SIDE'//nl// &
        '0.,10.,-.02,25.,6.,50.,0.,-.4'//nl//'LINE,MHB,SIDE,0.'//nl//'LINE,MHB,PLAN,10.'//nl// &
        'LINE,USH,SIDE'//nl//'0.,8.,-.016,25.,4.8,50.,0.,-.32'//nl//'LINE,USH,PLAN,6.'//nl// &
        'SECTION,UPPER,UCL,USH,MHB,0.,999.999'//nl), 'UPPER', 2)
    call tap%ok(norm2(rows%middle/rows%weight - [10.0_dp, 0.0_dp]) < 1.0e-11_dp .and. &
        abs(rows%weight - cos_45) < 1.0e-12_dp, 'a section that shrinks to a line keeps its shape')
    call tap%ok(.not. rows%is_line, 'its rows are not those of a line')

    ! The shoulder comes down on the chord from (0, 1) to (1, 0) of quarter sections: w is b1 over
    ! 2 sqrt(b0 b2), and b1 goes to zero.
    rows = end_of(text_body('TITLE,FLAT'//nl//'LINE,UCL,SIDE,1.'//nl//'LINE,MHB,SIDE,0.'//nl// &
        'LINE,MHB,PLAN,1.'//nl//'LINE,USH,SIDE'//nl//'STRAIGHT,0.,.75,10.,.5'//nl// &
        'LINE,USH,PLAN'//nl//'STRAIGHT,0.,.75,10.,.5'//nl// &
        'SECTION,UPPER,UCL,USH,MHB,0.,999.999'//nl), 'UPPER', 2)
    call tap%ok(abs(rows%weight) < 1.0e-12_dp .and. norm2(rows%middle) < 1.0e-12_dp, &
        'a section that flattens between fixed tangents loses its weight')
    call tap%finish()

contains

    !> The rows of a section at an end: 1, 2 of the first stretch, 3, 4 of the second.
    function end_of(body, name, number) result(rows)
        type(body_type), intent(in) :: body
        character(*), intent(in) :: name
        integer, intent(in) :: number
        type(rows_type) :: rows
        type(stretch_type), allocatable :: stretches(:)
        type(error_type), allocatable :: error
        integer :: which, k
        which = (number + 1)/2
        allocate (stretches(0))
        call stretches_of(body, 1.0e-3_dp, .false., stretches)
        k = findloc(body%sections(stretches(which)%slots%number)%name == name, .true., dim=1)
        call end_rows(stretches(which), stretches(which)%slots(k), 2 - mod(number, 2), rows, error)
        call tap%ok(.not. allocated(error), name//' has an end')
    end function end_of

    !> All rows are in one point, and w is its limit.
    subroutine judge_point(rows, at, w, tolerance, name)
        type(rows_type), intent(in) :: rows
        real(dp), intent(in) :: at(2), w, tolerance
        character(*), intent(in) :: name
        call tap%ok(all(rows%start == at) .and. all(rows%finish == at) .and. &
            all(rows%middle == rows%weight*at), name//': all in one point')
        call tap%near(rows%weight, w, tolerance, name//': its weight is that of the sections near')
    end subroutine judge_point

end program test_shell_limits
