!> Tables of conic cards as handles of C; see `loft.h`.
module api_c_table
    use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_value
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_loc, &
        c_null_ptr, c_ptr
    use api_c_deck, only: deck_of
    use api_c_error, only: hand_over, refuse
    use api_loft, only: conic_table, deck_type, error_type, row_type
    implicit none (type, external)
    private

    public :: loft_deck_table, loft_table_free, loft_table_row_count, loft_table_rows

    !> A table.
    type :: table_type
        type(row_type), allocatable :: row(:) !! from point 1 to point 3
    end type table_type

    !> A row: `loft_row`.
    type, bind(c) :: c_row_type
        real(c_double) :: x             !! deck units
        real(c_double) :: y             !! deck units
        real(c_double) :: slope         !! dy/dx, infinite where vertical
        real(c_double) :: curvature     !! 1/deck unit
    end type c_row_type

contains

    !> The table of a conic card by steps of an axis; null where that fails.
    type(c_ptr) function loft_deck_table(deck, card, axis, error) bind(c, name='loft_deck_table') &
        result(handle)
        type(c_ptr), value :: deck          !! a handle
        integer(c_int), value :: card       !! from 1
        integer(c_int), value :: axis       !! 1: by steps of X, 2: of Y
        type(c_ptr), value :: error         !! gets why it fails, or null
        type(deck_type), pointer :: held
        type(table_type), pointer :: table
        type(error_type), allocatable :: trouble

        handle = c_null_ptr
        allocate (table)
        held => deck_of(deck)
        if (associated(held)) then
            call conic_table(held, int(card), int(axis), table%row, trouble)
        else
            call refuse('the deck', trouble)
        end if
        if (allocated(trouble)) then
            deallocate (table)
        else
            handle = c_loc(table)
        end if
        call hand_over(trouble, error)
    end function loft_deck_table

    !> Frees a table.
    subroutine loft_table_free(slot) bind(c, name='loft_table_free')
        type(c_ptr), value :: slot !! address of the handle, which becomes NULL
        type(table_type), pointer :: table
        type(c_ptr), pointer :: handle

        if (.not. c_associated(slot)) return
        call c_f_pointer(slot, handle)
        if (.not. c_associated(handle)) return
        call c_f_pointer(handle, table)
        deallocate (table)
        handle = c_null_ptr
    end subroutine loft_table_free

    !> The number of rows.
    integer(c_int) function loft_table_row_count(table) bind(c, name='loft_table_row_count') &
        result(count)
        type(c_ptr), value :: table !! a handle, or null
        type(table_type), pointer :: held

        count = 0_c_int
        if (.not. c_associated(table)) return
        call c_f_pointer(table, held)
        count = int(size(held%row), c_int)
    end function loft_table_row_count

    !> Copies rows of a table; how many there were.
    integer(c_int) function loft_table_rows(table, first, count, rows) &
        bind(c, name='loft_table_rows') result(copies)
        type(c_ptr), value :: table         !! a handle, or null
        integer(c_int), value :: first      !! the first of them, from 1
        integer(c_int), value :: count      !! how many at most
        type(c_ptr), value :: rows          !! room for so many, or null
        type(table_type), pointer :: held
        type(c_row_type), pointer :: place(:)
        integer :: i

        copies = 0_c_int
        if (.not. c_associated(table) .or. .not. c_associated(rows) .or. first < 1) return
        call c_f_pointer(table, held)
        copies = max(0_c_int, min(count, int(size(held%row), c_int) - (first - 1_c_int)))
        call c_f_pointer(rows, place, [copies])
        do i = 1, copies
            associate (row => held%row(first - 1 + i))
                place(i)%x = real(row%x, c_double)
                place(i)%y = real(row%y, c_double)
                place(i)%slope = real(row%slope%value, c_double)
                if (row%slope%is_vertical) &
                    place(i)%slope = ieee_value(place(i)%slope, ieee_positive_inf)
                place(i)%curvature = real(row%curvature, c_double)
            end associate
        end do
    end function loft_table_rows

end module api_c_table
