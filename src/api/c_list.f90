!> What a deck has, counted and named, for C; see `loft.h`.
module api_c_list
    use, intrinsic :: iso_c_binding, only: c_char, c_int, c_int32_t, c_int64_t, c_ptr, c_size_t
    use api_c_deck, only: deck_of
    use api_c_text, only: copied
    use api_loft, only: deck_type, severity
    implicit none (type, external)
    private

    public :: loft_deck_body_count, loft_deck_section_count, loft_deck_duct_count
    public :: loft_deck_cut_count, loft_deck_card_count, loft_deck_fault_count
    public :: loft_deck_error_count
    public :: loft_deck_title, loft_deck_units, loft_deck_body_name, loft_deck_section_name
    public :: loft_deck_duct_name, loft_deck_cut_name, loft_deck_card_label
    public :: loft_deck_fault, loft_deck_fault_message, loft_deck_fault_card

    !> What a deck has one or many of.
    type :: thing_list
        integer :: title = 1        !! one, as are the units
        integer :: units = 2
        integer :: body = 3
        integer :: section = 4      !! of a body: its sections, then its patches and ducts
        integer :: duct = 5         !! of a body
        integer :: cut = 6          !! that the deck asks for
        integer :: card = 7         !! conic cards
        integer :: fault = 8
        integer :: faulty = 9       !! the cards of faults
    end type thing_list

    !> The same by name: `thing%body`.
    type(thing_list), parameter :: thing = thing_list()

    !> A fault: `loft_fault`.
    type, bind(c) :: c_fault_type
        integer(c_int64_t) :: line      !! of the deck, from 1; 0: the whole deck
        integer(c_int32_t) :: severity  !! one of `severity%...`
        integer(c_int32_t) :: first     !! first column at fault; 0: the whole card
        integer(c_int32_t) :: last      !! last column at fault
        integer(c_int32_t) :: spare     !! 0
    end type c_fault_type

contains

    !> The number of bodies.
    integer(c_int) function loft_deck_body_count(deck) &
        bind(c, name='loft_deck_body_count') result(count)
        type(c_ptr), value :: deck !! a handle, or null
        count = count_of(deck, thing%body, 0_c_int)
    end function loft_deck_body_count

    !> The number of sections, patches and ducts of a body.
    integer(c_int) function loft_deck_section_count(deck, body) &
        bind(c, name='loft_deck_section_count') result(count)
        type(c_ptr), value :: deck      !! a handle, or null
        integer(c_int), value :: body   !! from 1
        count = count_of(deck, thing%section, body)
    end function loft_deck_section_count

    !> The number of ducts of a body.
    integer(c_int) function loft_deck_duct_count(deck, body) &
        bind(c, name='loft_deck_duct_count') result(count)
        type(c_ptr), value :: deck      !! a handle, or null
        integer(c_int), value :: body   !! from 1
        count = count_of(deck, thing%duct, body)
    end function loft_deck_duct_count

    !> The number of cuts that the deck asks for.
    integer(c_int) function loft_deck_cut_count(deck) &
        bind(c, name='loft_deck_cut_count') result(count)
        type(c_ptr), value :: deck !! a handle, or null
        count = count_of(deck, thing%cut, 0_c_int)
    end function loft_deck_cut_count

    !> The number of conic cards.
    integer(c_int) function loft_deck_card_count(deck) &
        bind(c, name='loft_deck_card_count') result(count)
        type(c_ptr), value :: deck !! a handle, or null
        count = count_of(deck, thing%card, 0_c_int)
    end function loft_deck_card_count

    !> The number of faults.
    integer(c_int) function loft_deck_fault_count(deck) &
        bind(c, name='loft_deck_fault_count') result(count)
        type(c_ptr), value :: deck !! a handle, or null
        count = count_of(deck, thing%fault, 0_c_int)
    end function loft_deck_fault_count

    !> The number of faults that are errors.
    integer(c_int) function loft_deck_error_count(deck) &
        bind(c, name='loft_deck_error_count') result(number)
        type(c_ptr), value :: deck !! a handle, or null
        type(deck_type), pointer :: held

        number = 0_c_int
        held => deck_of(deck)
        if (.not. associated(held)) return
        if (held%faults%count == 0) return
        number = count(held%faults%item(:held%faults%count)%severity == severity%error, kind=c_int)
    end function loft_deck_error_count

    !> The title of a deck.
    integer(c_size_t) function loft_deck_title(deck, room, bytes) &
        bind(c, name='loft_deck_title') result(length)
        type(c_ptr), value :: deck                                  !! a handle, or null
        character(kind=c_char), intent(inout), optional :: room(*)  !! where it goes
        integer(c_size_t), value :: bytes                           !! there
        length = said(deck, thing%title, 0_c_int, 1_c_int, room, bytes)
    end function loft_deck_title

    !> The unit of the numbers of a deck.
    integer(c_size_t) function loft_deck_units(deck, room, bytes) &
        bind(c, name='loft_deck_units') result(length)
        type(c_ptr), value :: deck                                  !! a handle, or null
        character(kind=c_char), intent(inout), optional :: room(*)  !! where it goes
        integer(c_size_t), value :: bytes                           !! there
        length = said(deck, thing%units, 0_c_int, 1_c_int, room, bytes)
    end function loft_deck_units

    !> The name of a body.
    integer(c_size_t) function loft_deck_body_name(deck, body, room, bytes) &
        bind(c, name='loft_deck_body_name') result(length)
        type(c_ptr), value :: deck                                  !! a handle, or null
        integer(c_int), value :: body                               !! from 1
        character(kind=c_char), intent(inout), optional :: room(*)  !! where it goes
        integer(c_size_t), value :: bytes                           !! there
        length = said(deck, thing%body, 0_c_int, body, room, bytes)
    end function loft_deck_body_name

    !> The name of a section, patch or duct of a body.
    integer(c_size_t) function loft_deck_section_name(deck, body, section, room, bytes) &
        bind(c, name='loft_deck_section_name') result(length)
        type(c_ptr), value :: deck                                  !! a handle, or null
        integer(c_int), value :: body                               !! from 1
        integer(c_int), value :: section                            !! from 1
        character(kind=c_char), intent(inout), optional :: room(*)  !! where it goes
        integer(c_size_t), value :: bytes                           !! there
        length = said(deck, thing%section, body, section, room, bytes)
    end function loft_deck_section_name

    !> The name of a duct of a body.
    integer(c_size_t) function loft_deck_duct_name(deck, body, duct, room, bytes) &
        bind(c, name='loft_deck_duct_name') result(length)
        type(c_ptr), value :: deck                                  !! a handle, or null
        integer(c_int), value :: body                               !! from 1
        integer(c_int), value :: duct                               !! from 1
        character(kind=c_char), intent(inout), optional :: room(*)  !! where it goes
        integer(c_size_t), value :: bytes                           !! there
        length = said(deck, thing%duct, body, duct, room, bytes)
    end function loft_deck_duct_name

    !> The name of a cut that the deck asks for.
    integer(c_size_t) function loft_deck_cut_name(deck, number, room, bytes) &
        bind(c, name='loft_deck_cut_name') result(length)
        type(c_ptr), value :: deck                                  !! a handle, or null
        integer(c_int), value :: number                             !! of the cut, from 1
        character(kind=c_char), intent(inout), optional :: room(*)  !! where it goes
        integer(c_size_t), value :: bytes                           !! there
        length = said(deck, thing%cut, 0_c_int, number, room, bytes)
    end function loft_deck_cut_name

    !> The comment right before a conic card.
    integer(c_size_t) function loft_deck_card_label(deck, card, room, bytes) &
        bind(c, name='loft_deck_card_label') result(length)
        type(c_ptr), value :: deck                                  !! a handle, or null
        integer(c_int), value :: card                               !! from 1
        character(kind=c_char), intent(inout), optional :: room(*)  !! where it goes
        integer(c_size_t), value :: bytes                           !! there
        length = said(deck, thing%card, 0_c_int, card, room, bytes)
    end function loft_deck_card_label

    !> What is wrong and what would be right.
    integer(c_size_t) function loft_deck_fault_message(deck, number, room, bytes) &
        bind(c, name='loft_deck_fault_message') result(length)
        type(c_ptr), value :: deck                                  !! a handle, or null
        integer(c_int), value :: number                             !! of the fault, from 1
        character(kind=c_char), intent(inout), optional :: room(*)  !! where it goes
        integer(c_size_t), value :: bytes                           !! there
        length = said(deck, thing%fault, 0_c_int, number, room, bytes)
    end function loft_deck_fault_message

    !> The card that a fault is on.
    integer(c_size_t) function loft_deck_fault_card(deck, number, room, bytes) &
        bind(c, name='loft_deck_fault_card') result(length)
        type(c_ptr), value :: deck                                  !! a handle, or null
        integer(c_int), value :: number                             !! of the fault, from 1
        character(kind=c_char), intent(inout), optional :: room(*)  !! where it goes
        integer(c_size_t), value :: bytes                           !! there
        length = said(deck, thing%faulty, 0_c_int, number, room, bytes)
    end function loft_deck_fault_card

    !> A fault of a deck: 1, or 0 where there is none of that number.
    integer(c_int) function loft_deck_fault(deck, number, fault) bind(c, name='loft_deck_fault') &
        result(is_there)
        type(c_ptr), value :: deck                              !! a handle, or null
        integer(c_int), value :: number                         !! of the fault, from 1
        type(c_fault_type), intent(inout), optional :: fault    !! gets it
        type(deck_type), pointer :: held

        is_there = 0_c_int
        if (number < 1 .or. number > count_of(deck, thing%fault, 0_c_int)) return
        is_there = 1_c_int
        if (.not. present(fault)) return
        held => deck_of(deck)
        associate (found => held%faults%item(number))
            fault = c_fault_type(int(found%line, c_int64_t), int(found%severity, c_int32_t), &
                int(found%first, c_int32_t), int(found%last, c_int32_t), 0_c_int32_t)
        end associate
    end function loft_deck_fault

    !> How many of a thing a deck has; none where the handle is null, or there is no such body.
    integer(c_int) function count_of(handle, what, body) result(count)
        type(c_ptr), intent(in) :: handle       !! of C
        integer, intent(in) :: what             !! one of `thing%...`
        integer(c_int), intent(in) :: body      !! whose sections or ducts, from 1
        type(deck_type), pointer :: deck

        count = 0_c_int
        deck => deck_of(handle)
        if (.not. associated(deck)) return
        select case (what)
        case (thing%title, thing%units)
            count = 1_c_int
        case (thing%body)
            count = size(deck%bodies, kind=c_int)
        case (thing%section, thing%duct)
            if (body < 1 .or. body > size(deck%bodies)) return
            associate (of => deck%bodies(body))
                count = merge(size(of%sections, kind=c_int), size(of%ducts, kind=c_int), &
                    what == thing%section)
            end associate
        case (thing%cut)
            count = size(deck%cuts, kind=c_int)
        case (thing%card)
            count = size(deck%conics, kind=c_int)
        case default
            count = int(deck%faults%count, c_int)
        end select
    end function count_of

    !> Copies what a deck says of a thing; nothing where it has none of that number.
    integer(c_size_t) function said(handle, what, body, number, room, bytes) result(length)
        type(c_ptr), intent(in) :: handle                           !! of C
        integer, intent(in) :: what                                 !! one of `thing%...`
        integer(c_int), intent(in) :: body                          !! whose sections or ducts
        integer(c_int), intent(in) :: number                        !! which, from 1
        character(kind=c_char), intent(inout), optional :: room(*)  !! where it goes
        integer(c_size_t), intent(in) :: bytes                      !! there
        type(deck_type), pointer :: deck
        character(:), allocatable :: words

        words = ''
        deck => deck_of(handle)
        if (number >= 1 .and. number <= count_of(handle, what, body)) then
            select case (what)
            case (thing%title)
                words = deck%title
            case (thing%units)
                words = deck%units
            case (thing%body)
                words = trim(deck%bodies(number)%body%name)
            case (thing%section)
                words = trim(deck%bodies(body)%sections(number))
            case (thing%duct)
                words = trim(deck%bodies(body)%ducts(number)%name)
            case (thing%cut)
                words = trim(deck%cuts(number)%name)
            case (thing%card)
                words = deck%conics(number)%card%label
            case (thing%fault)
                words = deck%faults%item(number)%message
            case default
                words = trim(deck%faults%item(number)%card)
            end select
        end if
        length = copied(words, room, bytes)
    end function said

end module api_c_list
