!> A cut as a loft prints it: what plane it is, then each outline, a row a point.
!>
!>     CUT 3   STATION 20.000   FLANGE AFT
!>     OUTLINE 1 OF 1, OPEN
!>            STA         BL         WL       SLOPE       RADIUS     BEVEL
!>     SECTION LOWER
!>         20.000      0.000    -20.999    0.000000       16.123    -4.982
!>
!> An oblique cut is given in its true shape too: u and v in its own plane, with origin and axes.
module report_cut_listing
    use base_exact, only: is_zero
    use base_kinds, only: dp, i64
    use base_output, only: output_type
    use base_text, only: columns, compact, compact_length, right, to_text
    use cut_outline, only: cut_point_type, cut_type, note_type, outline_type
    use cut_plane, only: cut_kind, plane_type
    use base_digits, only: fixed, scientific
    use report_ordinate, only: ordinate_form_type, ordinate_text, ordinate_words
    use report_page, only: page_type, widest_page
    use report_panel_words, only: kind_word, panels_word
    implicit none (type, external)
    private

    public :: print_cut, plane_words

    !> Columns of the table beside the decimals of its ordinates, and of the bevel.
    integer, parameter :: ordinate_width = 8, narrow_width = 7, bevel_width = 9
    !> Decimals of slopes and bevels.
    integer, parameter :: slope_decimals = 6, bevel_decimals = 3
    !> Lines of a cut, and of an outline, that stay together.
    integer, parameter :: block_lines = 10, outline_lines = 6

contains

    !> Prints a cut.
    subroutine print_cut(page, number, cut, sections, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        integer, intent(in) :: number                   !! which cut of the deck, from 1
        type(cut_type), intent(in) :: cut               !! the cut
        character(*), intent(in) :: sections(:)         !! names of the body's sections
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals of ordinates
        type(output_type), intent(inout) :: out         !! where it goes
        integer :: i, met

        met = size(cut%outlines)
        if (allocated(cut%patched)) met = met + size(cut%patched)
        call page%keep(out, block_lines)
        call page%line(out, head_of(number, cut, form))
        if (is_oblique(cut)) call print_axes(page, cut%plane, form, out)
        if (met == 0) call page%line(out, 'THE PLANE DOES NOT MEET THE SKIN HERE')
        do i = 1, size(cut%outlines)
            call page%keep(out, outline_lines)
            call page%line(out, 'OUTLINE '//to_text(i)//' OF '//to_text(size(cut%outlines))// &
                trim(merge(', CLOSED', ', OPEN  ', cut%outlines(i)%is_closed)))
            call print_points(page, cut, cut%outlines(i), sections, form, out)
        end do
        if (allocated(cut%inside)) call print_inside(page, cut, sections, form, out)
        if (size(cut%outlines) > 0) call page%line(out, 'FOUND IN TWO WAYS THAT AGREE WITHIN '// &
            trim(adjustl(scientific(form%factor*cut%disagreement, 10, 2))))
        if (met > size(cut%outlines)) call print_patched(page, cut, sections, form, out)
        call print_notes(page, cut%notes, out)
        call page%blank(out)
        call page%blank(out)
    end subroutine print_cut

    !> The first line of a cut: number, plane, name, flange.
    function head_of(number, cut, form) result(text)
        integer, intent(in) :: number                   !! which cut of the deck
        type(cut_type), intent(in) :: cut               !! the cut
        type(ordinate_form_type), intent(in) :: form    !! of ordinates
        character(widest_page) :: text
        text = 'CUT '//to_text(number)//'   '//plane_words(cut%plane, form)
        if (cut%name /= '') text = trim(text)//'   '//trim(cut%name)
        text = trim(text)//'   FLANGE '//merge('FWD', 'AFT', cut%is_flange_forward)
    end function head_of

    !> A plane in words: `STATION 20.000`.
    function plane_words(plane, form) result(text)
        type(plane_type), intent(in) :: plane           !! the plane
        type(ordinate_form_type), intent(in) :: form    !! of ordinates
        character(widest_page) :: text
        select case (plane%kind)
        case (cut_kind%station)
            text = 'STATION '//ordinate_words(form, plane%through(1))
        case (cut_kind%buttock)
            text = 'BUTT LINE '//ordinate_words(form, plane%through(2))
        case (cut_kind%waterline)
            text = 'WATERLINE '//ordinate_words(form, plane%through(3))
        case (cut_kind%oblique)
            text = 'OBLIQUE FRAME'
        case default
            text = 'PLANE'
        end select
    end function plane_words

    !> Prints the origin and the axes of an oblique cut, and its normal.
    subroutine print_axes(page, plane, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(plane_type), intent(in) :: plane           !! the plane
        type(ordinate_form_type), intent(in) :: form    !! of ordinates
        type(output_type), intent(inout) :: out         !! where it goes
        call page%line(out, 'U = V = 0 AT  STA '//ordinate_words(form, plane%origin(1))//'  BL '// &
            ordinate_words(form, plane%origin(2))//'  WL '//ordinate_words(form, plane%origin(3)))
        call page%line(out, 'U AXIS '//vector(plane%u)//'   V AXIS '//vector(plane%v)// &
            '   (STA BL WL)')
    end subroutine print_axes

    !> Prints the points of an outline under their heads. The section is named where it changes.
    subroutine print_points(page, cut, outline, sections, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(cut_type), intent(in) :: cut               !! the cut
        type(outline_type), intent(in) :: outline       !! the outline
        character(*), intent(in) :: sections(:)         !! names of the body's sections
        type(ordinate_form_type), intent(in) :: form    !! of ordinates
        type(output_type), intent(inout) :: out         !! where it goes
        character(widest_page) :: lines(2)
        integer :: i, section, ordinates, count

        ordinates = merge(5, 3, is_oblique(cut))*columns_of(is_oblique(cut), form)
        count = merge(2, 1, takes_two(page, is_oblique(cut), form))
        lines = head_row(is_oblique(cut), form)
        if (count == 1) lines(1) = columns(lines(1), 1, ordinates)//lines(2)
        call page%set_columns(out, lines(:count))
        section = 0
        do i = 1, size(outline%points)
            associate (point => outline%points(i))
                if (point%section /= section .and. point%section > 0) then
                    call page%line(out, trim(kind_word(cut, point%section))//' '// &
                        trim(sections(point%section)))
                    section = point%section
                end if
                lines = row(point, is_oblique(cut), form)
                if (count == 1) lines(1) = columns(lines(1), 1, ordinates)//lines(2)
                call print_lines(page, lines(:count), out)
            end associate
        end do
        call page%end_columns()
    end subroutine print_points

    !> Prints the outlines on patches and ducts.
    subroutine print_patched(page, cut, sections, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(cut_type), intent(in) :: cut               !! the cut
        character(*), intent(in) :: sections(:)         !! names of the body's sections and patches
        type(ordinate_form_type), intent(in) :: form    !! of ordinates
        type(output_type), intent(inout) :: out         !! where it goes
        integer :: i
        do i = 1, size(cut%patched)
            call page%keep(out, outline_lines)
            call page%line(out, 'ON '//trim(panels_word(cut))//': OUTLINE '//to_text(i)//' OF '// &
                to_text(size(cut%patched))// &
                trim(merge(', CLOSED', ', OPEN  ', cut%patched(i)%is_closed)))
            call print_points(page, cut, cut%patched(i), sections, form, out)
        end do
        call page%line(out, 'ON '//trim(panels_word(cut))//': WITHIN '// &
            trim(adjustl(scientific(form%factor*cut%off_plane, 10, 2)))//' OF THE PLANE')
    end subroutine print_patched

    !> Prints lines that stay together.
    subroutine print_lines(page, lines, out)
        type(page_type), intent(inout) :: page      !! the listing
        character(*), intent(in) :: lines(:)        !! the lines
        type(output_type), intent(inout) :: out     !! where they go
        integer :: i
        call page%keep(out, size(lines))
        do i = 1, size(lines)
            call page%line(out, lines(i))
        end do
    end subroutine print_lines

    !> Prints the outlines of the inside of the skin. One without points is left out: a note says
    !> why it has none.
    subroutine print_inside(page, cut, sections, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(cut_type), intent(in) :: cut               !! the cut
        character(*), intent(in) :: sections(:)         !! names of the body's sections
        type(ordinate_form_type), intent(in) :: form    !! of ordinates
        type(output_type), intent(inout) :: out         !! where it goes
        integer :: i
        do i = 1, size(cut%inside)
            if (size(cut%inside(i)%points) == 0) cycle
            call page%keep(out, outline_lines)
            call page%line(out, 'INSIDE OF SKIN, '//ordinate_words(form, cut%skin)// &
                ' THICK: OUTLINE '//to_text(i)//' OF '//to_text(size(cut%inside)))
            call print_points(page, cut, cut%inside(i), sections, form, out)
        end do
    end subroutine print_inside

    !> Prints what is to be known of a cut.
    subroutine print_notes(page, notes, out)
        type(page_type), intent(inout) :: page      !! the listing
        type(note_type), intent(in) :: notes(:)     !! the notes
        type(output_type), intent(inout) :: out     !! where they go
        integer :: i
        do i = 1, size(notes)
            call page%paragraph(out, merge('ERROR: ', 'NOTE:  ', notes(i)%is_error)// &
                notes(i)%message)
        end do
    end subroutine print_notes

    !> The heads of the columns: of the ordinates, and of what follows them.
    pure function head_row(has_true_shape, form) result(text)
        logical, intent(in) :: has_true_shape           !! u and v stand in front
        type(ordinate_form_type), intent(in) :: form    !! of ordinates
        character(len=widest_page) :: text(2)
        integer :: width

        width = columns_of(has_true_shape, form)
        text(1) = right('STA', width)//right('BL', width)//right('WL', width)
        if (has_true_shape) text(1) = right('U', width)//right('V', width)//text(1)
        text(2) = right('SLOPE', width)//right('RADIUS', width + 1)//right('BEVEL', bevel_width)
    end function head_row

    !> The row of a point: its ordinates, and what follows them. What does not exist there is left
    !> blank.
    pure function row(point, has_true_shape, form) result(text)
        type(cut_point_type), intent(in) :: point       !! the point
        logical, intent(in) :: has_true_shape           !! u and v stand in front
        type(ordinate_form_type), intent(in) :: form    !! of ordinates
        character(len=widest_page) :: text(2)
        character(:), allocatable :: ordinates, bevel
        integer :: width, i

        width = columns_of(has_true_shape, form)
        ordinates = ''
        bevel = ''
        if (has_true_shape) then
            ordinates = ordinate_text(form, point%uv(1), width)// &
                ordinate_text(form, point%uv(2), width)
        end if
        do i = 1, 3
            ordinates = ordinates//ordinate_text(form, point%at(i), width)
        end do
        text(1) = ordinates
        if (point%has_normal) bevel = fixed(point%bevel, bevel_width, bevel_decimals)
        text(2) = slope_figure(point, width)//radius_figure(point, form, width + 1)//bevel
    end function row

    !> Columns of an ordinate.
    pure integer function columns_of(has_true_shape, form)
        logical, intent(in) :: has_true_shape           !! five stand on a line, not three
        type(ordinate_form_type), intent(in) :: form    !! its decimals
        columns_of = merge(narrow_width, ordinate_width, has_true_shape) + max(3, form%decimals)
    end function columns_of

    !> True where a row is too wide for one line of the page, and takes two.
    pure logical function takes_two(page, has_true_shape, form)
        type(page_type), intent(in) :: page             !! its width
        logical, intent(in) :: has_true_shape           !! u and v stand in front
        type(ordinate_form_type), intent(in) :: form    !! of ordinates
        takes_two = merge(7, 5, has_true_shape)*columns_of(has_true_shape, form) + 1 + bevel_width &
            > page%width()
    end function takes_two

    !> The slope of a point in its columns; a steep one has fewer decimals.
    pure function slope_figure(point, width) result(text)
        type(cut_point_type), intent(in) :: point   !! the point
        integer, intent(in) :: width                !! columns
        character(int(width, i64)) :: text
        integer :: figures

        if (.not. point%has_slope) then
            text = right('', width)
        else if (point%slope%is_vertical) then
            text = right('VERTICAL', width)
        else
            figures = floor(log10(max(10.0_dp, abs(point%slope%value))))
            text = fixed(point%slope%value, width, max(0, slope_decimals + 1 - figures))
        end if
    end function slope_figure

    !> The radius of curvature of a point in its columns, positive where the outline turns left.
    pure function radius_figure(point, form, width) result(text)
        type(cut_point_type), intent(in) :: point       !! the point
        type(ordinate_form_type), intent(in) :: form    !! of ordinates
        integer, intent(in) :: width                    !! columns
        character(int(width, i64)) :: text
        if (.not. point%has_curvature) then
            text = right('', width)
        else if (is_zero(point%curvature)) then
            text = right('STRAIGHT', width)
        else
            text = fixed(form%factor/point%curvature, width, form%decimals)
        end if
    end function radius_figure

    !> True where the true shape of a cut is not one of the three views.
    pure logical function is_oblique(cut)
        type(cut_type), intent(in) :: cut !! the cut
        is_oblique = cut%plane%kind == cut_kind%oblique .or. cut%plane%kind == cut_kind%plane
    end function is_oblique

    !> A unit vector in a sentence.
    pure function vector(v) result(text)
        real(dp), intent(in) :: v(3) !! STA, BL, WL
        character(len('(, , )', i64) + sum(compact_length(v))) :: text
        text = '('//compact(v(1))//', '//compact(v(2))//', '//compact(v(3))//')'
    end function vector

end module report_cut_listing
