!> The card reference: every card with its columns, printed from the tables the readers use, and the
!> rules of reading. `loft help cards` prints it and `doc/cards.md` contains it.
module report_card_reference
    use base_output, only: output_type
    use base_text, only: right, to_text
    use deck_audit_layout, only: audit_fields_of, audit_layout
    use deck_body_card, only: field_width, fields_across
    use deck_body_fields, only: fields_of, form_words
    use deck_body_layout, only: body_field_type, body_layout, body_layout_type, need, option_words
    use deck_body_word, only: words_in
    use deck_layout, only: conic_fields, field_layout_type, title_fields, units_fields
    implicit none (type, external)
    private

    public :: print_card_reference, print_card

contains

    !> Prints the reference.
    subroutine print_card_reference(out)
        type(output_type), intent(inout) :: out !! where it goes
        integer :: i

        call print_deck_rules(out)
        call print_layout('TITLE', title_fields, out)
        call out%line('')
        call print_layout('UNITS', units_fields, out)
        call out%line('')
        call out%line('THE 1970 DECK')
        call out%line('')
        call print_layout('The conic card of a 1970 deck', conic_fields, out)
        call print_conic_rules(out)
        call out%line('THE BODY DECK')
        call out%line('')
        call print_body_rules(out)
        do i = 1, size(body_layout)
            call out%line('')
            call print_body_layout(body_layout(i), fields_of(i), out)
        end do
        call out%line('')
        call print_options(out)
        call out%line('')
        call print_audit_rules(out)
        do i = 1, size(audit_layout)
            call out%line('')
            call print_body_layout(audit_layout(i), audit_fields_of(i), out)
        end do
    end subroutine print_card_reference

    !> Prints the cards that begin with a word, their options behind them.
    subroutine print_card(word, out, is_card)
        character(*), intent(in) :: word            !! in capitals; CONIC: the card of 1970
        type(output_type), intent(inout) :: out     !! where it goes
        logical, intent(out) :: is_card             !! there is such a card
        integer :: i

        is_card = any(word == [character(5) :: 'CONIC', 'TITLE', 'UNITS'])
        if (word == 'CONIC') call print_layout('The conic card of a 1970 deck', conic_fields, out)
        if (word == 'TITLE') call print_layout('TITLE', title_fields, out)
        if (word == 'UNITS') call print_layout('UNITS', units_fields, out)
        if (is_card .or. word == '') return
        do i = 1, size(body_layout)
            if (body_layout(i)%word == word) call put_card(body_layout(i), fields_of(i))
        end do
        do i = 1, size(audit_layout)
            if (audit_layout(i)%word == word) call put_card(audit_layout(i), audit_fields_of(i))
        end do
    contains
        !> Prints one of them.
        subroutine put_card(layout, field)
            type(body_layout_type), intent(in) :: layout    !! the card
            type(body_field_type), intent(in) :: field(:)   !! its fields
            if (is_card) call out%line('')
            is_card = .true.
            call print_body_layout(layout, field, out)
            call print_option_words(words_in(layout%options), out)
        end subroutine put_card
    end subroutine print_card

    !> Prints how the cards of printed tables are read.
    subroutine print_audit_rules(out)
        type(output_type), intent(inout) :: out !! where it goes
        call out%lines([character(80) :: 'THE DECK OF PRINTED TABLES', '', &
            'It begins with the word AUDIT, is read by loft audit, and its cards have the', &
            'fields of a body deck. In a SIDE view X is STA and Y is WL, in a PLAN view and', &
            'on a WATERLN X is STA and Y is BL, on a BUTTOCK X is STA and Y is WL, at a', &
            'STATION X is BL and Y is WL. A figure is kept as it is printed: its decimals', &
            'count, and ? is a character that can''t be read.'])
    end subroutine print_audit_rules

    !> Prints what holds for decks of both kinds.
    subroutine print_deck_rules(out)
        type(output_type), intent(inout) :: out !! where it goes
        call out%lines([character(80) :: &
            'A card has 80 columns. * in column 1 is a comment; blank cards are passed over.', &
            'The first card that is not blank, a comment, TITLE or UNITS decides: a number', &
            'or nothing in its first field makes a 1970 deck, a word a body deck, the word', &
            'AUDIT a deck of printed tables.', ''])
    end subroutine print_deck_rules

    !> Prints how the conic card of 1970 is read.
    subroutine print_conic_rules(out)
        type(output_type), intent(inout) :: out !! where it goes
        call out%lines([character(80) :: &
            'Columns 79-80 are free for a sequence number.', '', &
            'F fields: a punched point wins; without one the last columns are decimals', &
            '(-30 in F8.3 is -.030). A blank field is zero; a blank behind the first', &
            'figure is a zero. An exponent is E, D or a sign and figures: 1.5E2, 15.+1.', '', &
            'A comment right before a conic card names the card. TITLE and UNITS stand', &
            'before the first conic card. X1 of 999.99 or more, or the end of the file,', &
            'ends the deck.', ''])
    end subroutine print_conic_rules

    !> Prints how the cards of a body deck are read.
    subroutine print_body_rules(out)
        type(output_type), intent(inout) :: out !! where it goes
        call out%lines([character(80) :: &
            'A card has ten fields of eight columns; field 1 is columns 1-8. A card with a', &
            'comma in it has the same fields in the same order between commas, and up to', &
            '132 columns. A card with + alone in field 1 continues the one before: its', &
            'field 2 follows the last field of that one (field 11 where it went by columns).', '', &
            'A number is what it reads as: -30 is -30. A blank field is nothing, not zero.', &
            'A name has up to 8 letters, figures and signs - _ . / and begins with a letter;', &
            'capitals or not is the same. A name is used after the card that gives it.', &
            'Fields in brackets may be left blank.'])
    end subroutine print_body_rules

    !> Prints the columns of one card of either kind of deck.
    subroutine print_layout(name, fields, out)
        character(*), intent(in) :: name                 !! what the card is called
        type(field_layout_type), intent(in) :: fields(:) !! its fields
        type(output_type), intent(inout) :: out          !! where it goes
        integer :: i

        call out%line(name)
        call out%line('')
        call out%line('  columns  field  form   unit       meaning')
        do i = 1, size(fields)
            associate (field => fields(i))
                call out%line('  '//right(to_text(field%first)//'-'//to_text(field%last), 7)// &
                    '  '//field%name//'  '//form_text(field)//'  '//field%unit//'  '// &
                    trim(field%meaning))
            end associate
        end do
    end subroutine print_layout

    !> The FORTRAN format of a field in five columns: `F8.3`, `I2`, `A8`.
    pure function form_text(field) result(text)
        type(field_layout_type), intent(in) :: field !! the field
        character(5) :: text
        text = field%form//to_text(field%last - field%first + 1)
        if (field%form == 'F') text = trim(text)//'.'//to_text(field%decimals)
    end function form_text

    !> Prints one card of a body deck.
    subroutine print_body_layout(layout, field, out)
        type(body_layout_type), intent(in) :: layout    !! the card
        type(body_field_type), intent(in) :: field(:)   !! its fields
        type(output_type), intent(inout) :: out         !! where it goes
        character(:), allocatable :: name
        integer :: i

        name = trim(layout%word)
        if (name == '') name = '(numbers)'
        if (layout%second /= '') name = name//' '//trim(layout%second)
        call out%line(name//': '//trim(layout%meaning))
        if (size(field) > 0) call out%line('')
        if (size(field) > 0) call out%line( &
            '  field  columns  name      holds     unit       meaning')
        do i = 1, size(field)
            call print_field(field(i), out)
        end do
        if (layout%options /= '') call out%line('  behind  options: '//trim(layout%options))
    end subroutine print_body_layout

    !> Prints one field of a card of a body deck.
    subroutine print_field(field, out)
        type(body_field_type), intent(in) :: field  !! the field
        type(output_type), intent(inout) :: out     !! where it goes
        character(8) :: name, holds
        character(:), allocatable :: text

        name = field%name
        if (field%need == need%optional) name = '['//trim(field%name)//']'
        if (any(field%need == [need%repeated, need%paired])) name = trim(field%name)//'...'
        holds = form_words(field)
        text = '  '//right(to_text(field%field), 5)//'  '//right(columns_text(field%field), 7)// &
            '  '//name//'  '//holds//'  '//field%unit//'  '//trim(field%words)
        if (field%words /= '' .and. field%meaning /= '') text = text//': '
        call out%line(text//trim(field%meaning))
    end subroutine print_field

    !> The columns of a field: `9-16`, or `+9-16` on a continuation.
    pure function columns_text(number) result(text)
        integer, intent(in) :: number !! which field, from 1
        character(7) :: text
        integer :: place

        place = number
        if (number > fields_across) place = number - fields_across + 1
        text = to_text(field_width*(place - 1) + 1)//'-'//to_text(field_width*place)
        if (number > fields_across) text = '+'//text(:6)
    end function columns_text

    !> Prints the option words of data cards.
    subroutine print_options(out)
        type(output_type), intent(inout) :: out !! where it goes
        call out%line('Options of LINE, data cards and PATCH, in any order in the fields behind'// &
            ' the last one')
        call out%line('')
        call print_option_words(option_words%word, out)
    end subroutine print_options

    !> Prints option words with their meanings.
    subroutine print_option_words(word, out)
        character(*), intent(in) :: word(:)     !! some of them
        type(output_type), intent(inout) :: out !! where they go
        integer :: i
        do i = 1, size(option_words)
            if (any(word == option_words(i)%word)) call out%line('  '//option_words(i)%word// &
                '  '//trim(option_words(i)%meaning))
        end do
    end subroutine print_option_words

end module report_card_reference
