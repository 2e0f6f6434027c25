!> The script of a picture. That gnuplot obeys it is proved in plot.t.
program test_gnuplot_script
    use base_kinds, only: dp
    use base_output, only: output_type
    use export_gnuplot_script, only: print_gnuplot_script
    use export_picture, only: curve_type, frame_type, picture_type
    use geom_arc, only: line_between
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(picture_type) :: picture
    type(curve_type) :: curve
    type(output_type) :: out
    character(:), allocatable :: text
    character, parameter :: feed = new_line('a'), backslash = achar(92)

    picture%name = 'side'
    picture%heading = 'NOSE "B"'
    picture%view = 'Side view'
    picture%x_axis = 'station (STA), inches'
    picture%y_axis = 'waterline (WL), inches'
    curve%arc = line_between([0.0_dp, 0.0_dp], [1.0_dp, 1.0_dp])
    curve%name = 'MHB'//feed//'system "ls"'
    call picture%add(curve)
    curve%name = 'LCL'
    call picture%add(curve)
    call print_gnuplot_script(picture, frame_type([-1.0_dp, -2.0_dp], [3.0_dp, 4.0_dp], 4.0_dp), &
        'pdf', out)
    text = out%text()

    call tap%ok(has('picture = "side"'), 'the data file is named')
    call tap%ok(has('heading = "NOSE '//backslash//'042B'//backslash//'042"'), &
        'the title is a string')
    call tap%ok(has('y_axis = "waterline (WL), inches"'), 'an axis is named with its unit')
    call tap%ok(has('x_low  = -1.0000000000000000E+000') .and. &
        has('y_high =  4.0000000000000000E+000'), 'the frame is given')
    call tap%ok(has('curves = 2') .and. has('array name[2]') .and. has('name[2] = "LCL"'), &
        'the curves are named in their order')
    call tap%ok(has('name[1] = "MHB system '//backslash//'042ls'//backslash//'042"'), &
        'a line feed in a name begins no command')
    call tap%ok(has('if (!exists("format")) format = "pdf"'), &
        'the format can be changed from outside')
    call tap%ok(index(text, 'load ''curves.gp'''//feed) == len(text) - 16, &
        'drawing is left to the shared script, last of all')
    call tap%finish()

contains

    !> True where a line stands in the script.
    logical function has(line)
        character(*), intent(in) :: line !! a whole line
        has = index(feed//text, feed//line//feed) > 0
    end function has

end program test_gnuplot_script
