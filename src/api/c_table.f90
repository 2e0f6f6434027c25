!> Tables of conic cards as handles of C; see `loft.h`.
module api_c_table
    use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_value
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_loc, &
        c_null_ptr, c_ptr
    use api_c_deck, only: find_deck
    use api_c_error, only: hand_over
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
        type(c_ptr), value :: deck                      !! a handle
        integer(c_int), value :: card                   !! from 1
        integer(c_int), value :: axis                   !! 1: by steps of X, 2: of Y
        type(c_ptr), intent(out), optional :: error     !! gets why it fails
        type(deck_type), pointer :: held
        type(table_type), pointer :: table
        type(error_type), allocatable :: trouble

        handle = c_null_ptr
        allocate (table)
        call find_deck(deck, held, trouble)
        if (.not. allocated(trouble)) &
            call conic_table(held, int(card), int(axis), table%row, trouble)
        if (allocated(trouble)) then
            deallocate (table)
        else
            handle = c_loc(table)
        end if
        call hand_over(trouble, error)
    end function loft_deck_table

    !> Frees a table.
    subroutine loft_table_free(handle) bind(c, name='loft_table_free')
        type(c_ptr), intent(inout), optional :: handle !! becomes NULL
        type(table_type), pointer :: table

        if (.not. present(handle)) return
        table => table_of(handle)
        if (associated(table)) deallocate (table)
        handle = c_null_ptr
    end subroutine loft_table_free

    !> The number of rows.
    integer(c_int) function loft_table_row_count(table) bind(c, name='loft_table_row_count') &
        result(count)
        type(c_ptr), value :: table !! a handle, or null
        type(table_type), pointer :: held
        count = 0_c_int
        held => table_of(table)
        if (associated(held)) count = size(held%row, kind=c_int)
    end function loft_table_row_count

    !> Copies rows of a table; how many there were.
    integer(c_int) function loft_table_rows(table, first, count, rows) &
        bind(c, name='loft_table_rows') result(copies)
        type(c_ptr), value :: table                             !! a handle, or null
        integer(c_int), value :: first                          !! the first of them, from 1
        integer(c_int), value :: count                          !! how many at most
        type(c_row_type), intent(inout), optional :: rows(*)    !! room for so many
        type(table_type), pointer :: held
        integer :: i

        copies = 0_c_int
        held => table_of(table)
        if (.not. associated(held) .or. .not. present(rows) .or. first < 1) return
        copies = max(0_c_int, min(count, size(held%row, kind=c_int) - (first - 1_c_int)))
        do i = 1, copies
            rows(i) = c_row(held%row(first - 1 + i))
        end do
    end function loft_table_rows

    !> A row as C has it.
    type(c_row_type) function c_row(made) result(row)
        type(row_type), intent(in) :: made !! of a table
        row%x = real(made%x, c_double)
        row%y = real(made%y, c_double)
        row%slope = real(made%slope%value, c_double)
        if (made%slope%is_vertical) row%slope = ieee_value(row%slope, ieee_positive_inf)
        row%curvature = real(made%curvature, c_double)
    end function c_row

    !> The table behind a handle; not associated where the handle is null.
    function table_of(handle) result(table)
        type(c_ptr), intent(in) :: handle !! of C
        type(table_type), pointer :: table
        table => null()
        if (c_associated(handle)) call c_f_pointer(handle, table)
    end function table_of

end module api_c_table
