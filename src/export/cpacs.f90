!> Sections for CPACS, as CSV: what a script puts into point lists of `fuselageProfile` elements.
!>
!>     body,section,point,x_m,y_m,z_m
!>     FUSELAGE,1,1,0.3556,0,-0.3556
!>
!> `section` counts the sections of a body from 1, aft; `point` the points of a section from 1. As
!> CPACS wants them, lengths are in metres whatever the deck's unit is, x is aft, y to starboard, z
!> up, and a section begins at its lowest point, in the plane of symmetry where it has one there,
!> goes up on the side of positive y, and comes down on the other; the last point is the first
!> again. A section that is not closed ends where its skin ends.
!>
!> Source: CPACS schema 3.5, https://github.com/DLR-SL/CPACS, `profileGeometryType`, example 2.
module export_cpacs
    use base_digits, only: shortest
    use base_error, only: error_type
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: to_text
    use export_network, only: network_type, networks_type, note_networks, scale_networks
    use export_receipt, only: receipt_type
    use export_units, only: find_unit, unit_type
    implicit none (type, external)
    private

    public :: write_cpacs

contains

    !> Writes networks, best of whole rings, which CPACS calls sections without symmetry.
    !>
    !> Fails with `cause%usage` where their unit is none.
    subroutine write_cpacs(networks, out, receipt, error)
        type(networks_type), intent(in) :: networks         !! in any unit
        type(output_type), intent(inout) :: out             !! gets the file
        type(receipt_type), intent(inout) :: receipt        !! gets what was written
        type(error_type), allocatable, intent(out) :: error !! see above
        type(networks_type) :: metric
        type(unit_type) :: unit, metre
        integer :: i

        call find_unit(networks%units, unit, error)
        if (.not. allocated(error)) call find_unit('M', metre, error)
        if (allocated(error)) return
        metric = networks
        if (unit%name /= metre%name) &
            call scale_networks(metric, metre%inch/unit%inch, trim(metre%name))
        call note_networks(metric, 'SECTIONS OF POINTS', receipt)
        call receipt%say('lengths are in metres, as CPACS has them')
        call out%line('body,section,point,x_m,y_m,z_m')
        do i = 1, size(metric%list)
            call write_body(metric%list(i), out)
        end do
    end subroutine write_cpacs

    !> Writes one network.
    subroutine write_body(network, out)
        type(network_type), intent(in) :: network   !! in metres
        type(output_type), intent(inout) :: out     !! gets it
        integer, allocatable :: order(:)
        integer :: i, k

        allocate (order, source=point_order(network%points))
        do i = 1, size(network%points, 3)
            do k = 1, size(order)
                associate (at => network%points(:, order(k), i))
                    call out%line(network%name//','//to_text(i)//','//to_text(k)//','// &
                        shortest(at(1))//','//shortest(at(2))//','//shortest(at(3)))
                end associate
            end do
        end do
    end subroutine write_body

    !> The order of the points of all contours of a network: the other way round, and of closed ones
    !> from the lowest point to itself.
    pure function point_order(points) result(order)
        real(dp), intent(in) :: points(:, :, :)     !! shape (3, points, contours)
        integer, allocatable :: order(:)
        integer :: count, lowest, k

        count = size(points, 2)
        allocate (order(count))
        order = [(k, k=count, 1, -1)]
        if (.not. all(is_zero(points(:, 1, :) - points(:, count, :)))) return
        lowest = lowest_point(points(:, :count - 1, :))
        order = [(1 + modulo(lowest - k, count - 1), k=1, count)]
    end function point_order

    !> The point at which contours are lowest, all in all; one in BL 0 of all contours where there
    !> is any.
    pure integer function lowest_point(points) result(lowest)
        real(dp), intent(in) :: points(:, :, :)     !! shape (3, points, contours)
        logical :: is_centre(size(points, 2))

        is_centre = all(is_zero(points(2, :, :)), dim=2)
        if (.not. any(is_centre)) is_centre = .true.
        lowest = minloc(sum(points(3, :, :), dim=2), dim=1, mask=is_centre)
    end function lowest_point

end module export_cpacs
