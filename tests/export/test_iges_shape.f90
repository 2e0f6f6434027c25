!> Cuts and control lines of IGES files: their curves, names, levels, and what the receipt says.
program test_iges_shape
    use base_kinds, only: dp
    use export_drawing, only: shape_kind, shape_type
    use export_iges_file, only: iges_file_type
    use export_iges_shape, only: add_level, add_shape
    use export_receipt, only: receipt_type
    use support_iges_deck, only: deck_of, deck_type
    use support_iges_shapes, only: oblique_shape
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_splines()
    call check_conics()
    call check_line()
    call check_level()
    call tap%finish()

contains

    !> A cut with splines alone.
    subroutine check_splines()
        type(iges_file_type) :: file
        type(receipt_type) :: receipt
        type(deck_type) :: deck
        character(:), allocatable :: record
        integer :: i

        call add_shape(file, oblique_shape(0.4_dp), 5, .false., receipt)
        deck = deck_of(file%directory%text()//file%parameters%text())
        call tap%ok(deck%entities(126) == 3 .and. deck%entities(116) == 1 .and. &
            deck%entities(406) == 1 .and. file%directory%count == 10, 'splines, a point, a name')
        call tap%same(deck%record(1), '406,1,5HOBL_1;', 'the name of the cut')
        call tap%ok(deck%field(1, 15) == '15' .and. deck%field(1, 9) == '00010200', &
            'is a property that belongs to others')
        do i = 3, 9, 2
            call tap%ok(deck%field(i, 5) == '5' .and. deck%field(i, 13) == '6' .and. &
                deck%field(i, 18) == 'OBLIQUE' .and. deck%field(i, 19) == '12' .and. &
                deck%field(i, 4) == '1' .and. deck%field(i, 9) == '00000000', &
                'each curve has level, colour, label and number')
            record = deck%record(i)
            call tap%ok(record(len(record) - 6:) == ',0,1,1;', 'and the name')
        end do
        call tap%ok(index(deck%record(3), '126,2,2,1,0,0,0,') == 1, 'the arc is planar, rational')
        call tap%has(deck%record(3), ',0.,1.,0.89442719099991', 'it has its normal')
        call tap%ok(index(deck%record(5), '126,1,1,1,0,1,0,0.,0.,1.,1.,1.,1.,') == 1, &
            'the line is planar, polynomial')
        call tap%ok(index(deck%record(9), '116,3.,0.,1.,0,') == 1, 'the point is where it is')
        call tap%ok(receipt%count == 4, 'the receipt has four entities')
        associate (e => receipt%entities)
            call tap%ok(e(1)%kind == '126 B-SPLINE CURVE' .and. e(1)%is_exact .and. &
                e(1)%points == 3 .and. e(1)%spans == 1 .and. e(1)%name == 'OBL_1', 'an exact one')
            call tap%ok(.not. e(3)%is_exact .and. e(3)%error == 2.0e-4_dp .and. e(3)%has_place &
                .and. all(e(3)%worst == [5.0_dp, 13.0_dp, 6.0_dp]), 'a fitted one')
            call tap%ok(e(4)%kind == '116 POINT' .and. e(4)%is_exact, 'the point')
        end associate
    end subroutine check_splines

    !> The same with conics and lines.
    subroutine check_conics()
        type(iges_file_type) :: file
        type(receipt_type) :: receipt
        type(deck_type) :: deck

        call add_shape(file, oblique_shape(0.4_dp), 5, .true., receipt)
        deck = deck_of(file%directory%text()//file%parameters%text())
        call tap%ok(deck%entities(104) == 1 .and. deck%entities(124) == 1 .and. &
            deck%entities(110) == 1 .and. deck%entities(126) == 1 .and. deck%entities(116) == 1, &
            'an ellipse with its matrix, a line, what is neither, a point')
        call tap%ok(deck%field(3, 9) == '00010000' .and. deck%field(3, 4) == '0', &
            'the matrix belongs to others')
        call tap%ok(deck%field(5, 7) == '3' .and. deck%field(5, 15) == '1', 'the ellipse has it')
        call tap%ok(receipt%entities(1)%kind == '104 CONIC ARC' .and. &
            receipt%entities(1)%error < 1.0e-14_dp .and. receipt%entities(1)%is_exact, &
            'the receipt says so')
        call tap%ok(receipt%entities(2)%kind == '110 LINE', 'of the line too')
    end subroutine check_conics

    !> A control line is not said to be planar; one without contours is not there.
    subroutine check_line()
        type(iges_file_type) :: file
        type(receipt_type) :: receipt
        type(deck_type) :: deck
        type(shape_type) :: shape

        shape = oblique_shape(0.4_dp)
        shape%kind = shape_kind%line
        call add_shape(file, shape, 6, .false., receipt)
        deck = deck_of(file%directory%text()//file%parameters%text())
        call tap%ok(index(deck%record(3), '126,2,2,0,0,0,0,') == 1 .and. &
            index(deck%record(3), ',0.,1.,0.,0.,0.,0,1,1;') > 0, 'a control line has no normal')
        call tap%ok(deck%field(3, 18) == 'LINE' .and. deck%field(3, 13) == '1', 'and its label')
        deallocate (shape%contours)
        allocate (shape%contours(0))
        call add_shape(file, shape, 6, .false., receipt)
        call tap%ok(file%directory%count == 10 .and. receipt%count == 4, &
            'a cut without contours leaves nothing, not even a name')
    end subroutine check_line

    !> What a level is for.
    subroutine check_level()
        type(iges_file_type) :: file
        type(deck_type) :: deck
        call add_level(file, 3, 'STA_20: STATION 20')
        deck = deck_of(file%directory%text()//file%parameters%text())
        call tap%same(deck%record(1), '406,2,3,18HSTA_20: STATION 20;', 'a level says what it is')
        call tap%ok(deck%field(1, 5) == '3' .and. deck%field(1, 15) == '3', 'by its number')
    end subroutine check_level

end program test_iges_shape
