!> The tables that a conic card asks for, as rows: made once, printed as listing, CSV or picture.
module body_card_tables
    use base_decimal, only: grid_type, new_grid
    use base_error, only: error_type
    use base_fault, only: fault_list_type, new_fault, severity
    use deck_conic_card, only: conic_card_type
    use deck_layout, only: conic, conic_fields
    use geom_arc, only: arc_type
    use geom_contour, only: contour_point_type, contour_type, new_contour
    implicit none (type, external)
    private

    public :: card_table_type, contours_of_card, tables_of_card

    !> One table of a card.
    type :: card_table_type
        integer :: axis = 1                                 !! 1: steps of X, 2: steps of Y
        type(contour_point_type), allocatable :: row(:)     !! from point 1 to point 3
    end type card_table_type

contains

    !> The tables of a card, X before Y. A blank XI beside an ITYP that is not zero means a Y table
    !> alone. A table whose increment is at fault is left out; the fault stands on the card already,
    !> or, where the table would be too long, is added here.
    subroutine tables_of_card(card, arc, tables, faults)
        type(conic_card_type), intent(in) :: card                       !! a readable card
        type(arc_type), intent(in) :: arc                               !! its arc
        type(card_table_type), allocatable, intent(out) :: tables(:)    !! none, one or two
        type(fault_list_type), intent(inout) :: faults                  !! what is wrong is added
        type(contour_type), allocatable :: contours(:)
        integer :: i

        allocate (contours(0))
        call contours_of_card(card, arc, contours, faults)
        allocate (tables(size(contours)))
        do i = 1, size(contours)
            tables(i)%axis = contours(i)%axis
            call contours(i)%make_rows(tables(i)%row)
        end do
    end subroutine tables_of_card

    !> The same tables, their rows not made yet.
    subroutine contours_of_card(card, arc, contours, faults)
        type(conic_card_type), intent(in) :: card                       !! a readable card
        type(arc_type), intent(in) :: arc                               !! its arc
        type(contour_type), allocatable, intent(out) :: contours(:)     !! none, one or two
        type(fault_list_type), intent(inout) :: faults                  !! what is wrong is added
        type(contour_type) :: found(2)
        logical :: is_asked(2), is_made(2)
        integer :: axis, before, next

        before = faults%count
        is_asked = [card%wants_x_table(), card%wants_y_table()]
        do axis = 1, size(found)
            is_made(axis) = is_asked(axis)
            if (is_asked(axis)) call make_contour(card, arc, axis, found(axis), is_made(axis), &
                faults)
        end do
        call faults%place(before, card%line, card%image)
        allocate (contours(count(is_made)))
        next = 1
        do axis = 1, size(found)
            if (.not. is_made(axis)) cycle
            contours(next) = found(axis)
            next = next + 1
        end do
    end subroutine contours_of_card

    !> Prepares one table.
    subroutine make_contour(card, arc, axis, contour, is_made, faults)
        type(conic_card_type), intent(in) :: card       !! a readable card
        type(arc_type), intent(in) :: arc               !! its arc
        integer, intent(in) :: axis                     !! 1: steps of X, 2: of Y
        type(contour_type), intent(out) :: contour      !! the table, where there is one
        logical, intent(out) :: is_made                 !! there is one
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(grid_type) :: grid
        type(error_type), allocatable :: error
        integer :: start, step

        start = merge(conic%x1, conic%y1, axis == 1)
        step = merge(conic%xi, conic%yi, axis == 1)
        is_made = .false.
        if (.not. card%steps_well(step)) return
        call new_grid(card%value(start), card%value(step), grid, error)
        if (.not. allocated(error)) call new_contour(arc, axis, grid, contour, error)
        is_made = .not. allocated(error)
        if (is_made) return
        associate (field => conic_fields(step))
            call faults%add(new_fault(severity%error, field%first, field%last, error%message))
        end associate
    end subroutine make_contour

end module body_card_tables
