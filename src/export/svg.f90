!> Pages of patterns as SVG (Scalable Vector Graphics 1.1, W3C 2003): width and height in inches,
!> user units of a thousandth of an inch. Each part is a group, and in it each layer; Inkscape shows
!> them as layers. There are no styles and no references to other files: cutters read few of these.
module export_svg
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: to_text
    use export_pattern_letters, only: codes_of, utf8
    use export_pattern_number, only: short
    use export_pattern_page, only: drawing_order, is_straight, item_kind, item_type, label_type, &
        page_type, side
    use export_pattern_style, only: layer_of, layers, look_of, look_type
    implicit none (type, external)
    private

    public :: write_svg

    !> User units of an inch, and decimals of theirs.
    real(dp), parameter :: mils = 1000.0_dp
    integer, parameter :: decimals = 4

contains

    !> Writes a page.
    subroutine write_svg(page, out)
        type(page_type), intent(in) :: page         !! the page
        type(output_type), intent(inout) :: out     !! where it goes
        integer, allocatable :: order(:)
        integer :: i, k, group, layer

        call begin(page, out)
        allocate (order(0))
        order = drawing_order(page)
        group = -1
        layer = 0
        do i = 1, size(order)
            k = order(i)
            if (page%items(k)%group /= group) then
                if (layer > 0) call out%line('</g>')
                if (group >= 0) call out%line('</g>')
                group = page%items(k)%group
                layer = 0
                call open_part(page, group, out)
            end if
            if (layer_of(page%items(k)%style) /= layer .and. group > 0) then
                if (layer > 0) call out%line('</g>')
                layer = layer_of(page%items(k)%style)
                call open_layer(page, group, layer, out)
            end if
            call write_item(page%items(k), page%size(2), out)
        end do
        if (layer > 0) call out%line('</g>')
        if (group >= 0) call out%line('</g>')
        call out%line('</svg>')
    end subroutine write_svg

    !> Writes what stands before the items.
    subroutine begin(page, out)
        type(page_type), intent(in) :: page         !! the page
        type(output_type), intent(inout) :: out     !! where it goes

        call out%line('<?xml version="1.0" encoding="UTF-8"?>')
        call out%line('<svg xmlns="http://www.w3.org/2000/svg" version="1.1"')
        call out%line('    xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"')
        call out%line('    width="'//short(page%size(1), 6)//'in" height="'// &
            short(page%size(2), 6)//'in" viewBox="0 0 '//units(page%size(1))//' '// &
            units(page%size(2))//'"')
        call out%line('    font-family="Helvetica, Arial, sans-serif" fill="none" '// &
            'stroke-linecap="butt" stroke-linejoin="round">')
        call out%line('<title>'//escaped(page%title//', '//page%label)//'</title>')
        if (.not. page%is_clipped) return
        associate (box => page%window)
            call out%line('<defs><clipPath id="window"><rect x="'//units(box(1))//'" y="'// &
                units(page%size(2) - box(4))//'" width="'//units(box(3) - box(1))// &
                '" height="'//units(box(4) - box(2))//'"/></clipPath></defs>')
        end associate
    end subroutine begin

    !> Opens the group of a part, or of the sheet.
    subroutine open_part(page, group, out)
        type(page_type), intent(in) :: page         !! the page
        integer, intent(in) :: group                !! place in its groups; 0: the sheet
        type(output_type), intent(inout) :: out     !! where it goes
        character(:), allocatable :: clip

        if (group == 0) then
            call out%line('<g id="sheet" inkscape:groupmode="layer" inkscape:label="sheet">')
            return
        end if
        clip = ''
        if (page%is_clipped) clip = ' clip-path="url(#window)"'
        call out%line('<g id="'//name_of(page, group)//'" inkscape:groupmode="layer" '// &
            'inkscape:label="'//escaped(page%groups(group)%title)//'"'//clip//'>')
    end subroutine open_part

    !> Opens the group of a layer of a part.
    subroutine open_layer(page, group, layer, out)
        type(page_type), intent(in) :: page         !! the page
        integer, intent(in) :: group                !! place in its groups
        integer, intent(in) :: layer                !! place in `layers`
        type(output_type), intent(inout) :: out     !! where it goes
        call out%line('<g id="'//name_of(page, group)//'.'//trim(layers(layer))// &
            '" inkscape:groupmode="layer" inkscape:label="'//trim(layers(layer))//'">')
    end subroutine open_layer

    !> The name of a part: letters of its own in front make it a name in XML.
    pure function name_of(page, group) result(name)
        type(page_type), intent(in) :: page     !! the page
        integer, intent(in) :: group            !! place in its groups
        character(:), allocatable :: name
        name = 'part-'//page%groups(group)%name
    end function name_of

    !> Writes an item.
    subroutine write_item(item, height, out)
        type(item_type), intent(in) :: item         !! the item
        real(dp), intent(in) :: height              !! of the page, in
        type(output_type), intent(inout) :: out     !! where it goes
        type(look_type) :: look

        look = look_of(item%style)
        if (item%kind == item_kind%words) then
            call write_words(item%at(:, 1), item%label, look, height, out)
            return
        end if
        call out%put('<path d="')
        if (item%kind == item_kind%curves) then
            call write_curves(item, height, out)
        else
            call write_lines(item, height, out)
        end if
        if (item%is_closed) call out%put(' Z')
        call out%line('" '//paint(look)//'/>')
    end subroutine write_item

    !> Writes straight lines from point to point.
    subroutine write_lines(item, height, out)
        type(item_type), intent(in) :: item         !! lines
        real(dp), intent(in) :: height              !! of the page, in
        type(output_type), intent(inout) :: out     !! where it goes
        integer :: i

        call out%put('M '//place(item%at(:, 1), height))
        do i = 2, size(item%at, 2)
            call out%put(' L '//place(item%at(:, i), height))
        end do
    end subroutine write_lines

    !> Writes Bezier arcs, straight ones as lines, one a line of text.
    subroutine write_curves(item, height, out)
        type(item_type), intent(in) :: item         !! curves
        real(dp), intent(in) :: height              !! of the page, in
        type(output_type), intent(inout) :: out     !! where it goes
        integer :: i

        call out%put('M '//place(item%at(:, 1), height))
        do i = 4, size(item%at, 2), 3
            call out%line('')
            if (is_straight(item%at(:, i - 3:i))) then
                call out%put('L '//place(item%at(:, i), height))
            else
                call out%put('C '//place(item%at(:, i - 2), height)//' '// &
                    place(item%at(:, i - 1), height)//' '//place(item%at(:, i), height))
            end if
        end do
    end subroutine write_curves

    !> Writes words.
    subroutine write_words(at, label, look, height, out)
        real(dp), intent(in) :: at(2)               !! where they stand, in
        type(label_type), intent(in) :: label       !! what
        type(look_type), intent(in) :: look         !! how
        real(dp), intent(in) :: height              !! of the page, in
        type(output_type), intent(inout) :: out     !! where it goes
        character(:), allocatable :: more

        more = ''
        if (label%side == side%middle) more = ' text-anchor="middle"'
        if (label%side == side%left) more = ' text-anchor="end"'
        if (label%is_bold) more = more//' font-weight="bold"'
        call out%line('<text transform="matrix('//short(label%along(1), 6)//' '// &
            short(-label%along(2), 6)//' '//short(label%along(2), 6)//' '// &
            short(label%along(1), 6)//' '//place(at, height)//')" font-size="'// &
            units(label%height)//'"'//more//' xml:space="preserve" '//paint(look)//'>'// &
            escaped(label%text)//'</text>')
    end subroutine write_words

    !> How lines are drawn or areas filled.
    pure function paint(look) result(text)
        type(look_type), intent(in) :: look !! the look
        character(:), allocatable :: text
        integer :: i

        if (look%is_filled) then
            text = 'fill="'//colour(look%colour)//'"'
            return
        end if
        text = 'stroke="'//colour(look%colour)//'" stroke-width="'//units(look%width)//'"'
        if (look%dash(1) <= 0.0_dp) return
        text = text//' stroke-dasharray="'//units(look%dash(1))
        do i = 2, size(look%dash)
            if (look%dash(i) > 0.0_dp) text = text//' '//units(look%dash(i))
        end do
        text = text//'"'
    end function paint

    !> A colour: `#1a4d99`.
    pure function colour(rgb) result(text)
        real(dp), intent(in) :: rgb(3) !! red, green, blue: 0 to 1
        character(7) :: text
        write (text, '(a,3z2.2)') '#', nint(255.0_dp*rgb)
    end function colour

    !> A point in user units, y down.
    pure function place(at, height) result(text)
        real(dp), intent(in) :: at(2)       !! in, y up
        real(dp), intent(in) :: height      !! of the page, in
        character(:), allocatable :: text
        text = units(at(1))//' '//units(height - at(2))
    end function place

    !> A length in user units.
    pure function units(length) result(text)
        real(dp), intent(in) :: length !! in
        character(:), allocatable :: text
        text = short(mils*length, decimals)
    end function units

    !> Text as XML holds it.
    pure function escaped(text)
        character(*), intent(in) :: text !! any bytes
        character(:), allocatable :: escaped
        integer, allocatable :: codes(:)
        integer :: i

        allocate (codes(0))
        codes = codes_of(text)
        escaped = ''
        do i = 1, size(codes)
            select case (codes(i))
            case (34, 38, 39, 60, 62)
                escaped = escaped//'&#'//to_text(codes(i))//';'
            case default
                escaped = escaped//utf8(codes(i))
            end select
        end do
    end function escaped

end module export_svg
