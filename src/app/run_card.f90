!> One card of a 1970 deck computed: its text and what is wrong with it, to be printed when its turn
!> comes. Cards know nothing of each other, so many can be computed side by side.
module app_run_card
    use app_options, only: options_type
    use base_error, only: cause, error_type
    use base_fault, only: fault_list_type, new_fault, severity
    use base_kinds, only: i64
    use base_output, only: output_type
    use body_card_arc, only: arc_of_card
    use body_card_facts, only: card_facts_type, facts_of_card
    use body_card_tables, only: card_table_type, contours_of_card, tables_of_card
    use deck_conic_card, only: conic_card_type
    use deck_conic_deck, only: card_image_type, read_image
    use deck_layout, only: conic, conic_fields
    use geom_arc, only: arc_type
    use geom_contour, only: contour_type
    use period_card, only: period_card_type
    use period_printer, only: printer_type
    use period_program, only: run_card
    use report_card_block, only: card_block_type
    use report_csv, only: print_csv_table
    implicit none (type, external)
    private

    public :: card_result_type, compute_card

    !> What became of a card.
    type :: card_result_type
        integer(i64) :: count = 0       !! which conic card of the deck, from 1
        type(fault_list_type) :: faults !! what is wrong, in order
        type(card_block_type) :: block  !! its part of an ieee listing
        type(output_type) :: text       !! its lines of CSV, or of the 1970 page
    end type card_result_type

contains

    !> Computes one card in the arithmetic asked for.
    subroutine compute_card(options, image, it)
        type(options_type), intent(in) :: options       !! mode and format
        type(card_image_type), intent(in) :: image      !! the card as punched
        type(card_result_type), intent(inout) :: it     !! has the faults met before the card
        type(conic_card_type) :: card
        type(arc_type) :: arc
        logical :: has_arc

        it%count = image%count
        call it%text%clear()
        call read_image(image, card, it%faults)
        has_arc = .false.
        if (card%is_readable .and. .not. card%has_coinciding_points()) then
            call arc_of_card(card, arc, has_arc, it%faults)
        end if
        if (options%arithmetic == 's360') then
            if (card%is_readable) call run_period(options, card, it%text, it%faults)
            return
        end if
        has_arc = has_arc .and. card%is_whole
        if (options%format == 'csv') then
            if (has_arc) call put_csv_tables(card, arc, it)
        else
            call put_block(options, card, arc, has_arc, it)
        end if
    end subroutine compute_card

    !> Makes the part of the listing that a card has.
    subroutine put_block(options, card, arc, has_arc, it)
        type(options_type), intent(in) :: options       !! has the shift
        type(conic_card_type), intent(in) :: card       !! the card, sound or not
        type(arc_type), intent(in) :: arc               !! its arc, where it has one
        logical, intent(in) :: has_arc                  !! it has
        type(card_result_type), intent(inout) :: it     !! gets the block
        type(contour_type), allocatable :: contours(:)
        type(card_facts_type) :: facts

        allocate (contours(0))
        if (has_arc) then
            call contours_of_card(card, arc, contours, it%faults)
            facts = facts_of_card(card, arc, options%shift)
        end if
        call it%block%make(card, facts, contours)
    end subroutine put_block

    !> Puts the tables of a card as CSV.
    subroutine put_csv_tables(card, arc, it)
        type(conic_card_type), intent(in) :: card       !! the card
        type(arc_type), intent(in) :: arc               !! its arc
        type(card_result_type), intent(inout) :: it     !! gets the lines
        type(card_table_type), allocatable :: tables(:)
        integer :: i

        allocate (tables(0))
        call tables_of_card(card, arc, tables, it%faults)
        do i = 1, size(tables)
            call print_csv_table(tables(i), card%count, it%text)
        end do
    end subroutine put_csv_tables

    !> Runs a card as the program of 1970. What it could not do it says on the page; what stopped
    !> the machine, or would never have ended, is a fault; check values that are off are warned of.
    subroutine run_period(options, card, out, faults)
        type(options_type), intent(in) :: options       !! shift and carriage control
        type(conic_card_type), intent(in) :: card       !! a readable card
        type(output_type), intent(inout) :: out         !! gets the lines
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

end module app_run_card
