!> What decides the kind of a deck, and that nothing of it is lost.
program test_kind
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use deck_conic_card, only: conic_card_type
    use deck_conic_deck, only: conic_deck_type, found
    use deck_kind, only: deck_kind_of, opening_type, read_opening
    use deck_source, only: line_type, source_type
    use support_job_deck, only: words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character(*), parameter :: feed = new_line('a'), conic = &
        '-30.    -10.    .114    0.      -7.1    50.     -4.     .0523   5.'

    call tap%ok(kind_of(conic) == deck_kind_of%conic, 'a number makes a 1970 deck')
    call tap%ok(kind_of(repeat(' ', 8)//'5.') == deck_kind_of%conic, &
        'a blank field makes a 1970 deck')
    call tap%ok(kind_of('O.5') == deck_kind_of%conic, 'one letter is a slip in a number')
    call tap%ok(kind_of('LINE    A       SIDE') == deck_kind_of%body, 'a word makes a body deck')
    call tap%ok(kind_of('line,a,side') == deck_kind_of%body, 'in small letters too')
    call tap%ok(kind_of('* LINE'//feed//feed//'TITLE   LINE'//feed//conic) == deck_kind_of%conic, &
        'comments, blank cards and TITLE do not decide')
    call tap%ok(kind_of('UNITS,MM'//feed//'END') == deck_kind_of%body, 'UNITS does not decide')
    call tap%ok(kind_of('TITLES') == deck_kind_of%body, 'a word that only begins as TITLE decides')
    call tap%ok(kind_of('') == deck_kind_of%conic, 'an empty deck is taken as a 1970 deck')
    call tap%ok(kind_of('TITLE   A') == deck_kind_of%conic, 'so is one of a title alone')
    call tap%ok(kind_of('LI'//achar(0)) == deck_kind_of%conic, 'so is one with a null byte')
    call opening_keeps_all()
    call body_card_comes_again()
    call tap%finish()

contains

    !> The kind of a deck.
    integer function kind_of(text)
        character(*), intent(in) :: text
        type(source_type) :: source
        type(opening_type) :: opening
        type(fault_list_type) :: faults
        type(error_type), allocatable :: error
        call source%from_text(text)
        call read_opening(source, opening, faults, error)
        kind_of = opening%kind
    end function kind_of

    !> A conic deck reads on behind its opening as if there had been none.
    subroutine opening_keeps_all()
        type(source_type) :: source
        type(opening_type) :: opening
        type(fault_list_type) :: faults
        type(error_type), allocatable :: error
        type(conic_deck_type) :: deck
        type(conic_card_type) :: card
        integer :: outcome

        call source%from_text('TITLE   NOSE'//feed//'UNITS   FURLONGS'//feed//'* far'//feed// &
            '* LSH'//feed//feed//conic//feed//conic)
        call read_opening(source, opening, faults, error)
        call tap%ok(index(words_of(faults), '2:9-16 error: the unit') == 1, &
            'a fault of UNITS is said')
        call faults%clear()
        deck%heading = opening%heading
        call deck%next(source, card, outcome, faults, error)
        call tap%ok(outcome == found%conic .and. card%line == 6, 'the deciding card is read again')
        call tap%same(card%label, 'LSH', 'its comment still names it')
        call tap%same(deck%heading%title, 'NOSE', 'the title is known')
        call deck%next(source, card, outcome, faults, error)
        call tap%ok(outcome == found%conic .and. card%line == 7 .and. card%label == '', &
            'the next card follows without that name')
        call deck%next(source, card, outcome, faults, error)
        call tap%ok(outcome == found%finished .and. faults%count == 0, &
            'and the deck ends without a fault')
    end subroutine opening_keeps_all

    !> The deciding card of a body deck is the next line.
    subroutine body_card_comes_again()
        type(source_type) :: source
        type(opening_type) :: opening
        type(fault_list_type) :: faults
        type(error_type), allocatable :: error
        type(line_type) :: line
        logical :: has_line

        call source%from_text('* a comment'//feed//'DIGITS  4'//feed//'END')
        call read_opening(source, opening, faults, error)
        call source%next_line(line, has_line, error)
        if (has_line .and. line%text(1:1) == '*') call source%next_line(line, has_line, error)
        call tap%ok(has_line .and. line%number == 2, 'the deciding card keeps its line')
        call tap%same(line%text, 'DIGITS  4', 'and its text')
        call source%next_line(line, has_line, error)
        call tap%same(line%text, 'END', 'the next one follows')
        call source%next_line(line, has_line, error)
        call tap%ok(.not. has_line, 'then the file ends')
    end subroutine body_card_comes_again

end program test_kind
