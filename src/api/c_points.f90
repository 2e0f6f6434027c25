!> What is in a cut, for C; see `loft.h`.
module api_c_points
    use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_value
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int, c_int32_t, c_ptr, c_size_t
    use api_c_cut, only: cut_of
    use api_c_text, only: copied
    use api_loft, only: cut_type, point_type
    implicit none (type, external)
    private

    public :: loft_cut_kind, loft_cut_name, loft_cut_point_count, loft_cut_points
    public :: loft_cut_outline_count, loft_cut_outline_is_closed, loft_cut_section_name
    public :: loft_cut_note_count, loft_cut_note

    !> What a cut has one or many of.
    type :: thing_list
        integer :: name = 1 !! one
        integer :: point = 2
        integer :: outline = 3
        integer :: section = 4
        integer :: note = 5
    end type thing_list

    !> The same by name: `thing%point`.
    type(thing_list), parameter :: thing = thing_list()

    !> A point: `loft_point`.
    type, bind(c) :: c_point_type
        real(c_double) :: at(3)         !! STA, BL, WL, deck units
        real(c_double) :: uv(2)         !! true-shape coordinates, deck units
        real(c_double) :: slope         !! dv/du, infinite where vertical
        real(c_double) :: curvature     !! 1/deck unit
        real(c_double) :: normal(3)     !! outward unit normal of the skin
        real(c_double) :: bevel         !! degrees
        integer(c_int32_t) :: outline   !! from 1
        integer(c_int32_t) :: section   !! from 1
        integer(c_int32_t) :: has       !! 1: slope, 2: curvature, 4: normal and bevel
        integer(c_int32_t) :: spare     !! 0
    end type c_point_type

contains

    !> The kind of a cut, from 1; 0 for NULL.
    integer(c_int) function loft_cut_kind(cut) bind(c, name='loft_cut_kind') result(kind_of)
        type(c_ptr), value :: cut !! a handle, or null
        type(cut_type), pointer :: held
        kind_of = 0_c_int
        held => cut_of(cut)
        if (associated(held)) kind_of = int(held%kind, c_int)
    end function loft_cut_kind

    !> The number of points.
    integer(c_int) function loft_cut_point_count(cut) &
        bind(c, name='loft_cut_point_count') result(count)
        type(c_ptr), value :: cut !! a handle, or null
        count = count_of(cut, thing%point)
    end function loft_cut_point_count

    !> The number of outlines.
    integer(c_int) function loft_cut_outline_count(cut) &
        bind(c, name='loft_cut_outline_count') result(count)
        type(c_ptr), value :: cut !! a handle, or null
        count = count_of(cut, thing%outline)
    end function loft_cut_outline_count

    !> The number of notes.
    integer(c_int) function loft_cut_note_count(cut) &
        bind(c, name='loft_cut_note_count') result(count)
        type(c_ptr), value :: cut !! a handle, or null
        count = count_of(cut, thing%note)
    end function loft_cut_note_count

    !> 1 where an outline comes back to its first point.
    integer(c_int) function loft_cut_outline_is_closed(cut, outline) &
        bind(c, name='loft_cut_outline_is_closed') result(is_closed)
        type(c_ptr), value :: cut           !! a handle, or null
        integer(c_int), value :: outline    !! from 1
        type(cut_type), pointer :: held

        is_closed = 0_c_int
        if (outline < 1 .or. outline > count_of(cut, thing%outline)) return
        held => cut_of(cut)
        is_closed = merge(1_c_int, 0_c_int, held%is_closed(outline))
    end function loft_cut_outline_is_closed

    !> The name of a cut.
    integer(c_size_t) function loft_cut_name(cut, room, bytes) &
        bind(c, name='loft_cut_name') result(length)
        type(c_ptr), value :: cut                                   !! a handle, or null
        character(kind=c_char), intent(inout), optional :: room(*)  !! where it goes
        integer(c_size_t), value :: bytes                           !! there
        length = said(cut, thing%name, 1_c_int, room, bytes)
    end function loft_cut_name

    !> The name of a section that points are of.
    integer(c_size_t) function loft_cut_section_name(cut, section, room, bytes) &
        bind(c, name='loft_cut_section_name') result(length)
        type(c_ptr), value :: cut                                   !! a handle, or null
        integer(c_int), value :: section                            !! from 1
        character(kind=c_char), intent(inout), optional :: room(*)  !! where it goes
        integer(c_size_t), value :: bytes                           !! there
        length = said(cut, thing%section, section, room, bytes)
    end function loft_cut_section_name

    !> A note: what the user will want to know of a cut.
    integer(c_size_t) function loft_cut_note(cut, number, room, bytes) &
        bind(c, name='loft_cut_note') result(length)
        type(c_ptr), value :: cut                                   !! a handle, or null
        integer(c_int), value :: number                             !! of the note, from 1
        character(kind=c_char), intent(inout), optional :: room(*)  !! where it goes
        integer(c_size_t), value :: bytes                           !! there
        length = said(cut, thing%note, number, room, bytes)
    end function loft_cut_note

    !> Copies points of a cut; how many there were.
    integer(c_int) function loft_cut_points(cut, first, count, points) &
        bind(c, name='loft_cut_points') result(copies)
        type(c_ptr), value :: cut                                   !! a handle, or null
        integer(c_int), value :: first                              !! the first of them, from 1
        integer(c_int), value :: count                              !! how many at most
        type(c_point_type), intent(inout), optional :: points(*)    !! room for so many
        type(cut_type), pointer :: held
        integer :: i

        copies = 0_c_int
        if (.not. present(points) .or. first < 1) return
        copies = max(0_c_int, min(count, count_of(cut, thing%point) - (first - 1_c_int)))
        held => cut_of(cut)
        do i = 1, copies
            points(i) = point_of(held%points(first - 1 + i))
        end do
    end function loft_cut_points

    !> A point as C has it.
    type(c_point_type) function point_of(made) result(point)
        type(point_type), intent(in) :: made !! a point of a cut
        point%at = real(made%at, c_double)
        point%uv = real(made%uv, c_double)
        point%slope = real(made%slope, c_double)
        if (made%is_vertical) point%slope = ieee_value(point%slope, ieee_positive_inf)
        point%curvature = real(made%curvature, c_double)
        point%normal = real(made%normal, c_double)
        point%bevel = real(made%bevel, c_double)
        point%outline = int(made%outline, c_int32_t)
        point%section = int(made%section, c_int32_t)
        point%has = int(merge(1, 0, made%has_slope) + merge(2, 0, made%has_curvature) + &
            merge(4, 0, made%has_normal), c_int32_t)
        point%spare = 0_c_int32_t
    end function point_of

    !> How many of a thing a cut has; none where the handle is null.
    integer(c_int) function count_of(handle, what) result(count)
        type(c_ptr), intent(in) :: handle   !! of C
        integer, intent(in) :: what         !! one of `thing%...`
        type(cut_type), pointer :: cut

        count = 0_c_int
        cut => cut_of(handle)
        if (.not. associated(cut)) return
        select case (what)
        case (thing%name)
            count = 1_c_int
        case (thing%point)
            count = size(cut%points, kind=c_int)
        case (thing%outline)
            count = size(cut%is_closed, kind=c_int)
        case (thing%section)
            count = size(cut%sections, kind=c_int)
        case default
            count = size(cut%notes, kind=c_int)
        end select
    end function count_of

    !> Copies what a cut says of a thing; nothing where it has none of that number.
    integer(c_size_t) function said(handle, what, number, room, bytes) result(length)
        type(c_ptr), intent(in) :: handle                           !! of C
        integer, intent(in) :: what                                 !! one of `thing%...`
        integer(c_int), intent(in) :: number                        !! which, from 1
        character(kind=c_char), intent(inout), optional :: room(*)  !! where it goes
        integer(c_size_t), intent(in) :: bytes                      !! there
        type(cut_type), pointer :: cut
        character(:), allocatable :: words

        words = ''
        cut => cut_of(handle)
        if (number >= 1 .and. number <= count_of(handle, what)) then
            select case (what)
            case (thing%name)
                words = trim(cut%name)
            case (thing%section)
                words = trim(cut%sections(number))
            case default
                words = cut%notes(number)%message
            end select
        end if
        length = copied(words, room, bytes)
    end function said

end module api_c_points
