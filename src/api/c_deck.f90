!> Decks as handles of C: loading and freeing them; see `loft.h`.
module api_c_deck
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_int, c_loc, &
        c_null_ptr, c_ptr, c_size_t
    use api_c_error, only: hand_over, refuse
    use api_c_text, only: text_of_bytes, text_of_c
    use api_loft, only: deck_type, error_type, load_deck, parse_deck
    implicit none (type, external)
    private

    public :: deck_of, find_deck, loft_deck_load, loft_deck_parse, loft_deck_free, loft_deck_kind

contains

    !> The deck behind a handle; not associated where the handle is null.
    function deck_of(handle) result(deck)
        type(c_ptr), intent(in) :: handle !! of C
        type(deck_type), pointer :: deck
        deck => null()
        if (c_associated(handle)) call c_f_pointer(handle, deck)
    end function deck_of

    !> Finds the deck behind a handle. Fails with `cause%usage` where the handle is null.
    subroutine find_deck(handle, deck, error)
        type(c_ptr), intent(in) :: handle                   !! of C
        type(deck_type), pointer, intent(out) :: deck       !! behind it
        type(error_type), allocatable, intent(out) :: error !! see above
        deck => deck_of(handle)
        if (.not. associated(deck)) call refuse('the deck', error)
    end subroutine find_deck

    !> Loads a deck from a file; null where that fails.
    type(c_ptr) function loft_deck_load(path, error) bind(c, name='loft_deck_load') result(handle)
        character(kind=c_char), intent(in), optional :: path(*)     !! ends with a null
        type(c_ptr), intent(out), optional :: error                 !! gets why it fails
        type(deck_type), pointer :: deck
        type(error_type), allocatable :: trouble

        allocate (deck)
        if (present(path)) then
            call load_deck(text_of_c(path), deck, trouble)
        else
            call refuse('the path', trouble)
        end if
        call give(deck, trouble, handle, error)
    end function loft_deck_load

    !> Loads a deck from a text in memory; null where that fails.
    type(c_ptr) function loft_deck_parse(text, length, error) bind(c, name='loft_deck_parse') &
        result(handle)
        character(kind=c_char), intent(in), optional :: text(*)     !! lines with line feeds
        integer(c_size_t), value :: length                          !! its bytes
        type(c_ptr), intent(out), optional :: error                 !! gets why it fails
        type(deck_type), pointer :: deck
        type(error_type), allocatable :: trouble

        allocate (deck)
        if (present(text)) then
            call parse_deck(text_of_bytes(text, length), deck)
        else
            call refuse('the text', trouble)
        end if
        call give(deck, trouble, handle, error)
    end function loft_deck_parse

    !> Gives a deck to the caller, or frees it and says why there is none.
    subroutine give(deck, trouble, handle, error)
        type(deck_type), pointer, intent(inout) :: deck         !! loaded, or not
        type(error_type), allocatable, intent(in) :: trouble    !! why not
        type(c_ptr), intent(out) :: handle                      !! of the deck, or null
        type(c_ptr), intent(out), optional :: error             !! gets why it fails

        handle = c_null_ptr
        if (allocated(trouble)) then
            deallocate (deck)
        else
            handle = c_loc(deck)
        end if
        call hand_over(trouble, error)
    end subroutine give

    !> Frees a deck.
    subroutine loft_deck_free(handle) bind(c, name='loft_deck_free')
        type(c_ptr), intent(inout), optional :: handle !! becomes NULL
        type(deck_type), pointer :: deck

        if (.not. present(handle)) return
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

end module api_c_deck
