!> A deck named on the command line, opened and read as far as the card that says what kind it is.
module app_input
    use api_deck_file, only: deck_file_type
    use base_error, only: cause, error_type, fail
    use base_fault, only: fault_list_type
    use base_posix, only: are_one_file
    use deck_kind, only: deck_kind_of, opening_type, read_opening
    use deck_source, only: source_type
    implicit none (type, external)
    private

    public :: deck_input_type, open_input, close_input, spare_deck, refuse_tables

    !> A deck being read.
    type :: deck_input_type
        character(:), allocatable :: name   !! as the user gave it; `-` is standard input
        type(deck_file_type) :: file        !! the file
        type(source_type) :: source         !! its lines; the next is the deciding card
        type(opening_type) :: opening       !! its kind, and what TITLE and UNITS said
        logical :: has_checksum = .false.   !! its bytes are summed up; set before it is opened
    end type deck_input_type

contains

    !> Opens a deck and reads its beginning. It must be closed also where this fails.
    !>
    !> Fails with `cause%file_trouble` where it can't be opened or read.
    subroutine open_input(name, input, faults, error)
        character(*), intent(in) :: name                    !! as the user gave it
        type(deck_input_type), intent(inout) :: input       !! the deck
        type(fault_list_type), intent(inout) :: faults      !! what is wrong so far is added
        type(error_type), allocatable, intent(out) :: error !! see above

        input%name = name
        call input%file%open(name, input%source, error)
        if (allocated(error)) return
        if (input%has_checksum) call input%source%begin_checksum()
        call read_opening(input%source, input%opening, faults, error)
        if (allocated(error)) error%message = name//': '//error%message
    end subroutine open_input

    !> Refuses a deck of printed tables, of which no body is made.
    subroutine refuse_tables(input, error)
        type(deck_input_type), intent(in) :: input          !! a deck, opened
        type(error_type), allocatable, intent(out) :: error !! `cause%usage`
        if (input%opening%kind >= deck_kind_of%audit) call fail(error, cause%usage, input%name// &
            ' is a deck of printed tables; loft audit finds what is right in them')
    end subroutine refuse_tables

    !> Closes a deck.
    subroutine close_input(input)
        type(deck_input_type), intent(inout) :: input !! the deck
        call input%file%close()
    end subroutine close_input

    !> Refuses a result that would take the place of its deck, whatever names the two have.
    subroutine spare_deck(deck, output, error)
        character(*), intent(in) :: deck                    !! as the user gave it; it is there
        character(*), intent(in) :: output                  !! as the user gave it; may be empty
        type(error_type), allocatable, intent(out) :: error !! `cause%usage`

        if (deck == '-' .or. output == '' .or. output == '-') return
        if (are_one_file(output, deck)) then
            call fail(error, cause%usage, '-o '//output//' would replace the deck')
        end if
    end subroutine spare_deck

end module app_input
