!> A duct as a deck asks for it: through which outlines it goes.
module deck_duct
    use deck_body_card, only: card_type
    use deck_body_word, only: word_length
    implicit none (type, external)
    private

    public :: duct_type

    !> The field of the first outline.
    integer, parameter, public :: first_outline = 3

    !> A duct through outlines.
    type :: duct_type
        character(word_length) :: name = '' !! its name
        integer, allocatable :: outline(:)  !! places of its outlines in the list of the body, STA
                                            !! rising; two or more
        type(card_type) :: card             !! its card
    end type duct_type

end module deck_duct
