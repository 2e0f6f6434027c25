!> Tests of sections for CPACS. Oracles: squares worked by hand; the order that the CPACS schema
!> prescribes.
program test_cpacs
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_output, only: output_type
    use export_cpacs, only: write_cpacs
    use export_network, only: network_type, networks_type
    use export_receipt, only: receipt_type
    use support_tap, only: tap_type
    implicit none (type, external)
    character, parameter :: nl = new_line('a')
    character(*), parameter :: head = 'body,section,point,x_m,y_m,z_m'//nl
    !> Corners of a square, clockwise as seen from aft with starboard to the right: right, bottom,
    !> left, top, right.
    real(dp), parameter :: corners(2, 5) = reshape([1.0_dp, 0.0_dp, 0.0_dp, -1.0_dp, -1.0_dp, &
        0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp, 0.0_dp], [2, 5])
    type(tap_type) :: tap

    call check_ring()
    call check_units()
    call check_centre()
    call check_open()
    call check_bad()
    call tap%finish()

contains

    !> Networks of one, of two contours.
    subroutine square(points, units, networks)
        real(dp), intent(in) :: points(:, :)            !! BL and WL by columns
        character(*), intent(in) :: units               !! of them
        type(networks_type), intent(out) :: networks    !! at stations 0 and 8
        type(network_type) :: network

        network%name = 'BODY'
        allocate (network%points(3, size(points, 2), 2))
        network%points(1, :, 1) = 0.0_dp
        network%points(1, :, 2) = 8.0_dp
        network%points(2:, :, 1) = points
        network%points(2:, :, 2) = 2.0_dp*points
        network%error = 0.5_dp
        networks%deck = 'square.crd'
        networks%title = ''
        networks%units = units
        networks%list = [network]
    end subroutine square

    function written(networks, receipt) result(text)
        type(networks_type), intent(in) :: networks     !! what to write
        type(receipt_type), intent(out) :: receipt      !! of it
        character(:), allocatable :: text
        type(output_type) :: out
        type(error_type), allocatable :: error
        call write_cpacs(networks, out, receipt, error)
        text = out%text()
        if (allocated(error)) text = error%message
    end function written

    subroutine check_ring()
        type(networks_type) :: networks
        type(receipt_type) :: receipt

        call square(corners, 'M', networks)
        call tap%same(written(networks, receipt), head// &
            'BODY,1,1,0,0,-1'//nl//'BODY,1,2,0,1,0'//nl//'BODY,1,3,0,0,1'//nl// &
            'BODY,1,4,0,-1,0'//nl//'BODY,1,5,0,0,-1'//nl// &
            'BODY,2,1,8,0,-2'//nl//'BODY,2,2,8,2,0'//nl//'BODY,2,3,8,0,2'//nl// &
            'BODY,2,4,8,-2,0'//nl//'BODY,2,5,8,0,-2'//nl, &
            'from the lowest point up on the side of positive y, down on the other, to the first')
        call tap%ok(receipt%count == 1 .and. receipt%entities(1)%points == 10, &
            'the receipt counts the points')
    end subroutine check_ring

    subroutine check_units()
        type(networks_type) :: networks
        type(receipt_type) :: receipt

        call square(corners, 'MM', networks)
        call tap%has(written(networks, receipt), nl//'BODY,2,2,0.008,0.002,0'//nl, &
            'millimetres become metres')
        call square(corners, 'INCHES', networks)
        call tap%has(written(networks, receipt), nl//'BODY,2,2,0.2032,0.0508,0'//nl, &
            'inches become metres')
        call tap%near(receipt%entities(1)%error, 0.0127_dp, 1.0e-17_dp, 'so does the error')
        call square(corners, 'FEET', networks)
        call tap%has(written(networks, receipt), nl//'BODY,2,2,2.4384', 'and feet')
        call tap%has(receipt%notes, 'metres', 'the receipt says so')
    end subroutine check_units

    !> A section with two keels: the lowest points are not in the plane of symmetry.
    subroutine check_centre()
        type(networks_type) :: networks
        type(receipt_type) :: receipt
        real(dp), parameter :: keels(2, 5) = reshape([0.0_dp, 1.0_dp, 1.0_dp, -3.0_dp, 0.0_dp, &
            -1.0_dp, -1.0_dp, -3.0_dp, 0.0_dp, 1.0_dp], [2, 5])

        call square(keels, 'M', networks)
        call tap%has(written(networks, receipt), head//'BODY,1,1,0,0,-1'//nl//'BODY,1,2,0,1,-3'// &
            nl//'BODY,1,3,0,0,1'//nl, 'a section begins in the plane of symmetry')
        networks%list(1)%points(2, :, :) = networks%list(1)%points(2, :, :) + 5.0_dp
        call tap%has(written(networks, receipt), head//'BODY,1,1,0,6,-3'//nl// &
            'BODY,1,2,0,5,1'//nl, &
            'or at the lowest point where there is none')
    end subroutine check_centre

    subroutine check_open()
        type(networks_type) :: networks
        type(receipt_type) :: receipt
        real(dp), parameter :: quarter(2, 3) = reshape([3.0_dp, 0.0_dp, 2.0_dp, -2.0_dp, 0.0_dp, &
            -3.0_dp], [2, 3])
        call square(quarter, 'M', networks)
        call tap%has(written(networks, receipt), head//'BODY,1,1,0,0,-3'//nl//'BODY,1,2,0,2,-2'// &
            nl//'BODY,1,3,0,3,0'//nl//'BODY,2,1,', 'an open section goes up from its lower end')
    end subroutine check_open

    subroutine check_bad()
        type(networks_type) :: networks
        type(receipt_type) :: receipt
        call square(corners, 'CUBITS', networks)
        call tap%has(written(networks, receipt), 'CUBITS', 'a unit that is none is refused')
    end subroutine check_bad

end program test_cpacs
