!> Which cuts `loft export --cut` means: by number in the deck, by the name on its card, or by the
!> name it has in the file; letters in any case.
module app_export_choice
    use app_options, only: argument_type
    use base_error, only: cause, error_type, fail
    use base_text, only: to_text, upper
    use cut_outline, only: cut_type
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
    pure subroutine choose_cuts(words, cuts, shapes, is_chosen, error)
        type(argument_type), intent(in) :: words(:)         !! as the user gave them
        type(cut_type), intent(in) :: cuts(:)               !! all cuts of the deck, in its order
        type(shape_type), intent(in) :: shapes(:)           !! their names in files
        logical, allocatable, intent(out) :: is_chosen(:)   !! one for each cut
        type(error_type), allocatable, intent(out) :: error !! see above
        logical, allocatable :: is_meant(:)
        integer :: i, k

        allocate (is_chosen(size(cuts)), source=size(words) == 0)
        allocate (is_meant(size(cuts)))
        do i = 1, size(words)
            do k = 1, size(cuts)
                is_meant(k) = upper(words(i)%text) == upper(shapes(k)%name) .or. &
                    words(i)%text == to_text(k) .or. &
                    (cuts(k)%name /= '' .and. upper(words(i)%text) == upper(cuts(k)%name))
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
            text = text//' '//to_text(k)//' '//shapes(k)%name//','
        end do
        text = text(:len(text) - 1)
        if (size(shapes) > most_listed) text = text//' and so on to '//to_text(size(shapes))
    end function known_cuts

end module app_export_choice
