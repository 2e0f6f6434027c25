!> Tables of offsets on pages: stations across, butt lines or waterlines down.
!>
!>     HEIGHTS (WL) ON BUTT LINES
!>           BL SECTION          STA
!>                             0.000    10.000    20.000
!>        4.500 LOWER        -17.706   -19.468   -20.860
module report_offset_listing
    use base_output, only: output_type
    use base_text, only: right, row_of
    use cut_offsets, only: offset_table_type
    use report_ordinate, only: ordinate_form_type, ordinate_text
    use report_page, only: page_type, widest_page
    implicit none (type, external)
    private

    public :: print_offsets

    !> What a table and its rows are called, by axis.
    character(34), parameter :: title(2) = [character(34) :: &
        'HEIGHTS (WL) ON BUTT LINES', 'HALF-BREADTHS (BL) ON WATERLINES']
    character(2), parameter :: label(2) = ['BL', 'WL']
    !> Columns of a section's name.
    integer, parameter :: name_width = 10
    !> Columns of a figure, and of the ordinate at the left, beside their decimals.
    integer, parameter :: bare_width = 7, bare_ordinate = 9
    !> Rows that stay together with their heads.
    integer, parameter :: block_lines = 6

contains

    !> Prints a table, as many stations side by side as the page has room for.
    subroutine print_offsets(page, table, sections, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(offset_table_type), intent(in) :: table    !! the figures
        character(*), intent(in) :: sections(:)         !! names of the body's sections
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        type(output_type), intent(inout) :: out         !! where it goes
        integer :: first, last, side_by_side, figure_width, ordinate_width

        if (size(table%rows) == 0) return
        figure_width = bare_width + max(3, form%decimals)
        ordinate_width = bare_ordinate + max(3, form%decimals)
        side_by_side = (page%width() - ordinate_width - name_width)/figure_width
        do first = 1, size(table%stations), side_by_side
            last = min(first + side_by_side - 1, size(table%stations))
            call page%keep(out, block_lines)
            call page%line(out, title(table%axis))
            call print_band(page, table, [first, last], sections, form, out)
            call page%blank(out)
        end do
    end subroutine print_offsets

    !> Prints the rows for a band of stations.
    subroutine print_band(page, table, band, sections, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(offset_table_type), intent(in) :: table    !! the figures
        integer, intent(in) :: band(2)                  !! first and last station
        character(*), intent(in) :: sections(:)         !! names of the body's sections
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        type(output_type), intent(inout) :: out         !! where it goes
        character(widest_page) :: head(2)
        character(:), allocatable :: text
        integer :: i, j, figure_width, ordinate_width

        figure_width = bare_width + max(3, form%decimals)
        ordinate_width = bare_ordinate + max(3, form%decimals)
        head(1) = right(label(table%axis), ordinate_width)//' SECTION    STA'
        text = row_of(' ', ordinate_width + name_width)
        do j = band(1), band(2)
            text = text//ordinate_text(form, table%stations(j), figure_width)
        end do
        head(2) = text
        call page%set_columns(out, head)
        do i = 1, size(table%rows)
            associate (row => table%rows(i))
                if (.not. any(row%is_met(band(1):band(2)))) cycle
                text = row_of(' ', 1)//sections(row%section)
                text = ordinate_text(form, row%ordinate, ordinate_width)//text// &
                    row_of(' ', name_width - len(text))
                do j = band(1), band(2)
                    if (row%is_met(j)) then
                        text = text//ordinate_text(form, row%figure(j), figure_width)
                    else
                        text = text//right('-', figure_width)
                    end if
                end do
                call page%line(out, text)
            end associate
        end do
        call page%end_columns()
    end subroutine print_band

end module report_offset_listing
