!> Tests of PDF files.
program test_pdf
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_output, only: output_type
    use export_pattern_page, only: label_type, page_type, side
    use export_pattern_style, only: style
    use export_pdf, only: write_pdf
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(page_type) :: pages(2)
    type(label_type) :: label
    type(output_type) :: out, again
    type(error_type), allocatable :: error
    character(:), allocatable :: text

    pages(1)%title = 'DECK (1)'
    pages(2)%title = 'DECK (1)'
    pages(1)%label = 'STATION 20'
    pages(2)%label = 'A1'
    pages(1)%size = [10.0_dp, 200.0_dp]
    pages(2)%size = [8.5_dp, 11.0_dp]
    call pages(1)%draw_curves(style%outline, reshape([1.0_dp, 1.0_dp, 1.0_dp, 2.0_dp, 2.0_dp, &
        3.0_dp, 3.0_dp, 3.0_dp, 4.0_dp, 3.0_dp, 5.0_dp, 3.0_dp, 6.0_dp, 3.0_dp], [2, 7]), .true.)
    call pages(2)%open_group('A', 'A')
    call pages(2)%draw(style%centre, reshape([0.0_dp, 0.0_dp, 1.0_dp/3.0_dp, 1.0_dp], [2, 2]))
    call pages(2)%close_group()
    label%text = 'TA'
    label%side = side%left
    label%height = 0.5_dp
    label%along = [0.0_dp, 1.0_dp]
    call pages(2)%write(style%sheet_words, [2.0_dp, 4.0_dp], label)
    pages(2)%is_clipped = .true.
    pages(2)%window = [1.0_dp, 2.0_dp, 7.0_dp, 8.0_dp]
    call write_pdf(pages, out, error)
    text = out%text()
    call tap%ok(.not. allocated(error), 'pages are written')
    call tap%has(text, '/MediaBox [0 0 720 14400]', '72 units are an inch, 200 in are not too long')
    call tap%has(text, '/MediaBox [0 0 612 792]', 'each page has its size')
    call tap%has(text, '/Count 2 /Kids [6 0 R 8 0 R ]', 'and is in the tree')
    call tap%has(text, '/Nums [0 << /P (STATION 20) >> 1 << /P (A1) >> ]', 'pages have names')
    call tap%has(text, '/PrintScaling /None', 'printers are asked not to scale')
    call tap%has(text, '/Title (DECK \(1\))', 'the file has a title')
    call tap%ok(index(text, 'Date') == 0 .and. index(text, '/ID') == 0, 'no date, no identifier')
    call tap%has(text, '72 72 m'//new_line('a')//'72 144 144 216 216 216 c'//new_line('a')// &
        '432 216 l'//new_line('a')//'s'//new_line('a'), &
        'curves are cubic, straight arcs lines, what is closed is closed')
    call tap%has(text, '24 72 l', 'a third of an inch is 24 units')
    call tap%has(text, '72 144 432 432 re W n', 'a tile has a window')
    call tap%ok(index(text, 're W n') < index(text, '24 72 l') .and. index(text, '24 72 l') < &
        index(text, new_line('a')//'Q') .and. index(text, new_line('a')//'Q') < &
        index(text, '(TA) Tj'), 'for its parts, not for the sheet')
    ! T and A are 1.278 em wide: 46.008 units of 36.
    call tap%has(text, 'BT /F1 36 Tf 0 1 -1 0 144 241.992 Tm (TA) Tj ET', &
        'words that end at a point begin as far before it as they are wide')
    call write_pdf(pages, again, error)
    call tap%ok(again%text() == text, 'the same pages give the same bytes')

    pages(1)%size(2) = 200.1_dp
    call write_pdf(pages, again, error)
    call tap%ok(allocated(error), 'a page longer than 200 in is refused')
    if (allocated(error)) call tap%has(error%message, &
        'page STATION 20 is 10.000 by 200.100 in', 'by its name')
    call tap%ok(len(again%text()) == len(text), 'and nothing is written')
    call tap%finish()
end program test_pdf
