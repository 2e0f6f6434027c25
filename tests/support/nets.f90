!> Networks small enough to write out by hand.
module support_nets
    use base_kinds, only: dp
    use export_network, only: network_type, networks_type
    implicit none (type, external)
    private

    public :: two_nets

contains

    !> A network of three contours of two points, half a body, and one of two contours.
    function two_nets() result(networks)
        type(networks_type) :: networks
        type(network_type) :: network
        networks%deck = 'a.crd'
        networks%title = "PILOT'S SEAT"
        networks%units = 'MM'
        allocate (networks%list(0))
        network%name = 'UPPER'
        network%is_half = .true.
        network%error = 0.5_dp
        network%worst = [1.0_dp, 2.0_dp, 3.0_dp]
        network%points = reshape([0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, &
            10.0_dp, 0.0_dp, 2.5_dp, 10.0_dp, 3.0_dp, 0.0_dp, &
            20.0_dp, 0.0_dp, 5.0_dp, 20.0_dp, 0.1_dp, -1.0_dp], [3, 2, 3])
        networks%list = [network]
        network%name = 'LOWER'
        network%is_half = .false.
        network%points = network%points(:, :, 2:)
        networks%list = [networks%list, network]
    end function two_nets

end module support_nets
