!> Decks as handles of C; see `loft.h`.
module api_c_deck
    use, intrinsic :: iso_c_binding, only: c_associated, c_f_pointer, c_int, c_loc, c_null_ptr, &
        c_ptr, c_size_t
    use api_c_error, only: hand_over, refuse
    use api_c_text, only: text_of_bytes, text_of_c
    use api_loft, only: deck_type, error_type, load_deck, parse_deck, severity
    use base_fault, only: fault_list_type
    implicit none (type, external)
    private

    public :: deck_of, loft_deck_load, loft_deck_parse, loft_deck_free
    public :: loft_deck_kind, loft_deck_body_count, loft_deck_section_count, loft_deck_cut_count
    public :: loft_deck_card_count, loft_deck_fault_count, loft_deck_error_count

contains

    !> The deck behind a handle; not associated where the handle is null.
    function deck_of(handle) result(deck)
        type(c_ptr), intent(in) :: handle !! of C
        type(deck_type), pointer :: deck
        deck => null()
        if (c_associated(handle)) call c_f_pointer(handle, deck)
    end function deck_of

    !> Loads a deck from a file; null where that fails.
    type(c_ptr) function loft_deck_load(path, error) bind(c, name='loft_deck_load') result(handle)
        type(c_ptr), value :: path      !! ends with a null
        type(c_ptr), value :: error     !! gets why it fails, or null
        type(deck_type), pointer :: deck
        type(error_type), allocatable :: trouble

        handle = c_null_ptr
        if (c_associated(path)) then
            allocate (deck)
            call load_deck(text_of_c(path), deck, trouble)
            if (allocated(trouble)) then
                deallocate (deck)
            else
                handle = c_loc(deck)
            end if
        else
            call refuse('the path', trouble)
        end if
        call hand_over(trouble, error)
    end function loft_deck_load

    !> Loads a deck from a text in memory; null where that fails.
    type(c_ptr) function loft_deck_parse(text, length, error) bind(c, name='loft_deck_parse') &
        result(handle)
        type(c_ptr), value :: text              !! lines with line feeds between them
        integer(c_size_t), value :: length      !! its bytes
        type(c_ptr), value :: error             !! gets why it fails, or null
        type(deck_type), pointer :: deck
        type(error_type), allocatable :: trouble

        handle = c_null_ptr
        if (c_associated(text)) then
            allocate (deck)
            call parse_deck(text_of_bytes(text, length), deck)
            handle = c_loc(deck)
        else
            call refuse('the text', trouble)
        end if
        call hand_over(trouble, error)
    end function loft_deck_parse

    !> Frees a deck.
    subroutine loft_deck_free(slot) bind(c, name='loft_deck_free')
        type(c_ptr), value :: slot !! address of the handle, which becomes NULL
        type(deck_type), pointer :: deck
        type(c_ptr), pointer :: handle

        if (.not. c_associated(slot)) return
        call c_f_pointer(slot, handle)
        deck => deck_of(handle)
        if (associated(deck)) deallocate (deck)
        handle = c_null_ptr
    end subroutine loft_deck_free

    !> What kind of deck it is: 1 of 1970, 2 a body deck; 0 for NULL.
    integer(c_int) function loft_deck_kind(deck) bind(c, name='loft_deck_kind') result(kind_of)
        type(c_ptr), value :: deck !! a handle, or null
        type(deck_type), pointer :: held
        kind_of = 0_c_int
        held => deck_of(deck)
        if (associated(held)) kind_of = merge(2_c_int, 1_c_int, held%is_body_deck)
    end function loft_deck_kind

    !> The number of bodies.
    integer(c_int) function loft_deck_body_count(deck) &
        bind(c, name='loft_deck_body_count') result(count)
        type(c_ptr), value :: deck !! a handle, or null
        type(deck_type), pointer :: held
        count = 0_c_int
        held => deck_of(deck)
        if (associated(held)) count = int(size(held%bodies), c_int)
    end function loft_deck_body_count

    !> The number of cuts that the deck asks for.
    integer(c_int) function loft_deck_cut_count(deck) &
        bind(c, name='loft_deck_cut_count') result(count)
        type(c_ptr), value :: deck !! a handle, or null
        type(deck_type), pointer :: held
        count = 0_c_int
        held => deck_of(deck)
        if (associated(held)) count = int(size(held%cuts), c_int)
    end function loft_deck_cut_count

    !> The number of conic cards.
    integer(c_int) function loft_deck_card_count(deck) &
        bind(c, name='loft_deck_card_count') result(count)
        type(c_ptr), value :: deck !! a handle, or null
        type(deck_type), pointer :: held
        count = 0_c_int
        held => deck_of(deck)
        if (associated(held)) count = int(size(held%conics), c_int)
    end function loft_deck_card_count

    !> The number of faults.
    integer(c_int) function loft_deck_fault_count(deck) &
        bind(c, name='loft_deck_fault_count') result(count)
        type(c_ptr), value :: deck !! a handle, or null
        type(deck_type), pointer :: held
        count = 0_c_int
        held => deck_of(deck)
        if (associated(held)) count = int(held%faults%count, c_int)
    end function loft_deck_fault_count

    !> The number of faults that are errors.
    integer(c_int) function loft_deck_error_count(deck) &
        bind(c, name='loft_deck_error_count') result(count)
        type(c_ptr), value :: deck !! a handle, or null
        type(deck_type), pointer :: held
        count = 0_c_int
        held => deck_of(deck)
        if (associated(held)) count = int(errors_of(held%faults), c_int)
    end function loft_deck_error_count

    !> The number of sections and patches of a body.
    integer(c_int) function loft_deck_section_count(deck, body) &
        bind(c, name='loft_deck_section_count') result(count)
        type(c_ptr), value :: deck          !! a handle, or null
        integer(c_int), value :: body       !! from 1
        type(deck_type), pointer :: held

        count = 0_c_int
        held => deck_of(deck)
        if (.not. associated(held)) return
        if (body < 1 .or. body > size(held%bodies)) return
        count = int(size(held%bodies(body)%sections), c_int)
    end function loft_deck_section_count

    !> The number of faults in a list that are errors.
    pure integer function errors_of(faults) result(number)
        type(fault_list_type), intent(in) :: faults !! any
        number = 0
        if (faults%count > 0) number = count(faults%item(:faults%count)%severity == severity%error)
    end function errors_of

end module api_c_deck
