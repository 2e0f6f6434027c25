!> What kind of deck is it? The first card that is not blank, a comment, TITLE or UNITS decides:
!> the word AUDIT in its first field makes a deck of printed tables, any other word a body deck, a
!> number or nothing a 1970 deck. That card is put back, so that a deck from a pipe needs to be
!> read only once.
module deck_kind
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_text, only: upper
    use deck_control_card, only: begins_with_word, card_word, heading_type, read_heading_card
    use deck_source, only: line_type, source_type
    implicit none (type, external)
    private

    public :: opening_type, read_opening

    !> The kinds of deck.
    type, public :: deck_kind_list
        integer :: conic = 1    !! a 1970 deck; so are an empty one and one with a null byte
        integer :: body = 2     !! a body deck
        integer :: audit = 3    !! a deck of printed tables
        integer :: csv = 4      !! printed tables as comma-separated values
    end type deck_kind_list

    !> The kinds by name: `deck_kind_of%body`.
    type(deck_kind_list), parameter, public :: deck_kind_of = deck_kind_list()

    !> How a file of printed tables as comma-separated values begins, in capitals.
    character(*), parameter, public :: table_header = 'TABLE,VIEW,AT,WHAT,ALONG,PRINTED'

    !> How a deck begins.
    type :: opening_type
        integer :: kind = 1             !! one of `deck_kind_of%...`
        type(heading_type) :: heading   !! what TITLE and UNITS said so far
    end type opening_type

contains

    !> Reads on to the card that decides and puts it back, and with it the comment right before,
    !> which names a conic card.
    !>
    !> Fails with `cause%file_trouble` where the source can't be read.
    subroutine read_opening(source, opening, faults, error)
        type(source_type), intent(inout) :: source          !! where the lines come from
        type(opening_type), intent(out) :: opening          !! how the deck begins
        type(fault_list_type), intent(inout) :: faults      !! what is wrong so far is added
        type(error_type), allocatable, intent(out) :: error !! see above
        type(line_type) :: line
        type(line_type), allocatable :: comment
        logical :: has_line

        do
            call source%next_line(line, has_line, error)
            if (allocated(error) .or. .not. has_line) return
            if (line%has_null) exit
            if (line%filled == 0) cycle
            if (line%text(1:1) == '*') then
                comment = line
            else if (is_table_header(line%text)) then
                if (allocated(comment)) deallocate (comment)
                opening%kind = deck_kind_of%csv
                exit
            else if (begins_with_word(line)) then
                if (allocated(comment)) deallocate (comment)
                opening%kind = deck_kind_of%body
                if (card_word(line) == 'AUDIT') opening%kind = deck_kind_of%audit
                if (card_word(line) /= 'TITLE' .and. card_word(line) /= 'UNITS') exit
                opening%kind = deck_kind_of%conic
                call read_heading_card(line, opening%heading, faults)
            else
                exit
            end if
        end do
        call source%put_back(line)
        if (allocated(comment)) call source%put_back(comment)
    end subroutine read_opening

    !> True for the first line of printed tables as comma-separated values; its cells may stand in
    !> quotes.
    pure logical function is_table_header(text)
        character(*), intent(in) :: text !! a line
        character(len(text)) :: bare
        integer :: i, used

        bare = ''
        used = 0
        do i = 1, len(text)
            if (text(i:i) == '"') cycle
            used = used + 1
            bare(used:used) = text(i:i)
        end do
        is_table_header = index(upper(bare), table_header) == 1
    end function is_table_header

end module deck_kind
