!> Printed tables out of a file of either form: cards, or comma-separated values.
module deck_audit_file
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use deck_audit, only: audit_deck_type
    use deck_audit_csv, only: read_audit_csv
    use deck_audit_reader, only: read_audit
    use deck_kind, only: deck_kind_of, opening_type
    use deck_source, only: source_type
    implicit none (type, external)
    private

    public :: read_tables

contains

    !> Reads the tables.
    !>
    !> Fails with `cause%file_trouble` where the source can't be read.
    subroutine read_tables(source, opening, deck, faults, error)
        type(source_type), intent(inout) :: source          !! where the lines come from
        type(opening_type), intent(in) :: opening           !! how the file begins
        type(audit_deck_type), intent(out) :: deck          !! the tables
        type(fault_list_type), intent(inout) :: faults      !! what is wrong is added
        type(error_type), allocatable, intent(out) :: error !! see above
        if (opening%kind == deck_kind_of%csv) then
            call read_audit_csv(source, deck, faults, error)
        else
            call read_audit(source, opening%heading, deck, faults, error)
        end if
    end subroutine read_tables

end module deck_audit_file
