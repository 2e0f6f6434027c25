!> Pages of a listing: turning, headings, widths.
program test_page
    use base_constants, only: version
    use base_output, only: output_type
    use base_text, only: characters, to_text
    use report_page, only: page_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character(*), parameter :: feed = new_line('a'), form_feed = achar(12)
    character(*), parameter :: u_umlaut = char(195)//char(188)

    call check_heading()
    call check_turning()
    call check_columns()
    call check_keeping()
    call check_long_headings()
    call check_paragraphs()
    call check_size()
    call tap%finish()

contains

    !> The head of the first page, to the last character.
    subroutine check_heading()
        type(page_type) :: page
        type(output_type) :: out

        call page%set_heading('NOSE', 'nose.crd', 'INCHES')
        call page%line(out, 'FIRST LINE  ')
        call tap%same(out%text(), 'NOSE'//repeat(' ', 70)//'PAGE 1'//feed// &
            'nose.crd'//repeat(' ', 32)//'INCHES'//repeat(' ', &
            80 - 46 - 5 - len(version))//'LOFT '//version// &
            feed//feed//'FIRST LINE'//feed, &
            'title, page, deck, unit and version stand above the first line')
    end subroutine check_heading

    !> 200 lines on pages of 60.
    subroutine check_turning()
        type(page_type) :: page
        type(output_type) :: out
        character(:), allocatable :: text
        integer :: i, last

        call page%set_heading('', 'nose.crd', '')
        do i = 1, 200
            call page%line(out, '<'//to_text(i)//'>')
        end do
        text = out%text()
        call tap%ok(count_of(text, '<') == 200, 'no line is lost or printed twice')
        call tap%ok(count_of(text, form_feed) == 3 .and. count_of(text, 'PAGE') == 4, &
            '57 lines fit a page; a form feed stands between two')
        call tap%ok(index(text, '<57>'//feed//form_feed) > 0 .and. index(text, &
            '<171>'//feed//form_feed) > 0, &
            'the pages turn when they are full')
        call tap%ok(index(text, 'PAGE 4') > index(text, '<171>') .and. index(text, &
            'PAGE 4') < index(text, '<172>'), &
            'pages are numbered')
        call tap%ok(count_of(text, feed) == 200 + 4*3, 'every page has its three lines of heading')
        call page%set_heading('', 'nose.crd', '')
        do i = 201, 228
            call page%line(out, '<'//to_text(i)//'>')
        end do
        last = len(out%text())
        call page%blank(out)
        call tap%ok(len(out%text()) == last, 'a blank line at the foot of a page is left out')
        call page%line(out, 'NEXT')
        call page%blank(out)
        call page%line(out, 'LAST')
        text = out%text()
        call tap%ok(index(text(last:), 'NEXT'//feed//feed//'LAST'//feed) > 0, &
            'a blank line elsewhere is not')
    end subroutine check_turning

    !> Column headings come again on every page until they are ended.
    subroutine check_columns()
        type(page_type) :: page
        type(output_type) :: out
        character(:), allocatable :: text
        integer :: i

        call page%set_heading('', '', '')
        call page%set_columns(out, ['  X    Y', 'UPPER   '])
        do i = 1, 100
            call page%line(out, '<'//to_text(i)//'>')
        end do
        text = out%text()
        call tap%ok(count_of(text, '  X    Y'//feed//'UPPER'//feed) == 2, &
            'a column heading stands on each of two pages')
        call tap%ok(index(text, '<55>'//feed//form_feed) > 0 .and. count_of(text, '<') == 100, &
            'beside it 55 lines fit')
        call page%end_columns()
        do i = 1, 60
            call page%line(out, '<'//to_text(i)//'>')
        end do
        call tap%ok(count_of(out%text(), 'UPPER') == 2, 'ended, it is not repeated')
        call page%set_columns(out, ['LOWER'])
        do i = 1, 50
            call page%line(out, 'x')
        end do
        call page%set_columns(out, ['OTHER'])
        do i = 1, 60
            call page%line(out, 'y')
        end do
        text = out%text()
        call tap%ok(count_of(text, 'OTHER') == 2 .and. index(text, 'LOWER', &
            back=.true.) < index(text, 'OTHER'), &
            'a new heading takes the place of the old')
    end subroutine check_columns

    !> Lines that belong together.
    subroutine check_keeping()
        type(page_type) :: page
        type(output_type) :: out
        character(:), allocatable :: text
        integer :: i

        call page%set_heading('', '', '')
        do i = 1, 50
            call page%line(out, 'x')
        end do
        call page%keep(out, 7)
        call page%line(out, 'SEVEN FIT')
        call page%keep(out, 7)
        call page%line(out, 'NO MORE')
        text = out%text()
        call tap%ok(index(text, 'x'//feed//'SEVEN FIT'//feed//form_feed) > 0, &
            'the page turns only where the lines do not fit')
        call tap%ok(count_of(text, form_feed) == 1, 'and only once')

        call page%keep(out, 56)
        call page%set_columns(out, ['HEAD'])
        do i = 1, 53
            call page%line(out, 'y')
        end do
        call page%set_columns(out, ['FOOT'])
        text = out%text()
        call tap%ok(index(text, 'y'//feed//form_feed) > 0 .and. count_of(text, 'FOOT') == 1, &
            'a column heading does not stand alone at the foot of a page')
        call tap%ok(count_of(text(index(text, form_feed, back=.true.):), 'HEAD') == 0, &
            'and the page begun for it does not repeat the heading it replaces')
    end subroutine check_keeping

    !> Headings that are too long for their line.
    subroutine check_long_headings()
        call tap%ok(all(heading_widths(repeat('T', 72), 'nose.crd', 'INCHES', 99) == 80), &
            'a title of 72 letters leaves room for 99 pages')
        call tap%ok(all(heading_widths(repeat('T', 72), 'nose.crd', 'INCHES', 101) == 80), &
            'or is cut for more')
        call tap%ok(all(heading_widths(repeat(u_umlaut, 72), repeat(u_umlaut, 300), 'MM', &
            1) == 80), &
            'letters of two bytes count once, and a long name is cut')
        call tap%ok(all(heading_widths('', repeat('d', 50), 'INCHES', 1) == 80), &
            'a name past the middle moves the unit on')
    end subroutine check_long_headings

    !> Sentences of any length.
    subroutine check_paragraphs()
        type(page_type) :: page
        type(output_type) :: out
        character(:), allocatable :: text

        call page%set_heading('', '', '')
        call page%paragraph(out, repeat('a', 39)//' '//repeat('b', 40)//' c')
        call page%paragraph(out, repeat('d', 80))
        call page%paragraph(out, repeat('e', 100))
        text = out%text()
        call tap%ok(index(text, repeat('a', 39)//' '//repeat('b', 40)//feed//'  c'//feed) > 0, &
            'a sentence is broken between words, where its line is full')
        call tap%ok(index(text, feed//repeat('d', 80)//feed) > 0, 'a line that just fits is not')
        call tap%ok(index(text, feed//repeat('e', 80)//feed//'  '//repeat('e', 20)//feed) > 0, &
            'a word longer than the line is')
    end subroutine check_paragraphs

    !> Pages of another size.
    subroutine check_size()
        type(page_type) :: page
        type(output_type) :: out
        character(:), allocatable :: text
        integer :: i

        call page%set_size(132, 20)
        call page%set_heading('NOSE', 'nose.crd', 'MM')
        call tap%ok(page%width() == 132, 'a page has the width it was given')
        do i = 1, 40
            call page%line(out, 'x')
        end do
        text = out%text()
        call tap%ok(index(text, feed) == 133, 'the heading is as wide')
        call tap%ok(count_of(text, form_feed) == 2, '17 lines fit 20')
    end subroutine check_size

    !> Characters in the two heading lines of a page.
    function heading_widths(title, deck, units, number) result(widths)
        character(*), intent(in) :: title !! first line
        character(*), intent(in) :: deck  !! second line
        character(*), intent(in) :: units !! second line
        integer, intent(in) :: number     !! which page
        integer :: widths(2)
        type(page_type) :: page
        type(output_type) :: out
        character(:), allocatable :: text
        integer :: i, end_of_first, end_of_second

        call page%set_heading(title, deck, units)
        do i = 1, (number - 1)*57 + 1
            call page%line(out, 'x')
        end do
        text = out%text()
        if (number > 1) text = text(index(text, form_feed, back=.true.) + 1:)
        end_of_first = index(text, feed)
        end_of_second = end_of_first + index(text(end_of_first + 1:), feed)
        widths(1) = characters(text(:end_of_first - 1))
        widths(2) = characters(text(end_of_first + 1:end_of_second - 1))
        if (index(text(:end_of_first), ' PAGE '//to_text(number)) == 0) widths(1) = -1
        if (index(text(:end_of_second), '  '//units//' ') == 0) widths(2) = -1
    end function heading_widths

    !> How often a text stands in another.
    integer function count_of(text, part)
        character(*), intent(in) :: text !! the text
        character(*), intent(in) :: part !! what is counted
        integer :: at, step
        count_of = 0
        at = 1
        do
            step = index(text(at:), part)
            if (step == 0) exit
            count_of = count_of + 1
            at = at + step - 1 + len(part)
        end do
    end function count_of

end program test_page
