!> The gnuplot script of one picture. It only says what is to be drawn; how is said in the scripts
!> that it loads (`plot/curves.gp`, `plot/style.gp`). They and the data are in its folder, where
!> gnuplot is run.
module export_gnuplot_script
    use base_constants, only: version
    use base_output, only: output_type
    use base_text, only: to_text
    use export_gnuplot_text, only: number_text, quoted
    use export_picture, only: frame_type, picture_type
    implicit none (type, external)
    private

    public :: print_gnuplot_script

contains

    !> Prints the script of a picture.
    subroutine print_gnuplot_script(picture, frame, format, out)
        type(picture_type), intent(in) :: picture !! at least one curve
        type(frame_type), intent(in) :: frame     !! its frame
        character(*), intent(in) :: format        !! svg, pdf, png or txt, where not told otherwise
        type(output_type), intent(inout) :: out   !! where it goes
        integer :: i

        call out%line('# '//picture%view//', by LOFT '//version//'. To draw it again, here:')
        call out%line('#     gnuplot '//picture%name//'.gp')
        call out%line('#     gnuplot -e "format=''pdf''" '//picture%name//'.gp')
        call out%line('# The format may be svg, pdf, png or txt.')
        call out%line('picture = '//quoted(picture%name))
        call out%line('heading = '//quoted(picture%heading))
        call out%line('view = '//quoted(picture%view))
        call out%line('x_axis = '//quoted(picture%x_axis))
        call out%line('y_axis = '//quoted(picture%y_axis))
        call out%line('x_low  = '//number_text(frame%low(1)))
        call out%line('x_high = '//number_text(frame%high(1)))
        call out%line('y_low  = '//number_text(frame%low(2)))
        call out%line('y_high = '//number_text(frame%high(2)))
        call out%line('curves = '//to_text(picture%count))
        call out%line('array name['//to_text(picture%count)//']')
        do i = 1, picture%count
            call out%line('name['//to_text(i)//'] = '//quoted(picture%curve(i)%name))
        end do
        call out%line('if (!exists("format")) format = '//quoted(format))
        call out%line('load ''curves.gp''')
    end subroutine print_gnuplot_script

end module export_gnuplot_script
