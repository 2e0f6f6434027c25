!> Tests of the gnuplot data and script of a drawing; also of text that would be a command.
program test_body_gnuplot
    use base_kinds, only: dp
    use base_output, only: output_type
    use export_body_drawing, only: drawing_type, word_side
    use export_body_gnuplot, only: print_drawing_data, print_drawing_script
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(drawing_type) :: drawing
    type(output_type) :: data, script
    character, parameter :: feed = new_line('a')
    character(:), allocatable :: text

    drawing = drawing_type(name='lines', script='sheet', heading='A"B', view='it''s', note='', &
        x_axis='x', y_axis='y')
    call drawing%draw('grid', reshape([0.0_dp, 1.0_dp, 2.0_dp, 3.0_dp], [2, 2]))
    call drawing%draw('section', reshape([1.0_dp, 2.0_dp, 3.0_dp], [3, 1]))
    call drawing%draw('section', reshape([4.0_dp, 5.0_dp, 6.0_dp], [3, 1]))
    call drawing%write_words('`rm`@x'//feed//'"; quit', [1.0_dp, 2.0_dp], word_side%left, 1)
    call print_drawing_data(drawing, data)
    text = data%text()
    call tap%ok(index(text, feed//feed//feed//'# index 1, section'//feed) > 0, &
        'layers are parted by two blank lines')
    call tap%ok(index(text, '1.0000000000000000E+000  2.0000000000000000E+000  '// &
        '3.0000000000000000E+000'//feed//feed//' 4.') > 0, &
        'lines of a layer are parted by one, and may be in space')
    call tap%ok(index(text, ' 1 -1 1'//feed) > 0, 'words have number, side and size')
    call print_drawing_script(drawing, 'pdf', script)
    text = script%text()
    call tap%ok(index(text, 'heading = "A\042B"'//feed) > 0, 'a quote is no quote of gnuplot')
    call tap%ok(index(text, 'word[1] = "\140rm\140\100x \042; quit"'//feed) > 0, &
        'nor is anything else of a text a command')
    call tap%ok(index(text, 'layers = 2'//feed//'array style[2]'//feed//'style[1] = "grid"'//feed) &
        > 0, 'the script names the styles')
    call tap%ok(index(text, 'format = "pdf"') > 0, 'the format is what was asked')
    call tap%ok(index(text, 'load ''sheet.gp'''//feed) == len(text) - 15, &
        'the last thing is to draw')
    call tap%finish()
end program test_body_gnuplot
