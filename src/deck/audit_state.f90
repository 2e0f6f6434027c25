!> Tables being read, card by card, from a deck or from a file of comma-separated values.
module deck_audit_state
    use base_fault, only: fault_list_type
    use deck_audit, only: add_table, audit_deck_type, audit_table_type, audit_view, entry_kind
    use deck_audit_entry, only: lacks_point, take_between, take_known, take_printing, take_rows
    use deck_audit_layout, only: audit_card, audit_fields_of, audit_layout, view_words
    use deck_body_card, only: blame, blame_span, card_type, field_text, warn
    use deck_body_check, only: check_against
    use deck_body_crowd, only: blame_crowded
    use deck_body_value, only: is_filled, real_in, whole_in
    use deck_body_word, only: begins_as_word, crowded_word, in_words, nearest_word, place_of, &
        suggestion, words_in
    implicit none (type, external)
    private

    public :: state_type, take_card, take_as, close_table

    !> Conics that a chain may have.
    integer, parameter :: most_conics = 9

    !> The tables so far.
    type :: state_type
        type(audit_deck_type) :: deck           !! tables that are whole
        type(audit_table_type) :: table         !! the one being read
        type(card_type) :: card                 !! its AUDIT card
        logical :: is_open = .false.            !! there is one
        logical :: is_sound = .true.            !! its AUDIT card is
        logical :: is_along_y = .false.         !! what ALONG said last
        integer :: column = 1                   !! and its column
    end type state_type

contains

    !> Takes a card with its continuations.
    pure subroutine take_card(state, card, faults)
        type(state_type), intent(inout) :: state        !! the tables so far
        type(card_type), intent(in) :: card             !! the card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(:), allocatable :: word
        integer :: kind

        word = field_text(card, 1)
        kind = audit_card%row
        if (begins_as_word(word)) kind = place_of(word, audit_layout%word)
        if (kind == 0) then
            call blame_word(state, card, word, faults)
        else if (kind /= audit_card%end) then
            call take_as(state, card, kind, faults)
        end if
    end subroutine take_card

    !> Takes a card of a kind that is known.
    pure subroutine take_as(state, card, kind, faults)
        type(state_type), intent(inout) :: state        !! the tables so far
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: kind                     !! one of `audit_card%...`, not the last
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: before
        logical :: is_sound

        before = faults%count
        call check_against(card, audit_layout(kind), audit_fields_of(kind), faults)
        is_sound = .not. faults%has_errors(before)
        if (kind == audit_card%audit) then
            call close_table(state, faults)
            call open_table(state, card, is_sound, faults)
        else if (.not. state%is_open) then
            call blame(card, 1, 'a card outside a table; an AUDIT card comes first', faults)
        else if (is_sound) then
            call take_sound(state, card, kind, faults)
        end if
    end subroutine take_as

    !> Says that a word begins no card. Where it was meant to be an AUDIT card, the rows that follow
    !> are of its table.
    pure subroutine blame_word(state, card, word, faults)
        type(state_type), intent(inout) :: state        !! the tables so far
        type(card_type), intent(in) :: card             !! the card
        character(*), intent(in) :: word                !! its first field
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        character(len(audit_layout%word)) :: meant

        meant = crowded_word(word, audit_layout%word)
        if (meant /= '') then
            call blame_crowded(card, faults)
        else
            call blame(card, 1, word//' is no card of a deck of printed tables, '// &
                'which are '//in_words(pack(audit_layout%word, audit_layout%word /= ''))// &
                suggestion(word, audit_layout%word), faults)
            meant = nearest_word(word, audit_layout%word)
        end if
        if (meant /= audit_layout(audit_card%audit)%word) return
        call close_table(state, faults)
        call open_table(state, card, .false., faults)
    end subroutine blame_word

    !> Begins a table.
    pure subroutine open_table(state, card, is_sound, faults)
        type(state_type), intent(inout) :: state        !! gets it
        type(card_type), intent(in) :: card             !! an AUDIT card
        logical, intent(in) :: is_sound                 !! its fields are
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: i
        logical :: needs_at

        state%table = audit_table_type()
        state%card = card
        state%is_open = .true.
        state%is_sound = is_sound
        state%is_along_y = .false.
        state%column = 1
        if (.not. is_sound) return
        associate (table => state%table)
            table%line = card%sheet(1)%line
            table%name = field_text(card, 2)
            table%view = place_of(field_text(card, 3), words_in(view_words))
            needs_at = table%view >= audit_view%station
            if (needs_at .neqv. is_filled(card, 4)) then
                call blame(card, 4, 'AT is where a STATION, BUTTOCK or WATERLN is; '// &
                    'SIDE and PLAN have none', faults)
                state%is_sound = .false.
            end if
            table%at = real_in(card, 4)
            table%at_text = field_text(card, 4)
            do i = 1, 3
                table%control(i) = field_text(card, 4 + i)
            end do
            if (table%view /= audit_view%station .and. any(table%control /= '')) &
                call blame_span(card, 5, 7, 'only a STATION has lines of its points', faults)
        end associate
    end subroutine open_table

    !> Takes a card of a table, which is sound.
    pure subroutine take_sound(state, card, kind, faults)
        type(state_type), intent(inout) :: state        !! the tables so far
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: kind                     !! one of `audit_card%...`
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        select case (kind)
        case (audit_card%printed)
            call take_printing(state%table, card, faults)
        case (audit_card%conics)
            state%table%conics = whole_in(card, 2)
            if (state%table%conics < 1 .or. state%table%conics > most_conics) then
                call blame(card, 2, 'a chain has 1 to 9 conics', faults)
                state%table%conics = 1
            end if
        case (audit_card%shift)
            state%table%shift = real_in(card, 2)
        case (audit_card%exact)
            call take_known(state%table, card, entry_kind%exact, faults)
        case (audit_card%about)
            call take_known(state%table, card, entry_kind%about, faults)
        case (audit_card%between)
            call take_between(state%table, card, faults)
        case (audit_card%along)
            state%is_along_y = field_text(card, 2) == 'Y'
            state%column = 1
            if (is_filled(card, 3)) state%column = whole_in(card, 3)
            if (state%column == 1 .or. state%column == 2) return
            call blame(card, 3, 'COLUMN is 1 or 2', faults)
            state%column = 1
        case default
            call take_rows(state%table, card, state%is_along_y, state%column, faults)
        end select
    end subroutine take_sound

    !> Ends the table being read.
    pure subroutine close_table(state, faults)
        type(state_type), intent(inout) :: state        !! the tables so far
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: i, before

        if (.not. state%is_open) return
        state%is_open = .false.
        if (.not. state%is_sound) return
        before = faults%count
        do i = 1, 3
            if (lacks_point(state%table, i)) call blame(state%card, 2, 'table '// &
                trim(state%table%name)//': what is known of a point needs its X on an EXACT card', &
                faults)
        end do
        if (.not. allocated(state%table%entry)) allocate (state%table%entry(0))
        if (.not. any(state%table%entry(:state%table%count)%kind == entry_kind%row)) call warn( &
            state%card, 2, 'table '//trim(state%table%name)//' has no rows', faults)
        if (.not. faults%has_errors(before)) call add_table(state%deck, state%table)
    end subroutine close_table

end module deck_audit_state
