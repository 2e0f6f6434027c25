!> The curves and marks of a picture as a gnuplot data file: four data sets, parted by two blank
!> lines, for gnuplot's `index 0` to `index 3`.
!>
!>     0  arcs      x y               a block a curve, in order from point 1 to point 3
!>     1  points    x y curve         three lines a curve
!>     2  tangents  x y dx dy curve   two lines a curve
!>     3  figures   x y number        where the figures of the points stand
module export_gnuplot_data
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: to_text
    use export_gnuplot_text, only: number_text, plain
    use export_marks, only: figure_type, point_figures, stroke_type, tangent_strokes
    use export_picture, only: frame_type, picture_type
    implicit none (type, external)
    private

    public :: print_gnuplot_data

contains

    !> Prints the data of a picture.
    subroutine print_gnuplot_data(picture, frame, out)
        type(picture_type), intent(in) :: picture !! at least one curve
        type(frame_type), intent(in) :: frame     !! its frame
        type(output_type), intent(inout) :: out   !! where it goes

        call out%line('# '//plain(picture%heading)//': '//picture%view)
        call out%line('# x is '//picture%x_axis//'; y is '//picture%y_axis)
        call print_arcs(picture, out)
        call print_points(picture, out)
        call print_tangents(picture, frame%span, out)
        call print_figures(picture, frame%span, out)
    end subroutine print_gnuplot_data

    !> Prints the points of each arc.
    subroutine print_arcs(picture, out)
        type(picture_type), intent(in) :: picture !! the picture
        type(output_type), intent(inout) :: out   !! where it goes
        integer :: i, k

        call out%line('# index 0, arcs: x y')
        do i = 1, picture%count
            if (i > 1) call out%line('')
            call out%line('# curve '//to_text(i)//': '//plain(picture%curve(i)%name))
            do k = 1, size(picture%curve(i)%line, 2)
                call out%line(pair(picture%curve(i)%line(:, k)))
            end do
        end do
        call part(out)
    end subroutine print_arcs

    !> Prints the three points of each curve.
    subroutine print_points(picture, out)
        type(picture_type), intent(in) :: picture !! the picture
        type(output_type), intent(inout) :: out   !! where it goes
        integer :: i, k

        call out%line('# index 1, points: x y curve')
        do i = 1, picture%count
            do k = 1, 3
                call out%line(pair(picture%curve(i)%point(:, k))//' '//to_text(i))
            end do
        end do
        call part(out)
    end subroutine print_points

    !> Prints the end tangents of each curve.
    subroutine print_tangents(picture, span, out)
        type(picture_type), intent(in) :: picture !! the picture
        real(dp), intent(in) :: span              !! of its frame, deck units
        type(output_type), intent(inout) :: out   !! where it goes
        type(stroke_type) :: strokes(2)
        integer :: i, k

        call out%line('# index 2, tangents: x y dx dy curve')
        do i = 1, picture%count
            strokes = tangent_strokes(picture%curve(i), span)
            do k = 1, 2
                call out%line(pair(strokes(k)%from)//' '//pair(strokes(k)%to - strokes(k)%from)// &
                    ' '//to_text(i))
            end do
        end do
        call part(out)
    end subroutine print_tangents

    !> Prints the figures of the points.
    subroutine print_figures(picture, span, out)
        type(picture_type), intent(in) :: picture !! the picture
        real(dp), intent(in) :: span              !! of its frame, deck units
        type(output_type), intent(inout) :: out   !! where it goes
        type(figure_type), allocatable :: figures(:)
        integer :: i

        call out%line('# index 3, figures: x y number')
        allocate (figures, source=point_figures(picture, span))
        do i = 1, size(figures)
            call out%line(pair(figures(i)%at)//' '//to_text(figures(i)%number))
        end do
    end subroutine print_figures

    !> Two numbers of a line.
    pure function pair(point) result(text)
        real(dp), intent(in) :: point(2) !! x and y
        character(:), allocatable :: text
        text = number_text(point(1))//' '//number_text(point(2))
    end function pair

    !> Ends a data set.
    subroutine part(out)
        type(output_type), intent(inout) :: out !! where it goes
        call out%line('')
        call out%line('')
    end subroutine part

end module export_gnuplot_data
