!> `loft check`: reads decks, prints every diagnostic, and nothing else.
module app_check
    use app_files, only: deck_file_type
    use app_options, only: argument_type
    use app_status, only: status
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_output, only: output_type
    use body_card_arc, only: arc_of_card
    use body_card_tables, only: card_table_type, tables_of_card
    use deck_conic_card, only: conic_card_type
    use deck_conic_deck, only: conic_deck_type, found
    use deck_source, only: source_type
    use geom_arc, only: arc_type
    use report_fault, only: print_faults
    implicit none (type, external)
    private

    public :: check_decks

contains

    !> Checks decks one after the other. A deck that can't be read does not keep the others from
    !> being checked; the exit status is the gravest met.
    subroutine check_decks(decks, exit_status, messages)
        type(argument_type), intent(in) :: decks(:)  !! names; `-` is standard input
        integer, intent(out) :: exit_status          !! one of `status%...`
        type(output_type), intent(inout) :: messages !! diagnostics
        type(error_type), allocatable :: error
        logical :: is_faulty
        integer :: i

        exit_status = status%done
        do i = 1, size(decks)
            call check_deck(decks(i)%text, is_faulty, messages, error)
            if (is_faulty) exit_status = max(exit_status, status%faulty)
            if (.not. allocated(error)) cycle
            exit_status = status%unusable
            call messages%line('loft: '//error%message)
        end do
    end subroutine check_decks

    !> Checks one deck.
    !>
    !> Fails with `cause%file_trouble` where it can't be read.
    subroutine check_deck(name, is_faulty, messages, error)
        character(*), intent(in) :: name                    !! of the deck
        logical, intent(out) :: is_faulty                   !! an error was found in it
        type(output_type), intent(inout) :: messages        !! diagnostics
        type(error_type), allocatable, intent(out) :: error !! see above
        type(deck_file_type) :: file
        type(source_type) :: source
        type(conic_deck_type) :: deck
        type(conic_card_type) :: card
        type(fault_list_type) :: faults
        type(error_type), allocatable :: ignored
        integer :: outcome

        is_faulty = .false.
        call file%open(name, source, error)
        if (allocated(error)) return
        do
            call deck%next(source, card, outcome, faults, error)
            if (allocated(error)) then
                error%message = name//': '//error%message
                exit
            end if
            if (outcome == found%conic) call check_conic(card, faults)
            call print_faults(faults, name, .true., messages)
            call messages%flush(ignored)
            is_faulty = is_faulty .or. faults%has_errors(0)
            call faults%clear()
            if (outcome == found%finished) exit
        end do
        call file%close()
    end subroutine check_deck

    !> Looks whether a card would run.
    subroutine check_conic(card, faults)
        type(conic_card_type), intent(in) :: card       !! the card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(card_table_type), allocatable :: tables(:)
        type(arc_type) :: arc
        logical :: has_arc

        if (.not. card%is_readable .or. card%has_coinciding_points()) return
        call arc_of_card(card, arc, has_arc, faults)
        if (has_arc) call tables_of_card(card, arc, tables, faults)
    end subroutine check_conic

end module app_check
