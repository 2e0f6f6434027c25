!> The arcs of a 1970 deck: which cards have one, what is said of the others.
program test_card_arcs
    use app_card_arcs, only: card_arc_type, read_card_arcs
    use app_input, only: deck_input_type
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: to_text
    use deck_control_card, only: heading_type
    use deck_kind, only: read_opening
    use support_tap, only: tap_type
    implicit none (type, external)

    !> A card with an arc, and what can't be one: points 1 and 3 are one; a letter in a number.
    character(*), parameter :: nl = new_line('a')
    character(*), parameter :: good = &
        '-30.0   -10.0   .114    0.0     -7.1    50.0    -4.0    .0523   5.0'//nl
    character(*), parameter :: no_chord = &
        '-30.0   -10.0   .114    0.0     -7.1    -30.0   -10.0   .0523   5.0'//nl
    character(*), parameter :: letter = &
        '-30.0   -10.0   .114    0.0     -7.x    50.0    -4.0    .0523   5.0'//nl
    character(*), parameter :: ending = '999.999'//nl
    type(tap_type) :: tap
    type(heading_type) :: heading
    type(card_arc_type), allocatable :: list(:)
    type(output_type) :: messages
    logical :: is_faulty

    call check_few(tap)
    call check_many(tap)
    call tap%finish()

contains

    !> Reads a deck.
    subroutine read_deck(text)
        character(*), intent(in) :: text !! the deck
        type(deck_input_type) :: input
        type(fault_list_type) :: faults
        type(error_type), allocatable :: error
        input%name = 'deck'
        call input%source%from_text(text)
        call read_opening(input%source, input%opening, faults, error)
        call messages%clear()
        call read_card_arcs(input, heading, list, is_faulty, messages, error)
        if (allocated(error)) call tap%ok(.false., error%message)
    end subroutine read_deck

    !> Cards with and without an arc.
    subroutine check_few(tap)
        type(tap_type), intent(inout) :: tap !! the tally

        call read_deck('TITLE   NOSE'//nl//'UNITS   MM'//nl//'* MHB side'//nl//good//ending)
        call tap%ok(size(list) == 1 .and. .not. is_faulty, 'a card has its arc')
        call tap%ok(all(abs(list(1)%arc%finish - [50.0_dp, -4.0_dp]) <= 0.0_dp), &
            'which ends where it says')
        call tap%same(list(1)%card%label, 'MHB side', 'and the name before it')
        call tap%same(heading%title, 'NOSE', 'the title of the deck')
        call tap%same(trim(heading%units), 'MM', 'its unit')
        call tap%same(messages%text(), '', 'nothing is said of it')
        call read_deck(no_chord//letter//good//ending)
        call tap%ok(size(list) == 1 .and. is_faulty, 'a card without an arc is left out')
        call tap%ok(list(1)%card%count == 3, 'the others keep their numbers')
        call tap%ok(index(messages%text(), 'deck:1:') > 0 .and. &
            index(messages%text(), 'deck:2:36-36: error: Y2') > 0, 'and it is said why')
        call read_deck(ending)
        call tap%ok(size(list) == 0, 'a deck without a card has none')
    end subroutine check_few

    !> More cards than there is room for at first.
    subroutine check_many(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        integer, parameter :: many = 100
        character(:), allocatable :: text
        integer :: i

        text = ''
        do i = 1, many
            text = text//'* CARD '//to_text(i)//nl//good
        end do
        call read_deck(text//ending)
        call tap%ok(size(list) == many, 'a hundred cards')
        call tap%ok(all([(list(i)%card%label == 'CARD '//to_text(i), i = 1, size(list))]), &
            'in the order of the deck')
    end subroutine check_many

end program test_card_arcs
