!> An audit as comma-separated values, a row a figure:
!>
!>     table,view,at,what,along,printed,computed,low,high,residual,verdict,corrected,slip,sure
!>
!> `what` is `row` or a field of a card; `along` its X, or `Y` and its Y. `low` and `high` are what
!> the good figures allow, `residual` printed less computed in units of the last place.
module audit_csv
    use audit_deck, only: deck_audit_type
    use audit_finding, only: finding_type, verdict, verdict_name
    use audit_item, only: entry_of, item_type
    use audit_words, only: corrected, is_doubtful, reason
    use base_digits, only: shortest
    use base_output, only: output_type
    use deck_audit, only: audit_entry_type, entry_kind, known
    use deck_audit_layout, only: known_words, view_words
    use deck_body_word, only: words_in
    implicit none (type, external)
    private

    public :: print_audit_csv

contains

    !> Prints the header and a row for each figure.
    subroutine print_audit_csv(found, out)
        type(deck_audit_type), intent(in) :: found  !! what was found
        type(output_type), intent(inout) :: out     !! where it goes
        integer :: i, k

        call out%line('table,view,at,what,along,printed,computed,low,high,residual,verdict,'// &
            'corrected,slip,sure')
        do i = 1, size(found%item)
            associate (item => found%item(i))
                if (.not. item%is_audited) cycle
                do k = 1, size(item%entry)
                    if (item%entry(k) > 0) call out%line(row(item, item%table%entry( &
                        item%entry(k)), item%audit%finding(k)))
                end do
                do k = 1, 2
                    if (found%step(k, i)%verdict /= verdict%none) call out%line(row(item, &
                        item%table%entry(entry_of(item%table, known%xi + k - 1)), &
                        found%step(k, i)))
                end do
            end associate
        end do
    end subroutine print_audit_csv

    !> The row of a figure.
    pure function row(item, entry, finding) result(text)
        type(item_type), intent(in) :: item             !! its table
        type(audit_entry_type), intent(in) :: entry     !! as the deck has it
        type(finding_type), intent(in) :: finding       !! what was found
        character(:), allocatable :: text
        character(8), allocatable :: word(:)

        word = words_in(view_words)
        text = trim(item%table%name)//','//trim(word(item%table%view))//','// &
            trim(item%table%at_text)//','
        if (entry%kind == entry_kind%row) then
            text = text//'row,'//trim(merge('Y ', '  ', entry%is_along_y))
            if (entry%is_along_y) text = text//' '
            text = text//trim(entry%along_text)
        else
            word = words_in(known_words)
            text = text//trim(word(entry%what))//','
        end if
        text = text//','//trim(entry%text)//','
        if (finding%is_reached) then
            text = text//shortest(finding%computed)//','//shortest(finding%low)//','// &
                shortest(finding%high)//','//shortest(finding%residual)
        else
            text = text//',,,'
        end if
        text = text//','//verdict_name(finding%verdict)//','//corrected(finding)//','// &
            reason(finding)//','
        if (is_doubtful(finding)) text = text//shortest(finding%sure)
    end function row

end module audit_csv
