!> A 1970 deck run card by card: each card's tables are printed before the next card is read. What
!> is wrong with a card is reported as it is met; the other cards run.
module app_run_conics
    use app_files, only: base_name
    use app_input, only: deck_input_type
    use app_options, only: options_type
    use app_status, only: status
    use base_error, only: cause, error_type
    use base_fault, only: fault_list_type, new_fault, severity
    use base_output, only: output_type
    use body_card_arc, only: arc_of_card
    use body_card_facts, only: card_facts_type, facts_of_card
    use body_card_tables, only: card_table_type, tables_of_card
    use deck_conic_card, only: conic_card_type
    use deck_conic_deck, only: conic_deck_type, found
    use deck_layout, only: conic, conic_fields
    use geom_arc, only: arc_type
    use period_card, only: period_card_type
    use period_printer, only: printer_type
    use period_program, only: run_card
    use report_conic_listing, only: conic_listing_type
    use report_csv, only: print_csv_header, print_csv_table
    use report_fault, only: print_faults
    implicit none (type, external)
    private

    public :: run_conics

    !> A run on its way.
    type :: run_type
        type(options_type) :: options           !! what was asked for
        type(conic_deck_type) :: deck           !! the deck, as far as it is read
        type(conic_listing_type) :: listing     !! the pages of an ieee listing
    end type run_type

contains

    !> Runs the cards of a deck whose beginning has been read. The exit status is `status%done`, or
    !> `status%faulty` where a card was in error.
    !>
    !> Fails with `cause%file_trouble` where the deck can't be read.
    subroutine run_conics(options, input, out, messages, exit_status, error)
        type(options_type), intent(in) :: options           !! mode and format
        type(deck_input_type), intent(inout) :: input       !! the deck, at its first card
        type(output_type), intent(inout) :: out             !! the result
        type(output_type), intent(inout) :: messages        !! diagnostics
        integer, intent(out) :: exit_status                 !! one of `status%...`
        type(error_type), allocatable, intent(out) :: error !! see above
        type(run_type) :: run
        type(fault_list_type) :: faults
        type(conic_card_type) :: card
        type(error_type), allocatable :: ignored
        integer :: outcome

        exit_status = status%done
        run%options = options
        run%deck%heading = input%opening%heading
        if (options%format == 'csv') call print_csv_header(out)
        do
            call run%deck%next(input%source, card, outcome, faults, error)
            if (allocated(error)) then
                error%message = input%name//': '//error%message
                return
            end if
            if (outcome == found%conic) then
                call run_conic(run, card, base_name(input%name), out, faults)
            end if
            call print_faults(faults, input%name, .false., messages)
            call messages%flush(ignored)
            if (faults%has_errors(0)) exit_status = status%faulty
            call faults%clear()
            if (outcome == found%finished .or. out%has_failed()) exit
        end do
    end subroutine run_conics

    !> Runs one card in the arithmetic asked for.
    subroutine run_conic(run, card, deck_name, out, faults)
        type(run_type), intent(inout) :: run            !! the run
        type(conic_card_type), intent(in) :: card       !! the card, sound or not
        character(*), intent(in) :: deck_name           !! without folders
        type(output_type), intent(inout) :: out         !! the result
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(arc_type) :: arc
        type(card_table_type), allocatable :: tables(:)
        type(card_facts_type) :: facts
        logical :: has_arc

        has_arc = .false.
        if (card%is_readable .and. .not. card%has_coinciding_points()) then
            call arc_of_card(card, arc, has_arc, faults)
        end if
        if (run%options%arithmetic == 's360') then
            if (card%is_readable) call run_period(run%options, card, out, faults)
            return
        end if
        has_arc = has_arc .and. card%is_whole
        if (has_arc) then
            call tables_of_card(card, arc, tables, faults)
        else
            allocate (tables(0))
        end if
        if (run%options%format == 'csv') then
            call print_csv_tables(card, tables, out)
        else
            if (has_arc) facts = facts_of_card(card, arc, run%options%shift)
            if (card%count == 1) call run%listing%begin(run%deck%heading, deck_name)
            call run%listing%print_card(card, facts, tables, out)
        end if
    end subroutine run_conic

    !> Prints the tables of a card as CSV.
    subroutine print_csv_tables(card, tables, out)
        type(conic_card_type), intent(in) :: card       !! the card
        type(card_table_type), intent(in) :: tables(:)  !! its tables
        type(output_type), intent(inout) :: out         !! where they go
        integer :: i
        do i = 1, size(tables)
            call print_csv_table(tables(i), card%count, out)
        end do
    end subroutine print_csv_tables

    !> Runs a card as the program of 1970. What it could not do it says on the page; what stopped
    !> the machine, or would never have ended, is a fault; check values that are off are warned of.
    subroutine run_period(options, card, out, faults)
        type(options_type), intent(in) :: options       !! shift and carriage control
        type(conic_card_type), intent(in) :: card       !! a readable card
        type(output_type), intent(inout) :: out         !! the result
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(error_type), allocatable :: error
        type(printer_type) :: printer
        integer :: before, grade, first, last

        before = faults%count
        printer = printer_type(asa=options%asa)
        call run_card(period_card(card), options%shift, printer, out, error)
        if (.not. allocated(error)) return
        select case (error%cause)
        case (cause%singular, cause%increment)
            if (faults%has_errors(0)) return
        end select
        grade = merge(severity%warning, severity%error, error%cause == cause%checks_off)
        call blame_fields(error%cause, first, last)
        call faults%add(new_fault(grade, conic_fields(first)%first, conic_fields(last)%last, &
            error%message))
        call faults%place(before, card%line, card%image)
    end subroutine run_period

    !> The fields that made the trouble. A zero increment is that of X: a zero YI is a fault of
    !> the card already.
    pure subroutine blame_fields(reason, first, last)
        integer, intent(in) :: reason !! one of `cause%...`
        integer, intent(out) :: first !! field where they begin
        integer, intent(out) :: last  !! field where they end

        first = merge(conic%xi, conic%x1, reason == cause%increment .or. reason == cause%too_many)
        select case (reason)
        case (cause%singular, cause%checks_off)
            last = conic%s3
        case (cause%increment)
            last = conic%xi
        case default
            last = conic%yi
        end select
    end subroutine blame_fields

    !> A card as the 1970 program takes it.
    pure type(period_card_type) function period_card(card)
        type(conic_card_type), intent(in) :: card !! a readable card
        associate (v => card%value)
            period_card = period_card_type(v(conic%x1), v(conic%y1), v(conic%s1), v(conic%x2), &
                v(conic%y2), v(conic%x3), v(conic%y3), v(conic%s3), v(conic%xi), v(conic%yi), &
                card%ityp)
        end associate
    end function period_card

end module app_run_conics
