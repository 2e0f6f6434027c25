!> What listing, file and picture of an audit say in the same words: what a reading is, what is
!> right, how sure that is, and the card of a conic.
module audit_words
    use audit_audit, only: piece_type
    use audit_figure, only: figure_length
    use audit_finding, only: finding_type, verdict
    use audit_item, only: item_type
    use audit_slip, only: slip_name
    use audit_steps, only: find_step
    use base_digits, only: shortest
    use base_kinds, only: dp, i64
    use base_text, only: to_text
    use deck_audit, only: entry_kind, entry_length
    use deck_audit_layout, only: known_words
    use deck_body_card, only: field_width
    use deck_body_word, only: words_in
    implicit none (type, external)
    private

    public :: reading_name, corrected, reason, percent, card_image, why_no_card, is_doubtful

    !> Characters of the name of a reading: its abscissa as it is on the card, and its column.
    integer, parameter :: reading_length = entry_length + 8

contains

    !> What a reading is: its X, its Y, or its field: `X 5.000`, `X 5.000 (2)`, `S3`;
    !> blanks behind it.
    pure function reading_name(item, reading) result(name)
        type(item_type), intent(in) :: item !! its table
        integer, intent(in) :: reading      !! which
        character(reading_length) :: name
        character(8), allocatable :: word(:)

        if (item%entry(reading) == 0) then
            name = 'BY LINE'
            return
        end if
        associate (entry => item%table%entry(item%entry(reading)))
            if (entry%kind == entry_kind%row) then
                name = merge('Y', 'X', entry%is_along_y)//' '//trim(entry%along_text)
                if (entry%column /= 1) name = trim(name)//' ('//to_text(entry%column)//')'
            else
                allocate (word, source=words_in(known_words))
                name = word(entry%what)
            end if
        end associate
    end function reading_name

    !> True for a figure that is not as it should be.
    elemental logical function is_doubtful(finding)
        type(finding_type), intent(in) :: finding !! of a figure
        is_doubtful = finding%verdict == verdict%suspect .or. &
            finding%verdict == verdict%unreadable
    end function is_doubtful

    !> The figure of a corrected table: as printed where that agrees, else what is likely
    !> right; blanks behind it.
    pure function corrected(finding) result(text)
        type(finding_type), intent(in) :: finding !! of a figure
        character(figure_length) :: text
        text = finding%likely
        if (finding%verdict == verdict%blank) text = finding%computed_figure
    end function corrected

    !> How a figure that is not as it should be came about, in words.
    pure function reason(finding) result(words)
        type(finding_type), intent(in) :: finding !! of a figure
        character(merge(len(slip_name(finding%slip), i64), 0_i64, is_doubtful(finding))) :: words
        words = slip_name(finding%slip)
    end function reason

    !> How sure what is likely right is, in per cent; never all.
    pure function percent(finding) result(text)
        type(finding_type), intent(in) :: finding !! of a figure
        character(2) :: text
        text = to_text(min(99, nint(100.0_dp*finding%sure)))
    end function percent

    !> The card of 1970 that reproduces a conic and its table, by columns; blank where a number
    !> needs more columns than it has. A table along Y alone gets an XI past the last
    !> point, which prints one row, as in the paper.
    pure function card_image(item, piece) result(image)
        type(item_type), intent(in) :: item     !! the table
        type(piece_type), intent(in) :: piece   !! one conic of it
        character(80) :: image
        character(figure_length) :: number(8)
        real(dp) :: step
        integer :: i
        logical :: is_found

        image = ''
        if (.not. piece%card%is_conic) return
        associate (card => piece%card)
            number = card_number([card%number(1), card%number(1:2), card%number(2:3), &
                card%number(3:4), card%number(5)])
            number([1, 4, 6]) = [(card_number(shortest_text(card%x(i))), i = 1, 3)]
            if (any(len_trim(number) > field_width)) return
            do i = 1, 8
                image(field_width*(i - 1) + 1:field_width*i) = number(i)
            end do
            call find_step(item, .false., step, is_found)
            if (.not. is_found) step = aint(abs(card%x(3) - card%x(1))) + 1.0_dp
            step = sign(step, card%x(3) - card%x(1))
        end associate
        image(65:70) = card_number(shortest_text(rounded(step)))
        call find_step(item, .true., step, is_found)
        if (.not. is_found) return
        image(71:76) = card_number(shortest_text(rounded(sign(step, way_of(number([2, 7]))))))
        image(77:78) = ' 1'
    end function card_image

    !> Why a conic has no card that runs, in words; nothing where it has one.
    pure function why_no_card(item, piece) result(words)
        type(item_type), intent(in) :: item     !! the table
        type(piece_type), intent(in) :: piece   !! one conic of it
        character(50) :: words

        if (.not. piece%card%is_whole) then
            words = 'the good figures do not tell all of its numbers'
        else if (.not. piece%card%is_conic) then
            words = 'no conic goes through its points with its slopes'
        else if (card_image(item, piece) == '') then
            words = 'a number needs more columns than a field has'
        else
            words = ''
        end if
    end function why_no_card

    !> The way from one ordinate to another.
    pure real(dp) function way_of(number) result(way)
        character(*), intent(in) :: number(2) !! as punched
        real(dp) :: value(2)
        read (number, *) value
        way = value(2) - value(1)
    end function way_of

    !> A number as it is punched: with a point, without which a card of 1970 would put it elsewhere,
    !> and without the zero before it where the field has no room for that.
    elemental character(figure_length) function card_number(text) result(number)
        character(*), intent(in) :: text !! the number
        integer :: zero

        number = text
        if (index(number, '.') == 0) number = trim(number)//'.'
        zero = index(number, '0.')
        if (len_trim(number) <= field_width .or. zero == 0) return
        if (zero == 1) number = number(2:)
        if (zero == 2 .and. number(1:1) == '-') number = '-'//number(3:)
    end function card_number

    !> The shortest text of a number, in the length of a figure.
    pure character(figure_length) function shortest_text(value) result(text)
        real(dp), intent(in) :: value !! any
        text = shortest(value)
    end function shortest_text

    !> An increment without what doubles add to its decimals.
    pure real(dp) function rounded(step)
        real(dp), intent(in) :: step !! deck units
        real(dp), parameter :: places = 1.0e6_dp
        rounded = anint(step*places)/places
    end function rounded

end module audit_words
