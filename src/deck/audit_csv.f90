!> Printed tables as comma-separated values, a row a figure:
!>
!>     table,view,at,what,along,printed
!>     MHB,SIDE,,exact X1,,-30.0
!>     MHB,SIDE,,x,-25.,-9.443
!>
!> `what` is `x` or `y`, which a row is along, with a 2 behind it for the second column of the page;
!> or what a card says: `exact S1`, `about S3`, `between S3` (from `along` to `printed`),
!> `printed 1970`, `conics 2`, `shift 100.`; or `lines LCL LSH MHB`, the control
!> lines of a section, - for none.
!> A table ends where another begins. Further columns are passed over, so that what
!> `loft audit --format csv` wrote can be read. Cells may stand in quotes, as spreadsheets write
!> them; there is no comma in any that is read.
module deck_audit_csv
    use base_error, only: error_type
    use base_fault, only: fault_list_type
    use base_text, only: columns, to_text
    use deck_audit, only: audit_deck_type
    use deck_audit_layout, only: audit_card
    use deck_audit_state, only: close_table, state_type, take_as, take_card
    use deck_body_card, only: blame, card_type, field_text, field_type, free_columns, new_card
    use deck_body_stream, only: sort_by_line
    use deck_source, only: line_type, source_type
    implicit none (type, external)
    private

    public :: read_audit_csv

    !> Cells of a row, and which is which.
    integer, parameter :: cells = 6, table_cell = 1, view_cell = 2, at_cell = 3, what_cell = 4, &
        along_cell = 5, printed_cell = 6

contains

    !> Reads tables to the end of a file.
    !>
    !> Fails with `cause%file_trouble` where the source can't be read.
    subroutine read_audit_csv(source, deck, faults, error)
        type(source_type), intent(inout) :: source          !! where the lines come from
        type(audit_deck_type), intent(out) :: deck          !! the tables
        type(fault_list_type), intent(inout) :: faults      !! what is wrong is added
        type(error_type), allocatable, intent(out) :: error !! see above
        type(state_type) :: state
        type(line_type) :: line
        character(:), allocatable :: heading
        logical :: has_line
        integer :: before

        before = faults%count
        heading = ''
        call source%next_line(line, has_line, error)
        do while (has_line .and. .not. allocated(error))
            call source%next_line(line, has_line, error)
            if (.not. has_line .or. allocated(error)) exit
            if (line%filled > 0) call take_row(state, line, heading, faults)
        end do
        if (allocated(error)) return
        call close_table(state, faults)
        deck = state%deck
        deck%title = ''
        deck%units = 'INCHES'
        call sort_by_line(faults, before + 1)
    end subroutine read_audit_csv

    !> Takes a row of the file.
    subroutine take_row(state, line, heading, faults)
        type(state_type), intent(inout) :: state                    !! the tables so far
        type(line_type), intent(in) :: line                         !! the row
        character(:), allocatable, intent(inout) :: heading         !! of the table being read
        type(fault_list_type), intent(inout) :: faults              !! what is wrong is added
        type(card_type) :: row, card
        character(:), allocatable :: table

        row = new_card(line)
        if (size(row%field) < what_cell) then
            call blame(row, 1, 'a row has '//to_text(cells)//' cells: table,view,at,what,along,'// &
                'printed', faults)
            return
        end if
        do while (size(row%field) < cells)
            row%field = [row%field, field_type(1, line%filled + 1, line%filled)]
        end do
        row%field = between_quotes(row)
        table = field_text(row, table_cell)//','//field_text(row, view_cell)//','// &
            field_text(row, at_cell)
        if (table /= heading) then
            card = row
            card%field = row%field([what_cell, table_cell, view_cell, at_cell])
            call take_as(state, card, audit_card%audit, faults)
            heading = table
        end if
        card = row
        card%field = words_of_cell(row, what_cell)
        call take_what(state, row, card, faults)
    end subroutine take_row

    !> The cells of a row, those in quotes without them.
    pure function between_quotes(row) result(field)
        type(card_type), intent(in) :: row !! a row
        type(field_type), allocatable :: field(:)
        integer :: i

        allocate (field, source=row%field)
        do i = 1, size(field)
            associate (cell => field(i), image => row%sheet(1)%image)
                if (cell%last <= cell%first) cycle
                if (image(cell%first:cell%first) /= '"' .or. image(cell%last:cell%last) /= '"') &
                    cycle
                cell = field_type(1, cell%first + 1, cell%last - 1)
            end associate
        end do
    end function between_quotes

    !> Takes what a row says, `what` cut into words.
    subroutine take_what(state, row, card, faults)
        type(state_type), intent(inout) :: state        !! the tables so far
        type(card_type), intent(in) :: row              !! the row
        type(card_type), intent(inout) :: card          !! the same with the words of `what`
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        integer :: i

        select case (field_text(card, 1))
        case ('X', 'Y')
            state%is_along_y = field_text(card, 1) == 'Y'
            state%column = 1
            if (field_text(card, 2) == '2') state%column = 2
            card%field = row%field([along_cell, printed_cell])
            call take_as(state, card, audit_card%row, faults)
        case ('LINES')
            do i = 1, 3
                state%table%control(i) = field_text(card, 1 + i)
                if (field_text(card, 1 + i) == '-') state%table%control(i) = ''
            end do
        case ('EXACT', 'ABOUT')
            card%field = [card%field, row%field(printed_cell)]
            call take_card(state, card, faults)
        case ('BETWEEN')
            card%field = [card%field, row%field(along_cell), row%field(printed_cell)]
            call take_card(state, card, faults)
        case ('PRINTED', 'CONICS', 'SHIFT')
            call take_card(state, card, faults)
        case default
            call blame(row, what_cell, 'WHAT is x, y, exact, about, between, lines, printed, '// &
                'conics or shift', faults)
        end select
    end subroutine take_what

    !> The words of a cell as fields.
    pure function words_of_cell(row, cell) result(field)
        type(card_type), intent(in) :: row  !! a row
        integer, intent(in) :: cell         !! which cell
        type(field_type), allocatable :: field(:)
        character(:), allocatable :: image
        integer :: first, last

        allocate (field(0))
        image = columns(row%sheet(1)%image, 1, free_columns)
        first = row%field(cell)%first
        do while (first <= row%field(cell)%last)
            last = first - 2 + scan(image(first:)//' ', ' ')
            last = min(last, row%field(cell)%last)
            if (last >= first) field = [field, field_type(1, first, last)]
            first = max(last, first) + 1
        end do
        if (size(field) == 0) field = [row%field(cell)]
    end function words_of_cell

end module deck_audit_csv
