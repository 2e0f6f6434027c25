!> Cards one after the other: continuations, headings, comments, what follows END, bad lines.
program test_body_stream
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_text, only: to_text
    use deck_body_card, only: card_type, field_count, field_text
    use deck_body_stream, only: met, stream_type
    use deck_source, only: source_type
    use support_job_deck, only: words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character(*), parameter :: lf = new_line('a')

    call tap%same(told('ONE     A'//lf//'* comment'//lf//lf//'TWO     B'), 'ONE:2 TWO:2 .', &
        'cards in order, comments and blank cards passed over')
    call tap%same(told('ONE     A'//lf//'+       B       C'//lf//'* still'//lf//'+       D'), &
        'ONE:20 .', 'continuations belong to their card, also behind a comment')
    call tap%same(told('+       B'), &
        '. 1:1-1 error: a continuation without a card before it|', 'but must have one')
    call tap%same(told('TITLE   A NOSE'//lf//'ONE'), 'ONE:1 .', 'a heading is no card')
    call tap%same(told('ONE'//lf//'END'//lf//'TWO'//lf//'THREE'), &
        'ONE:1 END:1 . 2:0-0 warning: 2 cards after the END card not read|', &
        'nothing is read behind END, and that is said')
    call tap%same(told('ONE'//achar(9)//'A'//lf//'+       B'//lf//'TWO'), &
        'refused TWO:1 . 1:4-4 error: a tab or control byte on a card; put blanks in its place|', &
        'a card that can not be read takes its continuations with it')
    call tap%same(told('ONE     A'//lf//'+       '//achar(7)//lf//'TWO'), &
        'refused TWO:1 . 2:9-9 error: a tab or control byte on a card; put blanks in its place|', &
        'and they take it')
    call tap%same(told('ONE'//lf//'A'//achar(0)//'B'//lf//'TWO'), 'ONE:1 . 2:2-2 error: a null '// &
        'byte: this is a binary file, not a deck of cards; nothing more of it is read|', &
        'a null byte ends it; the card before it counts')
    call tap%finish()

contains

    !> What a text is read as: words and counts of fields of the cards, faults.
    function told(text) result(words)
        character(*), intent(in) :: text !! a deck
        character(:), allocatable :: words
        type(stream_type) :: stream
        type(source_type) :: source
        type(card_type) :: card
        type(fault_list_type) :: faults
        type(error_type), allocatable :: error
        integer :: outcome

        words = ''
        call source%from_text(text)
        do
            call stream%next_card(source, card, outcome, faults, error)
            if (outcome == met%finished) exit
            if (outcome == met%refused) words = words//'refused '
            if (outcome == met%card) words = words//field_text(card, 1)//':'// &
                to_text(field_count(card))//' '
        end do
        words = words//'.'
        if (faults%count > 0) words = words//' '//words_of(faults)
    end function told

end program test_body_stream
