!> Tests of words and comments of NC programs. Oracles: the rules of NISTIR 6556, section 3.3, and
!> Grbl's list of real-time characters.
program test_nc_word
    use base_kinds, only: dp
    use export_nc_word, only: comment, word
    use support_tap, only: tap_type
    implicit none (type, external)
    type(tap_type) :: tap

    call tap%same(word('X', 1.25_dp, 4), 'X1.2500', 'four decimals')
    call tap%same(word('Y', -12.5_dp, 3), 'Y-12.500', 'three decimals')
    call tap%same(word('Z', -0.00001_dp, 4), 'Z0.0000', 'zero has no sign')
    call tap%same(word('F', 99999.0_dp, 1), 'F99999.0', 'the largest of all')
    call tap%same(word('X', 12345.678901_dp, 6), 'X12345.678901', 'more figures than usual')
    call tap%same(comment('Deck nose.crd'), '(DECK NOSE.CRD)', 'capitals')
    call tap%same(comment('FRAME (AFT) 50%!'), '(FRAME -AFT- 50--)', &
        'no parenthesis within, no per cent, nothing that Grbl obeys')
    call tap%same(comment('a~b?c;d'//char(10)//'e'), '(A-B-C-D-E)', 'no other control')
    call tap%same(comment('K'//char(195)//char(188)//'hn'), '(K--HN)', 'ASCII alone')
    call tap%same(comment(''), '()', 'no words')
    call tap%ok(len(comment(repeat('x', 300))) == 70, 'never more than 70 characters')
    call tap%finish()

end program test_nc_word
