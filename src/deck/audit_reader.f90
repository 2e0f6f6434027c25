!> A deck of printed tables, read. All faults of the deck are collected, each on its card; a card in
!> error is left out and the others stay.
module deck_audit_reader
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use deck_audit, only: audit_deck_type
    use deck_audit_state, only: close_table, state_type, take_card
    use deck_body_card, only: card_type
    use deck_body_stream, only: met, sort_by_line, stream_type
    use deck_control_card, only: heading_type
    use deck_source, only: source_type
    implicit none (type, external)
    private

    public :: read_audit

contains

    !> Reads a deck of printed tables to its end.
    !>
    !> Fails with `cause%file_trouble` where the source can't be read.
    subroutine read_audit(source, heading, deck, faults, error)
        type(source_type), intent(inout) :: source          !! where the lines come from
        type(heading_type), intent(in) :: heading           !! what `read_opening` found
        type(audit_deck_type), intent(out) :: deck          !! the tables
        type(fault_list_type), intent(inout) :: faults      !! what is wrong is added, in deck order
        type(error_type), allocatable, intent(out) :: error !! see above
        type(stream_type) :: stream
        type(state_type) :: state
        type(card_type) :: card
        integer :: before, outcome

        before = faults%count
        stream%heading = heading
        do
            call stream%next_card(source, card, outcome, faults, error)
            if (allocated(error)) return
            if (outcome == met%finished) exit
            if (outcome == met%card) call take_card(state, card, faults)
        end do
        call close_table(state, faults)
        deck = state%deck
        deck%title = ''
        deck%units = 'INCHES'
        if (allocated(stream%heading%title)) deck%title = stream%heading%title
        if (allocated(stream%heading%units)) deck%units = stream%heading%units
        call sort_by_line(faults, before + 1)
    end subroutine read_audit

end module deck_audit_reader
