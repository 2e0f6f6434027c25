!> Which cuts `loft export --cut` means: by number in the deck, by the name on its card, or by the
!> name it has in the file; letters in any case. Of a deck of 1970 the cuts are its cards.
module app_export_choice
    use app_options, only: argument_type
    use base_error, only: cause, error_type, fail
    use base_text, only: to_text, upper
    use export_drawing, only: shape_type
    implicit none (type, external)
    private

    public :: choose_cuts

    !> Names that are listed where one is not known.
    integer, parameter :: most_listed = 12

contains

    !> The cuts that some words mean; without a word all.
    !>
    !> Fails with `cause%usage` where a word means none.
    pure subroutine choose_cuts(words, shapes, cards, is_chosen, error)
        type(argument_type), intent(in) :: words(:)         !! as the user gave them
        type(shape_type), intent(in) :: shapes(:)           !! names in files, numbers
        character(*), intent(in) :: cards(:)                !! names on their cards, or blank
        logical, allocatable, intent(out) :: is_chosen(:)   !! one for each cut
        type(error_type), allocatable, intent(out) :: error !! see above
        logical, allocatable :: is_meant(:)
        character(:), allocatable :: word
        integer :: i, k

        allocate (is_chosen(size(shapes)), source=size(words) == 0)
        allocate (is_meant(size(shapes)))
        do i = 1, size(words)
            word = upper(words(i)%text)
            do k = 1, size(shapes)
                is_meant(k) = word == upper(shapes(k)%name) .or. &
                    word == to_text(shapes(k)%number) .or. &
                    (cards(k) /= '' .and. word == upper(cards(k)))
            end do
            is_chosen = is_chosen .or. is_meant
            if (any(is_meant)) cycle
            call fail(error, cause%usage, '--cut '//words(i)%text//': '//known_cuts(shapes))
            return
        end do
    end subroutine choose_cuts

    !> A sentence that lists the cuts of a deck.
    pure function known_cuts(shapes) result(text)
        type(shape_type), intent(in) :: shapes(:) !! their names
        character(:), allocatable :: text
        integer :: k

        text = 'the deck has no cut'
        if (size(shapes) == 0) return
        text = 'no cut of the deck has this name or number; its cuts are:'
        do k = 1, min(size(shapes), most_listed)
            text = text//' '//to_text(shapes(k)%number)//' '//shapes(k)%name//','
        end do
        text = text(:len(text) - 1)
        if (size(shapes) > most_listed) &
            text = text//' and so on to '//to_text(shapes(size(shapes))%number)
    end function known_cuts

end module app_export_choice
