!> Words of an audit: what a reading is, what is right, the card.
program test_words
    use audit_deck, only: deck_audit_type
    use audit_finding, only: finding_type, verdict
    use audit_slip, only: slip
    use audit_words, only: card_image, corrected, is_doubtful, percent, reading_name, reason, &
        why_no_card
    use base_kinds, only: dp
    use support_audit_deck, only: audit_of, parabola
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(deck_audit_type) :: found
    type(finding_type) :: finding

    call audit_of(parabola//'ALONG,X,2|5.,.3|', found)
    call tap%same(trim(reading_name(found%item(1), 1))//'/'// &
        trim(reading_name(found%item(1), 10))//'/'//trim(reading_name(found%item(1), 13)), &
        'X 5./X 5. (2)/Y3', 'rows, second columns, fields')
    finding%verdict = verdict%suspect
    finding%likely = '4.5'
    finding%slip = slip%sign
    finding%sure = 0.9999_dp
    call tap%ok(is_doubtful(finding), 'a suspect is doubtful')
    call tap%same(trim(corrected(finding))//'/'//reason(finding)//'/'//percent(finding), &
        '4.5/the sign/99', 'what is right, why, and how sure: never all')
    finding%verdict = verdict%agrees
    call tap%same(reason(finding), '', 'what agrees needs no reason')
    finding%verdict = verdict%blank
    finding%computed_figure = '4.6'
    call tap%same(trim(corrected(finding)), '4.6', 'a blank is filled in')
    call audit_of(parabola, found)
    call tap%same(trim(card_image(found%item(1), found%item(1)%audit%piece(1))), &
        '0.      0.      0.      25.     6.25    50.     25.     1.      5.', &
        'the card, every number with its point')
    call tap%same(trim(why_no_card(found%item(1), found%item(1)%audit%piece(1))), '', &
        'there is nothing to say why not')
    call audit_of('AUDIT,A,SIDE|1.,1.000,2.,4.000,3.,2.500,4.,7.000,5.,1.000', found)
    call tap%ok(card_image(found%item(1), found%item(1)%audit%piece(1)) == '', &
        'no card where its numbers are not bounded')
    call tap%same(trim(why_no_card(found%item(1), found%item(1)%audit%piece(1))), &
        'the good figures do not tell all of its numbers', 'and the words for that')
    call tap%finish()

end program test_words
