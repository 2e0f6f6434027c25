!> `.hrm` files: the cross sections of components, as OpenVSP writes them (Export, XSec) and reads
!> them (Import, XSec), named for the Hermite surfaces that once were fitted to them.
!>
!> Source: OpenVSP, https://github.com/OpenVSP/OpenVSP, src/geom_core: `Vehicle::WriteXSecFile`,
!> `Geom::WriteXSecFile` (what is written) and `WireGeom::ReadXSec` (what is read). x is aft, y to
!> starboard, z up. A name ends at its first blank; TYPE 1 is a body, 0 a wing. The format has no
!> place for units or comments; both are in the receipt.
module export_hrm
    use base_digits, only: scientific
    use base_output, only: output_type
    use base_text, only: to_text
    use export_network, only: network_type, networks_type, note_networks
    use export_receipt, only: receipt_type
    implicit none (type, external)
    private

    public :: write_hrm

    !> Columns and figures of a number.
    integer, parameter :: width = 25, figures = 17

contains

    !> Writes networks, best of whole rings: the format knows no symmetry.
    subroutine write_hrm(networks, out, receipt)
        type(networks_type), intent(in) :: networks     !! in the unit of the file
        type(output_type), intent(inout) :: out         !! gets the file
        type(receipt_type), intent(inout) :: receipt    !! gets what was written
        integer :: i

        call note_networks(networks, 'COMPONENT OF CROSS SECTIONS', receipt)
        call receipt%say('the file has no place for units: lengths are in '//networks%units)
        call out%line(' HERMITE INPUT FILE')
        call out%line('')
        call out%line(' NUMBER OF COMPONENTS = '//to_text(size(networks%list)))
        do i = 1, size(networks%list)
            call write_component(networks%list(i), i - 1, out)
        end do
    end subroutine write_hrm

    !> Writes one component.
    subroutine write_component(network, group, out)
        type(network_type), intent(in) :: network   !! any
        integer, intent(in) :: group                !! its number, from 0
        type(output_type), intent(inout) :: out     !! gets it
        integer :: i, k

        call out%line('')
        call out%line(network%name//' ')
        call out%line(' GROUP NUMBER      = '//to_text(group)//' ')
        call out%line(' TYPE              = 1  ')
        call out%line(' CROSS SECTIONS    = '//to_text(size(network%points, 3))//' ')
        call out%line(' PTS/CROSS SECTION = '//to_text(size(network%points, 2))//' ')
        do i = 1, size(network%points, 3)
            do k = 1, size(network%points, 2)
                associate (at => network%points(:, k, i))
                    call out%line(scientific(at(1), width, figures)//'  '// &
                        scientific(at(2), width, figures)//'  '//scientific(at(3), width, figures))
                end associate
            end do
        end do
    end subroutine write_component

end module export_hrm
