!> A 1970 deck card by card: what is found, what it is called, and every fault of the deck as a
!> whole.
program test_conic_deck
    use, intrinsic :: iso_c_binding, only: c_int
    use base_error, only: cause, error_type
    use base_fault, only: fault_list_type
    use base_text, only: to_text
    use deck_conic_card, only: conic_card_type
    use deck_conic_deck, only: conic_deck_type, found
    use deck_source, only: source_type
    use support_faults, only: places, said
    use support_tap, only: tap_type
    implicit none (type, external)

    !> All that a deck gave.
    type :: reading_type
        character(:), allocatable :: cards  !! `1:label:line|`, a bad card with `!`
        type(fault_list_type) :: faults     !! all faults
        type(conic_deck_type) :: deck       !! the deck at its end
    end type reading_type

    type(tap_type) :: tap
    character(*), parameter :: feed = new_line('a'), tab = achar(9), null = achar(0)
    character(*), parameter :: mark = char(239)//char(187)//char(191)
    character(*), &
        parameter :: mhb = '-30.    -10.    .114    0.      -7.1    50.     -4.     .0523   5.'
    character(*), &
        parameter :: lsh = '-30.    -10.    -.268   0.      -16.    50.     -21.2   -.0697  5.'
    character(*), &
        parameter :: slip = '-3O.    -10.    -.268   0.      -16.    50.     -21.2   -.0697  5.'
    character(*), parameter :: last = '999.99'
    character(*), parameter :: no_card = &
        'error 0:0-0 the deck has no conic card; it needs at least one, with X1 in columns '// &
        '1-8 (see loft help cards)'
    character(*), parameter :: ended = ' X1 of 999.99 or more ends a 1970 deck'

    call check_sound_decks()
    call check_headings()
    call check_editors()
    call check_names()
    call check_bad_cards()
    call check_words()
    call check_end()
    call check_empty()
    call check_binary()
    call check_long_deck()
    call check_trouble()
    call tap%finish()

contains

    !> Decks without fault.
    subroutine check_sound_decks()
        call reads(mhb//feed//lsh//feed//last//feed, '1::1|2::2|', '', 'two cards and the end card')
        call reads(mhb//feed//lsh, '1::1|2::2|', '', 'the end of the file ends a deck')
        call reads(feed//'   '//feed//mhb//feed//repeat(' ', 5000)//feed//lsh//feed//feed, &
            '1::3|2::5|', '', &
            'blank cards are passed over, however long')
        call reads('*'//feed//'* a comment'//feed//feed//mhb//feed//'* the end'//feed//last, &
            '1:a comment:4|', '', &
            'comments stand anywhere')
    end subroutine check_sound_decks

    !> TITLE and UNITS before the first card.
    subroutine check_headings()
        type(reading_type) :: r

        r = reading('title   Nose'//feed//'* about units'//feed//'units   mm'//feed//mhb)
        call tap%same(said(r%faults)//r%cards, '1::4|', &
            'a heading comes before the cards and names none')
        call tap%same(r%deck%heading%title//'/'//r%deck%heading%units, 'Nose/MM', 'it is kept')
        r = reading('TITLE   '//char(206)//char(177)//feed//mhb)
        call tap%same(said(r%faults)//r%deck%heading%title, char(206)//char(177), &
            'a title may be in UTF-8')
        call reads('TITLE   ONE'//feed//'TITLE   TWO'//feed//mhb, '1::3|', &
            'error 2:1-5 a second TITLE card; a deck has one', 'two titles are a fault')
        call reads(mhb//feed//'TITLE   LATE'//feed//lsh, '1::1|2::3|', &
            'error 2:1-5 TITLE in a 1970 deck; only '// &
            'TITLE and UNITS may stand there, before the first conic card', &
            'a title after a card is a fault')
        r = reading(mhb//feed//'UNITS   MM')
        call tap%ok(.not. r%deck%heading%has_units .and. r%faults%count == 1, &
            'late units are not taken')
        call reads('TITLE'//tab//'NOSE'//feed//mhb, '1::2|', &
            'error 1:6-6 a tab or control byte on a card; put blanks in its place', &
            'a tab in a title')
        call reads('UNITS   CUBITS'//feed//mhb, '1::2|', &
            'error 1:9-16 the unit is INCHES, MM or FEET, from column 9 on', 'another unit')
    end subroutine check_headings

    !> What editors and other systems do to a file.
    subroutine check_editors()
        character(*), parameter :: crlf = achar(13)//feed

        call reads(mark//mhb//crlf//'   '//crlf//'* lower'//crlf//lsh//crlf//last//crlf, &
            '1::1|2:lower:4|', '', &
            'byte order mark and carriage returns are no part of a card')
        call reads(mark//'TITLE   X'//feed//mhb, '1::2|', '', 'a heading behind a byte order mark')
        call reads(mhb(:8)//tab//mhb(9:)//feed//lsh, '!1::1|2::2|', &
            'error 1:9-9 a tab on a card; fields go by columns, so put blanks in its place', &
            'a tab costs its card, the next one is read')
        call reads(mhb//repeat(' ', 80 - len(mhb))//repeat('x', 99920)//feed//lsh, '!1::1|2::2|', &
            'error 1:81-100000 text beyond column 80; XI stands in columns 65-70, YI in '// &
            '71-76, ITYP in 77-78, and 79-80 are free', &
            'so does a line of 100000 characters')
        call reads(repeat(' ', 3000)//'x'//feed//mhb, '!1::1|2::2|', &
            'error 1:81-3001 text beyond column 80; XI stands in columns 65-70, YI in '// &
            '71-76, ITYP in 77-78, and 79-80 are free'//feed// &
            'error 1:25-40 points 1 and 2 coincide; three different points fix a conic'//feed// &
            'error 1:41-56 points 1 and 3 coincide; three different points fix a conic'//feed// &
            'error 1:41-56 points 2 and 3 coincide; three different points fix a conic'//feed// &
            'error 1:65-70 XI is zero where a table is asked for; punch an increment, or ITYP '// &
            'and YI for '// &
            'a Y table alone', 'text far behind a blank card is not lost')
    end subroutine check_editors

    !> Comments name the card right behind them.
    subroutine check_names()
        call reads('* MHB side '//feed//mhb//feed//lsh, '1:MHB side:2|2::3|', '', &
            'a comment names the next card only')
        call reads('* one'//feed//'* two'//feed//mhb, '1:two:3|', '', 'the last of several')
        call reads('* one'//feed//feed//mhb, '1:one:3|', '', 'also over a blank card')
        call reads('*'//feed//mhb, '1::2|', '', 'an empty one names nothing')
        call reads('* one'//feed//'TITLE   X'//feed//mhb, '1::3|', '', &
            'one before a title names no card')
        call reads('* bad'//feed//slip//feed//lsh, '!1:bad:2|2::3|', &
            'error 2:3-3 X1: the letter O in a number; the figure is 0', &
            'a bad card has its name too')
        call reads(' * on'//feed//mhb, '!1::1|2::2|', &
            'error 1:2-2 X1: ''*'' in a number; figures, a sign, '// &
            'a point and an exponent are read', 'an asterisk in column 2 is no comment')
    end subroutine check_names

    !> Bad cards between good ones.
    subroutine check_bad_cards()
        type(reading_type) :: r

        r = reading(slip//feed//mhb//feed//slip//feed//lsh//feed//'0.'//feed//mhb//feed//last)
        call tap%same(r%cards, '!1::1|2::2|!3::3|4::4|!5::5|6::6|', &
            'bad cards are counted, the others come out')
        call tap%same(places(r%faults), &
            'error 1:3-3, error 3:3-3, error 5:25-40, error 5:41-56, '// &
            'error 5:41-56, error 5:65-70', 'every fault has its line')
        call tap%same(r%faults%item(2)%card, slip, 'and shows its card')
        call tap%ok(r%deck%cards == 6, 'the deck has six cards')
    end subroutine check_bad_cards

    !> Words that begin no card of a 1970 deck.
    subroutine check_words()
        character(*), parameter :: here = &
            ' of a 1970 deck; a conic card has X1 in columns 1-8, a comment * in column 1'
        character(*), parameter :: late = &
            ' in a 1970 deck; only TITLE and UNITS may stand there, before the first conic card'

        call reads('LINE    MHB     SIDE'//feed//mhb, '1::2|', &
            'error 1:1-4 LINE begins no card'//here, &
            'a word before the first card')
        call reads(mhb//feed//'  end'//feed//lsh, '1::1|2::3|', 'error 2:3-5 END'//late, &
            'a word after it, where it stands')
        call reads('comment without asterisk'//feed//mhb, '1::2|', &
            'error 1:1-7 COMMENT begins no card'//here, &
            'a comment without its asterisk')
        call reads(mhb//feed//'WATERLINES,-16.', '1::1|', 'error 2:1-10 WATERLINES'//late, &
            'a long word')
        call reads('NaN     0.', '', 'error 1:1-3 NAN begins no card'//here//feed//no_card, &
            'no number')
    end subroutine check_words

    !> The end card and what is behind it.
    subroutine check_end()
        call reads(mhb//feed//last//feed//lsh//feed//'TITLE   X'//feed//'* no card'//feed//feed// &
            slip, '1::1|', &
            'warning 2:0-0 3 cards after the end card not read;'//ended, &
            'cards after the end are counted and warned of, comments not')
        call reads(mhb//feed//last//feed//last, '1::1|', &
            'warning 2:0-0 1 card after the end card not read;'//ended, 'a second end card is one')
        call reads(mhb//feed//'1500.   -10.    .114  '//feed, '1::1|', &
            'warning 2:9-20'//ended//'; the rest of this card is not used', &
            'more on the end card is warned of')
        call reads(mhb//feed//' 999.999'//repeat(' ', 70)//'99', '1::1|', '', &
            'a sequence number on it is not')
        call reads(mhb//feed//'50      -10.'//feed//lsh, '1::1|', &
            'warning 2:9-12'//ended//'; the rest of this card is not used'//feed// &
            'warning 2:0-0 1 card after the end card not read;'//ended, &
            'a number without a point that ends the deck does so with warnings')
        call reads(last//feed//mhb, '', 'warning 1:0-0 1 card after the end card not read;'// &
            ended//feed//no_card, &
            'a deck that ends before its first card has none')
    end subroutine check_end

    !> Decks without a card.
    subroutine check_empty()
        call reads('', '', no_card, 'an empty file')
        call reads(feed//'* only a comment'//feed, '', no_card, 'a file of comments')
        call reads('TITLE   X', '', no_card, 'a title alone')
        call reads(last, '', no_card, 'an end card alone')
    end subroutine check_empty

    !> Null bytes: no deck.
    subroutine check_binary()
        character(*), parameter :: words = &
            ' a null byte: this is a binary file, not a deck of cards; nothing more of it is read'
        type(reading_type) :: r

        call reads(mhb//feed//'PK'//null//'x'//feed//lsh, '1::1|', 'error 2:3-3'//words, &
            'a null byte ends the reading')
        call reads('* '//null, '', 'error 1:3-3'//words, 'also in a comment')
        call reads(mhb//feed//last//feed//null, '1::1|', 'error 3:1-1'//words, &
            'also behind the end card')
        call reads(repeat('x', 2000)//null//feed//mhb, '', 'error 1:0-0'//words, &
            'far behind, no column is named')
        r = reading(null)
        call tap%ok(r%deck%is_binary .and. r%faults%item(1)%card == '', 'the card is not shown')
    end subroutine check_binary

    !> Many cards.
    subroutine check_long_deck()
        type(reading_type) :: r
        r = reading(repeat(mhb//feed, 4999)//slip//feed//'TITLE   X')
        call tap%ok(r%deck%cards == 5000, '5000 cards are counted')
        call tap%same(places(r%faults), 'error 5000:3-3, error 5001:1-5', &
            'their faults stand on their lines')
    end subroutine check_long_deck

    !> A source that can't be read.
    subroutine check_trouble()
        type(source_type) :: source
        type(conic_deck_type) :: deck
        type(conic_card_type) :: card
        type(fault_list_type) :: faults
        type(error_type), allocatable :: error
        integer :: outcome

        call source%attach(999_c_int)
        call deck%next(source, card, outcome, faults, error)
        call tap%ok(allocated(error), 'a source that can''t be read is an error')
        if (allocated(error)) call tap%ok(error%cause == cause%file_trouble, 'as file trouble')
        call tap%ok(faults%count == 0, 'and no fault of the deck')
    end subroutine check_trouble

    !> Compares the cards and faults of a deck.
    subroutine reads(text, cards, faults, name)
        character(*), intent(in) :: text   !! the deck
        character(*), intent(in) :: cards  !! its cards
        character(*), intent(in) :: faults !! its faults
        character(*), intent(in) :: name   !! the check as a phrase
        type(reading_type) :: r
        r = reading(text)
        call tap%same(r%cards, cards, name)
        call tap%same(said(r%faults), faults, name//': faults')
    end subroutine reads

    !> Reads a deck to its end.
    function reading(text) result(r)
        character(*), intent(in) :: text !! the deck
        type(reading_type) :: r
        type(source_type) :: source
        type(conic_card_type) :: card
        type(error_type), allocatable :: error
        integer :: outcome

        r%cards = ''
        call source%from_text(text)
        do
            call r%deck%next(source, card, outcome, r%faults, error)
            if (allocated(error) .or. outcome == found%finished) exit
            if (.not. card%is_sound) r%cards = r%cards//'!'
            r%cards = r%cards//to_text(card%count)//':'//card%label//':'//to_text(card%line)//'|'
        end do
        if (allocated(error)) r%cards = r%cards//error%message
    end function reading

end program test_conic_deck
