!> An audit as comma-separated values, a row a figure:
!>
!>     table,view,at,what,along,printed,computed,low,high,residual,verdict,corrected,slip,sure
!>
!> The first six cells are those that `deck_audit_csv` reads. `low` and `high` are what the good
!> figures allow, `residual` is printed less computed in units of the last place.
module audit_csv
    use audit_deck, only: deck_audit_type
    use audit_finding, only: finding_type, verdict, verdict_name
    use audit_item, only: item_type
    use audit_words, only: corrected, is_doubtful, reason
    use base_digits, only: shortest
    use base_kinds, only: dp, i64
    use base_output, only: output_type
    use base_text, only: to_text
    use deck_audit, only: audit_entry_type, entry_kind, entry_length, known
    use deck_audit_layout, only: known_words, printing_words, view_words
    use deck_body_word, only: word_length, words_in
    implicit none (type, external)
    private

    public :: print_audit_csv

    !> What the rows of the file say, by `entry_kind`.
    character(7), parameter :: kinds(4) = [character(7) :: 'row', 'exact', 'about', 'between']

contains

    !> Prints the header and a row for each figure.
    subroutine print_audit_csv(found, out)
        type(deck_audit_type), intent(in) :: found  !! what was found
        type(output_type), intent(inout) :: out     !! where it goes
        integer :: i

        call out%line('table,view,at,what,along,printed,computed,low,high,residual,verdict,'// &
            'corrected,slip,sure')
        do i = 1, size(found%item)
            call print_head(found%item(i), out)
            call print_entries(found%item(i), found%step(:, i), out)
        end do
    end subroutine print_audit_csv

    !> Prints what cards say of a whole table.
    subroutine print_head(item, out)
        type(item_type), intent(in) :: item         !! the table
        type(output_type), intent(inout) :: out     !! where it goes
        integer, parameter :: ways = 5
        character(8) :: word(ways)
        character(*), parameter :: nothing = ',,,,,,,,,,'

        associate (table => item%table)
            word = words_in(printing_words)
            if (any(table%control /= '')) call out%line(trim(front(item))//'lines '// &
                name_or_dash(table%control(1))//' '//name_or_dash(table%control(2))//' '// &
                name_or_dash(table%control(3))//nothing)
            if (table%printing > 0 .or. table%is_fie .or. table%decimals >= 0) call out%line( &
                trim(front(item))//'printed '//trim(word(table%printing + 1))// &
                merge(' FIE    ', ' DECIMAL', table%is_fie)//nothing)
            if (table%conics > 1) call out%line(trim(front(item))//'conics '// &
                to_text(table%conics)//nothing)
        end associate
    end subroutine print_head

    !> A name, or a dash where there is none.
    pure function name_or_dash(name) result(text)
        character(*), intent(in) :: name !! may be blank
        character(max(1_i64, len_trim(name, i64))) :: text
        text = name
        if (text == '') text = '-'
    end function name_or_dash

    !> Prints the figures of a table, in deck order.
    subroutine print_entries(item, step, out)
        type(item_type), intent(in) :: item         !! the table
        type(finding_type), intent(in) :: step(2)   !! of XI and YI
        type(output_type), intent(inout) :: out     !! where it goes
        type(finding_type) :: finding
        integer :: i, reading

        do i = 1, item%table%count
            finding = finding_type()
            if (item%is_audited) then
                reading = findloc(item%entry, i, dim=1)
                if (reading > 0) finding = item%audit%finding(reading)
                if (item%table%entry(i)%what == known%xi) finding = step(1)
                if (item%table%entry(i)%what == known%yi) finding = step(2)
            end if
            call print_row(item, item%table%entry(i), finding, out)
        end do
    end subroutine print_entries

    !> What every row of a table begins with; blanks behind it.
    pure function front(item) result(text)
        type(item_type), intent(in) :: item !! the table
        integer, parameter :: views = 5
        character(word_length) :: word(views)
        character(2*word_length + entry_length + 3) :: text
        word = words_in(view_words)
        text = trim(item%table%name)//','//trim(word(item%table%view))//','// &
            trim(item%table%at_text)//','
    end function front

    !> Prints the row of a figure.
    subroutine print_row(item, entry, finding, out)
        type(item_type), intent(in) :: item             !! its table
        type(audit_entry_type), intent(in) :: entry     !! as the deck has it
        type(finding_type), intent(in) :: finding       !! what was found
        type(output_type), intent(inout) :: out         !! where it goes
        character(:), allocatable :: text, printed
        character(8), allocatable :: word(:)

        text = trim(front(item))
        if (entry%kind == entry_kind%row) then
            text = text//merge('y', 'x', entry%is_along_y)//trim(merge(' 2', '  ', &
                entry%column == 2))//','//trim(entry%along_text)
        else
            word = words_in(known_words)
            text = text//trim(kinds(entry%kind))//' '//trim(word(entry%what))//','
            if (entry%kind == entry_kind%between) text = text//shortest(entry%low)
        end if
        printed = trim(entry%text)
        if (entry%kind == entry_kind%between) printed = shortest(entry%high)
        text = text//','//printed//','
        if (finding%is_reached) then
            text = text//shortest(in_figures(finding%computed))//','// &
                shortest(in_figures(min(finding%low, finding%computed)))//','// &
                shortest(in_figures(max(finding%high, finding%computed)))//','// &
                shortest(anint(1.0e3_dp*finding%residual)/1.0e3_dp)
        else
            text = text//',,,'
        end if
        text = text//','
        if (finding%verdict /= verdict%none) text = text//verdict_name(finding%verdict)
        text = text//','//trim(corrected(finding))//','//reason(finding)//','
        if (is_doubtful(finding)) text = text//shortest(in_figures(finding%sure))
        call out%line(text)
    end subroutine print_row

    !> A value to nine significant figures, of which the last ones are still those of the line.
    elemental real(dp) function in_figures(value) result(rounded)
        real(dp), intent(in) :: value !! any
        real(dp) :: places
        integer, parameter :: figures = 9
        real(dp), parameter :: nothing = 1.0e-13_dp

        rounded = 0.0_dp
        if (abs(value) < nothing) return
        places = 10.0_dp**(figures - 1 - floor(log10(abs(value))))
        rounded = anint(value*places)/places
    end function in_figures

end module audit_csv
