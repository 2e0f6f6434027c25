!> The table of cards: words fit their field, each card is told from all others.
program test_body_layout
    use deck_body_layout, only: body_card, body_layout, option_words
    use deck_body_word, only: words_in
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    integer :: i, j, twins, unknown

    twins = 0
    do i = 1, size(body_layout)
        do j = i + 1, size(body_layout)
            if (body_layout(i)%word == '') cycle
            if (body_layout(i)%word == body_layout(j)%word .and. &
                body_layout(i)%second == body_layout(j)%second) twins = twins + 1
        end do
    end do
    call tap%ok(twins == 0, 'no two cards have the same words')
    call tap%ok(count(body_layout%word == '') == 2, 'two have none: conics and points')
    unknown = 0
    do i = 1, size(body_layout)
        associate (options => words_in(body_layout(i)%options))
            do j = 1, size(options)
                if (all(option_words%word /= options(j))) unknown = unknown + 1
            end do
        end associate
    end do
    call tap%ok(unknown == 0, 'every option has its meaning')
    call tap%ok(all(body_layout%meaning /= ''), 'every card has its meaning')
    call tap%ok(size(body_layout) == body_card%end, 'every card has its name')
    call name(body_card%line, 'LINE')
    call name(body_card%conic, '')
    call name(body_card%radius, 'RADIUS')
    call name(body_card%section, 'SECTION')
    call name(body_card%skin, 'SKIN')
    call name(body_card%arcs, 'ARCS')
    call name(body_card%station, 'STATION')
    call name(body_card%plane, 'PLANE')
    call name(body_card%check_box, 'CHECK')
    call tap%finish()

contains

    !> A card has its place in the table.
    subroutine name(card, word)
        integer, intent(in) :: card
        character(*), intent(in) :: word
        call tap%same(trim(body_layout(card)%word), word, 'the card '//word//' is in its place')
    end subroutine name

end program test_body_layout
