!> The words for an interruption.
program test_trap
    use base_error, only: cause, error_type
    use period_trap, only: interrupt
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(error_type), allocatable :: error

    call interrupt(0, 'in the row at X = 5.', error)
    call tap%ok(.not. allocated(error), 'without a trap there is no error')
    call check(cause%overflow, 'exponent overflow in the row at X = 5.: ')
    call check(cause%underflow, 'exponent underflow in the row at X = 5.: ')
    call check(cause%divide, 'division by zero in the row at X = 5.: ')
    call tap%finish()

contains

    !> Checks cause and first words.
    subroutine check(trap, words)
        integer, intent(in) :: trap
        character(*), intent(in) :: words
        character(len(words)) :: first
        call interrupt(trap, 'in the row at X = 5.', error)
        call tap%ok(error%cause == trap, words//'has its cause')
        first = error%message
        call tap%same(first, words, words//'says where')
    end subroutine check

end program test_trap
