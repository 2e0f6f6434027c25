!> The tables that a conic card asks for, as rows: made once, printed as listing, CSV or picture.
module body_card_tables
    use base_decimal, only: grid_type, new_grid
    use base_error, only: error_type
    use base_fault, only: fault_list_type, new_fault, severity
    use deck_conic_card, only: conic_card_type
    use deck_layout, only: conic, conic_fields
    use geom_arc, only: arc_type
    use geom_contour, only: contour_of, contour_point_type
    implicit none (type, external)
    private

    public :: card_table_type, tables_of_card

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
        integer :: before

        before = faults%count
        allocate (tables(0))
        if (card%wants_x_table()) call add_table(card, arc, 1, tables, faults)
        if (card%wants_y_table()) call add_table(card, arc, 2, tables, faults)
        call faults%place(before, card%line, card%image)
    end subroutine tables_of_card

    !> Makes one table and adds it to the others.
    subroutine add_table(card, arc, axis, tables, faults)
        type(conic_card_type), intent(in) :: card                        !! a readable card
        type(arc_type), intent(in) :: arc                                !! its arc
        integer, intent(in) :: axis                                      !! 1: steps of X, 2: of Y
        type(card_table_type), allocatable, intent(inout) :: tables(:)   !! gets the table
        type(fault_list_type), intent(inout) :: faults                   !! what is wrong is added
        type(card_table_type) :: table
        type(grid_type) :: grid
        type(error_type), allocatable :: error
        integer :: start, step

        start = merge(conic%x1, conic%y1, axis == 1)
        step = merge(conic%xi, conic%yi, axis == 1)
        if (.not. card%steps_well(step)) return
        table%axis = axis
        call new_grid(card%value(start), card%value(step), grid, error)
        if (.not. allocated(error)) call contour_of(arc, axis, grid, table%row, error)
        if (allocated(error)) then
            associate (field => conic_fields(step))
                call faults%add(new_fault(severity%error, field%first, field%last, error%message))
            end associate
        else
            tables = [tables, table]
        end if
    end subroutine add_table

end module body_card_tables
