!> Faired lines on pages: each measured point beside the line at its station.
!>
!>     LINE      VIEW   WEIGHT         STA    MEASURED      FAIRED  DIFFERENCE
!>     SHR       SIDE       10      48.000      24.500      24.512       0.012
module report_faired_listing
    use base_digits, only: fixed
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: compact, right
    use body_faired, only: faired_point_type, faired_type
    use deck_job, only: view
    use report_ordinate, only: ordinate_form_type, ordinate_text, ordinate_words, widest_ordinate
    use report_page, only: page_columns, page_type, widest_page
    implicit none (type, external)
    private

    public :: print_faired

    !> The views by `view%...` of `deck_job`.
    character(5), parameter :: view_names(3) = ['SIDE ', 'PLAN ', 'ANGLE']
    !> Columns of the table, and decimals of an angle in degrees.
    integer, parameter :: figure_width = 12, weight_width = 9, angle_decimals = 5

contains

    !> Prints the faired views of a body.
    subroutine print_faired(page, list, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(faired_type), intent(in) :: list(:)        !! in the order of the lines
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        type(output_type), intent(inout) :: out         !! where it goes
        character(page_columns) :: head(1)
        integer :: i, j

        if (size(list) == 0) return
        call page%keep(out, 8)
        call page%line(out, 'FAIRED LINES')
        head(1) = 'LINE      VIEW  '//right('WEIGHT', weight_width)//right('STA', figure_width)// &
            right('MEASURED', figure_width)//right('FAIRED', figure_width)// &
            right('DIFFERENCE', figure_width)
        call page%set_columns(out, head)
        do i = 1, size(list)
            do j = 1, size(list(i)%point)
                call page%line(out, list(i)%line//'  '//view_names(list(i)%view)//' '// &
                    row(list(i)%point(j), list(i)%view, form))
            end do
            call page%paragraph(out, '  '//trim(largest(list(i), form)))
        end do
        call page%end_columns()
        call page%blank(out)
        call page%blank(out)
    end subroutine print_faired

    !> The row of a point, without its line.
    pure function row(point, which, form) result(text)
        type(faired_point_type), intent(in) :: point    !! the point
        integer, intent(in) :: which                    !! one of `view%...`
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        character(widest_page) :: text

        text = right(compact(point%weight), weight_width)
        if (point%is_held) text = right('HELD', weight_width)
        text = trim(text)//ordinate_text(form, point%sta, figure_width)// &
            trim(figure(point%measured, which, form))
        if (point%is_on) then
            text = trim(text)//trim(figure(point%faired, which, form))// &
                trim(figure(point%faired - point%measured, which, form))
        else
            text = trim(text)//right('-', figure_width)//right('-', figure_width)
        end if
    end function row

    !> An ordinate of a view in its columns: a length, or degrees.
    pure function figure(value, which, form) result(text)
        real(dp), intent(in) :: value                   !! deck units or degrees
        integer, intent(in) :: which                    !! one of `view%...`
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        character(widest_ordinate) :: text
        if (which == view%angle) then
            text = fixed(value, figure_width, angle_decimals)
        else
            text = ordinate_text(form, value, figure_width)
        end if
    end function figure

    !> The largest difference of a view, in words.
    pure function largest(item, form) result(words)
        type(faired_type), intent(in) :: item           !! a faired view
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        character(widest_page) :: words
        real(dp) :: miss(size(item%point))
        integer :: worst

        miss = merge(abs(item%point%faired - item%point%measured), 0.0_dp, item%point%is_on)
        worst = maxloc(miss, dim=1)
        words = 'LARGEST DIFFERENCE '//trim(adjustl(figure(miss(worst), item%view, form)))// &
            ' AT STA '//ordinate_words(form, item%point(worst)%sta)
    end function largest

end module report_faired_listing
