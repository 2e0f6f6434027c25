!> IGES card images: columns, numbers, and how free format goes on from card to card.
program test_iges_card
    use base_text, only: row_of
    use export_iges_card, only: section_type
    use support_iges_deck, only: deck_of, deck_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(section_type) :: section
    type(deck_type) :: deck

    section = section_type('S')
    call section%put_card('PLAIN')
    call section%put_card(row_of('X', 72))
    deck = deck_of(section%text())
    call tap%ok(deck%is_even .and. size(deck%cards) == 2 .and. section%count == 2, &
        'two cards of 80')
    call tap%same(deck%cards(1), 'PLAIN'//row_of(' ', 67)//'S      1', 'data, letter, number')
    call tap%same(deck%cards(2), row_of('X', 72)//'S      2', 'data of 72 columns')

    call check('1.,22.,333.;', '1.,22.,333.;')
    ! 62 columns and a value of three with its comma: it goes to the next card.
    call check(row_of('1', 60)//'.,22.,3.;', row_of('1', 60)//'.,', '22.,3.;')
    ! 61 columns: the value fits with its comma, or with its semicolon.
    call check(row_of('1', 59)//'.,22.,3.;', row_of('1', 59)//'.,22.', ',3.;', is_refused=.true.)
    call check(row_of('1', 58)//'.,22.,3.;', row_of('1', 58)//'.,22.,', '3.;')
    call check(row_of('1', 58)//'.,22.;', row_of('1', 58)//'.,22.;')
    ! Texts are broken anywhere but before their first character.
    call check(row_of('1', 58)//'.,10HABCDEFGHIJ,5;', row_of('1', 58)//'.,10HA', 'BCDEFGHIJ,5;')
    call check(row_of('1', 60)//'.,3HABC,5;', row_of('1', 60)//'.,', '3HABC,5;')
    call check(row_of('1', 59)//'.,3HABC;', row_of('1', 59)//'.,3HA', 'BC;')
    call check('1H,,1H;,60H'//row_of(';', 60)//',7;', '1H,,1H;,60H'//row_of(';', 53), &
        row_of(';', 7)//',7;')
    call check('5H'//row_of(' ', 5)//',1;', '5H'//row_of(' ', 5)//',1;')
    call check_long()
    call check_wide()
    call tap%finish()

contains

    !> Puts a record in section P and compares its cards.
    subroutine check(record, first, second, is_refused)
        character(*), intent(in) :: record              !! with its end
        character(*), intent(in) :: first               !! data of the first card
        character(*), intent(in), optional :: second    !! and of the second
        logical, intent(in), optional :: is_refused     !! it must not be so
        type(section_type) :: section
        type(deck_type) :: deck
        character(64) :: data
        logical :: is_so

        section = section_type('P')
        call section%put_free(record, 17)
        deck = deck_of(section%text())
        data = first
        is_so = deck%is_even .and. deck%cards(1) == data//'      17P      1'
        if (present(second)) then
            data = second
            is_so = is_so .and. size(deck%cards) == 2
            if (is_so) is_so = deck%cards(2) == data//'      17P      2'
        else
            is_so = is_so .and. size(deck%cards) == 1
        end if
        if (present(is_refused)) is_so = .not. is_so .and. size(deck%cards) == 2
        call tap%ok(is_so, 'cards of '//record(max(1, len(record) - 20):))
        if (.not. is_so) call tap%note(section%text())
    end subroutine check

    !> A text over many cards comes back whole.
    subroutine check_long()
        type(section_type) :: section
        type(deck_type) :: deck
        character(:), allocatable :: whole
        integer :: i

        section = section_type('P')
        call section%put_free('300H'//repeat('ab,;3H ', 42)//'abcdef,1;', 3)
        deck = deck_of(section%text())
        whole = ''
        do i = 1, size(deck%cards)
            whole = whole//deck%cards(i)(:64)
        end do
        call tap%ok(size(deck%cards) == 5, 'a text of 300 takes five cards')
        call tap%same(trim(whole), '300H'//repeat('ab,;3H ', 42)//'abcdef,1;', &
            'and nothing between its parts')
    end subroutine check_long

    !> Section G has 72 columns and no pointer.
    subroutine check_wide()
        type(section_type) :: section
        type(deck_type) :: deck
        section = section_type('G')
        call section%put_free(row_of('1', 70)//'.,2.;')
        deck = deck_of(section%text())
        call tap%same(deck%cards(1), row_of('1', 70)//'.,G      1', 'section G has 72 columns')
        call tap%same(deck%cards(2), '2.;'//row_of(' ', 69)//'G      2', 'and goes on')
    end subroutine check_wide

end program test_iges_card
