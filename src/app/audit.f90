!> `loft audit`: a deck of printed tables in, what is right and wrong in them out.
module app_audit
    use app_files, only: base_name, result_file_type
    use app_input, only: close_input, deck_input_type, open_input, spare_deck
    use app_options, only: options_type
    use app_status, only: status
    use audit_cards, only: print_audit_cards
    use audit_csv, only: print_audit_csv
    use audit_deck, only: audit_the_deck, deck_audit_type
    use audit_listing, only: print_audit
    use base_error, only: cause, error_type, fail
    use base_fault, only: fault_list_type
    use base_output, only: output_type
    use deck_audit, only: audit_deck_type
    use deck_audit_file, only: read_tables
    use deck_kind, only: deck_kind_of
    use report_fault, only: print_faults
    implicit none (type, external)
    private

    public :: audit_tables

contains

    !> Audits a deck. The exit status is `status%done`, or `status%faulty` where a card was in
    !> error; a figure that is suspect is a result.
    !>
    !> Fails with `cause%file_trouble` where the deck can't be read or the result not be written,
    !> and with `cause%usage` where it is no deck of printed tables, or the result would take its
    !> place.
    subroutine audit_tables(options, exit_status, messages, error)
        type(options_type), intent(in) :: options           !! deck, format, result
        integer, intent(out) :: exit_status                 !! one of `status%...`
        type(output_type), intent(inout) :: messages        !! diagnostics
        type(error_type), allocatable, intent(out) :: error !! see above
        type(deck_input_type) :: input
        type(result_file_type) :: result_file
        type(output_type) :: out
        type(audit_deck_type) :: deck
        type(fault_list_type) :: faults
        character(:), allocatable :: name

        name = options%operand(1)%text
        exit_status = status%unusable
        call open_input(name, input, faults, error)
        if (.not. allocated(error)) call read_deck(input, deck, faults, error)
        call close_input(input)
        if (allocated(error)) return
        call spare_deck(name, options%output, error)
        if (.not. allocated(error)) call result_file%begin(options%output, out, error)
        if (allocated(error)) return
        call print_faults(faults, name, .false., messages)
        call print_result(options%format, deck, base_name(name), out)
        call result_file%complete(out, error)
        if (.not. allocated(error)) exit_status = merge(status%faulty, status%done, &
            faults%has_errors(0))
    end subroutine audit_tables

    !> Reads the tables.
    !>
    !> Fails with `cause%usage` where there are none, and with `cause%file_trouble`.
    subroutine read_deck(input, deck, faults, error)
        type(deck_input_type), intent(inout) :: input       !! the deck, at its first card
        type(audit_deck_type), intent(out) :: deck          !! its tables
        type(fault_list_type), intent(inout) :: faults      !! what is wrong is added
        type(error_type), allocatable, intent(out) :: error !! see above

        if (input%opening%kind < deck_kind_of%audit) then
            call fail(error, cause%usage, input%name//' is no deck of printed tables, whose '// &
                'first card is AUDIT, or whose first line is table,view,at,what,along,printed; '// &
                'loft help audit has an example')
            return
        end if
        call read_tables(input%source, input%opening, deck, faults, error)
        if (allocated(error)) error%message = input%name//': '//error%message
    end subroutine read_deck

    !> Audits and prints.
    subroutine print_result(format, deck, deck_name, out)
        character(*), intent(in) :: format          !! listing, csv or deck
        type(audit_deck_type), intent(in) :: deck   !! the tables
        character(*), intent(in) :: deck_name       !! without folders
        type(output_type), intent(inout) :: out     !! where it goes
        type(deck_audit_type) :: found

        call audit_the_deck(deck, found)
        select case (format)
        case ('csv')
            call print_audit_csv(found, out)
        case ('deck')
            call print_audit_cards(deck, found, out)
        case default
            call print_audit(deck, found, deck_name, out)
        end select
    end subroutine print_result

end module app_audit
