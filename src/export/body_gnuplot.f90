!> A drawing of a body as gnuplot data and script. The data file has one data set a layer, parted
!> by two blank lines (gnuplot's `index 0` and so on), a block a line; then one with the places of
!> the words. The script says what is to be drawn; how is said in the shared script that it loads.
module export_body_gnuplot
    use base_constants, only: version
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: to_text
    use export_body_drawing, only: drawing_type
    use export_gnuplot_text, only: number_text, plain, quoted
    implicit none (type, external)
    private

    public :: print_drawing_data, print_drawing_script

contains

    !> Prints the data of a drawing.
    subroutine print_drawing_data(drawing, out)
        type(drawing_type), intent(in) :: drawing   !! at least one layer
        type(output_type), intent(inout) :: out     !! where it goes
        integer :: i

        call out%line('# '//plain(drawing%heading)//': '//plain(drawing%view))
        do i = 1, drawing%layers
            if (i > 1) call out%line('')
            if (i > 1) call out%line('')
            call print_layer(drawing, i, out)
        end do
        if (drawing%count == 0) return
        call out%line('')
        call out%line('')
        call out%line('# index '//to_text(drawing%layers)//', words: x y number side size')
        do i = 1, drawing%count
            associate (words => drawing%words(i))
                call out%line(row(words%at)//' '//to_text(i)//' '//to_text(words%side)// &
                    ' '//to_text(words%size))
            end associate
        end do
    end subroutine print_drawing_data

    !> Prints the lines of a layer.
    subroutine print_layer(drawing, number, out)
        type(drawing_type), intent(in) :: drawing   !! the drawing
        integer, intent(in) :: number               !! which layer
        type(output_type), intent(inout) :: out     !! where it goes
        integer :: i, k

        associate (layer => drawing%layer(number))
            call out%line('# index '//to_text(number - 1)//', '//trim(layer%style))
            do i = 1, layer%count
                if (i > 1) call out%line('')
                do k = 1, size(layer%stroke(i)%at, 2)
                    call out%line(row(layer%stroke(i)%at(:, k)))
                end do
            end do
        end associate
    end subroutine print_layer

    !> Prints the script of a drawing.
    subroutine print_drawing_script(drawing, format, out)
        type(drawing_type), intent(in) :: drawing   !! at least one layer
        character(*), intent(in) :: format          !! svg, pdf, png or txt, if not told otherwise
        type(output_type), intent(inout) :: out     !! where it goes
        integer :: i

        call out%line('# By LOFT '//version//'. To draw this picture again, here:')
        call out%line('#     gnuplot '//drawing%name//'.gp')
        call out%line('#     gnuplot -e "format=''pdf''" '//drawing%name//'.gp')
        call out%line('# The format may be svg, pdf, png or txt.')
        call out%line('picture = '//quoted(drawing%name))
        call out%line('heading = '//quoted(drawing%heading))
        call out%line('view = '//quoted(drawing%view))
        call out%line('note = '//quoted(drawing%note))
        call out%line('x_axis = '//quoted(drawing%x_axis))
        call out%line('y_axis = '//quoted(drawing%y_axis))
        call out%line('x_low  = '//number_text(drawing%low(1)))
        call out%line('x_high = '//number_text(drawing%high(1)))
        call out%line('y_low  = '//number_text(drawing%low(2)))
        call out%line('y_high = '//number_text(drawing%high(2)))
        call out%line('x_dot  = '//number_text(drawing%dot(1)))
        call out%line('y_dot  = '//number_text(drawing%dot(2)))
        call out%line('layers = '//to_text(drawing%layers))
        call out%line('array style['//to_text(drawing%layers)//']')
        do i = 1, drawing%layers
            call out%line('style['//to_text(i)//'] = '//quoted(trim(drawing%layer(i)%style)))
        end do
        call out%line('words = '//to_text(drawing%count))
        call out%line('array word['//to_text(max(1, drawing%count))//']')
        do i = 1, drawing%count
            call out%line('word['//to_text(i)//'] = '//quoted(drawing%words(i)%text))
        end do
        call out%line('if (!exists("format")) format = '//quoted(format))
        call out%line('load '''//drawing%script//'.gp''')
    end subroutine print_drawing_script

    !> Numbers of a line.
    pure function row(at) result(text)
        real(dp), intent(in) :: at(:) !! coordinates
        character(:), allocatable :: text
        integer :: i
        text = number_text(at(1))
        do i = 2, size(at)
            text = text//' '//number_text(at(i))
        end do
    end function row

end module export_body_gnuplot
