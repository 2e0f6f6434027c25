!> The cards that reproduce the tables of an audit: a deck of 1970, to be run by `loft run`.
module audit_cards
    use audit_audit, only: piece_type
    use audit_cross, only: table_title
    use audit_deck, only: deck_audit_type
    use audit_item, only: item_type
    use audit_words, only: card_image, why_no_card
    use base_output, only: output_type
    use deck_audit, only: audit_deck_type
    implicit none (type, external)
    private

    public :: print_audit_cards

contains

    !> Prints the cards, each under a comment that names its table. A table without a card has the
    !> comment alone.
    subroutine print_audit_cards(deck, found, out)
        type(audit_deck_type), intent(in) :: deck   !! the tables
        type(deck_audit_type), intent(in) :: found  !! what was found
        type(output_type), intent(inout) :: out     !! where it goes
        integer :: i, k

        if (deck%title /= '') call out%line('TITLE   '//deck%title)
        call out%line('UNITS   '//deck%units)
        do i = 1, size(found%item)
            associate (item => found%item(i))
                if (.not. item%is_audited) then
                    call out%line('* '//table_title(item)//': no line found')
                    cycle
                end if
                do k = 1, size(item%audit%piece)
                    call print_card(item, item%audit%piece(k), out)
                end do
            end associate
        end do
    end subroutine print_audit_cards

    !> Prints the card of one conic, or why there is none.
    subroutine print_card(item, piece, out)
        type(item_type), intent(in) :: item         !! the table
        type(piece_type), intent(in) :: piece       !! one conic of it
        type(output_type), intent(inout) :: out     !! where it goes

        if (why_no_card(item, piece) == '') then
            call out%line('* '//table_title(item))
            call out%line(trim(card_image(item, piece)))
        else
            call out%line('* '//table_title(item)//': no card: '// &
                trim(why_no_card(item, piece)))
        end if
    end subroutine print_card

end module audit_cards
