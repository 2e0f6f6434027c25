!> The receipt of an export: what each entity of the file is, how far it is from the exact shape,
!> and where. Each writer adds what it wrote; `app` prints it and puts it beside the file.
module export_receipt
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: entity_type, receipt_type

    !> One entity of a file.
    type :: entity_type
        character(:), allocatable :: name       !! of the cut, line, section or face
        character(:), allocatable :: kind       !! in the words of the format: `126 B-SPLINE CURVE`
        logical :: is_exact = .false.           !! the shape itself, but for rounding
        integer :: points = 0                   !! points, poles or triangles
        integer :: spans = 0                    !! stretches between knots; 0: does not apply
        real(dp) :: error = 0.0_dp              !! largest distance from the exact shape, measured
        logical :: has_place = .false.          !! `worst` is known
        real(dp) :: worst(3) = 0.0_dp           !! where it is: STA, BL, WL
    end type entity_type

    !> All of a file.
    type :: receipt_type
        type(entity_type), allocatable :: entities(:)   !! in the order of the file
        integer :: count = 0                            !! how many there are
        character(:), allocatable :: notes              !! lines of plain words, each with its end
    contains
        procedure :: add => add_entity
        procedure :: say
    end type receipt_type

contains

    !> Adds an entity.
    pure subroutine add_entity(receipt, entity)
        class(receipt_type), intent(inout) :: receipt   !! the receipt
        type(entity_type), intent(in) :: entity         !! what was written
        type(entity_type), allocatable :: grown(:)

        if (.not. allocated(receipt%entities)) allocate (receipt%entities(8))
        if (receipt%count == size(receipt%entities)) then
            allocate (grown(2*receipt%count))
            grown(:receipt%count) = receipt%entities
            call move_alloc(grown, receipt%entities)
        end if
        receipt%count = receipt%count + 1
        receipt%entities(receipt%count) = entity
    end subroutine add_entity

    !> Adds a line of plain words.
    pure subroutine say(receipt, line)
        class(receipt_type), intent(inout) :: receipt   !! the receipt
        character(*), intent(in) :: line                !! no line end
        if (.not. allocated(receipt%notes)) receipt%notes = ''
        receipt%notes = receipt%notes//line//new_line('a')
    end subroutine say

end module export_receipt
