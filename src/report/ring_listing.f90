!> How sections go round the body, on pages: each pair that meets with the largest break of the
!> skin there, how each stretch of stations closes, and ends that are loose.
!>
!>     SECTION     MEETS       ON                FROM          TO   DEGREES         STA
!>     UPPER       LOWER       MHB             10.000      80.000   0.00000
!>     UPPER       ITS IMAGE   UCL             10.000      80.000   2.29100      10.000
module report_ring_listing
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: right
    use body_body, only: body_type
    use body_ring_end, only: is_on_chine, line_of_end, name_of_end
    use body_ring_list, only: closure, loose_end_type, meeting_type, ring_type, stretch_type
    use base_digits, only: fixed
    use report_ordinate, only: ordinate_form_type, ordinate_text, ordinate_words
    use report_page, only: page_columns, page_type, widest_page
    implicit none (type, external)
    private

    public :: print_ring

    !> Columns of the table, and decimals of a break in degrees.
    integer, parameter :: name_width = 12, ordinate_width = 12, break_width = 10, break_decimals = 5

contains

    !> Prints how the sections of a body meet; nothing of a body without sections.
    subroutine print_ring(page, body, ring, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(body_type), intent(in) :: body             !! the body
        type(ring_type), intent(in) :: ring             !! of the body
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        type(output_type), intent(inout) :: out         !! where it goes
        character(page_columns) :: head(2)
        integer :: i

        if (size(ring%stretches) == 0) return
        call page%keep(out, 8)
        call page%line(out, 'SECTIONS WHERE THEY MEET')
        if (size(ring%meetings) > 0) then
            head(1) = right('COMMON RANGE', 3*name_width + 2*ordinate_width - 2)// &
                right('LARGEST BREAK', break_width + ordinate_width)
            head(2) = 'SECTION     MEETS       ON          '//right('FROM', ordinate_width - 2)// &
                right('TO', ordinate_width)//right('DEGREES', break_width)// &
                right('STA', ordinate_width)
            call page%set_columns(out, head)
            do i = 1, size(ring%meetings)
                call page%line(out, row(body, ring%meetings(i), form))
            end do
            call page%end_columns()
        end if
        call name_chines(page, body, ring%meetings, out)
        do i = 1, size(ring%stretches)
            call page%paragraph(out, stretch_words(ring%stretches(i), form))
        end do
        do i = 1, size(ring%loose)
            call print_loose(page, body, ring%loose(i), form, out)
        end do
        call page%blank(out)
        call page%blank(out)
    end subroutine print_ring

    !> The row of a meeting; a break that shows as zero is nowhere.
    pure function row(body, meeting, form) result(text)
        type(body_type), intent(in) :: body             !! the body
        type(meeting_type), intent(in) :: meeting       !! of two of its sections
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        character(widest_page) :: text
        character(name_width) :: first, second, line

        first = name_of_end(body, meeting%end(1))
        second = 'ITS IMAGE'
        if (meeting%end(2) > 0) second = name_of_end(body, meeting%end(2))
        line = line_of_end(body, meeting%end(1))
        text = first//second//line// &
            ordinate_text(form, meeting%from, ordinate_width - 2)// &
            ordinate_text(form, meeting%to, ordinate_width)// &
            fixed(meeting%break, break_width, break_decimals)
        if (meeting%break*10.0_dp**break_decimals >= 0.5_dp) &
            text = trim(text)//ordinate_text(form, meeting%sta, ordinate_width)
    end function row

    !> Prints the names of the chines, if there are any.
    subroutine name_chines(page, body, meetings, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(body_type), intent(in) :: body             !! the body
        type(meeting_type), intent(in) :: meetings(:)   !! of its sections
        type(output_type), intent(inout) :: out         !! where it goes
        character(:), allocatable :: words, name
        integer :: i, k

        words = ''
        do i = 1, size(meetings)
            do k = 1, count(meetings(i)%end > 0)
                if (.not. is_on_chine(body, meetings(i)%end(k))) cycle
                name = line_of_end(body, meetings(i)%end(k))
                if (index(words//',', ' '//name//',') == 0) words = words//', '//name
            end do
        end do
        if (words /= '') call page%paragraph(out, 'CHINES, WHERE A BREAK IS MEANT:'//words(2:))
    end subroutine name_chines

    !> How a stretch closes, in words.
    pure function stretch_words(stretch, form) result(words)
        type(stretch_type), intent(in) :: stretch       !! of stations
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        character(widest_page) :: words

        words = 'FROM STA '//ordinate_words(form, stretch%from)//' TO STA '// &
            ordinate_words(form, stretch%to)
        select case (stretch%closure)
        case (closure%round)
            words = trim(words)//' THE SECTIONS GO ALL ROUND'
        case (closure%halves)
            words = trim(words)//' THE SECTIONS GO FROM BL 0 TO BL 0'
        case default
            words = trim(words)//' THE SECTIONS ARE OPEN'
        end select
    end function stretch_words

    !> Prints a loose end in words, with the way to the next.
    subroutine print_loose(page, body, loose, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(body_type), intent(in) :: body             !! the body
        type(loose_end_type), intent(in) :: loose       !! end of one of its sections
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        type(output_type), intent(inout) :: out         !! where it goes
        character(:), allocatable :: words

        words = '  FROM STA '//ordinate_words(form, loose%from)//' TO STA '// &
            ordinate_words(form, loose%to)//' '//name_of_end(body, loose%end)// &
            ' MEETS NO SECTION ON '//line_of_end(body, loose%end)
        if (loose%next > 0) words = words//'; THE NEXT SUCH END, OF '// &
            name_of_end(body, loose%next)//' ON '//line_of_end(body, loose%next)// &
            ', IS UP TO '//ordinate_words(form, loose%gap(1))//' IN BL AND '// &
            ordinate_words(form, loose%gap(2))//' IN WL AWAY, AT STA '// &
            ordinate_words(form, loose%sta)
        call page%paragraph(out, words)
    end subroutine print_loose

end module report_ring_listing
