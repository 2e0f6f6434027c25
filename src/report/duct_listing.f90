!> The ducts of a body on pages: the outlines of each and how they were matched, then its sections:
!> the area curve.
!>
!>     DUCT INTAKE THROUGH 3 OUTLINES, 14 VERTICES AROUND
!>     OUTLINE            STA  POINTS  BEGINS WITH
!>     LIP             10.000      14            1
!>     FACE            40.000      14            4  TURNED
!>            STA          AREA  PERIMETER       4A/P CENTROID BL CENTROID WL
!>         10.000         1.180      3.927      1.202       0.000       0.243  LIP
module report_duct_listing
    use base_digits, only: fixed, scientific
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: right, to_text
    use body_duct, only: duct_outline_type, duct_type
    use cut_duct, only: duct_measure_type, duct_section_type
    use report_ordinate, only: ordinate_form_type, ordinate_text, ordinate_words
    use report_page, only: page_columns, page_type, widest_page
    implicit none (type, external)
    private

    public :: print_ducts

    !> Columns of the tables; decimals that they have room for.
    integer, parameter :: name_width = 9, count_width = 8, begin_width = 13
    integer, parameter :: figure_width = 12, area_width = 14, most_decimals = 5

contains

    !> Prints the ducts of a body.
    subroutine print_ducts(page, ducts, measures, form, out)
        type(page_type), intent(inout) :: page                  !! the listing
        type(duct_type), intent(in) :: ducts(:)                 !! of the body
        type(duct_measure_type), intent(in) :: measures(:)      !! of each
        type(ordinate_form_type), intent(in) :: form            !! unit and decimals
        type(output_type), intent(inout) :: out                 !! where they go
        type(ordinate_form_type) :: fitting
        integer :: i

        fitting = form
        fitting%decimals = min(form%decimals, most_decimals)
        do i = 1, size(ducts)
            call page%keep(out, 8)
            call page%line(out, 'DUCT '//trim(ducts(i)%name)//' THROUGH '// &
                to_text(size(ducts(i)%outline))//' OUTLINES, '// &
                to_text(ducts(i)%loft%vertices)//' VERTICES AROUND')
            call print_outlines(page, ducts(i), fitting, out)
            call print_sections(page, ducts(i), measures(i), fitting, out)
            call page%blank(out)
            call page%blank(out)
        end do
    end subroutine print_ducts

    !> Prints the outlines of a duct.
    subroutine print_outlines(page, duct, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(duct_type), intent(in) :: duct             !! the duct
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        type(output_type), intent(inout) :: out         !! where it goes
        character(page_columns) :: head(1)
        integer :: k

        head(1) = 'OUTLINE  '//right('STA', figure_width)//right('POINTS', count_width)// &
            right('BEGINS WITH', begin_width)
        call page%set_columns(out, head)
        do k = 1, size(duct%outline)
            call page%line(out, outline_row(duct%outline(k), form))
        end do
        call page%end_columns()
        call page%line(out, 'THE SURFACE IS WITHIN '// &
            trim(adjustl(scientific(form%factor*duct%panel%error, 10, 2)))//' OF THE OUTLINES')
    end subroutine print_outlines

    !> The row of an outline.
    pure function outline_row(outline, form) result(text)
        type(duct_outline_type), intent(in) :: outline  !! of a duct
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        character(widest_page) :: text
        text = outline%name//' '//ordinate_text(form, outline%sta, figure_width)// &
            right(to_text(outline%points), count_width)//right(to_text(outline%first), begin_width)
        if (outline%is_turned) text = trim(text)//'  TURNED'
    end function outline_row

    !> Prints the sections of a duct, and its volume.
    subroutine print_sections(page, duct, measure, form, out)
        type(page_type), intent(inout) :: page              !! the listing
        type(duct_type), intent(in) :: duct                 !! the duct
        type(duct_measure_type), intent(in) :: measure      !! of it
        type(ordinate_form_type), intent(in) :: form        !! unit and decimals
        type(output_type), intent(inout) :: out             !! where it goes
        character(page_columns) :: head(1)
        integer :: k

        call page%keep(out, 5)
        head(1) = right('STA', figure_width)//right('AREA', area_width)// &
            right('PERIMETER', figure_width)//right('4A/P', figure_width)// &
            right('CENTRE BL', figure_width)//right('CENTRE WL', figure_width)
        call page%set_columns(out, head)
        do k = 1, size(measure%section)
            call page%line(out, section_row(duct, measure%section(k), form))
        end do
        call page%end_columns()
        call page%line(out, 'VOLUME FROM STA '// &
            ordinate_words(form, duct%outline(1)%sta)//' TO STA '// &
            ordinate_words(form, duct%outline(size(duct%outline))%sta)//'   '// &
            trim(adjustl(scientific(form%factor**3*measure%volume, 20, 9))))
    end subroutine print_sections

    !> The row of a section: lengths in the printed unit, areas in its square. An outline has its
    !> name behind.
    pure function section_row(duct, section, form) result(text)
        type(duct_type), intent(in) :: duct                 !! the duct
        type(duct_section_type), intent(in) :: section      !! of it
        type(ordinate_form_type), intent(in) :: form        !! unit and decimals
        character(widest_page) :: text

        text = ordinate_text(form, section%sta, figure_width)// &
            fixed(form%factor**2*section%area, area_width, form%decimals)
        if (section%has_perimeter .and. section%perimeter > 0.0_dp) then
            text = trim(text)//fixed(form%factor*section%perimeter, figure_width, form%decimals)// &
                fixed(form%factor*4.0_dp*section%area/section%perimeter, figure_width, &
                form%decimals)
        else
            text = trim(text)//right('-', figure_width)//right('-', figure_width)
        end if
        text = trim(text)//ordinate_text(form, section%centroid(1), figure_width)// &
            ordinate_text(form, section%centroid(2), figure_width)
        if (section%outline > 0) text = trim(text)//'  '//trim(duct%outline(section%outline)%name)
    end function section_row

end module report_duct_listing
