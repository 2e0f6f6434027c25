!> A keeper that makes a list of rows, and fails after so many.
module support_keeper
    use base_error, only: cause, error_type, fail
    use sweep_keeper, only: keeper_type
    use sweep_record, only: record_type, row_of_record
    implicit none (type, external)
    private

    public :: list_keeper_type

    !> A row.
    type :: row_type
        character(:), allocatable :: text !! of a finished variant
    end type row_type

    !> The list.
    type, extends(keeper_type) :: list_keeper_type
        type(row_type), allocatable :: row(:)   !! in the order they came
        integer :: most = huge(0)               !! rows that are kept before it fails
    contains
        procedure :: keep => keep_in_list
    end type list_keeper_type

contains

    !> Keeps a variant.
    subroutine keep_in_list(keeper, record, error)
        class(list_keeper_type), intent(inout) :: keeper
        type(record_type), intent(in) :: record
        type(error_type), allocatable, intent(out) :: error
        if (.not. allocated(keeper%row)) allocate (keeper%row(0))
        if (size(keeper%row) >= keeper%most) then
            call fail(error, cause%file_trouble, 'the list is full')
        else
            keeper%row = [keeper%row, row_type(row_of_record(record, .false.))]
        end if
    end subroutine keep_in_list

end module support_keeper
