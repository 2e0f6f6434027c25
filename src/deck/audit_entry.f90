!> Cards of a printed table, taken into it: how it was printed, what is known besides.
module deck_audit_entry
    use base_fault, only: fault_list_type
    use deck_audit, only: add_entry, audit_entry_type, audit_table_type, entry_kind, known
    use deck_audit_layout, only: known_words, printing_words
    use deck_body_card, only: blame, blame_span, card_type, field_count, field_text
    use deck_body_value, only: is_filled, real_in, whole_in
    use deck_body_word, only: place_of, words_in
    implicit none (type, external)
    private

    public :: take_printing, take_known, take_between, take_rows, lacks_point

    !> Decimals that a figure may have.
    integer, parameter :: most_decimals = 9

contains

    !> Takes a PRINTED card.
    pure subroutine take_printing(table, card, faults)
        type(audit_table_type), intent(inout) :: table  !! gets it
        type(card_type), intent(in) :: card             !! the card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        table%printing = place_of(field_text(card, 2), words_in(printing_words)) - 1
        table%is_fie = field_text(card, 3) == 'FIE'
        if (.not. is_filled(card, 4)) return
        table%decimals = whole_in(card, 4)
        if (table%decimals <= most_decimals) return
        call blame(card, 4, 'a figure has at most 9 decimals', faults)
        table%decimals = -1
    end subroutine take_printing

    !> Takes an EXACT or ABOUT card.
    pure subroutine take_known(table, card, kind, faults)
        type(audit_table_type), intent(inout) :: table  !! gets them
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: kind                     !! one of `entry_kind%...`
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(audit_entry_type) :: entry
        integer :: i

        do i = 2, field_count(card), 2
            if (.not. (is_filled(card, i) .and. is_filled(card, i + 1))) then
                call blame_span(card, i, i + 1, 'a pair: what is known and its figure', faults)
                cycle
            end if
            entry = entry_of(card, i)
            entry%kind = kind
            entry%what = place_of(field_text(card, i), words_in(known_words))
            entry%text = field_text(card, i + 1)
            call add_known(table, entry, card, i, faults)
        end do
    end subroutine take_known

    !> Takes a BETWEEN card.
    pure subroutine take_between(table, card, faults)
        type(audit_table_type), intent(inout) :: table  !! gets it
        type(card_type), intent(in) :: card             !! the card
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(audit_entry_type) :: entry

        entry = entry_of(card, 2)
        entry%kind = entry_kind%between
        entry%what = place_of(field_text(card, 2), words_in(known_words))
        entry%low = real_in(card, 3)
        entry%high = real_in(card, 4)
        if (entry%low > entry%high) then
            call blame_span(card, 3, 4, 'LOW is more than HIGH', faults)
        else
            call add_known(table, entry, card, 2, faults)
        end if
    end subroutine take_between

    !> Adds a number known, which must be the first of its kind.
    pure subroutine add_known(table, entry, card, field, faults)
        type(audit_table_type), intent(inout) :: table  !! gets it
        type(audit_entry_type), intent(in) :: entry     !! the number
        type(card_type), intent(in) :: card             !! its card
        integer, intent(in) :: field                    !! its field
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        if (has_known(table, entry%what)) then
            call blame(card, field, field_text(card, field)//' is given twice', faults)
        else if (entry%what >= known%a .and. entry%kind == entry_kind%between) then
            call blame(card, field, 'a coefficient is given as it is printed: ABOUT or EXACT', &
                faults)
        else
            call add_entry(table, entry)
        end if
    end subroutine add_known

    !> Takes rows.
    pure subroutine take_rows(table, card, is_along_y, column, faults)
        type(audit_table_type), intent(inout) :: table  !! gets them
        type(card_type), intent(in) :: card             !! the card
        logical, intent(in) :: is_along_y               !! what ALONG said
        integer, intent(in) :: column                   !! and its column
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(audit_entry_type) :: entry
        integer :: i

        do i = 1, field_count(card), 2
            if (.not. is_filled(card, i)) then
                if (is_filled(card, i + 1)) call blame_span(card, i, i + 1, &
                    'a figure without the ordinate that it is for', faults)
                cycle
            end if
            entry = entry_of(card, i)
            entry%kind = entry_kind%row
            entry%is_along_y = is_along_y
            entry%column = column
            entry%along = real_in(card, i)
            entry%along_text = field_text(card, i)
            entry%text = field_text(card, i + 1)
            call add_entry(table, entry)
        end do
    end subroutine take_rows

    !> True where something is known of a point, 1 to 3, or of the slope there, but not its X.
    pure logical function lacks_point(table, point)
        type(audit_table_type), intent(in) :: table !! any
        integer, intent(in) :: point                !! which
        integer, parameter :: x(3) = [known%x1, known%x2, known%x3]

        lacks_point = (has_known(table, x(point) + 1) .or. has_slope(table, point)) .and. &
            .not. has_exactly(table, x(point))
    end function lacks_point

    !> True where something is known of the slope at a point.
    pure logical function has_slope(table, point)
        type(audit_table_type), intent(in) :: table !! any
        integer, intent(in) :: point                !! 1, 2 or 3
        has_slope = .false.
        if (point == 1) has_slope = has_known(table, known%s1)
        if (point == 3) has_slope = has_known(table, known%s3)
    end function has_slope

    !> True where a number is known.
    pure logical function has_known(table, what)
        type(audit_table_type), intent(in) :: table !! any
        integer, intent(in) :: what                 !! one of `known%...`
        has_known = .false.
        if (table%count > 0) has_known = any(table%entry(:table%count)%what == what)
    end function has_known

    !> True where a number is known as it was punched, or as it is printed.
    pure logical function has_exactly(table, what)
        type(audit_table_type), intent(in) :: table !! any
        integer, intent(in) :: what                 !! one of `known%...`
        has_exactly = .false.
        if (table%count > 0) has_exactly = any(table%entry(:table%count)%what == what .and. &
            table%entry(:table%count)%kind /= entry_kind%between)
    end function has_exactly

    !> An entry with its place in the file.
    pure type(audit_entry_type) function entry_of(card, field) result(entry)
        type(card_type), intent(in) :: card !! the card
        integer, intent(in) :: field        !! first field of the entry
        entry%line = card%sheet(card%field(field)%sheet)%line
    end function entry_of

end module deck_audit_entry
