!> Conic cards: the book's, and every way to punch one wrong.
program test_conic_card
    use base_error, only: error_type
    use base_fault, only: fault_list_type, new_fault, severity
    use base_kinds, only: dp
    use deck_conic_card, only: conic_card_type, ends_deck, read_conic_card
    use deck_layout, only: conic
    use deck_source, only: line_type, source_type
    use support_faults, only: places, said
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character(*), parameter :: feed = new_line('a')
    ! X1      Y1      S1      X2      Y2      X3      Y3      S3      XI
    character(*), parameter :: book = &
        '-30.    -10.    .114    0.      -7.1    50.     -4.     .0523   5.'
    character(*), parameter :: contour = &
        '   0.000 -18.000 0.00000   9.000 -15.999  11.901  -7.100 999.999 2.000 2.000 1'
    character(*), &
        parameter :: slash = 'a fraction in a number; it is written with decimals, 1/2 as .5'

    call check_sound()
    call check_implied()
    call check_numbers()
    call check_columns()
    call check_points()
    call check_increments()
    call check_extremes()
    call check_end()
    call tap%finish()

contains

    !> Cards of the book.
    subroutine check_sound()
        type(conic_card_type) :: card
        type(fault_list_type) :: faults

        call read_card(book, card, faults)
        call tap%same(said(faults), '', 'the book''s first line has no fault')
        call tap%ok(card%is_readable .and. card%is_sound, 'it is readable and sound')
        call tap%ok(maxval(abs(card%real([conic%x1, conic%y1, conic%s1, conic%x2, conic%y2, &
            conic%x3, &
            conic%y3, conic%s3, conic%xi, conic%yi]) - [-30.0_dp, -10.0_dp, 0.114_dp, 0.0_dp, &
            -7.1_dp, &
            50.0_dp, -4.0_dp, 0.0523_dp, 5.0_dp, 0.0_dp])) <= 0.0_dp, &
            'its fields are the nearest doubles')
        call tap%ok(card%ityp == 0 .and. card%wants_x_table() .and. .not. card%wants_y_table(), &
            'it asks for an X table')
        call tap%ok(card%line == 3 .and. card%image == book, 'it knows its line and image')
        call tap%ok(card%steps_well(conic%xi) .and. .not. card%steps_well(conic%yi), &
            'XI steps well, YI is blank')
        call tap%ok(.not. card%has_coinciding_points(), 'its points are three')

        call read_card(contour, card, faults)
        call tap%ok(said(faults) == '' .and. card%is_sound, &
            'the book''s first section has no fault')
        call tap%ok(card%wants_x_table() .and. card%wants_y_table() .and. card%ityp == 1, &
            'it asks for both tables')
        call tap%near(card%real(conic%s3), 999.999_dp, 0.0_dp, 'its last slope is vertical')
        call faultless(contour//'27', 'columns 79-80 are free for a sequence number')
        call faultless(contour//'/'//char(200)//repeat(' ', 3000), &
            'for any mark, and blanks behind are none')
        call faultless('-30.    -10.    .114    0.      -7.1    50.     -4.     .0523         '// &
            '.5     1', &
            'a blank XI beside ITYP asks for a Y table alone')
        call read_card(book(:64)//'      .5     1', card, faults)
        call tap%ok(card%is_sound .and. card%wants_y_table() .and. .not. card%wants_x_table(), &
            'and only that')
        call faultless(book(:64)//'      .5    1 ', &
            'an ITYP in the left column is 10, which is not zero')
        call faultless(book(:64)//'5.    -5.', 'a YI without ITYP is not looked at')
    end subroutine check_sound

    !> Numbers read otherwise than they look.
    subroutine check_implied()
        call faulty('     -30-10.    .114    0.      -7.1    50.     -4.     .0523   5.', &
            'remark 3:1-8 X1 is read as -0.03: no point was punched, so the last 3 columns '// &
            'are decimals', &
            'a number without a point is remarked')
        call faulty('-30.    -10.      1140000.      -7.1    50.     -4.     .0523   5.', &
            'remark 3:17-24 S1 is read as 1.14: no point was punched, so the last 5 columns '// &
            'are decimals', &
            'a slope has five decimals')
        call faulty('-30.    -10.    .114    0.      -7.1    50      -4.     .0523   5.', &
            'remark 3:41-48 X3 is read as 50000.: no point was punched, so the last 3 columns '// &
            'are '// &
            'decimals and a blank after a figure is a zero', 'and a blank behind it')
        call faulty('-3 0.   -10.    .114    0.      -7.1    50.     -4.     .0523   5.', &
            'remark 3:1-8 X1 is read as -300.: a blank after a figure is a zero', &
            'or a blank within')
        call faultless('-30.    -10.    .114       0    -7.1    50.     -4.     .0523   5.', &
            'a zero is a zero wherever it stands')
    end subroutine check_implied

    !> Fields that are no numbers: each has its own fault, and nothing else is said of the card.
    subroutine check_numbers()
        type(conic_card_type) :: card
        type(fault_list_type) :: faults

        call faulty('-30.    -1O.    .114    0.      -7.1    50.     -4.     .0523   5.', &
            'error 3:11-11 Y1: the letter O in a number; the figure is 0', 'a letter for a figure')
        call faulty('-3O.    -1,5    .1.4    0E      - .     50-2-3  -4.'//achar(7)// &
            '    .0523   /.    /     /', &
            'error 3:3-3 X1: the letter O in a number; the figure is 0'//feed// &
            'error 3:11-11 Y1: a comma in a number; the point is a full stop and fields go by '// &
            'columns'//feed// &
            'error 3:19-19 S1: a second point in the number'//feed// &
            'error 3:26-26 X2: the exponent has no figures'//feed// &
            'error 3:33-35 Y2: there is no figure in the number'//feed// &
            'error 3:45-45 X3: a sign inside the number'//feed// &
            'error 3:52-52 Y3: byte 07 (hexadecimal) in a number; only plain ASCII figures, '// &
            'signs '// &
            'and points are read'//feed//'error 3:65-65 XI: '//slash//feed// &
            'error 3:71-71 YI: '//slash//feed// &
            'error 3:77-77 ITYP: '//slash, &
            'ten fields at fault are ten faults, each in its columns')
        call faulty('-30.    -10.    .114    0.      -7.1    50.     -4.     .0523   '// &
            '5.          1.', &
            'error 3:78-78 ITYP: a point in a whole number', 'a point in ITYP')
        call read_card('-3O.    -10.    .114    0.      -7.1    -3O.    -10.    .0523', card, &
            faults)
        call tap%ok(.not. card%is_readable .and. .not. card%is_sound, &
            'a card with a bad number is not readable')
        call tap%same(places(faults), 'error 3:3-3, error 3:43-43', &
            'points and increments are not compared on it')
        call tap%same(faults%item(2)%card, &
            '-3O.    -10.    .114    0.      -7.1    -3O.    -10.    .0523', &
            'every fault shows the card')
    end subroutine check_numbers

    !> Tabs and text beyond the card.
    subroutine check_columns()
        character(*), parameter :: beyond = &
            ' text beyond column 80; XI stands in columns 65-70, YI in 71-76, ITYP in 77-78, '// &
            'and 79-80 are free'
        type(conic_card_type) :: card
        type(fault_list_type) :: faults

        call faulty('-30.'//achar(9)//'-10.'//achar(9)//'.114', &
            'error 3:5-5 a tab on a card; fields go by columns, so put blanks in its place', &
            'a tab is one fault, at the first of them')
        call read_card('-30.'//achar(9)//'-10.', card, faults)
        call tap%ok(.not. card%is_readable .and. .not. card%is_sound, &
            'a card with a tab is not read')
        call faulty(contour//'001', 'error 3:81-81'//beyond, 'a third column of a sequence number')
        call faulty(contour//'  SEE NOTE   ', 'error 3:81-88'//beyond, &
            'text beyond ends where it ends')
        call faulty(contour//repeat(' ', 5000)//'X', 'error 3:81-5079'//beyond, 'however far it is')
        call faulty(contour//repeat('X', 99922), 'error 3:81-100000'//beyond, &
            'a card of 100000 characters')
        call read_card(contour//'00001', card, faults)
        call tap%ok(card%is_readable .and. .not. card%is_sound, &
            'a card that is too long can be read')
    end subroutine check_columns

    !> Points that are one.
    subroutine check_points()
        character(*), parameter :: words = ' coincide; three different points fix a conic'
        type(conic_card_type) :: card
        type(fault_list_type) :: faults

        call faulty('-30.    -10.    .114    -30.    -10.000 50.     -4.     .0523   5.', &
            'error 3:25-40 points 1 and 2'//words, 'points 1 and 2, punched differently')
        call faulty('-30.    -10.    .114    0.      -7.1    -30.    -10.    .0523   5.', &
            'error 3:41-56 points 1 and 3'//words, 'points 1 and 3')
        call faulty('-30.    -10.    .114    50.     -4.     50.     -4.     .0523   5.', &
            'error 3:41-56 points 2 and 3'//words, 'points 2 and 3')
        call faulty('1.      0.              1.      -0.     1.                      5.', &
            'error 3:25-40 points 1 and 2'//words//feed//'error 3:41-56 points 1 and 3'//words// &
            feed// &
            'error 3:41-56 points 2 and 3'//words, 'all three, with a zero of either sign or blank')
        call faultless('-30.    -10.    .114    -30.    -7.1    50.     -7.1    .0523   5.', &
            'points that share one ordinate are two')
        call faultless('-30.    -10.    .114    -30.001 -10.    50.     -7.1    .0523   5.', &
            'points a thousandth apart are two')
        call read_card('-30.    -10.    .114    -30.    -10.    50.     -4.     .0523   5.', &
            card, faults)
        call tap%ok(card%is_readable .and. .not. card%is_sound .and. card%has_coinciding_points(), &
            'such a card is readable, not sound, and says so')
    end subroutine check_points

    !> Increments that are zero or go the wrong way.
    subroutine check_increments()
        character(*), parameter :: no_xi = &
            'error 3:65-70 XI is zero where a table is asked for; punch an increment, or ITYP '// &
            'and YI for a Y '// &
            'table alone'
        character(*), &
            parameter :: down = '50.     -4.     .0523   0.      -7.1    -30.    -10.    .114    '

        call faulty(book(:64), no_xi, 'a card that asks for no table')
        call faulty(book(:64)//'.000', no_xi, 'a zero is as good as a blank')
        call faulty(book(:64)//'-5.', &
            'error 3:65-70 XI has the wrong sign; from -30. to 50. it is positive', &
            'XI down on the way up')
        call faulty(down//'5.', &
            'error 3:65-70 XI has the wrong sign; from 50. to -30. it is negative', &
            'XI up on the way down')
        call faultless(down//'-5.', 'XI down on the way down')
        call faulty(book(:64)//'5.           1', &
            'error 3:71-76 YI is zero where a table is asked for; punch an increment', &
            'ITYP without YI')
        call faulty(book(:64)//'5.    -.5    1', &
            'error 3:71-76 YI has the wrong sign; from -10. to -4. it is positive', &
            'YI of the wrong sign')
        call faulty(book(:64)//'-5.   -.5    1', &
            'error 3:65-70 XI has the wrong sign; from -30. to 50. '// &
            'it is positive'//feed// &
            'error 3:71-76 YI has the wrong sign; from -10. to -4. it is positive', &
            'both of the wrong sign')
        call faultless('0.      -10.    0.      5.      0.      0.      10.     0.      1.', &
            'between equal ordinates XI may go up')
        call faultless('0.      -10.    0.      5.      0.      0.      10.     0.      -1.', &
            'or down')
        call faultless('-30.    -10.    .114    0.      -7.1    50.     -4.     .0523   200.', &
            'XI may be longer than the way')
    end subroutine check_increments

    !> Numbers of any size are compared without a trap.
    subroutine check_extremes()
        call faulty('  -9.E80-10.    .114    0.      -7.1       9.E80-4.     .0523   -9.E80', &
            'error 3:65-70 XI has the wrong sign; from -9.E+80 to 9.E+80 it is positive', &
            'huge numbers')
        call faultless(' -1.E-80-10.    .114    0.      -7.1      1.E-80-4.     .0523   1.E-80', &
            'tiny numbers are not zero')
        call faulty('   1.E81-10.    .114    0.      -7.1    50.     -4.     .0523   5.', &
            'error 3:4-8 X1: the number is out of range', 'a number out of range')
        call faulty('1.E8    -10.    .114    0.      -7.1    50.     -4.     .0523   5.', &
            'error 3:1-4 X1: the number is out of range; a blank behind its exponent is a zero', &
            'an exponent that is not at the end of its field')
    end subroutine check_extremes

    !> The card that ends a deck.
    subroutine check_end()
        call tap%ok(ends('999.99') .and. ends(' 999.999') .and. ends('1000.') &
            .and. ends('9.9999E2') &
            .and. ends('  999990'), 'an X1 of 999.99 or more ends the deck')
        call tap%ok(ends('50'), 'so does 50 in columns 1-2, which is 50000.000')
        call tap%ok(.not. any([ends('999.989'), ends('-999.99'), ends(''), ends('999.9O'), &
            ends('   99999'), &
            ends('        999.99')]), 'a smaller one does not, nor a slip, nor another field')
    end subroutine check_end

    !> A card without fault.
    subroutine faultless(text, name)
        character(*), intent(in) :: text !! the card
        character(*), intent(in) :: name !! the check as a phrase
        type(conic_card_type) :: card
        type(fault_list_type) :: faults
        call read_card(text, card, faults)
        call tap%same(said(faults), '', name)
        call tap%ok(card%is_readable .and. card%is_sound, name//': sound')
    end subroutine faultless

    !> A card with faults. Remarks leave it sound.
    subroutine faulty(text, expected, name)
        character(*), intent(in) :: text     !! the card
        character(*), intent(in) :: expected !! its faults
        character(*), intent(in) :: name     !! the check as a phrase
        type(conic_card_type) :: card
        type(fault_list_type) :: faults
        call faults%add(new_fault(severity%error, 0, 0, 'of another card'))
        call read_card(text, card, faults)
        call tap%same(said(faults), 'error 0:0-0 of another card'//feed//expected, name)
        call tap%ok(card%is_sound .eqv. index(expected, 'error') == 0, name//': sound or not')
    end subroutine faulty

    !> Reads a card as the third line of a file.
    subroutine read_card(text, card, faults)
        character(*), intent(in) :: text                !! the card
        type(conic_card_type), intent(out) :: card      !! what it says
        type(fault_list_type), intent(inout) :: faults  !! its faults are added
        call read_conic_card(line_of(text), card, faults)
    end subroutine read_card

    !> True where a card ends the deck.
    logical function ends(text)
        character(*), intent(in) :: text !! the card
        ends = ends_deck(line_of(text))
    end function ends

    !> A card as the third line of a file.
    function line_of(text) result(line)
        character(*), intent(in) :: text !! the card
        type(line_type) :: line
        type(source_type) :: source
        type(error_type), allocatable :: error
        logical :: found
        integer :: i
        call source%from_text(feed//feed//text//feed)
        do i = 1, 3
            call source%next_line(line, found, error)
        end do
    end function line_of

end program test_conic_card
