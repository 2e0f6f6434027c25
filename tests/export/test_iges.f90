!> Whole IGES files: sections, counts, levels; what can't be written.
program test_iges
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use base_output, only: output_type
    use export_drawing, only: drawing_type
    use export_iges, only: write_iges
    use export_receipt, only: receipt_type
    use export_settings, only: settings_type
    use export_shell, only: skin_model_type
    use support_iges_deck, only: deck_of, deck_type, find_section
    use support_iges_shapes, only: box_lid, oblique_shape
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(skin_model_type) :: none
    type(settings_type) :: settings
    character(:), allocatable :: text

    settings%tolerance = 0.001_dp
    call check_file()
    call check_twice()
    call check_faults()
    call tap%finish()

contains

    !> A drawing of one cut and one line.
    type(drawing_type) function drawing_of() result(drawing)
        drawing%deck = 'lid.crd'
        drawing%title = 'LID'
        drawing%units = 'FEET'
        drawing%tolerance = 0.001_dp
        allocate (drawing%cuts(1), drawing%lines(1))
        drawing%cuts(1) = oblique_shape(0.4_dp)
        drawing%lines(1) = oblique_shape(0.7_dp)
        drawing%lines(1)%name = 'UCL'
        drawing%lines(1)%kind = 6
    end function drawing_of

    !> A file with a cut, a line and a skin.
    subroutine check_file()
        type(output_type) :: out
        type(receipt_type) :: receipt
        type(error_type), allocatable :: error
        type(deck_type) :: deck
        character(80), allocatable :: cards(:)
        integer :: counts(4), i, number, last
        character, parameter :: letters(5) = ['S', 'G', 'D', 'P', 'T']
        character(32) :: wanted

        call write_iges(drawing_of(), box_lid(), settings, out, receipt, error)
        call tap%ok(.not. allocated(error), 'a file is written')
        text = out%text()
        deck = deck_of(text)
        call tap%ok(deck%is_even, 'every card has 80 columns')
        last = 0
        do i = 1, 4
            call find_section(deck, letters(i), cards)
            counts(i) = size(cards)
            call tap%ok(counts(i) > 0 .and. all(deck%cards(last + 1:last + counts(i)) == cards), &
                'section '//letters(i)//' is in its place')
            last = last + counts(i)
            read (cards(counts(i))(74:80), *) number
            call tap%ok(number == counts(i), 'its cards are numbered')
        end do
        write (wanted, '(4(a,i7))') (letters(i), counts(i), i=1, 4)
        call tap%ok(size(deck%cards) == last + 1 .and. deck%cards(last + 1)(:72) == wanted .and. &
            deck%cards(last + 1)(73:) == 'T      1', 'the last card counts them')
        call tap%ok(index(text, 'Level 1: OBL_1: OBLIQUE 1') > 0 .and. &
            index(text, 'Level 2: CONTROL LINES') > 0 .and. index(text, 'Level 3: SKIN') > 0, &
            'levels in plain words')
        call tap%ok(index(text, ',4,2HFT,') > 0, 'the unit is told')
        call tap%ok(index(text, ',16.,,,11,') > 0, 'and the largest coordinate')
        call tap%ok(deck%entities(406) == 7, 'three levels, two curves and two faces have names')
        call tap%ok(deck%entities(116) == 2 .and. deck%entities(144) == 1, 'all is there')
        call tap%ok(receipt%count == 10, 'and on the receipt')
    end subroutine check_file

    !> The same bytes again; others with conics.
    subroutine check_twice()
        type(output_type) :: out, other
        type(receipt_type) :: receipt
        type(error_type), allocatable :: error
        type(deck_type) :: deck

        call write_iges(drawing_of(), box_lid(), settings, out, receipt, error)
        call tap%ok(out%text() == text, 'the same drawing gives the same bytes')
        settings%has_conics = .true.
        call write_iges(drawing_of(), box_lid(), settings, other, receipt, error)
        deck = deck_of(other%text())
        call tap%ok(deck%entities(104) == 2 .and. deck%entities(110) == 2, 'conics where asked for')
    end subroutine check_twice

    !> Nothing to write; a unit that is none.
    subroutine check_faults()
        type(output_type) :: out
        type(receipt_type) :: receipt
        type(error_type), allocatable :: error
        type(drawing_type) :: drawing

        drawing = drawing_of()
        deallocate (drawing%cuts, drawing%lines)
        call write_iges(drawing, none, settings, out, receipt, error)
        call tap%ok(allocated(error), 'nothing is refused')
        if (allocated(error)) call tap%ok(error%cause == cause%no_arc, 'and this is why')
        drawing = drawing_of()
        drawing%units = 'YARDS'
        call write_iges(drawing, none, settings, out, receipt, error)
        call tap%ok(allocated(error), 'an unknown unit is refused')
        if (allocated(error)) call tap%ok(error%cause == cause%usage, 'and this is why')
        call tap%ok(out%text() == '' .and. receipt%count == 0, 'nothing is written then')
    end subroutine check_faults

end program test_iges
