!> TITLE and UNITS, well and badly punched.
program test_control_card
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use deck_control_card, only: begins_with_word, card_word, heading_type, read_heading_card
    use deck_source, only: line_type, source_type
    use support_faults, only: said
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character(*), parameter :: feed = new_line('a'), tab = achar(9)
    character(*), parameter :: u_umlaut = char(195)//char(188)
    character(*), parameter :: misplaced = ' stands in columns 1-5 and its text from column 9 on'
    character(*), &
        parameter :: no_unit = 'error 3:9-16 the unit is INCHES, MM or FEET, from column 9 on'

    call check_words()
    call check_titles()
    call check_long_titles()
    call check_units()
    call check_second()
    call check_control_bytes()
    call tap%finish()

contains

    !> What counts as a word.
    subroutine check_words()
        call tap%ok(is_word('TITLE') .and. is_word('Line 5') .and. is_word('  end') &
            .and. is_word('aa'), &
            'two letters begin a word')
        call tap%ok(.not. any([is_word('O.5'), is_word('-30.'), is_word('E5'), is_word('x 5'), &
            is_word('5ab'), &
            is_word('        TITLE'), is_word('*comment'), is_word('       AB')]), &
            'a slip in a number does not, nor what stands behind column 8')
        call tap%same(word('title   x'), 'TITLE', 'a word is told in capitals')
        call tap%same(word('  Line,MHB'), 'LINE', 'a comma ends it')
        call tap%same(word('TITLE'//tab//'x'), 'TITLE', 'so does a tab')
        call tap%same(word('END'), 'END', 'or the end of the card')
        call tap%same(word('WATERLINES 5.'), 'WATERLINES', 'a long word is whole')
    end subroutine check_words

    !> Titles.
    subroutine check_titles()
        call title('TITLE   NOSE OF APPENDIX B', 'NOSE OF APPENDIX B', '', 'a title is read')
        call title('title   Nose  of ', 'Nose  of', '', 'in lower case its letters stay')
        call title('TITLE     INDENTED', '  INDENTED', '', 'blanks before it stay')
        call title('TITLE', '', '', 'a title may be blank')
        call title('TITLE   B'//u_umlaut//'hne', 'B'//u_umlaut//'hne', '', &
            'letters beyond ASCII stay')
        call title('TITLE NOSE', 'SE', 'error 3:1-8 the word TITLE'//misplaced, &
            'text too near is a fault')
        call title(' TITLE  NOSE', 'NOSE', 'error 3:1-8 the word TITLE'//misplaced, &
            'so is a word set in')
        call title('TITLE,NOSE, LOWER', 'NOSE, LOWER', '', 'a comma behind the word is free field')
        call title('TITLE   NOSE, LOWER', 'NOSE, LOWER', '', 'a comma in the text is not')
    end subroutine check_titles

    !> Titles to column 80 and beyond.
    subroutine check_long_titles()
        character(*), parameter :: long = 'text beyond column 80; shorten the title'

        call title('TITLE   '//repeat('x', 72), repeat('x', 72), '', '72 letters fit')
        call title('TITLE   '//repeat('x', 73)//'  ', repeat('x', 72), 'error 3:81-81 '//long, &
            '73 do not')
        call title('TITLE   '//repeat(u_umlaut, 72), repeat(u_umlaut, 72), '', &
            '72 letters of two bytes fit')
        call title('TITLE   '//repeat(u_umlaut, 74), repeat(u_umlaut, 72), &
            'error 3:153-156 '//long, &
            'of 74 the bytes of the last two are at fault')
        call title('TITLE   x'//repeat(' ', 2000), 'x', '', 'blanks do not count')
        call title('TITLE   x'//repeat(' ', 2000)//'y', 'x', 'error 3:81-2010 '//long, &
            'text far behind is seen')
    end subroutine check_long_titles

    !> Units.
    subroutine check_units()
        call unit('UNITS   INCHES', 'INCHES', '', 'inches')
        call unit('units   mm', 'MM', '', 'millimetres in lower case')
        call unit('UNITS   Feet    ', 'FEET', '', 'feet')
        call unit('UNITS', '', no_unit, 'no unit is a fault')
        call unit('UNITS   METRES', '', no_unit, 'so is another')
        call unit('UNITS    MM', '', no_unit, 'or one a column off')
        call unit('UNITS   MM INCH', '', no_unit, 'or two')
        call unit('UNITS   MM      MILLIMETRES', 'MM', &
            'error 3:17-27 text outside the columns; the unit stands in columns 9-16', &
            'text behind it is a fault')
        call unit('UNITS MM', '', 'error 3:1-8 the word UNITS'//misplaced//feed//no_unit, &
            'a unit too near is two')
        call unit(' UNITS  MM', 'MM', 'error 3:1-8 the word UNITS'//misplaced, &
            'a word set in is a fault')
    end subroutine check_units

    !> A second card of a kind.
    subroutine check_second()
        type(heading_type) :: heading
        type(fault_list_type) :: faults

        call read_heading_card(line_of('TITLE   ONE'), heading, faults)
        call tap%ok(heading%has_title .and. .not. heading%has_units, &
            'a title card is no units card')
        call read_heading_card(line_of('UNITS   MM'), heading, faults)
        call tap%same(said(faults), '', 'one of each is well')
        call read_heading_card(line_of('TITLE   TWO'), heading, faults)
        call read_heading_card(line_of('UNITS   FEET'), heading, faults)
        call tap%same(said(faults), 'error 3:1-5 a second TITLE card; a deck has one'//feed// &
            'error 3:1-5 a second UNITS card; a deck has one', 'two of each are not')
        call tap%same(faults%item(2)%card, 'UNITS   FEET', 'a fault shows its own card')
        call tap%same(heading%title//' '//heading%units, 'ONE MM', 'the first of each stays')
    end subroutine check_second

    !> Tabs and control bytes: one fault says it, and nothing is taken from the card.
    subroutine check_control_bytes()
        character(*), &
            parameter :: words = ' a tab or control byte on a card; put blanks in its place'

        call title('TITLE'//tab//'NOSE', '(none)', 'error 3:6-6'//words, 'a tab is a fault')
        call title('TITLE   A'//achar(27)//'[1m', '(none)', 'error 3:10-10'//words, &
            'so is an escape')
        call title('TITLE   A'//achar(127), '(none)', 'error 3:10-10'//words, 'or a delete')
        call unit('UNITS'//tab//'MM', '', 'error 3:6-6'//words, 'also on a units card')
    end subroutine check_control_bytes

    !> Reads a title card and compares the title and the faults.
    subroutine title(card, expected, faulty, name)
        character(*), intent(in) :: card             !! the card
        character(*), intent(in) :: expected         !! the title
        character(*), intent(in) :: faulty           !! the faults
        character(*), intent(in) :: name             !! the check as a phrase
        type(heading_type) :: heading
        type(fault_list_type) :: faults

        call read_heading_card(line_of(card), heading, faults)
        if (.not. allocated(heading%title)) heading%title = '(none)'
        call tap%same(heading%title, expected, name)
        call tap%same(said(faults), faulty, name//': faults')
    end subroutine title

    !> Reads a units card and compares the unit and the faults.
    subroutine unit(card, expected, faulty, name)
        character(*), intent(in) :: card     !! the card
        character(*), intent(in) :: expected !! the unit, or nothing
        character(*), intent(in) :: faulty   !! the faults
        character(*), intent(in) :: name     !! the check as a phrase
        type(heading_type) :: heading
        type(fault_list_type) :: faults

        call read_heading_card(line_of(card), heading, faults)
        if (.not. allocated(heading%units)) heading%units = ''
        call tap%same(heading%units, expected, name)
        call tap%same(said(faults), faulty, name//': faults')
    end subroutine unit

    !> A card as the third line of a file.
    function line_of(card) result(line)
        character(*), intent(in) :: card !! the card
        type(line_type) :: line
        type(source_type) :: source
        type(error_type), allocatable :: error
        logical :: found
        integer :: i
        call source%from_text(feed//feed//card//feed)
        do i = 1, 3
            call source%next_line(line, found, error)
        end do
    end function line_of

    !> True where a card begins with a word.
    logical function is_word(card)
        character(*), intent(in) :: card !! the card
        is_word = begins_with_word(line_of(card))
    end function is_word

    !> The word a card begins with.
    function word(card)
        character(*), intent(in) :: card !! the card
        character(:), allocatable :: word
        word = card_word(line_of(card))
    end function word

end program test_control_card
