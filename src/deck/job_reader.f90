!> A body deck, read into a job. All faults of the deck are collected, each on its card; a card in
!> error is left out of the job and the others stay.
module deck_job_reader
    use base_error, only: error_type
    use base_fault, only: fault_list_type, fault_type, new_fault, severity
    use base_kinds, only: i64
    use base_text, only: counted, to_text
    use deck_body_card, only: blame, card_type, continue_card, free_columns, is_continuation, &
        new_card
    use deck_body_layout, only: body_card
    use deck_control_card, only: begins_with_word, card_word, control_bytes, heading_type, &
        read_heading_card
    use deck_job, only: job_type
    use deck_job_deed, only: finish_job, take_card
    use deck_job_state, only: state_type
    use deck_layout, only: card_columns
    use deck_source, only: line_type, source_type
    implicit none (type, external)
    private

    public :: read_job

    !> A deck being read.
    type :: deck_type
        type(state_type) :: state           !! the job so far
        type(heading_type) :: heading       !! what TITLE and UNITS said
        type(card_type) :: card             !! the card that may still be continued
        logical :: has_card = .false.       !! there is one
        logical :: is_refused = .false.     !! the last card can't be read, nor its continuations
        logical :: is_binary = .false.      !! a null byte was met; nothing more is read
        logical :: has_ended = .false.      !! the END card was met
        integer(i64) :: end_line = 0        !! where it stands
        integer(i64) :: after_end = 0       !! cards behind it
    end type deck_type

contains

    !> Reads a body deck to its end.
    !>
    !> Fails with `cause%file_trouble` where the source can't be read.
    subroutine read_job(source, heading, job, faults, error)
        type(source_type), intent(inout) :: source          !! where the lines come from
        type(heading_type), intent(in) :: heading           !! what `read_opening` found
        type(job_type), intent(out) :: job                  !! what the deck asks for
        type(fault_list_type), intent(inout) :: faults      !! what is wrong is added, in deck order
        type(error_type), allocatable, intent(out) :: error !! see above
        type(deck_type) :: deck
        type(line_type) :: line
        logical :: has_line
        integer :: before

        before = faults%count
        deck%heading = heading
        do while (.not. deck%is_binary)
            call source%next_line(line, has_line, error)
            if (allocated(error)) return
            if (.not. has_line) exit
            call take_line(deck, line, faults)
        end do
        call finish_card(deck, faults)
        if (deck%after_end > 0) call add_fault(severity%warning, 0, &
            counted(deck%after_end, 'card')//' after the END card not read', &
            line_type(text='', number=deck%end_line), faults)
        call finish_job(deck%state, deck%heading, faults)
        call sort_by_line(faults, before + 1)
        job = deck%state%job
    end subroutine read_job

    !> Takes one line of the file.
    subroutine take_line(deck, line, faults)
        type(deck_type), intent(inout) :: deck          !! the deck so far
        type(line_type), intent(in) :: line             !! the line
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        if (line%has_null) then
            deck%is_binary = .true.
            call add_fault(severity%error, max(1, index(line%text, achar(0))), &
                'a null byte: this is a binary file, not a deck of cards; nothing more of it '// &
                'is read', &
                line_type(text='', number=line%number), faults)
        else if (line%filled == 0) then
            return
        else if (line%text(1:1) == '*') then
            return
        else if (deck%has_ended) then
            deck%after_end = deck%after_end + 1
        else if (is_continuation(line)) then
            call take_continuation(deck, line, faults)
        else
            call finish_card(deck, faults)
            call begin_card(deck, line, faults)
        end if
    end subroutine take_line

    !> Takes a line that begins a card.
    subroutine begin_card(deck, line, faults)
        type(deck_type), intent(inout) :: deck          !! the deck so far
        type(line_type), intent(in) :: line             !! the line
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(:), allocatable :: word

        word = ''
        if (begins_with_word(line)) word = card_word(line)
        deck%is_refused = .false.
        if (word == 'TITLE' .or. word == 'UNITS') then
            call read_heading_card(line, deck%heading, faults)
        else if (has_sound_columns(line, faults)) then
            deck%has_card = .true.
            deck%card = new_card(line)
        else
            deck%is_refused = .true.
            deck%state%open%is_sound = .false.
        end if
        if (word /= 'END') return
        deck%has_ended = .true.
        deck%end_line = line%number
    end subroutine begin_card

    !> Takes a line that continues a card.
    subroutine take_continuation(deck, line, faults)
        type(deck_type), intent(inout) :: deck          !! the deck so far
        type(line_type), intent(in) :: line             !! the line
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        if (.not. has_sound_columns(line, faults)) then
            deck%has_card = .false.
            deck%is_refused = .true.
            deck%state%open%is_sound = .false.
        else if (deck%has_card) then
            call continue_card(deck%card, line)
        else if (.not. deck%is_refused) then
            call add_fault(severity%error, 1, 'a continuation without a card before it', line, &
                faults)
        end if
    end subroutine take_continuation

    !> Hands on the card that can't be continued any more.
    subroutine finish_card(deck, faults)
        type(deck_type), intent(inout) :: deck          !! the deck so far
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        if (deck%has_card) call take_card(deck%state, deck%card, faults)
        deck%has_card = .false.
    end subroutine finish_card

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

end module deck_job_reader
