!> Names and titles of the shapes of a drawing. A name serves as file name, layer and program name,
!> so it has but letters, figures, `-`, `_` and `.`; a title is for people.
module export_drawing_name
    use base_digits, only: shortest
    use base_kinds, only: dp, i64
    use base_text, only: limited
    use cut_outline, only: cut_type
    use cut_plane, only: cut_kind, plane_type
    use export_drawing, only: drawing_type
    use export_taken_names, only: new_taken, take_name, taken_type
    implicit none (type, external)
    private

    public :: cut_name, cut_title, safe_name, make_unique

    !> Room for a title: that of a plane with the three ordinates of a point.
    integer, parameter :: longest_title = 120

contains

    !> The name of a cut: `STA_20`, `BL_-4.5`, `WL_-16_FLOOR`, `OBL_FIREWALL`, `PLANE`.
    pure function cut_name(cut) result(name)
        type(cut_type), intent(in) :: cut   !! any
        character(longest_title) :: name
        character(*), parameter :: names(5) = [character(5) :: 'STA', 'BL', 'WL', 'OBL', 'PLANE']

        name = kind_words(cut%plane, names, '_')
        if (len_trim(cut%name) > 0) name = trim(name)//'_'//adjustl(cut%name)
        name = safe_name(name)
    end function cut_name

    !> The title of a cut: `STATION 20`, `WATERLINE -16 FLOOR`, `OBLIQUE FIREWALL`; of a plane
    !> without name the point it goes through.
    pure function cut_title(cut) result(title)
        type(cut_type), intent(in) :: cut !! any
        character(longest_title) :: title
        character(*), parameter :: titles(5) = [character(9) :: 'STATION', 'BUTT LINE', &
            'WATERLINE', 'OBLIQUE', 'PLANE']

        title = kind_words(cut%plane, titles, ' ')
        if (len_trim(cut%name) > 0) then
            title = trim(title)//' '//adjustl(cut%name)
        else if (cut%plane%kind > cut_kind%waterline) then
            title = trim(title)//' THROUGH STA '//shortest(cut%plane%through(1))//' BL '// &
                shortest(cut%plane%through(2))//' WL '//shortest(cut%plane%through(3))
        end if
    end function cut_title

    !> The word of the kind of a plane; of one across an axis also where it is.
    pure function kind_words(plane, words, gap) result(text)
        type(plane_type), intent(in) :: plane   !! of a cut
        character(*), intent(in) :: words(:)    !! of each of `cut_kind%...`
        character, intent(in) :: gap            !! between word and ordinate
        character(longest_title) :: text
        text = words(plane%kind)
        if (plane%kind <= cut_kind%waterline) &
            text = trim(text)//gap//shortest(plane%through(plane%kind))
    end function kind_words

    !> A text with `_` for every byte that a name may not have; never empty.
    pure function safe_name(text) result(name)
        character(*), intent(in) :: text !! any bytes
        character(max(1_i64, len_trim(text, i64))) :: name
        character(*), parameter :: letters = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ', &
            others = 'abcdefghijklmnopqrstuvwxyz0123456789-_.'

        name = limited(trim(text), letters//others, '_')
        if (name == '') name = '_'
    end function safe_name

    !> Gives the names in a drawing that stand there before, in any case of letters, the suffix
    !> `-2`, `-3` and so on: cuts first, then lines.
    pure subroutine make_unique(drawing)
        type(drawing_type), intent(inout) :: drawing !! its shapes have names
        type(taken_type) :: taken
        integer :: i, cuts, lines

        cuts = 0
        lines = 0
        if (allocated(drawing%cuts)) cuts = size(drawing%cuts)
        if (allocated(drawing%lines)) lines = size(drawing%lines)
        taken = new_taken(cuts + lines)
        do i = 1, cuts
            call take_name(taken, drawing%cuts(i)%name)
        end do
        do i = 1, lines
            call take_name(taken, drawing%lines(i)%name)
        end do
    end subroutine make_unique

end module export_drawing_name
