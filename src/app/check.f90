!> `loft check`: reads decks, prints every diagnostic, and nothing else.
module app_check
    use api_computed_body, only: computed_body_type, how_type, judge_body
    use api_deck, only: judge_conic
    use app_input, only: close_input, deck_input_type, open_input
    use app_options, only: argument_type
    use app_status, only: status
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_output, only: output_type
    use base_text, only: printable
    use deck_audit, only: audit_deck_type
    use deck_audit_file, only: read_tables
    use deck_conic_card, only: conic_card_type
    use deck_conic_deck, only: conic_deck_type, found
    use deck_job, only: job_type
    use deck_job_reader, only: read_job
    use deck_kind, only: deck_kind_of
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
            call messages%line('loft: '//trim(printable(error%message)))
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
        type(deck_input_type) :: input
        type(audit_deck_type) :: tables
        type(fault_list_type) :: faults

        is_faulty = .false.
        call open_input(name, input, faults, error)
        if (.not. allocated(error)) then
            if (input%opening%kind == deck_kind_of%body) then
                call check_body(input, faults, error)
            else if (input%opening%kind >= deck_kind_of%audit) then
                call read_tables(input%source, input%opening, tables, faults, error)
            else
                call check_conics(input, faults, is_faulty, messages, error)
            end if
            call report(input%name, faults, is_faulty, messages)
            if (allocated(error)) error%message = name//': '//error%message
        end if
        call close_input(input)
    end subroutine check_deck

    !> Checks a 1970 deck, card by card. The faults of its end are left in the list.
    !>
    !> Fails with `cause%file_trouble` where it can't be read.
    subroutine check_conics(input, faults, is_faulty, messages, error)
        type(deck_input_type), intent(inout) :: input       !! the deck, at its first card
        type(fault_list_type), intent(inout) :: faults      !! found so far, not yet printed
        logical, intent(inout) :: is_faulty                 !! an error was found in it
        type(output_type), intent(inout) :: messages        !! diagnostics
        type(error_type), allocatable, intent(out) :: error !! see above
        type(conic_deck_type) :: deck
        type(conic_card_type) :: card
        type(arc_type) :: arc
        logical :: has_arc
        integer :: outcome

        deck%heading = input%opening%heading
        do
            call deck%next(input%source, card, outcome, faults, error)
            if (allocated(error) .or. outcome == found%finished) return
            call judge_conic(card, arc, has_arc, faults)
            call report(input%name, faults, is_faulty, messages)
        end do
    end subroutine check_conics

    !> Checks a body deck: reads it, builds its bodies and makes their cuts.
    !>
    !> Fails with `cause%file_trouble` where it can't be read.
    subroutine check_body(input, faults, error)
        type(deck_input_type), intent(inout) :: input       !! the deck, at its first card
        type(fault_list_type), intent(inout) :: faults      !! what is wrong is added
        type(error_type), allocatable, intent(out) :: error !! see above
        type(job_type) :: job
        type(computed_body_type) :: computed
        integer :: i

        call read_job(input%source, input%opening%heading, job, faults, error)
        if (allocated(error)) return
        do i = 1, size(job%body)
            call judge_body(job, i, computed, faults, how_type(is_shared=.true.))
        end do
    end subroutine check_body

    !> Prints faults and forgets them.
    subroutine report(name, faults, is_faulty, messages)
        character(*), intent(in) :: name                !! of the deck
        type(fault_list_type), intent(inout) :: faults  !! found since the last report
        logical, intent(inout) :: is_faulty             !! an error was found in the deck
        type(output_type), intent(inout) :: messages    !! diagnostics
        type(error_type), allocatable :: ignored
        call print_faults(faults, name, .true., messages)
        call messages%flush(ignored)
        is_faulty = is_faulty .or. faults%has_errors(0)
        call faults%clear()
    end subroutine report

end module app_check
