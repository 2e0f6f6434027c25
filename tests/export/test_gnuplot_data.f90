!> The data file of a picture, read back as gnuplot reads it: data sets parted by two blank lines,
!> blocks by one, `#` lines passed over.
program test_gnuplot_data
    use base_kinds, only: dp
    use base_output, only: output_type
    use export_gnuplot_data, only: print_gnuplot_data
    use export_picture, only: curve_type, frame_of, picture_type
    use geom_arc, only: line_between
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(picture_type) :: picture
    type(output_type) :: out
    character(:), allocatable :: text
    character, parameter :: feed = new_line('a')
    real(dp) :: number(5)

    picture%heading = 'A nose'//feed//'9 9 9'
    picture%view = 'Side view'
    picture%x_axis = 'station (STA), mm'
    picture%y_axis = 'waterline (WL), mm'
    call picture%add(straight('first'//feed//'7 7 7', [0.0_dp, 1.0_dp], [10.0_dp, 1.0_dp]))
    call picture%add(straight('second', [0.0_dp, 2.0_dp], [10.0_dp, 2.0_dp]))
    call print_gnuplot_data(picture, frame_of(picture), out)
    text = out%text()

    call tap%ok(occurrences(feed//feed//feed) == 3, 'four data sets stand in the file')
    call tap%ok(occurrences(feed//'7 7 7') == 0 .and. occurrences(feed//'9 9 9') == 0, &
        'a line feed in a name makes no data')
    call tap%ok(index(text, '# curve 1: first 7 7 7'//feed) > 0 .and. &
        index(text, '# curve 2: second'//feed) > 0, &
        'each block of the arcs has the name of its curve')
    call tap%ok(index(text, '# x is station (STA), mm; y is waterline (WL), mm'//feed) > 0, &
        'the axes and their unit are said')

    call line_of_set(0, 1, number(:2))
    call tap%ok(all(number(:2) == [0.0_dp, 1.0_dp]), 'the first arc begins in point 1')
    call line_of_set(1, 6, number(:3))
    call tap%ok(all(number(:3) == [10.0_dp, 2.0_dp, 2.0_dp]), &
        'the last point is point 3 of curve 2')
    call line_of_set(2, 3, number(:5))
    call tap%ok(all(abs(number(:5) - [-0.5_dp, 2.0_dp, 1.0_dp, 0.0_dp, 2.0_dp]) < 1.0e-14_dp), &
        'a tangent is where it begins, how far it goes, and its curve')
    call line_of_set(3, 3, number(:3))
    call tap%ok(all(abs(number(:3) - [10.65_dp, 1.0_dp, 3.0_dp]) < 1.0e-14_dp), &
        'a figure is a place and a number')
    call tap%finish()

contains

    !> A straight curve.
    type(curve_type) function straight(name, from, to) result(curve)
        character(*), intent(in) :: name !! its name
        real(dp), intent(in) :: from(2)  !! point 1
        real(dp), intent(in) :: to(2)    !! point 3
        curve%name = name
        curve%arc = line_between(from, to)
        curve%point = reshape([from, 0.5_dp*(from + to), to], [2, 3])
    end function straight

    !> How often something stands in the text.
    integer function occurrences(what) result(times)
        character(*), intent(in) :: what !! what is looked for
        integer :: i
        times = count([(text(i:i + len(what) - 1) == what, i=1, len(text) - len(what) + 1)])
    end function occurrences

    !> The numbers on a line of a data set; NaN-like huge where there is no such line.
    subroutine line_of_set(set, line, number)
        integer, intent(in) :: set          !! which data set, from 0
        integer, intent(in) :: line         !! which line of it with numbers, from 1
        real(dp), intent(out) :: number(:)  !! its numbers
        integer :: first, last, sets, lines, blanks

        number = huge(1.0_dp)
        sets = 0
        lines = 0
        blanks = 0
        first = 1
        do while (first <= len(text))
            last = first + index(text(first:), feed) - 2
            if (last < first) then
                blanks = blanks + 1
                if (blanks == 2) sets = sets + 1
                if (blanks == 2) lines = 0
            else if (text(first:first) /= '#') then
                blanks = 0
                lines = lines + 1
                if (sets == set .and. lines == line) read (text(first:last), *) number
            end if
            first = last + 2
        end do
    end subroutine line_of_set

end program test_gnuplot_data
