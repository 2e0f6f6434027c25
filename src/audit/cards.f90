!> The cards that reproduce the tables of an audit: a deck of 1970, to be run by `loft run`.
module audit_cards
    use audit_cross, only: table_title
    use audit_deck, only: deck_audit_type
    use audit_words, only: card_image
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
                    if (card_image(item, item%audit%piece(k)) /= '') then
                        call out%line('* '//table_title(item))
                        call out%line(trim(card_image(item, item%audit%piece(k))))
                    else
                        call out%line('* '//table_title(item)//': no card: the good figures '// &
                            'do not tell all of its numbers')
                    end if
                end do
            end associate
        end do
    end subroutine print_audit_cards

end module audit_cards
