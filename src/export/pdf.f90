!> Pages of patterns as PDF 1.4: 72 units per inch, Helvetica (which every reader has), nothing
!> compressed, no dates and no identifiers, so that the same pages give the same bytes.
!>
!> Pages are no larger than 200 in: readers that do not know of larger ones print them too small.
!>
!> Source: PDF Reference, 3rd ed., Adobe Portable Document Format 1.4; appendix C for 14400 units.
module export_pdf
    use base_constants, only: version
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: to_text
    use export_pattern_letters, only: text_width
    use export_pattern_number, only: inches, short
    use export_pattern_page, only: drawing_order, is_straight, item_kind, item_type, label_type, &
        largest_page, page_type
    use export_pattern_style, only: look_of, look_type
    use export_pdf_file, only: pdf_file_type, pdf_text
    implicit none (type, external)
    private

    public :: write_pdf

    !> Units of an inch, and decimals of a unit.
    real(dp), parameter :: points = 72.0_dp
    integer, parameter :: decimals = 5
    !> Numbers of the objects that every file has; two for each page follow.
    integer, parameter :: catalogue = 1, tree = 2, info = 3, fonts(2) = [4, 5], first_page = 6

contains

    !> Writes pages. Fails with `cause%usage` where a page is too large.
    subroutine write_pdf(pages, out, error)
        type(page_type), intent(in) :: pages(:)             !! at least one
        type(output_type), intent(inout) :: out             !! where it goes
        type(error_type), allocatable, intent(out) :: error !! see above
        type(pdf_file_type) :: file
        integer :: i

        call refuse_large(pages, error)
        if (allocated(error)) return
        call file%begin(first_page - 1 + 2*size(pages), out)
        call file%object(catalogue, '<< /Type /Catalog /Pages '//to_text(tree)//' 0 R '// &
            '/PageLabels << /Nums ['//labels_of(pages)//'] >> '// &
            '/ViewerPreferences << /PrintScaling /None >> >>', out)
        call file%object(tree, '<< /Type /Pages /Count '//to_text(size(pages))//' /Kids ['// &
            kids_of(pages)//'] >>', out)
        call file%object(info, '<< /Title '//pdf_text(pages(1)%title)//' /Producer (LOFT '// &
            version//') >>', out)
        call file%object(fonts(1), font('Helvetica'), out)
        call file%object(fonts(2), font('Helvetica-Bold'), out)
        do i = 1, size(pages)
            call write_page(pages(i), first_page + 2*(i - 1), file, out)
        end do
        call file%finish(catalogue, info, out)
    end subroutine write_pdf

    !> Fails with `cause%usage` where a page is larger than readers take.
    subroutine refuse_large(pages, error)
        type(page_type), intent(in) :: pages(:)             !! the pages
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: i

        do i = 1, size(pages)
            if (maxval(pages(i)%size) <= largest_page) cycle
            call fail(error, cause%usage, 'page '//pages(i)%label//' is '// &
                inches(pages(i)%size(1))//' by '//inches(pages(i)%size(2))//' in, and a page '// &
                'of a PDF ends at 200 in; take paper (a4, letter, a3, tabloid), SVG or a sheet '// &
                'for each cut')
            return
        end do
    end subroutine refuse_large

    !> Names of the pages, by their numbers from 0.
    pure function labels_of(pages) result(text)
        type(page_type), intent(in) :: pages(:) !! the pages
        character(:), allocatable :: text
        integer :: i
        text = ''
        do i = 1, size(pages)
            text = text//to_text(i - 1)//' << /P '//pdf_text(pages(i)%label)//' >> '
        end do
    end function labels_of

    !> References to the pages.
    pure function kids_of(pages) result(text)
        type(page_type), intent(in) :: pages(:) !! the pages
        character(:), allocatable :: text
        integer :: i
        text = ''
        do i = 1, size(pages)
            text = text//to_text(first_page + 2*(i - 1))//' 0 R '
        end do
    end function kids_of

    !> One of the types that every reader has.
    pure function font(name) result(text)
        character(*), intent(in) :: name !! of the type
        character(:), allocatable :: text
        text = '<< /Type /Font /Subtype /Type1 /BaseFont /'//name//' /Encoding /WinAnsiEncoding >>'
    end function font

    !> Writes a page and what is on it.
    subroutine write_page(page, number, file, out)
        type(page_type), intent(in) :: page             !! the page
        integer, intent(in) :: number                   !! of its object
        type(pdf_file_type), intent(inout) :: file      !! gets both
        type(output_type), intent(inout) :: out         !! where it goes
        type(output_type) :: stream

        call file%object(number, '<< /Type /Page /Parent '//to_text(tree)// &
            ' 0 R /MediaBox [0 0 '//units(page%size(1))//' '//units(page%size(2))// &
            '] /Resources << /Font << /F1 '//to_text(fonts(1))//' 0 R /F2 '//to_text(fonts(2))// &
            ' 0 R >> >> /Contents '//to_text(number + 1)//' 0 R >>', out)
        call draw_page(page, stream)
        call file%stream(number + 1, stream%text(), out)
    end subroutine write_page

    !> Draws what is on a page: the parts within its window, then what belongs to the sheet.
    subroutine draw_page(page, out)
        type(page_type), intent(in) :: page         !! the page
        type(output_type), intent(inout) :: out     !! gets it
        integer, allocatable :: order(:)
        integer :: i, style
        logical :: is_clipped

        allocate (order(0))
        order = drawing_order(page)
        call out%line('1 j')
        is_clipped = page%is_clipped
        if (is_clipped) call out%line('q '//units(page%window(1))//' '//units(page%window(2))// &
            ' '//units(page%window(3) - page%window(1))//' '// &
            units(page%window(4) - page%window(2))//' re W n')
        style = 0
        do i = 1, size(order)
            associate (item => page%items(order(i)))
                if (is_clipped .and. item%group == 0) then
                    call out%line('Q')
                    is_clipped = .false.
                    style = 0
                end if
                if (item%style /= style) call set_look(look_of(item%style), out)
                style = item%style
                call draw_item(item, out)
            end associate
        end do
        if (is_clipped) call out%line('Q')
    end subroutine draw_page

    !> Says how the next items look.
    subroutine set_look(look, out)
        type(look_type), intent(in) :: look         !! the look
        type(output_type), intent(inout) :: out     !! gets it
        character(:), allocatable :: colour, dashes
        integer :: i

        colour = short(look%colour(1), 3)//' '//short(look%colour(2), 3)//' '// &
            short(look%colour(3), 3)
        if (look%is_filled) then
            call out%line(colour//' rg')
            return
        end if
        dashes = ''
        do i = 1, size(look%dash)
            if (look%dash(i) > 0.0_dp) dashes = dashes//units(look%dash(i))//' '
        end do
        call out%line(colour//' RG '//units(look%width)//' w ['//dashes//'] 0 d')
    end subroutine set_look

    !> Draws an item.
    subroutine draw_item(item, out)
        type(item_type), intent(in) :: item         !! the item
        type(output_type), intent(inout) :: out     !! gets it
        type(look_type) :: look
        character :: deed
        integer :: i

        look = look_of(item%style)
        if (item%kind == item_kind%words) then
            call draw_words(item%at(:, 1), item%label, out)
            return
        end if
        call out%line(place(item%at(:, 1))//' m')
        do i = 2, size(item%at, 2)
            if (item%kind == item_kind%lines) then
                call out%line(place(item%at(:, i))//' l')
            else if (mod(i, 3) == 1) then
                call draw_curve(item%at(:, i - 3:i), out)
            end if
        end do
        deed = merge('s', 'S', item%is_closed)
        if (look%is_filled) deed = 'f'
        call out%line(deed)
    end subroutine draw_item

    !> Draws a Bezier arc from where the pen is.
    subroutine draw_curve(control, out)
        real(dp), intent(in) :: control(2, 4)       !! its control points, in
        type(output_type), intent(inout) :: out     !! gets it

        if (is_straight(control)) then
            call out%line(place(control(:, 4))//' l')
        else
            call out%line(place(control(:, 2))//' '//place(control(:, 3))//' '// &
                place(control(:, 4))//' c')
        end if
    end subroutine draw_curve

    !> Draws words.
    subroutine draw_words(at, label, out)
        real(dp), intent(in) :: at(2)               !! where they stand, in
        type(label_type), intent(in) :: label       !! what
        type(output_type), intent(inout) :: out     !! gets it
        real(dp) :: start(2)

        start = at - 0.5_dp*real(label%side, dp)*label%along* &
            text_width(label%text, label%height, label%is_bold)
        call out%line('BT /F'//merge('2', '1', label%is_bold)//' '//units(label%height)//' Tf '// &
            short(label%along(1), 6)//' '//short(label%along(2), 6)//' '// &
            short(-label%along(2), 6)//' '//short(label%along(1), 6)//' '//place(start)// &
            ' Tm '//pdf_text(label%text)//' Tj ET')
    end subroutine draw_words

    !> A point in units.
    pure function place(at) result(text)
        real(dp), intent(in) :: at(2) !! in
        character(:), allocatable :: text
        text = units(at(1))//' '//units(at(2))
    end function place

    !> A length in units.
    pure function units(length) result(text)
        real(dp), intent(in) :: length !! in
        character(:), allocatable :: text
        text = short(points*length, decimals)
    end function units

end module export_pdf
