!> `loft run`: a deck in, its tables out, one card at a time. What is wrong with a card is reported
!> as it is met; the other cards run.
module app_run
    use app_files, only: base_name, deck_file_type, result_file_type
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
    use deck_layout, only: conic
    use deck_source, only: source_type
    use geom_arc, only: arc_type
    use period_card, only: period_card_type
    use period_printer, only: printer_type
    use period_program, only: run_card
    use report_conic_listing, only: conic_listing_type
    use report_csv, only: print_csv_header, print_csv_table
    use report_fault, only: print_faults
    implicit none (type, external)
    private

    public :: run_deck

    !> A run on its way.
    type :: run_type
        type(options_type) :: options           !! what was asked for
        type(conic_deck_type) :: deck           !! the deck, as far as it is read
        type(conic_listing_type) :: listing     !! the pages of an ieee listing
        type(output_type) :: out                !! the result
        integer :: status = status%done         !! exit status so far
    end type run_type

contains

    !> Runs a deck. The exit status is `status%done`, or `status%faulty` where a card was in error.
    !>
    !> Fails with `cause%file_trouble` where the deck can't be read or the result not be written.
    subroutine run_deck(options, exit_status, messages, error)
        type(options_type), intent(in) :: options           !! deck, mode, format, result
        integer, intent(out) :: exit_status                 !! one of `status%...`
        type(output_type), intent(inout) :: messages        !! diagnostics
        type(error_type), allocatable, intent(out) :: error !! see above
        type(run_type) :: run
        type(deck_file_type) :: deck_file
        type(result_file_type) :: result_file
        type(source_type) :: source
        character(:), allocatable :: name

        name = '-'
        if (size(options%operand) > 0) name = options%operand(1)%text
        run%options = options
        exit_status = status%unusable
        call deck_file%open(name, source, error)
        if (allocated(error)) return
        call result_file%begin(options%output, run%out, error)
        if (.not. allocated(error)) call run_cards(run, source, name, messages, error)
        call deck_file%close()
        if (allocated(error)) then
            call result_file%abandon()
        else
            call result_file%complete(run%out, error)
        end if
        if (.not. allocated(error)) exit_status = run%status
    end subroutine run_deck

    !> Runs the cards of a deck one after the other.
    subroutine run_cards(run, source, name, messages, error)
        type(run_type), intent(inout) :: run                !! the run
        type(source_type), intent(inout) :: source          !! lines of the deck
        character(*), intent(in) :: name                    !! of the deck
        type(output_type), intent(inout) :: messages        !! diagnostics
        type(error_type), allocatable, intent(out) :: error !! `cause%file_trouble`
        type(fault_list_type) :: faults
        type(conic_card_type) :: card
        type(error_type), allocatable :: ignored
        integer :: outcome

        if (run%options%format == 'csv') call print_csv_header(run%out)
        do
            call run%deck%next(source, card, outcome, faults, error)
            if (allocated(error)) then
                error%message = name//': '//error%message
                return
            end if
            if (outcome == found%conic) call run_conic(run, card, base_name(name), faults)
            call print_faults(faults, name, .false., messages)
            call messages%flush(ignored)
            if (faults%has_errors(0)) run%status = status%faulty
            call faults%clear()
            if (outcome == found%finished .or. run%out%has_failed()) exit
        end do
    end subroutine run_cards

    !> Runs one card in the arithmetic asked for.
    subroutine run_conic(run, card, deck_name, faults)
        type(run_type), intent(inout) :: run            !! the run
        type(conic_card_type), intent(in) :: card       !! the card, sound or not
        character(*), intent(in) :: deck_name           !! without folders
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
            if (card%is_readable) call run_period(run, card, faults)
            return
        end if
        if (has_arc) then
            call tables_of_card(card, arc, tables, faults)
        else
            allocate (tables(0))
        end if
        if (run%options%format == 'csv') then
            call print_csv_tables(card, tables, run%out)
        else
            if (has_arc) facts = facts_of_card(card, arc, run%options%shift)
            if (card%count == 1) call run%listing%begin(run%deck%heading, deck_name)
            call run%listing%print_card(card, facts, tables, run%out)
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
    !> the machine, or would never have ended, is a fault.
    subroutine run_period(run, card, faults)
        type(run_type), intent(inout) :: run            !! the run
        type(conic_card_type), intent(in) :: card       !! a readable card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(error_type), allocatable :: error
        type(printer_type) :: printer
        integer :: before

        before = faults%count
        printer = printer_type(asa=run%options%asa)
        call run_card(period_card(card), run%options%shift, printer, run%out, error)
        if (.not. allocated(error)) return
        select case (error%cause)
        case (cause%singular, cause%increment)
            if (faults%has_errors(0)) return
        end select
        call faults%add(new_fault(severity%error, 0, 0, error%message))
        call faults%place(before, card%line, card%image)
    end subroutine run_period

    !> A card as the 1970 program takes it.
    pure type(period_card_type) function period_card(card)
        type(conic_card_type), intent(in) :: card !! a readable card
        associate (v => card%value)
            period_card = period_card_type(v(conic%x1), v(conic%y1), v(conic%s1), v(conic%x2), &
                v(conic%y2), v(conic%x3), v(conic%y3), v(conic%s3), v(conic%xi), v(conic%yi), &
                card%ityp)
        end associate
    end function period_card

end module app_run
