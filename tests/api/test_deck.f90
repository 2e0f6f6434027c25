!> Decks held whole: what kind they are, their title and unit, conics, bodies, cuts and faults.
program test_deck
    use api_deck, only: deck_type, read_deck
    use base_error, only: error_type
    use base_fault, only: severity
    use deck_source, only: source_type
    use support_book, only: text_file
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(deck_type) :: deck, copy
    character, parameter :: nl = new_line('a')
    integer :: i

    call read('TITLE   TWO CARDS'//nl//'UNITS   MM'//nl//'* first'//nl// &
        '0.,0.,0.,1.,.4,2.,2.,2.,1.'//nl//'0.,0.,0.,1.,.x,2.,2.,2.,1.'//nl//'999.999'//nl)
    call tap%ok(.not. deck%is_body_deck, 'a number in the first card makes a deck of 1970')
    call tap%same(deck%title, 'TWO CARDS', 'it has its title')
    call tap%same(deck%units, 'MM', 'and its unit')
    call tap%ok(size(deck%conics) == 2 .and. size(deck%bodies) == 0 .and. size(deck%cuts) == 0, &
        'and two conics, no body, no cut')
    call tap%ok(.not. any(deck%conics%has_arc), 'free fields are no cards of 1970')
    call tap%ok(deck%faults%has_errors(0), 'and are errors')

    call read(text_file('cards/sae700202.crd'))
    call tap%ok(size(deck%conics) == 11, 'the nose of 1970 has eleven cards')
    call tap%ok(all(deck%conics%has_arc), 'each of them an arc')
    call tap%same(deck%conics(1)%card%label, 'MHB side', 'the first has its label')
    call tap%ok(.not. deck%faults%has_errors(0), 'and none is in error')
    copy = deck
    call tap%same(copy%conics(11)%card%image, deck%conics(11)%card%image, 'a copy is whole')

    call read(text_file('cards/inlet.crd'))
    call tap%ok(deck%is_body_deck, 'a word in the first card makes a body deck')
    call tap%ok(size(deck%cuts) == size(deck%bodies(1)%cuts) + size(deck%bodies(1)%outlines), &
        'its cuts and faired outlines are listed')
    call tap%ok(any(deck%cuts%is_outline), 'outlines among them')
    call tap%ok(all(deck%cuts%body == 1), 'all of its body')

    call read(text_file('cards/faults.crd'))
    call tap%ok(count([(deck%faults%item(i)%severity == severity%error, &
        i=1, deck%faults%count)]) > 3, 'a faulty deck has its errors')
    call tap%ok(all([(allocated(deck%faults%item(i)%message), i=1, deck%faults%count)]), &
        'each with its words')
    call read('')
    call tap%ok(deck%faults%has_errors(0), 'no deck at all is an error')
    call tap%same(deck%units//deck%title, 'INCHES', 'in inches, without a title')
    call tap%finish()

contains

    !> Reads a deck from memory; a text in memory can't fail to be read.
    subroutine read(text)
        character(*), intent(in) :: text !! the deck
        type(source_type) :: source
        type(error_type), allocatable :: error
        call source%from_text(text)
        call read_deck(source, deck, error)
        call tap%ok(.not. allocated(error), 'a deck in memory is read')
    end subroutine read

end program test_deck
