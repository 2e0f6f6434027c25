!> Decks of printed tables for tests: a deck as one text with `|` between its lines.
module support_audit_deck
    use audit_deck, only: audit_the_deck, deck_audit_type
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use deck_audit, only: audit_deck_type
    use deck_audit_file, only: read_tables
    use deck_kind, only: opening_type, read_opening
    use deck_source, only: source_type
    use support_job_deck, only: words_of
    implicit none (type, external)
    private

    public :: tables_of, audit_of, table_faults

    !> The parabola y = x**2/100 from 0 to 50, printed to three decimals, sound.
    character(*), parameter, public :: parabola = &
        'AUDIT,PAR,SIDE|EXACT,X1,0.,Y1,0.,S1,0.|EXACT,X3,50.,Y3,25.|ABOUT,S3,1.00|'// &
        '5.,.250,10.,1.000,15.,2.250,20.,4.000|25.,6.250,30.,9.000,35.,12.250|'// &
        '40.,16.000,45.,20.250|'

contains

    !> Reads a deck.
    subroutine tables_of(text, deck, faults)
        character(*), intent(in) :: text                !! its lines with `|` between them
        type(audit_deck_type), intent(out) :: deck      !! the tables
        type(fault_list_type), intent(out) :: faults    !! what is wrong
        type(source_type) :: source
        type(opening_type) :: opening
        type(error_type), allocatable :: error
        character(:), allocatable :: lines
        integer :: i

        lines = text
        do i = 1, len(lines)
            if (lines(i:i) == '|') lines(i:i) = new_line('a')
        end do
        call source%from_text(lines)
        call read_opening(source, opening, faults, error)
        call read_tables(source, opening, deck, faults, error)
    end subroutine tables_of

    !> What is wrong with a deck, in words.
    function table_faults(text) result(words)
        character(*), intent(in) :: text                !! its lines with `|` between them
        character(:), allocatable :: words
        type(audit_deck_type) :: deck
        type(fault_list_type) :: faults
        call tables_of(text, deck, faults)
        words = words_of(faults)
    end function table_faults

    !> The audit of a deck without faults.
    subroutine audit_of(text, found)
        character(*), intent(in) :: text                !! its lines with `|` between them
        type(deck_audit_type), intent(out) :: found     !! what is found
        type(audit_deck_type) :: deck
        type(fault_list_type) :: faults
        call tables_of(text, deck, faults)
        call audit_the_deck(deck, found)
    end subroutine audit_of

end module support_audit_deck
