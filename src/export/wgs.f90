!> LaWGS files: the Langley Wireframe Geometry Standard, contours of points that panel methods take.
!>
!> Source: C. B. Craidon, "A Description of the Langley Wireframe Geometry Standard (LaWGS) Format",
!> NASA TM 85767, 1985. A title; then for each object its name, a record of its number, its
!> contours, points of each, local symmetry, rotation, translation, scale, global symmetry, and its
!> points contour by contour, all list-directed. x is aft, y to starboard, z up. Global symmetry 1
!> adds the mirror image in the plane of x and z.
module export_wgs
    use base_digits, only: shortest
    use base_output, only: output_type
    use base_text, only: first_bytes, printable, to_text
    use export_network, only: network_type, networks_type, note_networks
    use export_receipt, only: receipt_type
    implicit none (type, external)
    private

    public :: write_wgs

    !> Characters of a title or a name.
    integer, parameter :: widest = 80

contains

    !> Writes networks; those of a half have the flag of symmetry.
    subroutine write_wgs(networks, out, receipt)
        type(networks_type), intent(in) :: networks     !! in the unit of the file
        type(output_type), intent(inout) :: out         !! gets the file
        type(receipt_type), intent(inout) :: receipt    !! gets what was written
        integer :: i

        call note_networks(networks, 'OBJECT OF CONTOURS', receipt)
        call out%line(quoted('UNITS='//networks%units//' DECK '// &
            trim(printable(networks%deck))//' '//trim(printable(networks%title))))
        do i = 1, size(networks%list)
            call write_object(networks%list(i), i, out)
        end do
    end subroutine write_wgs

    !> Writes one object.
    subroutine write_object(network, number, out)
        type(network_type), intent(in) :: network   !! any
        integer, intent(in) :: number               !! its number
        type(output_type), intent(inout) :: out     !! gets it
        integer :: i, k

        call out%line(quoted(network%name))
        call out%line(to_text(number)//' '//to_text(size(network%points, 3))//' '// &
            to_text(size(network%points, 2))//' 0  0 0 0  0 0 0  1 1 1  '// &
            to_text(merge(1, 0, network%is_half)))
        do i = 1, size(network%points, 3)
            do k = 1, size(network%points, 2)
                associate (at => network%points(:, k, i))
                    call out%line(shortest(at(1))//' '//shortest(at(2))//' '//shortest(at(3)))
                end associate
            end do
        end do
    end subroutine write_object

    !> Up to 80 characters in apostrophes; those inside become two, as Fortran reads them.
    pure function quoted(words) result(text)
        character(*), intent(in) :: words !! any text
        character(:), allocatable :: text
        integer :: i

        text = "'"
        do i = 1, first_bytes(trim(words), widest)
            text = text//words(i:i)
            if (words(i:i) == "'") text = text//"'"
        end do
        text = text//"'"
    end function quoted

end module export_wgs
