!> Names and titles of the shapes of a drawing. A name serves as file name, layer and program name,
!> so it has but letters, figures, `-`, `_` and `.`; a title is for people.
module export_drawing_name
    use base_digits, only: shortest
    use base_kinds, only: dp
    use base_text, only: limited, to_text, upper
    use cut_outline, only: cut_type
    use cut_plane, only: cut_kind, plane_type
    use export_drawing, only: drawing_type, shape_type
    implicit none (type, external)
    private

    public :: cut_name, cut_title, safe_name, make_unique

contains

    !> The name of a cut: `STA_20`, `BL_-4.5`, `WL_-16_FLOOR`, `OBL_FIREWALL`, `PLANE`.
    pure function cut_name(cut) result(name)
        type(cut_type), intent(in) :: cut   !! any
        character(:), allocatable :: name
        character(*), parameter :: names(5) = [character(5) :: 'STA', 'BL', 'WL', 'OBL', 'PLANE']

        name = kind_words(cut%plane, names, '_')
        if (len_trim(cut%name) > 0) name = name//'_'//trim(adjustl(cut%name))
        name = safe_name(name)
    end function cut_name

    !> The title of a cut: `STATION 20`, `WATERLINE -16 FLOOR`, `OBLIQUE FIREWALL`; of a plane
    !> without name the point it goes through.
    pure function cut_title(cut) result(title)
        type(cut_type), intent(in) :: cut !! any
        character(:), allocatable :: title
        character(*), parameter :: titles(5) = [character(9) :: 'STATION', 'BUTT LINE', &
            'WATERLINE', 'OBLIQUE', 'PLANE']

        title = kind_words(cut%plane, titles, ' ')
        if (len_trim(cut%name) > 0) then
            title = title//' '//trim(adjustl(cut%name))
        else if (cut%plane%kind > cut_kind%waterline) then
            title = title//' THROUGH STA '//shortest(cut%plane%through(1))//' BL '// &
                shortest(cut%plane%through(2))//' WL '//shortest(cut%plane%through(3))
        end if
    end function cut_title

    !> The word of the kind of a plane; of one across an axis also where it is.
    pure function kind_words(plane, words, gap) result(text)
        type(plane_type), intent(in) :: plane   !! of a cut
        character(*), intent(in) :: words(:)    !! of each of `cut_kind%...`
        character, intent(in) :: gap            !! between word and ordinate
        character(:), allocatable :: text
        text = trim(words(plane%kind))
        if (plane%kind <= cut_kind%waterline) &
            text = text//gap//shortest(plane%through(plane%kind))
    end function kind_words

    !> A text with `_` for every byte that a name may not have; never empty.
    pure function safe_name(text) result(name)
        character(*), intent(in) :: text !! any bytes
        character(:), allocatable :: name
        character(*), parameter :: letters = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ', &
            others = 'abcdefghijklmnopqrstuvwxyz0123456789-_.'

        name = limited(trim(text), letters//others, '_')
        if (len(name) == 0) name = '_'
    end function safe_name

    !> Gives the names in a drawing that stand there before, in any case of letters, the suffix
    !> `-2`, `-3` and so on: cuts first, then lines.
    pure subroutine make_unique(drawing)
        type(drawing_type), intent(inout) :: drawing !! its shapes have names
        type(shape_type) :: none(0)
        integer :: i

        if (allocated(drawing%cuts)) then
            do i = 1, size(drawing%cuts)
                call settle(drawing%cuts(:i - 1), none, drawing%cuts(i)%name)
            end do
        end if
        if (.not. allocated(drawing%lines)) return
        do i = 1, size(drawing%lines)
            if (allocated(drawing%cuts)) then
                call settle(drawing%cuts, drawing%lines(:i - 1), drawing%lines(i)%name)
            else
                call settle(none, drawing%lines(:i - 1), drawing%lines(i)%name)
            end if
        end do
    end subroutine make_unique

    !> Gives a name the suffix that makes it another than those before it.
    pure subroutine settle(cuts, lines, name)
        type(shape_type), intent(in) :: cuts(:)                     !! before it
        type(shape_type), intent(in) :: lines(:)                    !! before it, too
        character(:), allocatable, intent(inout) :: name            !! may get a suffix
        character(:), allocatable :: asked
        integer :: count

        asked = name
        count = 1
        do while (any(is_named(cuts, name)) .or. any(is_named(lines, name)))
            count = count + 1
            name = asked//'-'//to_text(count)
        end do
    end subroutine settle

    !> True for a shape of a name, whatever the case of its letters.
    elemental logical function is_named(shape, name)
        type(shape_type), intent(in) :: shape   !! has a name
        character(*), intent(in) :: name        !! to compare with
        is_named = upper(shape%name) == upper(name)
    end function is_named

end module export_drawing_name
