!> Who keeps the variants of a sweep as they are finished: extend it with a file, a progress line,
!> or a list in memory. It is called by one thread at a time.
module sweep_keeper
    use base_error, only: error_type
    use sweep_record, only: record_type
    implicit none (type, external)
    private

    public :: keeper_type

    !> A keeper.
    type, abstract :: keeper_type
    contains
        procedure(keep_record), deferred :: keep
    end type keeper_type

    abstract interface
        !> Keeps a variant. An error ends the sweep.
        subroutine keep_record(keeper, record, error)
            import :: error_type, keeper_type, record_type
            implicit none (type, external)
            class(keeper_type), intent(inout) :: keeper         !! the keeper
            type(record_type), intent(in) :: record             !! a finished variant
            type(error_type), allocatable, intent(out) :: error !! it can't be kept
        end subroutine keep_record
    end interface

end module sweep_keeper
