!> The block of a card before it is put on pages.
program test_card_block
    use base_kinds, only: i64
    use body_card_facts, only: card_facts_type
    use deck_conic_card, only: conic_card_type
    use geom_contour, only: contour_type
    use report_card_block, only: card_block_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(conic_card_type) :: card
    type(card_facts_type) :: facts
    type(contour_type), allocatable :: none(:)
    type(card_block_type) :: block
    character(:), allocatable :: text

    allocate (none(0))
    card%label = 'keel'//achar(7)
    card%count = 12
    card%line = 34
    card%image = '-30.    -10.'
    call block%make(card, facts, none)
    text = block%text%text()
    call tap%ok(block%front == 4 .and. block%tables == 0, &
        'a card without an arc has its echo alone')
    call tap%ok(block%front_bytes == len(text, i64), 'and nothing behind it')
    call tap%has(text, 'CARD 12   keel? ', 'number and name, a control byte as ?')
    call tap%has(text, 'LINE 34'//new_line('a'), 'and line')
    call tap%has(text, new_line('a')//'-30.    -10.'//new_line('a'), 'as punched')
    call block%make(card, facts, none)
    call tap%same(block%text%text(), text, 'its room is used again')
    call tap%finish()

end program test_card_block
