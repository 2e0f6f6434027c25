!> Names of the files of pictures of cuts.
module app_picture_name
    use base_text, only: row_of, to_text
    use cut_outline, only: cut_type
    use cut_plane, only: cut_kind
    use export_body_cut, only: kind_word
    use export_body_drawing, only: mark_of
    implicit none (type, external)
    private

    public :: cut_name, safe_word

contains

    !> The name of the files of a cut: `cut-01-station-20`, `cut-12-oblique-firewall`.
    pure function cut_name(number, cut) result(name)
        integer, intent(in) :: number       !! of the cut in its deck
        type(cut_type), intent(in) :: cut   !! the cut
        character(:), allocatable :: name
        integer :: axis

        name = to_text(number)
        name = 'cut-'//row_of('0', 2 - len(name))//name//'-'//kind_word(cut%plane%kind)
        axis = cut%plane%kind
        if (axis <= cut_kind%waterline) &
            name = name//'-'//safe_word(mark_of(cut%plane%through(axis)))
        if (safe_word(cut%name) /= '') name = name//'-'//safe_word(cut%name)
    end function cut_name

    !> A text as a word of small letters, figures, points and hyphens; `minus-` for a minus sign.
    pure function safe_word(text) result(word)
        character(*), intent(in) :: text !! any bytes
        character(:), allocatable :: word
        integer :: i

        word = ''
        do i = 1, len_trim(text)
            select case (text(i:i))
            case ('a':'z', '0':'9', '.')
                word = word//text(i:i)
            case ('A':'Z')
                word = word//achar(iachar(text(i:i)) + 32)
            case ('-')
                if (word == '') word = word//'minus'
                word = word//'-'
            case default
                word = word//'-'
            end select
        end do
    end function safe_word

end module app_picture_name
