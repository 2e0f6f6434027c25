!> The skin of a body in IGES files: its faces outward, its caps, its names and receipt.
program test_iges_skin
    use base_kinds, only: dp
    use export_iges_file, only: iges_file_type
    use export_iges_skin, only: add_skin, has_skin
    use export_receipt, only: receipt_type
    use export_shell, only: skin_model_type
    use support_iges_deck, only: deck_of, deck_type
    use support_iges_shapes, only: box_lid
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(iges_file_type) :: file
    type(receipt_type) :: receipt
    type(skin_model_type) :: none, model
    type(deck_type) :: deck

    call tap%ok(.not. has_skin(none), 'a drawing may have no skin')
    allocate (none%faces(0))
    call tap%ok(.not. has_skin(none), 'or one without faces')
    model = box_lid()
    call tap%ok(has_skin(model), 'this one has faces')
    call add_skin(file, model, 4, receipt)
    deck = deck_of(file%directory%text()//file%parameters%text())
    call tap%same(deck%record(1), '406,1,17HUPPER STA 0 TO 10;', 'the name of the face')
    call tap%ok(deck%field(3, 1) == '128' .and. deck%field(3, 5) == '4' .and. &
        deck%field(3, 18) == 'SKIN' .and. deck%field(3, 19) == '1', 'the face on its level')
    ! v runs from the crown to the side, so that the normal points outward: STA x (-WL) = BL.
    call tap%ok(index(deck%record(3), '128,1,2,1,2,0,0,0,0,0,0.,0.,10.,10.,0.,0.,0.,1.,1.,1.,'// &
        '1.,1.,0.7071067811865476,0.7071067811865476,1.,1.,0.,0.,2.,10.,0.,2.,0.,2.,2.,') == 1, &
        'its normal turned outward')
    call tap%ok(index(deck%record(3), ',0.,10.,0.,1.,0,1,1;') > 0, 'its ranges and name')
    call tap%ok(deck%entities(144) == 1 .and. deck%entities(128) == 2, 'and the cap')
    call tap%same(deck%record(5), '406,1,9HCAP STA 0;', 'with its name')
    call tap%ok(receipt%count == 2, 'the receipt has both')
    associate (e => receipt%entities)
        call tap%ok(e(1)%kind == '128 B-SPLINE SURFACE' .and. e(1)%points == 6 .and. &
            e(1)%spans == 1 .and. .not. e(1)%is_exact .and. e(1)%error == 3.0e-4_dp .and. &
            e(1)%has_place .and. all(e(1)%worst == [5.0_dp, 1.0_dp, 1.5_dp]), 'a fitted surface')
        call tap%ok(e(2)%kind == '144 TRIMMED PLANE' .and. e(2)%is_exact .and. &
            .not. e(2)%has_place .and. e(2)%name == 'CAP STA 0', 'an exact plane')
    end associate
    call tap%finish()
end program test_iges_skin
