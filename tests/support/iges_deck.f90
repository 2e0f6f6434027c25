!> An IGES file taken apart by its columns: cards, sections, directory fields, records.
module support_iges_deck
    implicit none (type, external)
    private

    public :: deck_type, deck_of, find_section

    !> The cards of a file.
    type :: deck_type
        character(80), allocatable :: cards(:)
        logical :: is_even = .true.             !! every line has 80 columns
    contains
        procedure :: field
        procedure :: record
        procedure :: entities
    end type deck_type

contains

    !> Takes a text apart.
    function deck_of(text) result(deck)
        character(*), intent(in) :: text !! lines, each with its end
        type(deck_type) :: deck
        integer :: first, length, i

        allocate (deck%cards(count([(text(i:i) == new_line('a'), i=1, len(text))])))
        first = 1
        do i = 1, size(deck%cards)
            length = index(text(first:), new_line('a')) - 1
            if (length /= 80) deck%is_even = .false.
            deck%cards(i) = text(first:first + length - 1)
            first = first + length + 1
        end do
    end function deck_of

    !> The cards of a section.
    subroutine find_section(deck, letter, cards)
        class(deck_type), intent(in) :: deck                    !! the file
        character, intent(in) :: letter                         !! S, G, D, P or T
        character(80), allocatable, intent(out) :: cards(:)     !! in order
        integer :: i, found

        allocate (cards(count(deck%cards(:)(73:73) == letter)))
        found = 0
        do i = 1, size(deck%cards)
            if (deck%cards(i)(73:73) /= letter) cycle
            found = found + 1
            cards(found) = deck%cards(i)
        end do
    end subroutine find_section

    !> A field of the directory, without blanks: 1 to 9 of the first card, 11 to 19 of the second.
    function field(deck, pointer, number) result(word)
        class(deck_type), intent(in) :: deck    !! the file
        integer, intent(in) :: pointer          !! to the entity
        integer, intent(in) :: number           !! which, as the standard counts them
        character(:), allocatable :: word
        character(80), allocatable :: cards(:)
        integer :: column

        call find_section(deck, 'D', cards)
        column = 8*mod(number - 1, 10)
        word = trim(adjustl(cards(pointer + (number - 1)/10)(column + 1:column + 8)))
    end function field

    !> The record of an entity, from all its cards, without the blanks at their ends.
    function record(deck, pointer) result(text)
        class(deck_type), intent(in) :: deck    !! the file
        integer, intent(in) :: pointer          !! to the entity
        character(:), allocatable :: text
        character(80), allocatable :: cards(:)
        integer :: i, owner

        text = ''
        call find_section(deck, 'P', cards)
        do i = 1, size(cards)
            read (cards(i)(65:72), *) owner
            if (owner == pointer) text = text//trim(cards(i)(:64))
        end do
    end function record

    !> How many entities of a type there are.
    integer function entities(deck, kind) result(number)
        class(deck_type), intent(in) :: deck    !! the file
        integer, intent(in) :: kind             !! type of entity
        character(80), allocatable :: cards(:)
        integer :: i, found

        call find_section(deck, 'D', cards)
        number = 0
        do i = 1, size(cards), 2
            read (cards(i)(:8), *) found
            if (found == kind) number = number + 1
        end do
    end function entities

end module support_iges_deck
