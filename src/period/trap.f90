!> The words for an arithmetic interruption: the 1970 machine would have stopped the card there.
module period_trap
    use base_error, only: cause, error_type, fail
    implicit none (type, external)
    private

    public :: interrupt

contains

    !> Makes an error of a trap, none of 0.
    pure subroutine interrupt(trap, place, error)
        integer, intent(in) :: trap                         !! 0, `cause%overflow`, ...
        character(*), intent(in) :: place                   !! where, as `in the field X1`
        type(error_type), allocatable, intent(out) :: error !! allocated unless the trap is 0

        select case (trap)
        case (cause%overflow)
            call fail(error, trap, 'exponent overflow '//place// &
                ': a System/360 number stays below 7.2e75; use smaller numbers')
        case (cause%underflow)
            call fail(error, trap, 'exponent underflow '//place// &
                ': a System/360 number is zero or at least 5.4e-79; use zero or larger numbers')
        case (cause%divide)
            call fail(error, trap, 'division by zero '//place// &
                ': the curve has no ordinate there; use another first point or increment')
        end select
    end subroutine interrupt

end module period_trap
