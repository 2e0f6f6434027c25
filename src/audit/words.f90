!> What listing, file and picture of an audit say in the same words: what a reading is, what is
!> right, how sure that is, and the card of a conic.
module audit_words
    use audit_audit, only: piece_type
    use audit_finding, only: finding_type, verdict
    use audit_item, only: item_type
    use audit_slip, only: slip_name
    use audit_steps, only: find_step
    use base_digits, only: shortest
    use base_kinds, only: dp
    use base_text, only: to_text
    use deck_audit, only: entry_kind
    use deck_audit_layout, only: known_words
    use deck_body_word, only: words_in
    implicit none (type, external)
    private

    public :: reading_name, corrected, reason, percent, card_image, is_doubtful

contains

    !> What a reading is: its X, its Y, or its field: `X 5.000`, `X 5.000 (2)`, `S3`.
    pure function reading_name(item, reading) result(name)
        type(item_type), intent(in) :: item !! its table
        integer, intent(in) :: reading      !! which
        character(:), allocatable :: name
        character(8), allocatable :: word(:)

        if (item%entry(reading) == 0) then
            name = 'BY LINE'
            return
        end if
        associate (entry => item%table%entry(item%entry(reading)))
            if (entry%kind == entry_kind%row) then
                name = merge('Y', 'X', entry%is_along_y)//' '//trim(entry%along_text)
                if (entry%column /= 1) name = name//' ('//to_text(entry%column)//')'
            else
                word = words_in(known_words)
                name = trim(word(entry%what))
            end if
        end associate
    end function reading_name

    !> True for a figure that is not as it should be.
    elemental logical function is_doubtful(finding)
        type(finding_type), intent(in) :: finding !! of a figure
        is_doubtful = finding%verdict == verdict%suspect .or. &
            finding%verdict == verdict%unreadable
    end function is_doubtful

    !> The figure of a corrected table: as printed where that agrees, else what is likely right.
    pure function corrected(finding) result(text)
        type(finding_type), intent(in) :: finding !! of a figure
        character(:), allocatable :: text
        text = trim(finding%likely)
        if (finding%verdict == verdict%blank) text = trim(finding%computed_figure)
    end function corrected

    !> How a figure that is not as it should be came about, in words.
    pure function reason(finding) result(words)
        type(finding_type), intent(in) :: finding !! of a figure
        character(:), allocatable :: words
        words = ''
        if (is_doubtful(finding)) words = slip_name(finding%slip)
    end function reason

    !> How sure what is likely right is, in per cent; never all.
    pure function percent(finding) result(text)
        type(finding_type), intent(in) :: finding !! of a figure
        character(:), allocatable :: text
        text = to_text(min(99, nint(100.0_dp*finding%sure)))
    end function percent

    !> The card of 1970 that reproduces a conic and its table, by columns.
    pure function card_image(item, piece) result(image)
        type(item_type), intent(in) :: item     !! the table
        type(piece_type), intent(in) :: piece   !! one conic of it
        character(80) :: image
        real(dp) :: step
        logical :: is_found

        image = ''
        associate (card => piece%card)
            image(1:8) = shortest(card%x(1))
            image(9:16) = card%number(1)
            image(17:24) = card%number(2)
            image(25:32) = shortest(card%x(2))
            image(33:40) = card%number(3)
            image(41:48) = shortest(card%x(3))
            image(49:56) = card%number(4)
            image(57:64) = card%number(5)
        end associate
        call find_step(item, .false., step, is_found)
        if (is_found) image(65:70) = with_point(step)
        call find_step(item, .true., step, is_found)
        if (is_found) image(71:76) = with_point(step)
        if (is_found) image(77:78) = ' 1'
    end function card_image

    !> An increment with its point.
    pure function with_point(step) result(text)
        real(dp), intent(in) :: step !! deck units
        character(:), allocatable :: text
        real(dp), parameter :: places = 1.0e6_dp
        text = shortest(anint(step*places)/places)
        if (index(text, '.') == 0) text = text//'.'
    end function with_point

end module audit_words
