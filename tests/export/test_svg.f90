!> Tests of SVG files.
program test_svg
    use base_kinds, only: dp
    use base_output, only: output_type
    use export_pattern_page, only: label_type, page_type, side
    use export_pattern_style, only: style
    use export_svg, only: write_svg
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(page_type) :: page
    type(label_type) :: label
    type(output_type) :: out, again
    character(:), allocatable :: text

    page%name = 'STA_20'
    page%title = 'A & B'
    page%label = 'A1'
    page%size = [12.5_dp, 9.0_dp]
    call page%open_group('20_CABIN', 'STATION "20" <CABIN> '//char(255)//char(195)//char(169))
    call page%draw_curves(style%outline, reshape([1.0_dp, 1.0_dp, 1.0_dp, 2.0_dp, 2.0_dp, 3.0_dp, &
        3.0_dp, 3.0_dp, 4.0_dp, 3.0_dp, 5.0_dp, 3.0_dp, 6.0_dp, 3.0_dp], [2, 7]), .true.)
    call page%draw(style%centre, reshape([0.0_dp, 0.0_dp, 12.3456789_dp, 9.0_dp], [2, 2]))
    call page%close_group()
    label%text = '<&>'
    label%side = side%middle
    label%height = 0.25_dp
    label%along = [0.0_dp, 1.0_dp]
    call page%write(style%sheet_words, [2.0_dp, 4.0_dp], label)
    call write_svg(page, out)
    text = out%text()
    call tap%has(text, 'width="12.5in" height="9in" viewBox="0 0 12500 9000"', &
        'the page has its size in inches')
    call tap%has(text, '<title>A &#38; B, A1</title>', 'and a title')
    call tap%has(text, 'd="M 1000 8000'//new_line('a')//'C 1000 7000 2000 6000 3000 6000'// &
        new_line('a')//'L 6000 6000 Z"', 'curves are cubic, straight arcs lines, y goes down')
    call tap%has(text, 'L 12345.6789 0"', 'coordinates have four decimals of a mil')
    call tap%has(text, 'stroke-width="13.7795"', 'lines their weight')
    call tap%has(text, 'stroke-dasharray="500 60 60 60"', 'and dashes')
    call tap%has(text, '<g id="part-20_CABIN" inkscape:groupmode="layer" '// &
        'inkscape:label="STATION &#34;20&#34; &#60;CABIN&#62; '//char(239)//char(191)// &
        char(189)//char(195)//char(169)//'">', 'a part is a layer, its title escaped and UTF-8')
    call tap%has(text, '<g id="part-20_CABIN.outline" inkscape:groupmode="layer"', &
        'with layers of its own')
    call tap%has(text, '<text transform="matrix(0 -1 1 0 2000 5000)" font-size="250" '// &
        'text-anchor="middle" xml:space="preserve" fill="#000000">&#60;&#38;&#62;</text>', &
        'words are text, turned, in the middle')
    call tap%ok(count_of(text, '<g ') == 4 .and. count_of(text, '</g>') == 4, 'groups are closed')
    call tap%ok(index(text, 'clip') == 0, 'a page that is no tile is not clipped')
    call tap%ok(index(text, 'href') == 0 .and. index(text, 'url(') == 0, 'nothing is from outside')

    page%is_clipped = .true.
    page%window = [1.0_dp, 2.0_dp, 11.0_dp, 8.0_dp]
    call write_svg(page, again)
    text = again%text()
    call tap%has(text, '<rect x="1000" y="1000" width="10000" height="6000"/>', &
        'a tile has a window')
    call tap%ok(count_of(text, 'clip-path="url(#window)"') == 1, 'for its parts, not for the sheet')
    call tap%finish()

contains

    !> How often a text has another.
    integer function count_of(text, part) result(number)
        character(*), intent(in) :: text    !! where to look
        character(*), intent(in) :: part    !! for what
        integer :: i
        number = 0
        do i = 1, len(text) - len(part) + 1
            if (text(i:i + len(part) - 1) == part) number = number + 1
        end do
    end function count_of

end program test_svg
