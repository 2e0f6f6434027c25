!> Tests of corners and ribs: each stands once, whoever has it.
program test_shell_ribs
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use export_shell_ribs, only: ribs_of, ribs_type, settle_forms
    use export_shell_rows, only: form
    use export_shell_stretch, only: stretch_type, stretches_of
    use support_skins, only: deck_body, text_body
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(stretch_type), allocatable :: stretches(:)
    type(ribs_type) :: ribs
    type(error_type), allocatable :: error
    integer :: forms(5)
    character, parameter :: nl = new_line('a')

    call take(deck_body('fuselage'))
    call tap%ok(size(ribs%rib) == 14, 'the fuselage has 14 ribs: two at five stations, four aft')
    call tap%ok(size(ribs%corner, 2) == 20, 'and 20 corners: three at five stations, five aft')
    call tap%ok(ribs%ends(4)%rib(2, 2) == ribs%ends(5)%rib(1, 2) .and. ribs%ends(4)%rib(2, 2) > 0, &
        'at station 200 UPPER and SIDE have the same rib')
    call tap%ok(all(ribs%ends(5)%rib(1, 3:4) == 0), 'FILLET and RIDGE have none: they are points')
    call tap%ok(all(ribs%ends(5)%corner(1, stretches(5)%slots(4)%track) == &
        ribs%ends(5)%corner(1, stretches(5)%slots(2)%track(1))), 'in the corner where SIDE begins')
    forms = [form%arc, form%halves, form%arc, form%arc, form%arc]
    call settle_forms(stretches, ribs, forms)
    call tap%ok(all(forms == [form%arc, form%halves, form%halves, form%arc, form%arc]), &
        'sections of one rib have one form')

    call take(text_body('TITLE,TURNED'//nl//'LINE,UCL,SIDE,10.'//nl//'LINE,MHB,SIDE,0.'//nl// &
        'LINE,MHB,PLAN,10.'//nl//'LINE,USH,SIDE,8.'//nl//'LINE,USH,PLAN,6.'//nl// &
        'SECTION,FORE,UCL,USH,MHB,0.,999.999,0.,20.'//nl// &
        'SECTION,AFT,MHB,USH,UCL,999.999,0.,20.,50.'//nl))
    call tap%ok(size(ribs%rib) == 3, 'a section run through backwards has the same rib')
    call tap%ok(ribs%ends(1)%is_forward(2, 1) .and. .not. ribs%ends(2)%is_forward(1, 1), &
        'the other way')

    call take(text_body('TITLE,ALMOST'//nl//'LINE,UCL,SIDE,10.'//nl//'LINE,MHB,SIDE,0.'//nl// &
        'LINE,MHB,PLAN,10.'//nl//'LINE,USH,SIDE,8.'//nl//'LINE,USH,PLAN,6.'//nl// &
        'LINE,US2,SIDE,8.001'//nl//'LINE,US2,PLAN,6.'//nl// &
        'SECTION,FORE,UCL,USH,MHB,0.,999.999,0.,20.'//nl// &
        'SECTION,AFT,UCL,US2,MHB,0.,999.999,20.,50.'//nl))
    call tap%ok(size(ribs%rib) == 4 .and. size(ribs%corner, 2) == 6, &
        'arcs of one chord and two shoulders are two ribs between the same corners')

    call take(text_body('TITLE,STERN'//nl//'LINE,UCL,SIDE'//nl//'STRAIGHT,0.,10.,30.,0.'//nl// &
        'LINE,LCL,SIDE'//nl//'STRAIGHT,0.,-10.,30.,0.'//nl//'LINE,MHB,SIDE,0.'//nl// &
        'LINE,MHB,PLAN,10.'//nl//'LINE,USH,SIDE'//nl//'STRAIGHT,0.,8.,30.,0.'//nl// &
        'LINE,USH,PLAN,6.'//nl//'LINE,LSH,SIDE'//nl//'STRAIGHT,0.,-9.,30.,0.'//nl// &
        'LINE,LSH,PLAN,6.'//nl//'SECTION,UPPER,UCL,USH,MHB,0.,999.999'//nl// &
        'SECTION,LOWER,LCL,LSH,MHB,0.,999.999'//nl))
    call tap%ok(ribs%ends(1)%rib(2, 1) == ribs%ends(1)%rib(2, 2), &
        'sections that shrink to one line have one rib')
    call tap%ok(ribs%rib(ribs%ends(1)%rib(2, 1))%is_straight, 'which is straight')
    call tap%ok(abs(ribs%ends(1)%rows(2, 1)%weight - ribs%ends(1)%rows(2, 2)%weight) > 0.1_dp, &
        'each with its own weight')
    call tap%finish()

contains

    !> Finds the ribs of a body.
    subroutine take(given)
        type(body_type), intent(in) :: given
        body = given
        call stretches_of(body, 1.0e-3_dp, .false., stretches)
        call ribs_of(stretches, ribs, error)
        call tap%ok(.not. allocated(error), 'a body has ribs')
    end subroutine take

end program test_shell_ribs
