!> The listing of an audit: each table with its line, its figures and what is right, then what the
!> tables say of one another.
module audit_listing
    use audit_audit, only: piece_type
    use audit_cross, only: table_title
    use audit_cross_listing, only: print_cross, print_summary
    use audit_deck, only: deck_audit_type
    use audit_finding, only: finding_type, verdict, verdict_name
    use audit_item, only: entry_of, item_type
    use audit_parameter, only: find_pairs, pair_type, parameter_type
    use audit_printing, only: printing, printing_name
    use audit_reading, only: sort
    use audit_words, only: card_image, corrected, is_doubtful, percent, reading_name, reason, &
        why_no_card
    use base_constants, only: vertical_slope
    use base_digits, only: fixed, shortest
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: right, to_text, upper
    use deck_audit, only: audit_deck_type, entry_length, known
    use report_page, only: page_columns, page_type
    implicit none (type, external)
    private

    public :: print_audit

    !> Columns of names, figures and values; decimals of a value beyond those of its table.
    integer, parameter :: name_width = 16, figure_width = 12, further = 2
    !> Round numbers and pairs of them that are shown.
    integer, parameter :: most_shown = 4

contains

    !> Prints an audit.
    subroutine print_audit(deck, found, deck_name, out)
        type(audit_deck_type), intent(in) :: deck       !! the tables
        type(deck_audit_type), intent(in) :: found      !! what was found
        character(*), intent(in) :: deck_name           !! without folders
        type(output_type), intent(inout) :: out         !! where it goes
        type(page_type) :: page
        integer :: i

        call page%set_heading(deck%title, deck_name, deck%units)
        do i = 1, size(found%item)
            call print_table(page, found, i, out)
        end do
        call print_cross(page, found, out)
        call print_summary(page, found, out)
    end subroutine print_audit

    !> Prints a table.
    subroutine print_table(page, found, i, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(deck_audit_type), intent(in) :: found      !! what was found
        integer, intent(in) :: i                        !! which table
        type(output_type), intent(inout) :: out         !! where it goes
        character(:), allocatable :: words
        integer :: k

        associate (item => found%item(i))
            call page%keep(out, 12)
            call page%line(out, 'TABLE '//table_title(item))
            if (.not. item%is_audited) then
                call page%line(out, 'NO LINE: ITS FIGURES ARE TOO FEW FOR A CONIC')
                call page%blank(out)
                return
            end if
            call say_printing(item, words)
            call page%paragraph(out, words)
            do k = 1, size(item%audit%piece)
                call print_piece(page, item, item%audit%piece(k), out)
            end do
            call print_figures(page, item, found%step(:, i), out)
        end associate
    end subroutine print_table

    !> Says in words how a table was printed.
    pure subroutine say_printing(item, words)
        type(item_type), intent(in) :: item             !! the table
        character(:), allocatable, intent(out) :: words !! the sentence
        integer :: way

        words = 'PRINTED: '//upper(printing_name(item%audit%printing))
        if (item%line%printing /= printing%unknown) return
        words = words//', AS THE FIGURES TELL; NUMBERS MET BY EACH WAY: '
        do way = 1, 4
            if (item%audit%met_by(way) < 0) cycle
            if (way > 1) words = words//', '
            words = words//upper(printing_name(way))//' '//to_text(item%audit%met_by(way))
        end do
    end subroutine say_printing

    !> Prints a conic of a table: its numbers, and its card.
    subroutine print_piece(page, item, piece, out)
        type(page_type), intent(inout) :: page      !! the listing
        type(item_type), intent(in) :: item         !! the table
        type(piece_type), intent(in) :: piece       !! one conic of it
        type(output_type), intent(inout) :: out     !! where it goes
        integer :: k

        call page%blank(out)
        call page%keep(out, 9)
        call page%line(out, trim(merge('STRAIGHT', 'CONIC   ', &
            piece%fit%problem%is_straight))//' FROM X '//shortest(piece%first)//' TO '// &
            shortest(piece%last)//':    LINE, LEAST, MOST, ROUND NUMBERS')
        do k = 1, size(piece%parameter)
            if (piece%parameter(k)%exists) call print_parameter(page, piece%parameter(k), out)
        end do
        call print_pairs(page, piece, out)
        if (why_no_card(item, piece) == '') then
            call page%line(out, 'CARD')
            call page%line(out, card_image(item, piece))
        else
            call page%line(out, 'NO CARD: '//upper(why_no_card(item, piece)))
        end if
    end subroutine print_piece

    !> Prints a number of the card in its columns.
    subroutine print_parameter(page, parameter, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(parameter_type), intent(in) :: parameter   !! of a conic
        type(output_type), intent(inout) :: out         !! where it goes
        character(:), allocatable :: text
        integer, parameter :: decimals = 6
        integer :: k, count

        text = right(trim(parameter%name)//' AT X '//shortest(parameter%quantity%along), &
            name_width)//'  '//fixed(parameter%value, figure_width, decimals)
        if (.not. parameter%is_limited) then
            call page%paragraph(out, text//'  NOT BOUNDED BY THE GOOD FIGURES')
            return
        end if
        text = text//fixed(parameter%low, figure_width, decimals)// &
            fixed(parameter%high, figure_width, decimals)
        count = size(parameter%round)
        if (count > most_shown + 1) count = most_shown
        do k = 1, count
            text = text//'  '//trim(parameter%round(k))
        end do
        if (count < size(parameter%round)) text = text//'  ... '// &
            trim(parameter%round(size(parameter%round)))
        call page%paragraph(out, text)
    end subroutine print_parameter

    !> Prints the pairs of slopes of fewest decimals, where neither slope is one number alone.
    subroutine print_pairs(page, piece, out)
        type(page_type), intent(inout) :: page      !! the listing
        type(piece_type), intent(in) :: piece       !! one conic of it
        type(output_type), intent(inout) :: out     !! where it goes
        type(pair_type), allocatable :: pairs(:)
        character(:), allocatable :: words
        integer, parameter :: fewest = 2, most = 5
        integer :: decimals, k

        associate (s1 => piece%parameter(2), s3 => piece%parameter(5))
            if (.not. (is_open(s1) .and. is_open(s3))) return
            do decimals = fewest, most
                pairs = find_pairs(piece%fit, s1%quantity, s3%quantity, decimals)
                if (size(pairs) > 0) exit
            end do
        end associate
        if (size(pairs) == 0) return
        words = 'S1 AND S3 TOGETHER:'
        do k = 1, min(size(pairs), 2*most_shown)
            words = words//'  '//trim(pairs(k)%first)//' WITH '//trim(pairs(k)%second)
            if (k < min(size(pairs), 2*most_shown)) words = words//','
        end do
        if (size(pairs) > 2*most_shown) words = words//' AND '// &
            to_text(size(pairs) - 2*most_shown)//' MORE'
        call page%paragraph(out, words)
    end subroutine print_pairs

    !> True for a number that may be one of many.
    pure logical function is_open(parameter)
        type(parameter_type), intent(in) :: parameter !! of a conic
        real(dp), parameter :: noise = 1.0e-9_dp
        is_open = parameter%exists .and. parameter%is_limited .and. &
            parameter%high - parameter%low > noise*max(1.0_dp, abs(parameter%value))
    end function is_open

    !> Prints the figures of a table.
    subroutine print_figures(page, item, step, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(item_type), intent(in) :: item             !! the table
        type(finding_type), intent(in) :: step(2)       !! of XI and YI
        type(output_type), intent(inout) :: out         !! where it goes
        character(page_columns) :: head(1)
        integer :: k

        call page%blank(out)
        head(1) = right('FIGURE', name_width)//right('PRINTED', figure_width)// &
            right('LINE', figure_width)//right('OFF', 9)//'  VERDICT   '// &
            right('CORRECTED', figure_width)//' SURE'
        call page%set_columns(out, head)
        do k = 1, size(item%entry)
            if (item%entry(k) == 0) cycle
            call print_figure_row(page, reading_name(item, k), item%line%reading(k)%figure%text, &
                item%audit%finding(k), decimals_of(item, k), out)
        end do
        do k = 1, 2
            if (step(k)%verdict /= verdict%none) call print_figure_row(page, &
                merge('XI', 'YI', k == 1), step_text(item, k), step(k), 3, out)
        end do
        call page%end_columns()
        call page%blank(out)
        call page%blank(out)
    end subroutine print_figures

    !> The increment as it is printed.
    pure function step_text(item, axis) result(text)
        type(item_type), intent(in) :: item !! the table
        integer, intent(in) :: axis         !! 1: XI, 2: YI
        character(entry_length) :: text
        text = item%table%entry(entry_of(item%table, merge(known%xi, known%yi, axis == 1)))%text
    end function step_text

    !> Decimals that the value of a reading is shown with.
    pure integer function decimals_of(item, reading) result(decimals)
        type(item_type), intent(in) :: item !! the table
        integer, intent(in) :: reading      !! which
        decimals = max(item%line%reading(reading)%figure%scale%decimals, &
            item%audit%scale%decimals, 0)
        if (item%line%reading(reading)%sort == sort%slope) decimals = 4
        if (item%line%reading(reading)%sort == sort%coefficient) decimals = 8
        decimals = min(decimals + further, 8)
    end function decimals_of

    !> Prints the row of a figure, and how it came about where it is not as it should be.
    subroutine print_figure_row(page, name, printed, finding, decimals, out)
        type(page_type), intent(inout) :: page          !! the listing
        character(*), intent(in) :: name                !! what it is
        character(*), intent(in) :: printed             !! as it is printed
        type(finding_type), intent(in) :: finding       !! what was found of it
        integer, intent(in) :: decimals                 !! of its value
        type(output_type), intent(inout) :: out         !! where it goes
        character(:), allocatable :: text
        character(10) :: word

        word = upper(verdict_name(finding%verdict))
        text = right(name, name_width)//right(trim(printed), figure_width)
        if (finding%is_reached .and. abs(finding%computed) >= vertical_slope) then
            text = text//right('VERTICAL', figure_width)//right('', 9)//'  '//word// &
                right(corrected(finding), figure_width)
        else if (finding%is_reached) then
            text = text//fixed(finding%computed, figure_width, decimals)// &
                fixed(finding%residual, 9, 1)//'  '//word//right(corrected(finding), figure_width)
            if (is_doubtful(finding)) text = text//right(percent(finding), 4)//'%'
        else
            text = text//right('NOT REACHED', figure_width)//right('', 9)//'  '//word
        end if
        call page%line(out, text)
        if (reason(finding) /= '') call page%line(out, right('', name_width)//'    '// &
            upper(reason(finding)))
    end subroutine print_figure_row

end module audit_listing
