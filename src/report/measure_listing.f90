!> Measures on pages: the sections along the length, then the whole body.
module report_measure_listing
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: right
    use cut_measure, only: section_measure_type
    use cut_measure_body, only: body_measure_type
    use base_digits, only: fixed, scientific
    use report_ordinate, only: ordinate_form_type, ordinate_text, ordinate_words
    use report_page, only: page_columns, page_type, widest_page
    implicit none (type, external)
    private

    public :: print_measures

    !> Columns of the table.
    integer, parameter :: figure_width = 11, large_width = 12

contains

    !> Prints the sections of the area curve, then volume, wetted area and centroid; nothing of a
    !> body without sections.
    subroutine print_measures(page, measure, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(body_measure_type), intent(in) :: measure  !! of a body
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        type(output_type), intent(inout) :: out         !! where it goes

        if (size(measure%curve) == 0) return
        call print_curve(page, measure, form, out)
        call page%blank(out)
        call page%keep(out, 5)
        call print_body(page, measure, form, out)
        call page%blank(out)
        call page%blank(out)
    end subroutine print_measures

    !> Prints girth, area, centroid and moments of the sections. Where one has no area, the reason
    !> stands once below the table.
    subroutine print_curve(page, measure, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(body_measure_type), intent(in) :: measure  !! of a body
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        type(output_type), intent(inout) :: out         !! where it goes
        character(page_columns) :: head(1)
        character(:), allocatable :: why
        integer :: i

        call page%line(out, 'SECTIONS OF THE WHOLE BODY')
        head(1) = right('STA', figure_width)//right('GIRTH', figure_width)// &
            right('AREA', large_width)//right('CENTROID WL', large_width)// &
            right('MOMENT ACROSS', large_width + 3)//right('MOMENT UPRIGHT', large_width + 3)
        call page%set_columns(out, head)
        do i = 1, size(measure%curve)
            associate (section => measure%curve(i))
                call page%line(out, section_row(section, form))
                if (is_lopsided(section, form)) call page%line(out, lopsided_row(section, form))
                if (section%has_area .or. allocated(why)) cycle
                if (allocated(section%why)) why = 'WITHOUT AREA: AT STA '// &
                    ordinate_words(form, section%sta)//' '//section%why
            end associate
        end do
        call page%end_columns()
        if (allocated(why)) call page%paragraph(out, why)
    end subroutine print_curve

    !> The row of a section: lengths in the printed unit, areas in its square, moments in its
    !> fourth power.
    pure function section_row(section, form) result(text)
        type(section_measure_type), intent(in) :: section   !! the section
        type(ordinate_form_type), intent(in) :: form        !! unit and decimals
        character(widest_page) :: text

        text = ordinate_text(form, section%sta, figure_width)
        if (section%has_girth) then
            text = trim(text)//fixed(form%factor*section%girth, figure_width, form%decimals)
        else
            text = trim(text)//right('-', figure_width)
        end if
        if (.not. section%has_area) then
            text = trim(text)//right('-', large_width)
            return
        end if
        text = trim(text)//fixed(form%factor**2*section%area, large_width, form%decimals)// &
            ordinate_text(form, section%centroid(2), large_width)// &
            fixed(form%factor**4*section%inertia(1), large_width + 3, form%decimals)// &
            fixed(form%factor**4*section%inertia(2), large_width + 3, form%decimals)
    end function section_row

    !> True where the centroid of a section is off BL 0 as far as it is printed.
    pure logical function is_lopsided(section, form)
        type(section_measure_type), intent(in) :: section   !! the section
        type(ordinate_form_type), intent(in) :: form        !! unit and decimals
        is_lopsided = section%has_area .and. &
            abs(form%factor*section%centroid(1))*10.0_dp**form%decimals >= 0.5_dp
    end function is_lopsided

    !> The row below that of a section whose two sides differ.
    pure function lopsided_row(section, form) result(text)
        type(section_measure_type), intent(in) :: section   !! the section
        type(ordinate_form_type), intent(in) :: form        !! unit and decimals
        character(widest_page) :: text
        text = right('CENTROID BL', figure_width + figure_width + large_width)// &
            ordinate_text(form, section%centroid(1), large_width)// &
            right('PRODUCT', large_width + 3)// &
            fixed(form%factor**4*section%inertia(3), large_width + 3, form%decimals)
    end function lopsided_row

    !> Prints volume, centroid and wetted area with the estimates of their errors.
    subroutine print_body(page, measure, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(body_measure_type), intent(in) :: measure  !! of a body
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        type(output_type), intent(inout) :: out         !! where it goes

        call page%line(out, 'FROM STA '//ordinate_words(form, measure%from)//' TO STA '// &
            ordinate_words(form, measure%to))
        if (measure%has_wetted) call page%line(out, 'WETTED AREA '// &
            figure(measure%wetted_area, measure%wetted_error, form%factor**2))
        if (measure%has_volume) then
            call page%line(out, 'VOLUME      '// &
                figure(measure%volume, measure%volume_error, form%factor**3))
            call page%line(out, 'CENTROID    STA '//ordinate_words(form, measure%centroid(1))// &
                '  BL '//ordinate_words(form, measure%centroid(2))// &
                '  WL '//ordinate_words(form, measure%centroid(3)))
        else if (allocated(measure%why)) then
            call page%paragraph(out, 'NO VOLUME: '//measure%why)
        end if
    end subroutine print_body

    !> A measure with the estimate of its error.
    pure function figure(value, error_estimate, factor) result(text)
        real(dp), intent(in) :: value           !! in deck units to some power
        real(dp), intent(in) :: error_estimate  !! of the quadrature, the same
        real(dp), intent(in) :: factor          !! printed unit over deck unit, to that power
        character(widest_page) :: text
        text = fixed(factor*value, 20, 6)//'   ERROR BELOW '// &
            trim(adjustl(scientific(factor*error_estimate, 10, 2)))
    end function figure

end module report_measure_listing
