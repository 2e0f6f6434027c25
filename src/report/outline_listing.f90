!> A faired outline on pages: what was asked and what came of it, the measured points beside the
!> outline, and points at equal length around it.
module report_outline_listing
    use base_digits, only: fixed, scientific
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: compact, right, to_text, widest_compact
    use body_outline, only: outline_type
    use cut_faired, only: faired_cut, ring_length, points_around
    use cut_outline, only: cut_type
    use geom_fairing, only: faired_energy
    use report_ordinate, only: ordinate_form_type, ordinate_text, ordinate_words, widest_ordinate
    use report_page, only: page_columns, page_type
    implicit none (type, external)
    private

    public :: print_outline

    !> Columns of the tables; decimals of slopes and significant figures of energies.
    integer, parameter :: number_width = 5, figure_width = 13, slope_decimals = 6
    integer, parameter :: energy_width = 18, energy_decimals = 9

contains

    !> Prints an outline. Its points stand counter-clockwise or clockwise as those measured.
    subroutine print_outline(page, number, outline, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        integer, intent(in) :: number                   !! of the cut, from 1
        type(outline_type), intent(in) :: outline       !! faired
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        type(output_type), intent(inout) :: out         !! where it goes

        call page%keep(out, 16)
        call page%line(out, 'CUT '//to_text(number)//'   STATION '// &
            ordinate_words(form, outline%sta)//'   '//trim(outline%name)//'   FAIRED OUTLINE')
        call print_facts(page, outline, form, out)
        call print_measured(page, outline, form, out)
        call print_around(page, outline, form, out)
        call page%blank(out)
        call page%blank(out)
    end subroutine print_outline

    !> Prints what was asked, energies, area, multiplier. Energies and areas are in printed units
    !> squared.
    subroutine print_facts(page, outline, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(outline_type), intent(in) :: outline       !! faired
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        type(output_type), intent(inout) :: out         !! where it goes
        type(error_type), allocatable :: error
        real(dp) :: length

        associate (fairing => outline%fairing, square => form%factor**2)
            call page%line(out, '  ENERGY OF SECOND DERIVATIVE'// &
                figure(square*fairing%energy(1))// &
                '   SHARE '//compact(fairing%beta))
            call page%line(out, '  ENERGY OF THIRD DERIVATIVE '// &
                figure(square*fairing%energy(2))// &
                '   SHARE '//compact(1.0_dp - fairing%beta))
            call page%line(out, '  ENERGY                     '// &
                figure(square*faired_energy(fairing)))
            call page%line(out, '  WEIGHTED SQUARES OF MISFIT '//figure(square*fairing%misfit))
            call page%line(out, '  LARGEST MISFIT             '// &
                figure(form%factor*fairing%deviation))
            call page%line(out, '  AREA                       '// &
                figure(square*abs(fairing%area))//asked_words(outline, square))
            call page%line(out, '  MULTIPLIER OF THE AREA     '// &
                figure(sign(1.0_dp, fairing%area)*fairing%lambda)//'   STEPS '// &
                to_text(fairing%steps))
        end associate
        call ring_length(outline%fairing%vertex, length, error)
        if (.not. allocated(error)) call page%line(out, '  LENGTH                     '// &
            figure(form%factor*length))
    end subroutine print_facts

    !> A figure of ten digits in its columns.
    pure function figure(value) result(text)
        real(dp), intent(in) :: value !! printed units
        character(energy_width) :: text
        text = scientific(value, energy_width, energy_decimals)
    end function figure

    !> What area was asked for.
    pure function asked_words(outline, square) result(words)
        type(outline_type), intent(in) :: outline   !! faired
        real(dp), intent(in) :: square              !! printed units squared in one of the deck
        character(12 + widest_compact) :: words
        words = '   AS IT COMES'
        if (outline%has_area) words = '   ASKED '//compact(square*outline%area)
    end function asked_words

    !> Prints the measured points beside those of the outline.
    subroutine print_measured(page, outline, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(outline_type), intent(in) :: outline       !! faired
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        type(output_type), intent(inout) :: out         !! where it goes
        character(page_columns) :: head(2)
        integer :: i

        call page%keep(out, 6)
        head(1) = right('', number_width)//right('MEASURED', 2*figure_width)// &
            right('FAIRED', 2*figure_width)
        head(2) = right('', number_width)//right('BL', figure_width)//right('WL', figure_width)// &
            right('BL', figure_width)//right('WL', figure_width)//right('APART', figure_width)
        call page%set_columns(out, head)
        associate (measured => outline%measured%point, near => outline%fairing%near)
            do i = 1, size(measured, 2)
                call page%line(out, right(to_text(i), number_width)// &
                    trim(pair(measured(:, i), form))// &
                    trim(pair(near(:, i), form))//ordinate_text(form, norm2(near(:, i) &
                    - measured(:, i)), figure_width))
            end do
        end associate
        call page%end_columns()
    end subroutine print_measured

    !> Prints points at equal length.
    subroutine print_around(page, outline, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(outline_type), intent(in) :: outline       !! faired
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        type(output_type), intent(inout) :: out         !! where it goes
        type(cut_type) :: cut
        type(error_type), allocatable :: error
        integer :: i

        call faired_cut(outline, points_around, cut, error)
        if (allocated(error)) return
        call page%keep(out, 6)
        call page%line(out, 'POINTS AT EQUAL LENGTH')
        call page%set_columns(out, [right('', number_width)//right('BL', figure_width)// &
            right('WL', figure_width)//right('SLOPE', figure_width)// &
            right('CURVATURE', figure_width)])
        do i = 1, points_around
            associate (point => cut%outlines(1)%points(i))
                call page%line(out, right(to_text(i), number_width)// &
                    trim(pair(point%at(2:), form))// &
                    slope_figure(cut, i)//scientific(point%curvature/form%factor, figure_width, 4))
            end associate
        end do
        call page%end_columns()
    end subroutine print_around

    !> Two ordinates in their columns.
    pure function pair(at, form) result(text)
        real(dp), intent(in) :: at(2)                   !! BL, WL, deck units
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        character(2*widest_ordinate) :: text
        text = ordinate_text(form, at(1), figure_width)//ordinate_text(form, at(2), figure_width)
    end function pair

    !> The slope dWL/dBL of a point in its columns.
    pure function slope_figure(cut, number) result(text)
        type(cut_type), intent(in) :: cut   !! the outline
        integer, intent(in) :: number       !! which point
        character(figure_width) :: text
        associate (slope => cut%outlines(1)%points(number)%slope)
            text = right('VERTICAL', figure_width)
            if (.not. slope%is_vertical) text = fixed(slope%value, figure_width, slope_decimals)
        end associate
    end function slope_figure

end module report_outline_listing
