!> Words: lists, the nearest one, names.
program test_body_word
    use deck_body_word, only: begins_as_word, crowded_word, in_words, name_trouble, nearest_word, &
        suggestion, &
        words_in
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character(8), parameter :: deck(5) = [character(8) :: 'STATION', 'SECTION', 'SKIN', 'BL', '']

    call tap%ok(size(words_in('')) == 0 .and. size(words_in('  ')) == 0, 'no text has no words')
    call tap%ok(all(words_in(' SIDE  PLAN ANGLE ') == ['SIDE ', 'PLAN ', 'ANGLE']), &
        'words come in order')
    call tap%same(in_words(words_in('A')), 'A', 'a list of one')
    call tap%same(in_words(words_in('A B')), 'A or B', 'a list of two')
    call tap%same(in_words(words_in('A B C D')), 'A, B, C or D', 'a list of four')
    call tap%same(trim(crowded_word('STATION 5', deck)), 'STATION', 'a word and a blank')
    call tap%same(trim(crowded_word('SKIN.05', deck)), 'SKIN', 'a word and a number')
    call tap%same(trim(crowded_word('STATION', deck)), '', 'a word alone is not crowded')
    call tap%same(trim(crowded_word('STATIONS', deck)), '', 'nor is a longer word')
    call tap%same(trim(nearest_word('SATTION', deck)), 'STATION', 'letters exchanged')
    call tap%same(trim(nearest_word('STATON', deck)), 'STATION', 'a letter left out')
    call tap%same(trim(nearest_word('SECCTION', deck)), 'SECTION', 'a letter twice')
    call tap%same(trim(nearest_word('SKIM', deck)), 'SKIN', 'a letter wrong')
    call tap%same(trim(nearest_word('ECTIONS', deck)), 'SECTION', 'two slips')
    call tap%same(trim(nearest_word('FUSELAGE', deck)), '', 'too many slips')
    call tap%same(trim(nearest_word('X', deck)), '', 'one letter is never nearly a word')
    call tap%same(trim(nearest_word('BK', deck)), 'BL', 'two letters may have one slip')
    call tap%same(trim(nearest_word('XY', deck)), '', 'but not two')
    call tap%same(suggestion('SKIM', deck), '; did you mean SKIN?', 'a suggestion ends a sentence')
    call tap%same(suggestion('FUSELAGE', deck), '', 'no suggestion, no words')
    call tap%same(trim(name_trouble('A')), '', 'a letter is a name')
    call tap%same(trim(name_trouble('L-1_A./2')), '', 'figures and signs are of a name')
    call tap%ok(name_trouble('5A') /= '', 'a figure begins no name')
    call tap%ok(name_trouble('-A') /= '', 'a sign begins no name')
    call tap%ok(name_trouble('A B') /= '', 'no blank is in a name')
    call tap%ok(name_trouble('A*B') /= '', 'no star is in a name')
    call tap%ok(name_trouble('A'//char(195)) /= '', 'no byte beyond ASCII is in a name')
    call tap%ok(name_trouble('ABCDEFGHI') /= '', 'nine letters are too many')
    call tap%ok(begins_as_word('AB') .and. begins_as_word('AB5'), 'two letters begin a word')
    call tap%ok(.not. (begins_as_word('A') .or. begins_as_word('O.5') .or. begins_as_word('')), &
        'one letter does not')
    call tap%finish()
end program test_body_word
