!> What is in a cut, for C; see `loft.h`.
module api_c_points
    use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_value
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_int32_t, &
        c_ptr, c_size_t
    use api_c_cut, only: cut_of
    use api_c_text, only: copied
    use api_loft, only: cut_type, point_type
    implicit none (type, external)
    private

    public :: loft_cut_kind, loft_cut_name, loft_cut_point_count, loft_cut_points
    public :: loft_cut_outline_count, loft_cut_outline_is_closed, loft_cut_section_name
    public :: loft_cut_note_count, loft_cut_note

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

    !> The name of a cut.
    integer(c_size_t) function loft_cut_name(cut, room, bytes) &
        bind(c, name='loft_cut_name') result(length)
        type(c_ptr), value :: cut               !! a handle, or null
        type(c_ptr), value :: room              !! where it goes, or null
        integer(c_size_t), value :: bytes       !! there
        type(cut_type), pointer :: held
        character(:), allocatable :: text

        text = ''
        held => cut_of(cut)
        if (associated(held)) then
            text = trim(held%name)
        end if
        length = copied(text, room, bytes)
    end function loft_cut_name

    !> The number of points.
    integer(c_int) function loft_cut_point_count(cut) &
        bind(c, name='loft_cut_point_count') result(count)
        type(c_ptr), value :: cut !! a handle, or null
        type(cut_type), pointer :: held
        count = 0_c_int
        held => cut_of(cut)
        if (associated(held)) count = int(size(held%points), c_int)
    end function loft_cut_point_count

    !> The number of outlines.
    integer(c_int) function loft_cut_outline_count(cut) &
        bind(c, name='loft_cut_outline_count') result(count)
        type(c_ptr), value :: cut !! a handle, or null
        type(cut_type), pointer :: held
        count = 0_c_int
        held => cut_of(cut)
        if (associated(held)) count = int(size(held%is_closed), c_int)
    end function loft_cut_outline_count

    !> The number of notes.
    integer(c_int) function loft_cut_note_count(cut) &
        bind(c, name='loft_cut_note_count') result(count)
        type(c_ptr), value :: cut !! a handle, or null
        type(cut_type), pointer :: held
        count = 0_c_int
        held => cut_of(cut)
        if (associated(held)) count = int(size(held%notes), c_int)
    end function loft_cut_note_count

    !> 1 where an outline comes back to its first point.
    integer(c_int) function loft_cut_outline_is_closed(cut, outline) &
        bind(c, name='loft_cut_outline_is_closed') result(is_closed)
        type(c_ptr), value :: cut           !! a handle, or null
        integer(c_int), value :: outline    !! from 1
        type(cut_type), pointer :: held

        is_closed = 0_c_int
        held => cut_of(cut)
        if (.not. associated(held)) return
        if (outline < 1 .or. outline > size(held%is_closed)) return
        is_closed = merge(1_c_int, 0_c_int, held%is_closed(outline))
    end function loft_cut_outline_is_closed

    !> The name of a section that points are of.
    integer(c_size_t) function loft_cut_section_name(cut, section, room, bytes) &
        bind(c, name='loft_cut_section_name') result(length)
        type(c_ptr), value :: cut               !! a handle, or null
        integer(c_int), value :: section             !! from 1
        type(c_ptr), value :: room              !! where it goes, or null
        integer(c_size_t), value :: bytes       !! there
        type(cut_type), pointer :: held
        character(:), allocatable :: text

        text = ''
        held => cut_of(cut)
        if (associated(held)) then
            if (section >= 1 .and. section <= size(held%sections)) &
                text = trim(held%sections(section))
        end if
        length = copied(text, room, bytes)
    end function loft_cut_section_name

    !> A note: what the user will want to know of a cut.
    integer(c_size_t) function loft_cut_note(cut, number, room, bytes) &
        bind(c, name='loft_cut_note') result(length)
        type(c_ptr), value :: cut               !! a handle, or null
        integer(c_int), value :: number              !! of the note, from 1
        type(c_ptr), value :: room              !! where it goes, or null
        integer(c_size_t), value :: bytes       !! there
        type(cut_type), pointer :: held
        character(:), allocatable :: text

        text = ''
        held => cut_of(cut)
        if (associated(held)) then
            if (number >= 1 .and. number <= size(held%notes)) &
                text = held%notes(number)%message
        end if
        length = copied(text, room, bytes)
    end function loft_cut_note

    !> Copies points of a cut; how many there were.
    integer(c_int) function loft_cut_points(cut, first, count, points) &
        bind(c, name='loft_cut_points') result(copies)
        type(c_ptr), value :: cut           !! a handle, or null
        integer(c_int), value :: first      !! the first of them, from 1
        integer(c_int), value :: count      !! how many at most
        type(c_ptr), value :: points        !! room for so many, or null
        type(cut_type), pointer :: held
        type(c_point_type), pointer :: place(:)
        integer :: i

        copies = 0_c_int
        held => cut_of(cut)
        if (.not. associated(held) .or. .not. c_associated(points) .or. first < 1) return
        copies = max(0_c_int, min(count, int(size(held%points), c_int) - (first - 1_c_int)))
        call c_f_pointer(points, place, [copies])
        do i = 1, copies
            place(i) = point_of(held%points(first - 1 + i))
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

end module api_c_points
