!> The cards of a deck of words, one after the other: lines are read on until a card can't be
!> continued any more. Headings, comments and what follows the END card are dealt with here.
module deck_body_stream
    use base_error, only: error_type
    use base_fault, only: fault_list_type, fault_type, new_fault, severity
    use base_kinds, only: i64
    use base_text, only: counted, to_text
    use deck_body_card, only: card_type, continue_card, free_columns, is_continuation, new_card
    use deck_control_card, only: begins_with_word, card_word, control_bytes, heading_type, &
        read_heading_card
    use deck_layout, only: card_columns
    use deck_source, only: line_type, source_type
    implicit none (type, external)
    private

    public :: stream_type, sort_by_line

    !> What `next_card` met.
    type, public :: met_list
        integer :: card = 1     !! a card with its continuations
        integer :: refused = 2  !! a card that can't be read
        integer :: finished = 3 !! the end of the deck
    end type met_list
    !> The same by name: `met%card`.
    type(met_list), parameter, public :: met = met_list()

    !> A deck being read.
    type :: stream_type
        type(heading_type) :: heading       !! what TITLE and UNITS said
        logical :: has_ended = .false.      !! the END card was met
        logical, private :: is_refused = .false. !! so was the last card, and its continuations are
        logical, private :: is_binary = .false.  !! a null byte was met; nothing more is read
        integer(i64), private :: end_line = 0    !! where END stands
        integer(i64), private :: after_end = 0   !! cards behind it
    contains
        procedure :: next_card
    end type stream_type

contains

    !> Reads the next card.
    !>
    !> Fails with `cause%file_trouble` where the source can't be read.
    subroutine next_card(stream, source, card, outcome, faults, error)
        class(stream_type), intent(inout) :: stream         !! the deck
        type(source_type), intent(inout) :: source          !! where its lines come from
        type(card_type), intent(out) :: card                !! the card, where there is one
        integer, intent(out) :: outcome                     !! one of `met%...`
        type(fault_list_type), intent(inout) :: faults      !! what is wrong is added
        type(error_type), allocatable, intent(out) :: error !! see above
        type(line_type) :: line
        logical :: has_line, has_card

        has_card = .false.
        outcome = met%finished
        do while (.not. stream%is_binary .and. outcome == met%finished)
            call source%next_line(line, has_line, error)
            if (allocated(error)) return
            if (.not. has_line) exit
            if (line%has_null) then
                call refuse_binary(stream, line, faults)
            else if (line%filled == 0) then
                cycle
            else if (line%text(1:1) == '*') then
                cycle
            else if (stream%has_ended .and. .not. has_card) then
                stream%after_end = stream%after_end + 1
            else if (is_continuation(line)) then
                call take_continuation(stream, line, card, has_card, outcome, faults)
            else if (has_card) then
                call source%put_back(line)
                outcome = met%card
            else
                call begin_card(stream, line, card, has_card, outcome, faults)
            end if
        end do
        if (outcome /= met%finished) return
        if (has_card) then
            outcome = met%card
        else if (stream%after_end > 0) then
            call add_fault(severity%warning, 0, &
                counted(stream%after_end, 'card')//' after the END card not read', &
                line_type(text='', number=stream%end_line), faults)
        end if
    end subroutine next_card

    !> A line that no text file has.
    subroutine refuse_binary(stream, line, faults)
        class(stream_type), intent(inout) :: stream     !! the deck
        type(line_type), intent(in) :: line             !! the line
        type(fault_list_type), intent(inout) :: faults  !! gets the fault
        stream%is_binary = .true.
        call add_fault(severity%error, max(1, index(line%text, achar(0))), &
            'a null byte: this is a binary file, not a deck of cards; nothing more of it is read', &
            line_type(text='', number=line%number), faults)
    end subroutine refuse_binary

    !> Takes a line that begins a card.
    subroutine begin_card(stream, line, card, has_card, outcome, faults)
        class(stream_type), intent(inout) :: stream     !! the deck
        type(line_type), intent(in) :: line             !! the line
        type(card_type), intent(inout) :: card          !! the card it is
        logical, intent(inout) :: has_card              !! there is one now
        integer, intent(inout) :: outcome               !! it is refused
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(:), allocatable :: word

        word = ''
        if (begins_with_word(line)) word = card_word(line)
        stream%is_refused = .false.
        if (word == 'TITLE' .or. word == 'UNITS') then
            call read_heading_card(line, stream%heading, faults)
        else if (has_sound_columns(line, faults)) then
            has_card = .true.
            card = new_card(line)
        else
            stream%is_refused = .true.
            outcome = met%refused
        end if
        if (word /= 'END') return
        stream%has_ended = .true.
        stream%end_line = line%number
    end subroutine begin_card

    !> Takes a line that continues a card.
    subroutine take_continuation(stream, line, card, has_card, outcome, faults)
        class(stream_type), intent(inout) :: stream     !! the deck
        type(line_type), intent(in) :: line             !! the line
        type(card_type), intent(inout) :: card          !! the card before it
        logical, intent(inout) :: has_card              !! there is one
        integer, intent(inout) :: outcome               !! the whole card is refused
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        if (.not. has_sound_columns(line, faults)) then
            has_card = .false.
            stream%is_refused = .true.
            outcome = met%refused
        else if (has_card) then
            call continue_card(card, line)
        else if (.not. stream%is_refused) then
            call add_fault(severity%error, 1, 'a continuation without a card before it', line, &
                faults)
        end if
    end subroutine take_continuation

    !> Faults of a line as a row of columns: tabs, control bytes, too many columns.
    logical function has_sound_columns(line, faults) result(is_sound)
        type(line_type), intent(in) :: line             !! the line
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: bad, room

        bad = scan(line%text, control_bytes())
        if (bad > 0) call add_fault(severity%error, bad, &
            'a tab or control byte on a card; put blanks in its place', line, faults)
        room = merge(free_columns, card_columns, index(line%text, ',') > 0)
        is_sound = bad == 0 .and. line%filled <= room
        if (line%filled <= room) return
        call add_fault(severity%error, room + 1, 'text beyond column '//to_text(room)// &
            '; a card has 80 columns, with commas 132; a card with + in column 1 continues it', &
            line, faults)
        associate (fault => faults%item(faults%count))
            fault%last = line%filled
        end associate
    end function has_sound_columns

    !> Adds a fault in one column of a line.
    subroutine add_fault(grade, column, message, line, faults)
        integer, intent(in) :: grade                    !! one of `severity%...`
        integer, intent(in) :: column                   !! the column; 0: the whole line
        character(*), intent(in) :: message             !! what is wrong
        type(line_type), intent(in) :: line             !! the line
        type(fault_list_type), intent(inout) :: faults  !! gets the fault
        integer :: before
        before = faults%count
        call faults%add(new_fault(grade, column, column, message))
        call faults%place(before, line%number, line%text)
    end subroutine add_fault

    !> Puts faults in the order of their lines; those of one line stay as they are, those of the
    !> whole deck come last.
    subroutine sort_by_line(faults, first)
        type(fault_list_type), intent(inout) :: faults  !! the faults
        integer, intent(in) :: first                    !! the first to sort
        type(fault_type) :: fault
        integer :: i, j

        do i = first + 1, faults%count
            if (.not. comes_before(faults%item(i), faults%item(i - 1))) cycle
            fault = faults%item(i)
            do j = i - 1, first, -1
                if (.not. comes_before(fault, faults%item(j))) exit
                faults%item(j + 1) = faults%item(j)
            end do
            faults%item(j + 1) = fault
        end do
    end subroutine sort_by_line

    !> True where one fault stands on an earlier line than another.
    pure logical function comes_before(a, b)
        type(fault_type), intent(in) :: a !! a fault
        type(fault_type), intent(in) :: b !! another
        comes_before = a%line > 0 .and. (b%line == 0 .or. a%line < b%line)
    end function comes_before

end module deck_body_stream
