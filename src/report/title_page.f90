!> The first page of a body listing: what the figures are, from where they count, how they are
!> rounded, and which cards they come from.
module report_title_page
    use base_output, only: output_type
    use base_text, only: right, to_text
    use deck_job, only: job_type
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

    !> Prints every card that was read, in the order of the deck.
    subroutine print_echo(page, job, out)
        type(page_type), intent(inout) :: page      !! the listing
        type(job_type), intent(in) :: job           !! what the deck asks for
        type(output_type), intent(inout) :: out     !! where it goes
        integer :: i, k

        call page%line(out, 'CARDS READ')
        do i = 1, size(job%card)
            associate (sheets => job%card(i)%sheet)
                do k = 1, size(sheets)
                    call page%line(out, right(to_text(sheets(k)%line), number_width)//'  '// &
                        trim(sheets(k)%image))
                end do
            end associate
        end do
    end subroutine print_echo

end module report_title_page
