!> The skin of a body as networks: contours across it, each with the same number of points, joined
!> point to point along it. What files of design tools (`.hrm`, `.wgs`) are written from.
!>
!> A contour is in the plane of a station; contours go aft. Seen from aft, the outside is to the
!> left of a contour, so that the way aft, the way along it and the way out are right-handed.
module export_network
    use base_kinds, only: dp
    use export_receipt, only: entity_type, receipt_type
    implicit none (type, external)
    private

    public :: network_type, networks_type, scale_networks, note_networks

    !> One network.
    type :: network_type
        character(:), allocatable :: name       !! letters, figures, - _ .
        real(dp), allocatable :: points(:, :, :) !! STA, BL, WL; shape (3, points, contours)
        logical :: is_half = .false.            !! its mirror image in BL 0 belongs to the body
        real(dp) :: error = 0.0_dp              !! largest distance of flat panels from the skin
        real(dp) :: worst(3) = 0.0_dp           !! where: STA, BL, WL
    end type network_type

    !> All of a body.
    type :: networks_type
        character(:), allocatable :: deck       !! file name of the deck, without folders
        character(:), allocatable :: title      !! of the deck, may be empty
        character(:), allocatable :: units      !! INCHES, MM, FEET or M: of all lengths in it
        type(network_type), allocatable :: list(:) !! in order
        logical :: is_by_deck = .false.         !! contours at the stations that the deck cuts
    end type networks_type

contains

    !> Networks in another unit.
    pure subroutine scale_networks(networks, factor, units)
        type(networks_type), intent(inout) :: networks  !! all lengths become larger by the factor
        real(dp), intent(in) :: factor                  !! above zero: new units in one of the old
        character(*), intent(in) :: units               !! the new unit: INCHES, MM, FEET or M
        integer :: i

        networks%units = units
        do i = 1, size(networks%list)
            associate (network => networks%list(i))
                network%points = factor*network%points
                network%error = factor*network%error
                network%worst = factor*network%worst
            end associate
        end do
    end subroutine scale_networks

    !> Adds an entity for each network, and says what is approximate.
    pure subroutine note_networks(networks, kind, receipt)
        type(networks_type), intent(in) :: networks     !! as written
        character(*), intent(in) :: kind                !! in the words of the format
        type(receipt_type), intent(inout) :: receipt    !! gets it
        type(entity_type) :: entity
        integer :: i

        do i = 1, size(networks%list)
            associate (network => networks%list(i))
                entity%name = network%name
                entity%kind = kind
                entity%points = size(network%points, 2)*size(network%points, 3)
                entity%spans = size(network%points, 3) - 1
                entity%error = network%error
                entity%has_place = .true.
                entity%worst = network%worst
            end associate
            call receipt%add(entity)
        end do
        call receipt%say('points are on the exact skin; errors are those of flat panels '// &
            'between them')
        if (networks%is_by_deck) then
            call receipt%say('contours are at the stations that the deck cuts, and where lines '// &
                'begin, join or end')
        else
            call receipt%say('contours are at stations chosen for the tolerance')
        end if
    end subroutine note_networks

end module export_network
