!> What a deck says of itself in words, for C; see `loft.h`.
module api_c_words
    use, intrinsic :: iso_c_binding, only: c_associated, c_f_pointer, c_int, c_int32_t, c_int64_t, &
        c_ptr, c_size_t
    use api_c_deck, only: deck_of
    use api_c_text, only: copied
    use api_loft, only: deck_type
    implicit none (type, external)
    private

    public :: loft_deck_title, loft_deck_units, loft_deck_body_name, loft_deck_section_name
    public :: loft_deck_cut_name, loft_deck_card_label
    public :: loft_deck_fault, loft_deck_fault_message, loft_deck_fault_card

    !> A fault: `loft_fault`.
    type, bind(c) :: c_fault_type
        integer(c_int64_t) :: line      !! of the deck, from 1; 0: the whole deck
        integer(c_int32_t) :: severity  !! one of `severity%...`
        integer(c_int32_t) :: first     !! first column at fault; 0: the whole card
        integer(c_int32_t) :: last      !! last column at fault
        integer(c_int32_t) :: spare     !! 0
    end type c_fault_type

contains

    !> The title of a deck.
    integer(c_size_t) function loft_deck_title(deck, room, bytes) &
        bind(c, name='loft_deck_title') result(length)
        type(c_ptr), value :: deck              !! a handle, or null
        type(c_ptr), value :: room              !! where it goes, or null
        integer(c_size_t), value :: bytes       !! there
        type(deck_type), pointer :: held
        character(:), allocatable :: text

        text = ''
        held => deck_of(deck)
        if (associated(held)) then
            text = held%title
        end if
        length = copied(text, room, bytes)
    end function loft_deck_title

    !> The unit of the numbers of a deck.
    integer(c_size_t) function loft_deck_units(deck, room, bytes) &
        bind(c, name='loft_deck_units') result(length)
        type(c_ptr), value :: deck              !! a handle, or null
        type(c_ptr), value :: room              !! where it goes, or null
        integer(c_size_t), value :: bytes       !! there
        type(deck_type), pointer :: held
        character(:), allocatable :: text

        text = ''
        held => deck_of(deck)
        if (associated(held)) then
            text = held%units
        end if
        length = copied(text, room, bytes)
    end function loft_deck_units

    !> The name of a body.
    integer(c_size_t) function loft_deck_body_name(deck, body, room, bytes) &
        bind(c, name='loft_deck_body_name') result(length)
        type(c_ptr), value :: deck              !! a handle, or null
        integer(c_int), value :: body                !! from 1
        type(c_ptr), value :: room              !! where it goes, or null
        integer(c_size_t), value :: bytes       !! there
        type(deck_type), pointer :: held
        character(:), allocatable :: text

        text = ''
        held => deck_of(deck)
        if (associated(held)) then
            if (body >= 1 .and. body <= size(held%bodies)) &
                text = trim(held%bodies(body)%body%name)
        end if
        length = copied(text, room, bytes)
    end function loft_deck_body_name

    !> The name of a section or patch of a body.
    integer(c_size_t) function loft_deck_section_name(deck, body, section, room, bytes) &
        bind(c, name='loft_deck_section_name') result(length)
        type(c_ptr), value :: deck              !! a handle, or null
        integer(c_int), value :: body           !! from 1
        integer(c_int), value :: section        !! from 1
        type(c_ptr), value :: room              !! where it goes, or null
        integer(c_size_t), value :: bytes       !! there
        type(deck_type), pointer :: held
        character(:), allocatable :: text

        text = ''
        held => deck_of(deck)
        if (associated(held)) then
            if (body >= 1 .and. body <= size(held%bodies)) &
                text = name_in(held%bodies(body)%sections, section)
        end if
        length = copied(text, room, bytes)
    end function loft_deck_section_name

    !> The name of a cut that the deck asks for.
    integer(c_size_t) function loft_deck_cut_name(deck, number, room, bytes) &
        bind(c, name='loft_deck_cut_name') result(length)
        type(c_ptr), value :: deck              !! a handle, or null
        integer(c_int), value :: number              !! of the cut, from 1
        type(c_ptr), value :: room              !! where it goes, or null
        integer(c_size_t), value :: bytes       !! there
        type(deck_type), pointer :: held
        character(:), allocatable :: text

        text = ''
        held => deck_of(deck)
        if (associated(held)) then
            if (number >= 1 .and. number <= size(held%cuts)) &
                text = trim(held%cuts(number)%name)
        end if
        length = copied(text, room, bytes)
    end function loft_deck_cut_name

    !> The comment right before a conic card.
    integer(c_size_t) function loft_deck_card_label(deck, card, room, bytes) &
        bind(c, name='loft_deck_card_label') result(length)
        type(c_ptr), value :: deck              !! a handle, or null
        integer(c_int), value :: card                !! from 1
        type(c_ptr), value :: room              !! where it goes, or null
        integer(c_size_t), value :: bytes       !! there
        type(deck_type), pointer :: held
        character(:), allocatable :: text

        text = ''
        held => deck_of(deck)
        if (associated(held)) then
            if (card >= 1 .and. card <= size(held%conics)) &
                text = held%conics(card)%card%label
        end if
        length = copied(text, room, bytes)
    end function loft_deck_card_label

    !> A fault of a deck: 1, or 0 where there is none of that number.
    integer(c_int) function loft_deck_fault(deck, number, fault) bind(c, name='loft_deck_fault') &
        result(is_there)
        type(c_ptr), value :: deck              !! a handle, or null
        integer(c_int), value :: number         !! of the fault, from 1
        type(c_ptr), value :: fault             !! gets it, or null
        type(deck_type), pointer :: held
        type(c_fault_type), pointer :: place

        is_there = 0_c_int
        held => deck_of(deck)
        if (.not. associated(held)) return
        if (number < 1 .or. number > held%faults%count) return
        is_there = 1_c_int
        if (.not. c_associated(fault)) return
        call c_f_pointer(fault, place)
        associate (found => held%faults%item(number))
            place = c_fault_type(int(found%line, c_int64_t), int(found%severity, c_int32_t), &
                int(found%first, c_int32_t), int(found%last, c_int32_t), 0_c_int32_t)
        end associate
    end function loft_deck_fault

    !> What is wrong and what would be right.
    integer(c_size_t) function loft_deck_fault_message(deck, number, room, bytes) &
        bind(c, name='loft_deck_fault_message') result(length)
        type(c_ptr), value :: deck              !! a handle, or null
        integer(c_int), value :: number              !! of the fault, from 1
        type(c_ptr), value :: room              !! where it goes, or null
        integer(c_size_t), value :: bytes       !! there
        type(deck_type), pointer :: held
        character(:), allocatable :: text

        text = ''
        held => deck_of(deck)
        if (associated(held)) then
            if (number >= 1 .and. number <= held%faults%count) &
                text = held%faults%item(number)%message
        end if
        length = copied(text, room, bytes)
    end function loft_deck_fault_message

    !> The card that a fault is on.
    integer(c_size_t) function loft_deck_fault_card(deck, number, room, bytes) &
        bind(c, name='loft_deck_fault_card') result(length)
        type(c_ptr), value :: deck              !! a handle, or null
        integer(c_int), value :: number              !! of the fault, from 1
        type(c_ptr), value :: room              !! where it goes, or null
        integer(c_size_t), value :: bytes       !! there
        type(deck_type), pointer :: held
        character(:), allocatable :: text

        text = ''
        held => deck_of(deck)
        if (associated(held)) then
            if (number >= 1 .and. number <= held%faults%count) &
                text = trim(held%faults%item(number)%card)
        end if
        length = copied(text, room, bytes)
    end function loft_deck_fault_card

    !> A name of a list, or nothing where it has none of that number.
    pure function name_in(names, number) result(name)
        character(*), intent(in) :: names(:)        !! the list
        integer(c_int), intent(in) :: number        !! from 1
        character(:), allocatable :: name
        name = ''
        if (number >= 1 .and. number <= size(names)) name = trim(names(number))
    end function name_in

end module api_c_words
