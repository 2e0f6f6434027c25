!> The first page of a body listing: what the figures are, from where they count, how they are
!> rounded, and which cards they come from.
module report_title_page
    use base_kinds, only: i64
    use base_output, only: output_type
    use base_text, only: right, to_text
    use deck_body_card, only: card_type
    use deck_job, only: body_type, job_type, view_type
    use deck_sweep, only: sweep_type
    use report_ordinate, only: largest_rounding, ordinate_form_type
    use report_page, only: page_type
    implicit none (type, external)
    private

    public :: print_title_page

    !> Columns of a line number in the echo.
    integer, parameter :: number_width = 6

contains

    !> Prints the datum statement and the echo of the cards.
    subroutine print_title_page(page, job, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(job_type), intent(in) :: job               !! what the deck asks for
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        type(output_type), intent(inout) :: out         !! where it goes

        call print_datum(page, job, form, out)
        call page%blank(out)
        call print_echo(page, job, out)
        call page%blank(out)
        call page%blank(out)
    end subroutine print_title_page

    !> Says from where ordinates count, in which unit, and how they are rounded.
    subroutine print_datum(page, job, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(job_type), intent(in) :: job               !! what the deck asks for
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        type(output_type), intent(inout) :: out         !! where it goes

        call page%line(out, 'DATUM')
        call page%line(out, '  STATION (STA)     POSITIVE AFT')
        call page%line(out, '  BUTT LINE (BL)    POSITIVE TO STARBOARD, 0 ON THE CENTRE LINE')
        call page%line(out, '  WATERLINE (WL)    POSITIVE UP')
        call page%line(out, '  DECK UNIT         '//job%units)
        call page%line(out, '  ORDINATES IN      '//form%unit//', '//largest_rounding(form))
        call page%line(out, '  TO                OUTSIDE OF SKIN UNLESS A TABLE SAYS INSIDE')
        if (job%is_symmetric) then
            call page%line(out, '  SYMMETRY          ABOUT BL 0; TABLES GIVE THE STARBOARD HALF')
        else
            call page%line(out, '  SYMMETRY          NO; TABLES GIVE BOTH SIDES')
        end if
        if (job%is_closed) call page%line(out, '  CLOSED            SECTIONS ARE CLOSED ALONG BL 0')
    end subroutine print_datum

    !> Prints the cards the body is made of, in the order of the deck.
    subroutine print_echo(page, job, out)
        type(page_type), intent(inout) :: page      !! the listing
        type(job_type), intent(in) :: job           !! what the deck asks for
        type(output_type), intent(inout) :: out     !! where it goes
        type(card_type), allocatable :: cards(:)
        integer(i64) :: last
        integer :: i, k, next(1)

        allocate (cards(0))
        do i = 1, size(job%body)
            call gather(job%body(i), cards)
        end do
        call gather_sweep(job%sweep, cards)
        call page%line(out, 'CARDS READ')
        last = 0
        do i = 1, size(cards)
            next = minloc(first_lines(cards), mask=first_lines(cards) > last)
            if (next(1) == 0) exit
            associate (sheets => cards(next(1))%sheet)
                do k = 1, size(sheets)
                    call page%line(out, right(to_text(sheets(k)%line), number_width)//'  '// &
                        trim(sheets(k)%image))
                end do
                last = sheets(1)%line
            end associate
        end do
    end subroutine print_echo

    !> Adds the cards of a sweep.
    subroutine gather_sweep(sweep, cards)
        type(sweep_type), intent(in) :: sweep                   !! of the job
        type(card_type), allocatable, intent(inout) :: cards(:) !! gets its cards
        integer :: i

        call add(sweep%card, cards)
        if (.not. allocated(sweep%target)) return
        do i = 1, size(sweep%target)
            call add(sweep%target(i)%card, cards)
        end do
        do i = 1, size(sweep%wanted)
            call add(sweep%wanted(i)%card, cards)
        end do
    end subroutine gather_sweep

    !> The line where each card begins.
    pure function first_lines(cards) result(lines)
        type(card_type), intent(in) :: cards(:) !! with at least one sheet each
        integer(i64) :: lines(size(cards))
        integer :: i
        do i = 1, size(cards)
            lines(i) = cards(i)%sheet(1)%line
        end do
    end function first_lines

    !> Adds the cards of a body.
    subroutine gather(body, cards)
        type(body_type), intent(in) :: body                     !! a body of the job
        type(card_type), allocatable, intent(inout) :: cards(:) !! gets its cards
        integer :: i, k

        do i = 1, size(body%line)
            do k = 1, size(body%line(i)%view)
                call gather_view(body%line(i)%view(k), cards)
            end do
        end do
        do i = 1, size(body%section)
            call add(body%section(i)%card, cards)
        end do
        do i = 1, size(body%patch)
            call add(body%patch(i)%card, cards)
        end do
        do i = 1, size(body%outline)
            call add(body%outline(i)%card, cards)
            do k = 1, size(body%outline(i)%piece)
                call add(body%outline(i)%piece(k)%card, cards)
            end do
        end do
        call add(body%nose_card, cards)
        do i = 1, size(body%cut)
            call add(body%cut(i)%card, cards)
        end do
        do i = 1, size(body%check)
            call add(body%check(i)%card, cards)
        end do
    end subroutine gather

    !> Adds the cards of a view.
    subroutine gather_view(view, cards)
        type(view_type), intent(in) :: view                     !! of a control line
        type(card_type), allocatable, intent(inout) :: cards(:) !! gets its cards
        integer :: i

        call add(view%card, cards)
        if (.not. allocated(view%piece)) return
        do i = 1, size(view%piece)
            call add(view%piece(i)%card, cards)
        end do
    end subroutine gather_view

    !> Adds a card, if it is one.
    subroutine add(card, cards)
        type(card_type), intent(in) :: card                     !! any
        type(card_type), allocatable, intent(inout) :: cards(:) !! gets it
        if (.not. allocated(card%sheet)) return
        if (size(card%sheet) == 0) return
        cards = [cards, card]
    end subroutine add

end module report_title_page
