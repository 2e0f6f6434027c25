!> A job half read: cards that stand once, lines by name.
program test_job_state
    use base_fault, only: fault_list_type
    use base_kinds, only: i64
    use deck_body_card, only: card_type, new_card
    use deck_body_layout, only: body_card
    use deck_job, only: control_line_type
    use deck_job_list, only: append
    use deck_job_state, only: check_once, find_line, state_type, text_of
    use deck_source, only: line_type
    use support_job_deck, only: words_of
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(state_type) :: state
    type(card_type) :: card
    type(control_line_type) :: line
    type(fault_list_type) :: faults

    card = new_card(line_type('CLOSE', 4_i64, 5_i64, 5))
    call check_once(state, card, body_card%close, 'deck', faults)
    call tap%ok(faults%count == 0, 'a first card is no fault')
    call check_once(state, card, body_card%digits, 'deck', faults)
    call tap%ok(faults%count == 0, 'nor is one of another kind')
    call check_once(state, card, body_card%close, 'deck', faults)
    call tap%same(words_of(faults), '4:1-8 error: a second CLOSE card; a deck has one|', &
        'a second is')
    call tap%ok(find_line(state, 'A') == 0, 'no line, none found')
    line%name = 'A'
    call append(state%body%line, state%lines, line)
    line%name = 'AB'
    call append(state%body%line, state%lines, line)
    call tap%ok(find_line(state, 'A') == 1 .and. find_line(state, 'AB') == 2, &
        'lines are found by name')
    call tap%ok(find_line(state, 'B') == 0, 'and by no part of it')
    call tap%same(text_of('AB'), 'AB      ', 'a name is as long as its field')
    call tap%finish()
end program test_job_state
