!> Cuts as comma-separated values, in full, a row a point.
!>
!>     cut,kind,section,sta,bl,wl,slope,curvature,bevel
!>     1,station,LOWER,0,0,-18,0,0.062,0
module report_cut_csv
    use base_output, only: output_type
    use base_text, only: to_text
    use cut_outline, only: cut_point_type, cut_type, outline_type
    use base_digits, only: shortest
    use report_slope, only: slope_text
    implicit none (type, external)
    private

    public :: print_cut_csv_header, print_cut_csv

    !> The kinds of cut as the file names them, by `cut_kind`.
    character(9), parameter :: kind_names(5) = &
        [character(9) :: 'station', 'buttock', 'waterline', 'oblique', 'plane']

contains

    !> Prints the header line.
    subroutine print_cut_csv_header(out)
        type(output_type), intent(inout) :: out !! where it goes
        call out%line('cut,kind,section,sta,bl,wl,slope,curvature,bevel')
    end subroutine print_cut_csv_header

    !> Prints the points of a cut, outline by outline.
    subroutine print_cut_csv(number, cut, section_names, out)
        integer, intent(in) :: number                !! which cut of the deck, from 1
        type(cut_type), intent(in) :: cut            !! the cut
        character(*), intent(in) :: section_names(:) !! names of the body's sections
        type(output_type), intent(inout) :: out      !! where they go
        character(:), allocatable :: front
        integer :: i

        front = to_text(number)//','//trim(kind_names(cut%plane%kind))//','
        do i = 1, size(cut%outlines)
            call print_outline_csv(front, cut%outlines(i), section_names, out)
        end do
        if (.not. allocated(cut%patched)) return
        do i = 1, size(cut%patched)
            call print_outline_csv(front, cut%patched(i), section_names, out)
        end do
    end subroutine print_cut_csv

    !> Prints the points of an outline.
    subroutine print_outline_csv(front, outline, section_names, out)
        character(*), intent(in) :: front            !! what stands in front of each row
        type(outline_type), intent(in) :: outline    !! the outline
        character(*), intent(in) :: section_names(:) !! names of the body's sections and patches
        type(output_type), intent(inout) :: out      !! where they go
        integer :: k

        do k = 1, size(outline%points)
            call print_point(front//trim(section_names(outline%points(k)%section)), &
                outline%points(k), out)
        end do
    end subroutine print_outline_csv

    !> Prints the numbers of a point; one that does not exist is an empty field.
    subroutine print_point(front, point, out)
        character(*), intent(in) :: front           !! what stands in front of them
        type(cut_point_type), intent(in) :: point   !! the point
        type(output_type), intent(inout) :: out     !! where they go
        character(:), allocatable :: text

        text = front//','//shortest(point%at(1))//','//shortest(point%at(2))//','// &
            shortest(point%at(3))//','
        if (point%has_slope) text = text//slope_text(point%slope)
        text = text//','
        if (point%has_curvature) text = text//shortest(point%curvature)
        text = text//','
        if (point%has_normal) text = text//shortest(point%bevel)
        call out%line(text)
    end subroutine print_point

end module report_cut_csv
