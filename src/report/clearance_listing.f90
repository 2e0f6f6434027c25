!> Clearances on pages: each component, its gap from the inside of the skin, and where.
!>
!>     COMPONENT        ASKED     FOUND        STA         BL         WL
!>     WHEEL            1.000     0.412     31.250     12.500    -18.750   TOO SMALL
module report_clearance_listing
    use base_output, only: output_type
    use base_text, only: right
    use cut_clearance, only: clearance_type
    use report_ordinate, only: ordinate_form_type, ordinate_text
    use report_page, only: page_columns, page_type, widest_page
    implicit none (type, external)
    private

    public :: print_clearances

    !> Columns of the table.
    integer, parameter :: figure_width = 10, ordinate_width = 11, name_width = 10

contains

    !> Prints the clearances of a body's components.
    subroutine print_clearances(page, clearances, form, out)
        type(page_type), intent(inout) :: page                  !! the listing
        type(clearance_type), intent(in) :: clearances(:)       !! one a component
        type(ordinate_form_type), intent(in) :: form            !! unit and decimals
        type(output_type), intent(inout) :: out                 !! where it goes
        character(page_columns) :: head(2)
        integer :: i

        if (size(clearances) == 0) return
        call page%keep(out, 6)
        call page%line(out, 'CLEARANCES FROM THE INSIDE OF THE SKIN')
        head(1) = right('CLEARANCE', name_width + 2*figure_width)// &
            right('NEAREST POINT OF THE SKIN', 3*ordinate_width)
        head(2) = 'COMPONENT '//right('ASKED', figure_width)//right('FOUND', figure_width)// &
            right('STA', ordinate_width)//right('BL', ordinate_width)//right('WL', ordinate_width)
        call page%set_columns(out, head)
        do i = 1, size(clearances)
            call page%line(out, row(clearances(i), form))
            if (allocated(clearances(i)%note)) then
                call page%paragraph(out, '  '//clearances(i)%note)
            end if
        end do
        call page%end_columns()
        call page%blank(out)
        call page%blank(out)
    end subroutine print_clearances

    !> The row of a component.
    pure function row(clearance, form) result(text)
        type(clearance_type), intent(in) :: clearance   !! the component
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        character(widest_page) :: text
        character(name_width) :: name
        integer :: i

        name = clearance%name
        text = name//ordinate_text(form, clearance%asked, figure_width)// &
            ordinate_text(form, clearance%gap, figure_width)
        do i = 1, 3
            text = trim(text)//ordinate_text(form, clearance%nearest(i), ordinate_width)
        end do
        if (clearance%is_short) text = trim(text)//'  TOO SMALL'
    end function row

end module report_clearance_listing
