!> A 1970 deck, card by card: TITLE and UNITS, then conic cards until X1 is 999.99 or more or the
!> file ends. Nothing but the present card is held. Comments (`*` in column 1) and blank cards are
!> passed over; the comment right before a conic card names it.
!>
!> The first card that is not blank, a comment, TITLE or UNITS decides what the deck is: a word in
!> its first columns makes it a body deck, which is not read here.
module deck_conic_deck
    use base_error, only: error_type
    use base_fault, only: fault_list_type, new_fault, severity
    use base_kinds, only: i64
    use base_text, only: columns, counted
    use deck_conic_card, only: conic_card_type, ends_deck, read_conic_card
    use deck_control_card, only: begins_with_word, card_word, heading_type, read_heading_card
    use deck_layout, only: last_read_column
    use deck_source, only: line_type, source_type
    implicit none (type, external)
    private

    public :: conic_deck_type, card_image_type, read_image

    !> What the next card turned out to be.
    type, public :: found_list
        integer :: conic = 1    !! a conic card, sound or not
        integer :: finished = 2 !! the deck is at its end
    end type found_list

    !> The outcomes by name: `found%conic`.
    type(found_list), parameter, public :: found = found_list()

    !> A conic card as it was found, its fields not read.
    type :: card_image_type
        type(line_type) :: line                 !! the line of the deck
        integer(i64) :: count = 0               !! which conic card of the deck, from 1
        character(:), allocatable :: label      !! the comment right before it, or nothing
    end type card_image_type

    !> A deck being read.
    type :: conic_deck_type
        type(heading_type) :: heading           !! what TITLE and UNITS said
        integer(i64) :: cards = 0               !! conic cards met, bad ones too
        logical :: is_binary = .false.          !! a null byte was met; the rest is not read
        logical, private :: has_ended = .false. !! the end card has been met
        integer(i64), private :: after_end = 0  !! cards behind it
        integer(i64), private :: end_line = 0   !! where the end card stands
        character(:), allocatable, private :: comment !! the last comment, if nothing came since
    contains
        procedure :: next => next_conic
        procedure :: next_image
    end type conic_deck_type

contains

    !> Reads on to the next conic card or to the end of the deck. Faults met on the way are added
    !> to the list with their line and card.
    !>
    !> Fails with `cause%file_trouble` where the source can't be read.
    subroutine next_conic(deck, source, card, outcome, faults, error)
        class(conic_deck_type), intent(inout) :: deck       !! the deck
        type(source_type), intent(inout) :: source          !! where its lines come from
        type(conic_card_type), intent(out) :: card          !! the card, where one was found
        integer, intent(out) :: outcome                     !! one of `found%...`
        type(fault_list_type), intent(inout) :: faults      !! what is wrong is added
        type(error_type), allocatable, intent(out) :: error !! see above
        type(card_image_type) :: image

        call deck%next_image(source, image, outcome, faults, error)
        if (.not. allocated(error) .and. outcome == found%conic) then
            call read_image(image, card, faults)
        end if
    end subroutine next_conic

    !> Reads a conic card that has been found.
    subroutine read_image(image, card, faults)
        type(card_image_type), intent(in) :: image      !! from `next_image`
        type(conic_card_type), intent(out) :: card      !! what it says
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        card%count = image%count
        card%label = image%label
        call read_conic_card(image%line, card, faults)
    end subroutine read_image

    !> Finds the next conic card without reading its fields, or the end of the deck; else as `next`.
    subroutine next_image(deck, source, image, outcome, faults, error)
        class(conic_deck_type), intent(inout) :: deck       !! the deck
        type(source_type), intent(inout) :: source          !! where its lines come from
        type(card_image_type), intent(inout) :: image       !! the card, where one was found
        integer, intent(out) :: outcome                     !! one of `found%...`
        type(fault_list_type), intent(inout) :: faults      !! what is wrong is added
        type(error_type), allocatable, intent(out) :: error !! see above
        logical :: has_line

        outcome = found%finished
        do while (.not. deck%is_binary)
            call source%next_line(image%line, has_line, error)
            if (allocated(error)) return
            if (.not. has_line) exit
            call take_line(deck, image%line, outcome, faults)
            if (outcome == found%finished) cycle
            call take_conic(deck, image)
            return
        end do
        call close_deck(deck, faults)
    end subroutine next_image

    !> Takes a line: the outcome is set where it is a conic card, which is left to the caller.
    subroutine take_line(deck, line, outcome, faults)
        class(conic_deck_type), intent(inout) :: deck   !! the deck
        type(line_type), intent(in) :: line             !! the line
        integer, intent(inout) :: outcome               !! one of `found%...`
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        if (line%has_null) then
            call refuse_binary(deck, line, faults)
        else if (line%filled == 0) then
            return
        else if (line%text(1:1) == '*') then
            deck%comment = trim(adjustl(line%text(2:)))
        else if (deck%has_ended) then
            deck%after_end = deck%after_end + 1
        else if (begins_with_word(line)) then
            call take_word(deck, line, faults)
        else if (ends_deck(line)) then
            call take_end(deck, line, faults)
        else
            outcome = found%conic
        end if
    end subroutine take_line

    !> Takes a conic card.
    subroutine take_conic(deck, image)
        class(conic_deck_type), intent(inout) :: deck   !! the deck
        type(card_image_type), intent(inout) :: image   !! has its line; gets number and name

        deck%cards = deck%cards + 1
        image%count = deck%cards
        image%label = ''
        if (allocated(deck%comment)) call move_alloc(deck%comment, image%label)
    end subroutine take_conic

    !> Takes a card with a word in front: a heading card before the first conic, else a fault.
    subroutine take_word(deck, line, faults)
        class(conic_deck_type), intent(inout) :: deck   !! the deck
        type(line_type), intent(in) :: line             !! the line
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(:), allocatable :: word
        integer :: before, first, last

        word = card_word(line)
        first = verify(line%text, ' ')
        last = first + len(word) - 1
        before = faults%count
        if (allocated(deck%comment)) deallocate (deck%comment)
        if (deck%cards > 0) then
            call faults%add(new_fault(severity%error, first, last, word//' in a 1970 deck; only'// &
                ' TITLE and UNITS may stand there, before the first conic card'))
        else if (word == 'TITLE' .or. word == 'UNITS') then
            call read_heading_card(line, deck%heading, faults)
        else
            call faults%add(new_fault(severity%error, first, last, word//' begins no card'// &
                ' of a 1970 deck; a conic card has X1 in columns 1-8, a comment * in column 1'))
        end if
        call faults%place(before, line%number, line%text)
    end subroutine take_word

    !> Takes the end card. What stands on it behind X1 is not used, and that is said.
    subroutine take_end(deck, line, faults)
        class(conic_deck_type), intent(inout) :: deck   !! the deck
        type(line_type), intent(in) :: line             !! the line
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: before

        deck%has_ended = .true.
        deck%end_line = line%number
        before = faults%count
        if (columns(line%text, 9, last_read_column) == '') return
        call faults%add(new_fault(severity%warning, 9, min(last_read_column, len_trim(line%text)), &
            'X1 of 999.99 or more ends a 1970 deck; the rest of this card is not used'))
        call faults%place(before, line%number, line%text)
    end subroutine take_end

    !> A null byte: this is no text, and reading on would only make noise.
    subroutine refuse_binary(deck, line, faults)
        class(conic_deck_type), intent(inout) :: deck   !! the deck
        type(line_type), intent(in) :: line             !! the line
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: before, column

        deck%is_binary = .true.
        before = faults%count
        column = index(line%text, achar(0))
        call faults%add(new_fault(severity%error, column, column, &
            'a null byte: this is a binary file, not a deck of cards; nothing more of it is read'))
        call faults%place(before, line%number, '')
    end subroutine refuse_binary

    !> At the end of the file: says what was not read, or that there was nothing to read.
    subroutine close_deck(deck, faults)
        class(conic_deck_type), intent(inout) :: deck   !! the deck
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: before

        before = faults%count
        if (deck%after_end > 0) then
            call faults%add(new_fault(severity%warning, 0, 0, counted(deck%after_end, 'card')// &
                ' after the end card not read; X1 of 999.99 or more ends a 1970 deck'))
            call faults%place(before, deck%end_line, '')
        end if
        if (deck%cards == 0 .and. .not. deck%is_binary) then
            call faults%add(new_fault(severity%error, 0, 0, &
                'the deck has no conic card; it needs at least one, with X1 in columns 1-8 '// &
                '(see loft help cards)'))
        end if
    end subroutine close_deck

end module deck_conic_deck
