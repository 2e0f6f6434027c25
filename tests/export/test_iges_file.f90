!> The directory of an IGES file and the parameters it points to.
program test_iges_file
    use base_kinds, only: dp
    use export_iges_file, only: entry_type, iges_file_type, iges_status
    use export_iges_record, only: record_type
    use support_iges_deck, only: deck_of, deck_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(iges_file_type) :: file
    type(record_type) :: first, second
    type(entry_type) :: entry
    type(deck_type) :: deck
    integer :: pointers(2), i

    call first%whole(126)
    call first%reals([(real(i, dp)/3.0_dp, i=1, 9)])
    call file%add(126, entry_type(level=3, colour=4, number=12, label='STATION', &
        is_line=.true.), first, pointers(1))
    call second%whole(104)
    entry%form = 2
    entry%matrix = 1
    entry%status = iges_status%part
    call file%add(104, entry, second, pointers(2))
    call tap%ok(all(pointers == [1, 3]), 'pointers are the numbers of first directory cards')
    deck = deck_of(file%directory%text()//file%parameters%text())
    call tap%same(deck%cards(1), '     126       1       0       1       3       0       0'// &
        '       000000000D      1', 'first card: parameters, line font, level, status')
    call tap%same(deck%cards(2), '     126       0       4       2       0                '// &
        ' STATION      12D      2', 'second card: colour, cards, form, label')
    call tap%same(deck%cards(3), '     104       3       0       0       0       0       1'// &
        '       000010000D      3', 'a part, with a matrix, behind the cards of the first')
    call tap%same(deck%cards(4), '     104       0       0       1       2                '// &
        '               0D      4', 'its form')
    call tap%same(deck%record(3), '104;', 'its parameters')
    call tap%ok(index(deck%record(1), '126,0.3333333333333333,0.6666666666666666,1.,') == 1, &
        'and those of the first')
    call tap%finish()
end program test_iges_file
